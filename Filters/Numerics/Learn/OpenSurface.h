/// Open a learned surface where the samples end: remove the parts without samples, along smooth
/// border curves. The steps are our own construction, not from a publication.

#ifndef ConformalOpenSurface_h
#define ConformalOpenSurface_h

#include "Base/Run.h"
#include "Border/OpenParts.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"

namespace conformal
{
/// Remove the parts of a learned surface that are beyond the border, see findOpenParts() and
/// fitBorders(). Vertex values of the result are interpolated.
/// @param[in,out] result  closed surface, in the samples' unit, with Supported. On return, if
///   the surface was opened, it has a BorderReport. If no sheet can be cut out of the surface,
///   NumberOfBorders is 0.
/// @param[in] options  options.HoleSize in the samples' unit
/// @return whether parts of the surface are to be left open; otherwise, nothing changes
/// @throws Aborted
bool openSurface(const TrainingSamples& samples, const BorderOptions& options,
  ConformalSOMResult& result, const Run& run = {});
}

#endif

/// Parser and writer of the meshes of SPHARM-PDM: surfaces (_surf) and their spheres (_para) as
/// legacy VTK files.

#ifndef ConformalSPHARMMesh_h
#define ConformalSPHARMMesh_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string>
#include <string_view>

namespace conformal
{
/// Read the points (float or double) and polygons of a legacy VTK file of a POLYDATA, text or
/// binary, versions 1.0 to 5.1. Vertices and lines are passed over; the rest of the file from the
/// first arrays on is not read.
SurfaceResult parseSPHARMMesh(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Whether bytes from the start of a file are those of a legacy VTK file of a POLYDATA.
bool looksLikeSPHARMMesh(std::string_view start);

/// The file of the sphere: its name has "_para" before the extension, in place of "_surf" if the
/// surface's has that.
std::string sphereNameOf(const std::string& path);

/// The surface, or its "SpherePosition" in place of its points, as text of version 3.0. Numbers
/// are read back the same.
/// @throws std::invalid_argument if there are polygons other than triangles, or, of the sphere, no
///         "SpherePosition" or one without a direction
/// @throws Aborted
std::string makeSPHARMSurface(const SurfaceData& surface, const Run& run = {});
std::string makeSPHARMSphere(const SurfaceData& surface, const Run& run = {});
}

#endif

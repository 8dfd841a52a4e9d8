// Compare the projections of the classes that draw or read maps with those of the core, and choose
// one from the bytes of a fuzzer.
#ifndef CasesProjections_h
#define CasesProjections_h

#include "Body/MapImage.h"
#include "Case.h"
#include "FilterSource.h"

#include "vtkNew.h"

#include <vector>

namespace cases
{
/// Return the default and the values of Projection, of a class and of the core.
template <typename Filter>
std::vector<Mirror> ProjectionMirrors()
{
  using conformal::MapProjection;
  const auto same = [](const char* name, int ours, MapProjection core)
  { return Same(name, ours, static_cast<int>(core)); };
  vtkNew<Filter> filter;
  return { same("Projection", filter->GetProjection(), conformal::MapImage().Projection),
    same("EQUIRECTANGULAR", Filter::EQUIRECTANGULAR, MapProjection::Equirectangular),
    same("LAMBERT_AZIMUTHAL", Filter::LAMBERT_AZIMUTHAL, MapProjection::LambertAzimuthal),
    same("MOLLWEIDE", Filter::MOLLWEIDE, MapProjection::Mollweide),
    same("PEIRCE_QUINCUNCIAL", Filter::PEIRCE_QUINCUNCIAL, MapProjection::PeirceQuincuncial),
    same("MERCATOR", Filter::MERCATOR, MapProjection::Mercator),
    same("CAPSULE", Filter::CAPSULE, MapProjection::Capsule) };
}

/// Set the projection of a class from the bytes of a fuzzer.
template <typename Filter>
void FuzzProjection(Filter* filter, fuzz::FilterSource& source)
{
  filter->SetProjection(source.below(Filter::CAPSULE + 1));
  if (source.flag())
  {
    filter->SetCentralLongitude(source.number());
    filter->SetCapsuleAspect(source.number());
  }
}
}

#endif

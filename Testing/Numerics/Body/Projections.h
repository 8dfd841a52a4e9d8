/// Lists of the projections of maps, for tests.

#ifndef ConformalTestProjections_h
#define ConformalTestProjections_h

#include "Body/MapProjection.h"

namespace projections
{
/// The projections that show the whole sphere: all but Mercator's.
constexpr conformal::MapProjection Whole[] = { conformal::MapProjection::Equirectangular,
  conformal::MapProjection::LambertAzimuthal, conformal::MapProjection::Mollweide,
  conformal::MapProjection::PeirceQuincuncial };
}

#endif

/// Store a point on a triangle mesh by its barycentric coordinates.

#ifndef ConformalSurfacePlace_h
#define ConformalSurfacePlace_h

#include "Base/Types.h"

#include <array>

namespace conformal
{
/// Point on a triangle mesh: three vertex ids and their barycentric weights. Weights are >= 0 and
/// have the sum 1.
struct SurfacePlace
{
  std::array<int, 3> Ids = { -1, -1, -1 };
  Vector3 Weights = { 1, 0, 0 };

  bool isVertex() const { return this->Weights[0] == 1.0; }
};
}

#endif

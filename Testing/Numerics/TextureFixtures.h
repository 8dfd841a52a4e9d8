// Make models and views for tests of textures.
#ifndef TextureFixtures_h
#define TextureFixtures_h

#include "Base/Types.h"
#include "Texture/SphereProjection.h"

namespace fixtures
{
constexpr conformal::SphereProjection AllProjections[] = {
  conformal::SphereProjection::Stereographic, conformal::SphereProjection::LongitudeLatitude,
  conformal::SphereProjection::Octahedral, conformal::SphereProjection::CubeMap
};

// Build an egg without symmetry, from directions n.
inline conformal::Points egg(const conformal::Points& n)
{
  conformal::Points points(n.rows(), 3);
  for (conformal::Index i = 0; i < n.rows(); ++i)
  {
    const double x = n(i, 0), y = n(i, 1), z = n(i, 2);
    points.row(i) = conformal::Vector3(x * (1.0 + 0.2 * y), 1.4 * y, z * (0.8 + 0.1 * x + 0.1 * y));
  }
  return points;
}

template <typename Options>
Options seenFrom(const conformal::Vector3& direction, const conformal::Vector3& up)
{
  Options options;
  options.ViewDirection = direction;
  options.ViewUp = up;
  return options;
}
}

#endif

/// Make surfaces for tests of registration, and deform their sphere maps by a known function.

#ifndef ConformalTestHeads_h
#define ConformalTestHeads_h

#include "Mesh/GeodesicSphere.h"
#include "Register/SphericalRegistration.h"
#include "Shapes.h"

#include <cmath>

namespace heads
{
/// Compute the distance from the center of a head to its surface, in the direction n. The head has
/// a nose, an ear and a tail, so that it has no symmetry.
/// @param[in] nose  height of the nose
inline double radiusAt(const conformal::Vector3& n, double nose = 0.7)
{
  using conformal::Vector3;
  const auto bump = [&](const Vector3& at, double width)
  { return std::exp((n.dot(at.normalized()) - 1.0) / (width * width)); };
  return 1.0 + nose * bump({ 1, 0.1, 0.2 }, 0.3) + 0.4 * bump({ -0.2, 1, 0.6 }, 0.35) +
    0.9 * bump({ -0.8, -0.3, -0.6 }, 0.25);
}

/// Build a flattened head. The sphere map of each point is the direction of the geodesic sphere
/// from which the point was made.
inline conformal::RegisteredSurface head(int frequency, double nose = 0.7)
{
  conformal::RegisteredSurface result;
  const auto sphere = conformal::makeGeodesicSphere(frequency);
  result.Surface.Triangles = sphere.Triangles;
  result.Surface.SpherePositions = sphere.Positions;
  result.Surface.Positions = shapes::over(sphere.Positions,
    [=](const conformal::Vector3& n) -> conformal::Vector3
    { return radiusAt(n, nose) * n.cwiseProduct(conformal::Vector3(1.2, 0.9, 1.0)); });
  result.Features.resize(sphere.Positions.rows(), 0);
  return result;
}

/// Build a body with two equal ends: a rotation by 180 degrees about z leaves it unchanged.
inline conformal::RegisteredSurface twoEnds()
{
  using conformal::Vector3;
  conformal::RegisteredSurface result = head(12);
  result.Surface.Positions = shapes::over(result.Surface.SpherePositions,
    [](const Vector3& n) -> Vector3
    {
      const auto bump = [&](const Vector3& at, double width)
      { return std::exp((n.dot(at.normalized()) - 1.0) / (width * width)); };
      return (1.0 + bump({ 1, 0.3, 0.4 }, 0.3) + bump({ -1, -0.3, 0.4 }, 0.3)) *
        n.cwiseProduct(Vector3(1.6, 0.9, 1.0));
    });
  return result;
}

/// Deform the sphere smoothly, then rotate it.
/// @param[in] angle  angle of the rotation [radians]
inline conformal::Vector3 warped(const conformal::Vector3& n, double angle)
{
  using conformal::Vector3;
  const Vector3 bent =
    n + 0.12 * Vector3(n[1] * n[2], std::sin(2.0 * n[0]) * n[2], -n[0] * n[1] * n[1]);
  return Eigen::AngleAxisd(angle, Vector3(0.2, -0.7, 0.5).normalized()) * bent.normalized();
}

inline conformal::RegisteredSurface withWarpedMap(
  conformal::RegisteredSurface surface, double angle)
{
  surface.Surface.SpherePositions = shapes::over(
    surface.Surface.SpherePositions, [=](const conformal::Vector3& n) { return warped(n, angle); });
  return surface;
}

/// Compute the mean distance of corresponding unit vectors, converted to an angle [degrees].
inline double meanAngle(const conformal::Points& a, const conformal::Points& b)
{
  return (a - b).rowwise().norm().mean() * 180.0 / conformal::Pi;
}
}

#endif

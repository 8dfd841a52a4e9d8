/// Valid and optimal positions of a vertex inside the triangles around it on the sphere,
/// \cite Praun2003.

#ifndef ConformalSphereStar_h
#define ConformalSphereStar_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <array>
#include <optional>
#include <vector>

namespace conformal
{
/// Minimum determinant of a triangle, twice its minimum area. Larger triangles are not flipped if
/// other programs round unit vectors.
constexpr double MinimumDeterminant = 1e-13;

/// Energy of a map of a surface to the sphere. It is the sum over all triangles of
///     S ((S/A)^AreaExponent + AreaWeight (S/A)^2) (D/A)^AngleExponent
/// where S is the area of a triangle on the surface, scaled to the total area of the unit sphere. A
/// is the area of the triangle on the sphere, and D the Dirichlet energy of its map. D/A is at
/// least 1, and 1 for a conformal map. S/A is 1 everywhere for an equal-area map.
///
/// Implementation note: A is computed as half the determinant of the three unit vectors, slightly
/// less than the area. The energy thus grows without bound when a triangle approaches a flip. The
/// square of SmallArea is added to AreaWeight S^2. This addition matters only where areas would
/// otherwise underflow, as at the end of a long limb.
struct SphereEnergy
{
  double AreaExponent = 0.35;
  double AreaWeight = 0.005;
  int AngleExponent = 1; ///< exponent, at least 1
  double SmallArea = 10.0 * MinimumDeterminant;
};

/// Compute the determinant of three close unit vectors. It is positive if they are
/// counter-clockwise seen from outside. The formula uses differences to reduce rounding errors.
inline double determinant(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return a.dot((b - a).cross(c - a));
}

/// Properties of a triangle of the surface that SphereEnergy needs.
struct SourceTriangle
{
  double Area = 0.0;                  ///< area S
  std::array<double, 3> Cotangents{}; ///< cotangents of the angles, divided by 4
};

/// One of the triangles around a vertex v. Its corners are v, Neighbor, and the next neighbor.
struct Corner
{
  int Neighbor = 0;
  SourceTriangle Source; ///< properties of the triangle; its first corner is v
};

/// Find the centroid of the kernel of a star-shaped ring, projected from the center of the sphere.
/// The kernel consists of the points for which all sides of the ring are counter-clockwise.
/// @param[in] ring  ids of positions; seen from the first one, all other sides are
///   counter-clockwise
/// @return centroid; nothing if no point has all determinants >= MinimumDeterminant
std::optional<Vector3> kernelCentroid(const std::vector<Vector3>& positions, const Ring& ring);

/// Move a vertex by one step of Newton's method in its tangent plane. The step is shortened until
/// the energy of the triangles decreases and no triangle is flipped. If no step satisfies this, the
/// vertex is not moved.
/// @param[in,out] positions  unit vectors; only that of v is changed
/// @param[in] corners        triangles around v, counter-clockwise
void relaxVertex(std::vector<Vector3>& positions, int v, const Corner* corners, int size,
  const SphereEnergy& energy);

/// Compute the energy of the triangles around a vertex at a given position. It is infinite if a
/// triangle is flipped or too small.
double starEnergy(const std::vector<Vector3>& positions, const Vector3& place,
  const Corner* corners, int size, const SphereEnergy& energy);
}

#endif

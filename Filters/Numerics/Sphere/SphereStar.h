/// Find valid and optimal positions on the sphere for a vertex, while its neighbors are fixed,
/// \cite Praun2003. A position is valid if no triangle at the vertex is flipped.

#ifndef ConformalSphereStar_h
#define ConformalSphereStar_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace conformal
{
/// Minimum determinant of the three unit vectors of a triangle on the sphere. The determinant is
/// about twice the area. Triangles with a larger determinant keep their orientation, even if other
/// programs round the unit vectors.
constexpr double MinimumDeterminant = 1e-13;

/// Height of a triangle on the sphere over its longest side above which it keeps its orientation,
/// of any size. Rounding moves unit vectors by a thousandth of this height. The ends of long bodies
/// have triangles with much smaller determinants, but safe heights.
constexpr double MinimumSafeHeight = 1e-13;

/// Energy of a map of a surface to the sphere, with terms for angles and for areas. The energy is
/// the sum, over all triangles, of
///     S ((S/A)^AreaExponent + AreaWeight (S/A)^2) (D/A)^AngleExponent
/// where S is the area of a triangle on the surface. All areas S are scaled so that their total is
/// the area of the unit sphere. A is the area of the triangle on the sphere. D is the Dirichlet
/// energy of the map of the triangle: half the integral of its squared derivative. D/A is 1 if the
/// map is conformal, and larger otherwise. If the map preserves areas, S/A is 1 for all triangles.
///
/// Implementation note: A is computed as half the determinant of the three unit vectors, which is
/// slightly less than the area. As a triangle is about to flip, A tends to 0, and the energy to
/// infinity. In the formula, AreaWeight S^2 is replaced by AreaWeight S^2 + SmallArea^2. The added
/// term matters where areas are too small for double precision, for example at the end of a leg.
/// Elsewhere, the term is negligible.
struct SphereEnergy
{
  double AreaExponent = 0.35;
  double AreaWeight = 0.005;
  int AngleExponent = 1; ///< exponent of D/A, an integer of at least 1
  double SmallArea = 10.0 * MinimumDeterminant;
};

/// Compute the determinant of three close unit vectors a, b, c. The determinant is positive if they
/// are counter-clockwise seen from outside. The formula uses differences to reduce rounding errors.
inline double determinant(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return a.dot((b - a).cross(c - a));
}

/// Properties of a triangle of the surface that SphereEnergy needs.
struct SourceTriangle
{
  double Area = 0.0; ///< area S, see SphereEnergy
  /// Cotangents of the angles, divided by 4: coefficients of the squared edge lengths in D
  std::array<double, 3> Cotangents{};
};

/// Triangle at a vertex v. Its corners are v, Neighbor, and the next neighbor counter-clockwise.
struct Corner
{
  int Neighbor = 0;
  SourceTriangle Source; ///< properties of the triangle; its first corner is v
};

/// Find a valid position for a vertex inside the polygon of its neighbors (ring). The kernel of the
/// ring is the set of positions that form counter-clockwise triangles with all sides of the ring.
/// The result is the centroid of the kernel. To compute the centroid, the sphere is projected from
/// its center to a plane.
/// @param[in] ring  ids of the neighbors in `positions`. The first neighbor must form
///   counter-clockwise triangles with all sides of the ring that do not contain this neighbor.
/// @param[in] minimumHeight  height of a triangle over its longest side above which its determinant
///   may be smaller; by default, none may
/// @return unit vector, or no value if every position leaves a triangle with a determinant below
///   MinimumDeterminant
std::optional<Vector3> kernelCentroid(const std::vector<Vector3>& positions, const Ring& ring,
  double minimumHeight = std::numeric_limits<double>::infinity());

/// Move a vertex to a position of lower energy, by one step of Newton's method in the tangent plane
/// of the sphere. The step is shortened until the energy of the vertex's triangles decreases and no
/// triangle is flipped. If no step length satisfies these conditions, the vertex is not moved.
/// @param[in,out] positions  unit vectors of all vertices; only the unit vector of v is changed
/// @param[in] corners        triangles around v, counter-clockwise
void relaxVertex(std::vector<Vector3>& positions, int v, const Corner* corners, int size,
  const SphereEnergy& energy);

/// Compute the energy of the triangles around a vertex, if the vertex is at the position `place`.
/// If a triangle is flipped or too small, the result is infinite.
double starEnergy(const std::vector<Vector3>& positions, const Vector3& place,
  const Corner* corners, int size, const SphereEnergy& energy);
}

#endif

/// The star of a vertex on the sphere: feasible and optimal positions of the vertex.

#ifndef ConformalSphereStar_h
#define ConformalSphereStar_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <array>
#include <optional>
#include <vector>

namespace conformal
{
/// Twice the areas that are large enough to bear rounding to unit vectors in other programs.
constexpr double MinimumDeterminant = 1e-13;

/// Energy of a map from triangles to the sphere, a sum over triangles
///     S ((S/A)^AreaExponent + AreaWeight (S/A)^2) (D/A)^AngleExponent
/// S being the share of a triangle of the surface, A its area on the sphere and D the Dirichlet
/// energy of its map. D/A >= 1, and 1 is conformal; S/A = 1 everywhere is equal in area.
///
/// Implementation note: A is half the determinant of the three unit vectors, a little less than the
/// area, so that the energy grows beyond all bounds exactly where a triangle is about to flip. To
/// AreaWeight S^2 the square of SmallArea is added, which matters only where the map without it
/// would be smaller than numbers can bear, as at the end of a long limb.
struct SphereEnergy
{
  double AreaExponent = 0.35;
  double AreaWeight = 0.005;
  int AngleExponent = 1; ///< at least 1
  double SmallArea = 10.0 * MinimumDeterminant;
};

/// Determinant of three nearly equal unit vectors, positive where they are counter-clockwise seen
/// from outside. From differences, which keeps the digits.
inline double determinant(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return a.dot((b - a).cross(c - a));
}

/// What the energy needs to know of a triangle of the surface.
struct SourceTriangle
{
  double Area = 0.0;                  ///< S
  std::array<double, 3> Cotangents{}; ///< of the corners' angles, over four
};

/// The triangle (v, Neighbor, next neighbor) as vertex v sees it.
struct Corner
{
  int Neighbor = 0;
  SourceTriangle Source; ///< v's corner first
};

/// A point inside the star-shaped polygon of a ring, from which all its sides are seen
/// counter-clockwise: the centroid, as seen from the sphere's center, of all such points.
/// @param[in] ring       ids of positions, the first one seeing all others so
/// @return nothing if there is no point whose determinants are all >= MinimumDeterminant
std::optional<Vector3> kernelCentroid(const std::vector<Vector3>& positions, const Ring& ring);

/// Move a vertex by one step of Newton's method in its tangent plane, shortened until the energy of
/// its triangles falls and none of them is flipped; it stays where no such step is found.
/// @param[in,out] positions  unit vectors
/// @param[in] corners        around v, counter-clockwise
void relaxVertex(std::vector<Vector3>& positions, int v, const Corner* corners, int size,
  const SphereEnergy& energy);

/// Energy of the triangles around a place, infinite if one of them is flipped or too small.
double starEnergy(const std::vector<Vector3>& positions, const Vector3& place,
  const Corner* corners, int size, const SphereEnergy& energy);
}

#endif

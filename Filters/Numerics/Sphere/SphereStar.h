/// Feasible and optimal positions of a vertex in its star on the sphere, \cite Praun2003.

#ifndef ConformalSphereStar_h
#define ConformalSphereStar_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <array>
#include <optional>
#include <vector>

namespace conformal
{
/// Twice the minimum area of a triangle that survives rounding to unit vectors in other programs.
constexpr double MinimumDeterminant = 1e-13;

/// Energy of a map from triangles to the sphere, a sum over triangles
///     S ((S/A)^AreaExponent + AreaWeight (S/A)^2) (D/A)^AngleExponent
/// S is the share of a triangle in the area of the surface, A its area on the sphere. D is the
/// Dirichlet energy of its map. D/A >= 1, with equality for a conformal map. S/A = 1 everywhere for
/// an equal-area map.
///
/// Implementation note: A is half the determinant of the three unit vectors, slightly less than the
/// area. The energy thus grows without bound exactly where a triangle is about to flip. The square
/// of SmallArea is added to AreaWeight S^2. It matters only where areas would otherwise underflow,
/// as at the end of a long limb.
struct SphereEnergy
{
  double AreaExponent = 0.35;
  double AreaWeight = 0.005;
  int AngleExponent = 1; ///< at least 1
  double SmallArea = 10.0 * MinimumDeterminant;
};

/// Compute the determinant of three close unit vectors, positive if counter-clockwise seen from
/// outside. Differences preserve the digits.
inline double determinant(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return a.dot((b - a).cross(c - a));
}

/// Properties of a triangle of the surface for the energy.
struct SourceTriangle
{
  double Area = 0.0;                  ///< S
  std::array<double, 3> Cotangents{}; ///< cotangents of the angles over four
};

/// Triangle (v, Neighbor, next neighbor) around a vertex v.
struct Corner
{
  int Neighbor = 0;
  SourceTriangle Source; ///< corner at v first
};

/// Find the centroid of the kernel of a star-shaped ring, as projected from the center of the
/// sphere. From each point of the kernel, all sides of the ring are counter-clockwise.
/// @param[in] ring  ids of positions; from the first one all other sides are counter-clockwise
/// @return nothing if there is no point with all determinants >= MinimumDeterminant
std::optional<Vector3> kernelCentroid(const std::vector<Vector3>& positions, const Ring& ring);

/// Move a vertex by one step of Newton's method in its tangent plane. The step is shortened until
/// the energy of the triangles decreases and none is flipped. Without such a step the vertex stays.
/// @param[in,out] positions  unit vectors
/// @param[in] corners        around v, counter-clockwise
void relaxVertex(std::vector<Vector3>& positions, int v, const Corner* corners, int size,
  const SphereEnergy& energy);

/// Compute the energy of the triangles around a position, infinite if one of them is flipped or too
/// small.
double starEnergy(const std::vector<Vector3>& positions, const Vector3& place,
  const Corner* corners, int size, const SphereEnergy& energy);
}

#endif

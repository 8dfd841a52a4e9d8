/// Interpolate values between the vertices of a sphere mesh.
///
/// Own construction, not from a publication: interpolation weights are computed together with their
/// gradients. Registration needs these gradients to minimize energies of interpolated values.

#ifndef ConformalSphereSamples_h
#define ConformalSphereSamples_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Sphere/SphereLocator.h"

namespace conformal
{
/// Matrix with one row for each vertex or direction. A direction is a unit vector, a point of the
/// unit sphere. Rows are contiguous in memory, so that reading a row is fast.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Barycentric weights of a direction, and their gradients. The weights refer to the triangle of a
/// sphere mesh that contains the direction.
struct SphereWeights
{
  int Triangle = -1;                 ///< id of the triangle
  std::array<int, 3> Ids{};          ///< corners of the triangle
  Vector3 Weights = Vector3::Zero(); ///< weights of the corners, with sum 1
  /// Row k: gradient of the weight of corner k with respect to the direction.
  Eigen::Matrix3d Slopes = Eigen::Matrix3d::Zero();
};

/// Sphere mesh with a search structure that finds the triangle containing a direction. Several
/// threads may search concurrently.
class SphereGrid
{
public:
  SphereGrid() = default;
  explicit SphereGrid(Mesh sphere, const Run& run = {});

  const Mesh& mesh() const { return this->Sphere; }
  /// Return the number of vertices.
  Index size() const { return this->Sphere.Positions.rows(); }

  /// Compute the interpolation weights in a direction.
  /// @param[in] hint  triangle that is probably near the direction, for a faster search; or -1
  SphereWeights weightsAt(const Vector3& direction, int hint = -1) const;

private:
  Mesh Sphere;
  SphereLocator Locator;
};

/// Interpolate values in given directions, linearly in each triangle of a sphere mesh.
/// @param[in] values      one row for each vertex of the grid
/// @param[in] directions  #N by 3
/// @return #N rows of interpolated values
Rows sampleAt(
  const SphereGrid& grid, const Rows& values, const Points& directions, const Run& run = {});
}

#endif

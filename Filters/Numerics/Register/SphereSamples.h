/// Interpolate values at the vertices of a geodesic sphere. Own construction: weights are returned
/// with their gradients, because descents need derivatives.

#ifndef ConformalSphereSamples_h
#define ConformalSphereSamples_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Sphere/SphereLocator.h"

namespace conformal
{
/// Matrix with one row for each vertex or direction. It is stored row by row, so that a lookup
/// reads contiguous memory.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Barycentric weights of a direction in a triangle of a sphere mesh, and their gradients.
struct SphereWeights
{
  int Triangle = -1;
  std::array<int, 3> Ids{};
  Vector3 Weights = Vector3::Zero();
  Eigen::Matrix3d Slopes = Eigen::Matrix3d::Zero(); ///< row k: gradient of weight k
};

/// Sphere mesh for point location. Queries only read, so several threads may query concurrently.
class SphereGrid
{
public:
  SphereGrid() = default;
  explicit SphereGrid(Mesh sphere, const Run& run = {});

  const Mesh& mesh() const { return this->Sphere; }
  Index size() const { return this->Sphere.Positions.rows(); }

  /// @param[in] hint  triangle that may be close, which reduces the cost; or -1
  SphereWeights weightsAt(const Vector3& direction, int hint = -1) const;

private:
  Mesh Sphere;
  SphereLocator Locator;
};

/// Interpolate values in given directions.
/// @param[in] values  values with one row for each vertex of the grid
Rows sampleAt(
  const SphereGrid& grid, const Rows& values, const Points& directions, const Run& run = {});
}

#endif

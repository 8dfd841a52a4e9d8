/// Values at the vertices of a geodesic sphere, linear in between.
/// Own construction: linear interpolation with a derivative, for descents.

#ifndef ConformalSphereSamples_h
#define ConformalSphereSamples_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Sphere/SphereLocator.h"

namespace conformal
{
/// One row for each vertex or direction, so that a lookup reads one piece of memory.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A triangle of a sphere mesh seen from a direction in it: weights of its corners, and how they
/// change with the direction.
struct SphereWeights
{
  int Triangle = -1;
  std::array<int, 3> Ids{};
  Vector3 Weights = Vector3::Zero();
  Eigen::Matrix3d Slopes = Eigen::Matrix3d::Zero(); ///< row k: gradient of weight k
};

/// A sphere mesh in which directions are looked up. Only reads; many threads may ask at once.
class SphereGrid
{
public:
  SphereGrid() = default;
  explicit SphereGrid(Mesh sphere, const Run& run = {});

  const Mesh& mesh() const { return this->Sphere; }
  Index size() const { return this->Sphere.Positions.rows(); }

  /// @param[in] hint  a triangle that may be near, or -1
  SphereWeights weightsAt(const Vector3& direction, int hint = -1) const;

private:
  Mesh Sphere;
  SphereLocator Locator;
};

/// Values in given directions.
/// @param[in] values  one row for each vertex of the grid
Rows sampleAt(
  const SphereGrid& grid, const Rows& values, const Points& directions, const Run& run = {});
}

#endif

/// Compute the deformation gradient of each triangle of a surface, \cite Sumner2004.

#ifndef ConformalDeformationGradients_h
#define ConformalDeformationGradients_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Deformation gradients of a surface, for any number of its deformed shapes (poses). The gradient
/// of a triangle is the matrix S = W V^-1, \cite Sumner2004 Eq. 4. The columns of V are two edges
/// of the triangle at rest, and the vector from its first corner to a fourth vertex. W contains the
/// same vectors after the deformation. The fourth vertex is above the triangle, at the distance of
/// the square root of twice its area, \cite Sumner2004 Eq. 1. Thus S = s I if the surface grows by
/// the factor s.
///
/// Implementation note: the gradient of a triangle without area is not defined. It gets the
/// gradient of the closest triangle with area, counted in triangles across edges.
class DeformationGradients
{
public:
  DeformationGradients() = default;

  /// @param[in] rest  surface at rest; finite positions. Triangles may have no area.
  /// @throws std::invalid_argument if no triangle has an area
  explicit DeformationGradients(const Mesh& rest, const Run& run = {});

  /// Compute the gradients from the shape at rest to a deformed shape.
  /// @param[in] pose  #V by 3, vertices of the deformed shape
  /// @return #F matrices
  /// @throws Aborted
  std::vector<Eigen::Matrix3d> of(const Points& pose, const Run& run = {}) const;

private:
  conformal::Triangles Triangles;
  std::vector<Eigen::Matrix3d> Inverses; // V^-1 of each triangle
  std::vector<int> Donors;               // triangle whose gradient is used for each triangle
};
}

#endif

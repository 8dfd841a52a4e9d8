/// Measure the mean curvature of triangle meshes, averaged over disks.

#ifndef ConformalMeanCurvature_h
#define ConformalMeanCurvature_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Measure the mean curvature of a triangle mesh at given triangles.
///
/// The mean curvature of a surface with the unit normal n is H = div(n) / 2, the mean of the two
/// principal curvatures. For outward normals, H is positive on a ridge, and 1 / r on a sphere of
/// radius r. On a triangle, n is interpolated linearly from the normals n_i at its corners. Let N
/// be the normal of the triangle, A its area, and e_i the edge opposite to corner i. Then
///
///     H = sum_i n_i . (N x e_i) / (4 A)
///
/// The normals n_i are those of \cite Max1999, which are exact if a vertex and its neighbors lie on
/// a sphere. The average over a disk depends little on the size of the triangles.
class MeanCurvature
{
public:
  /// @param[in] points  #V by 3 positions
  /// @param[in] triangles  #F by 3 ids; kept by reference. Neighbors are found by shared ids.
  MeanCurvature(const Points& points, const Triangles& triangles, const Run& run = {});

  /// Memory of one thread for disks.
  struct Memory
  {
    std::vector<int> Found;
    std::vector<bool> IsFound; ///< for each triangle; all false between calls
  };

  /// Return the mean of H, weighted by area, over a disk: the triangles whose centroids are closer
  /// to `center` than `radius`, as far as they are connected to `triangle`, and `triangle` itself.
  /// @param[in] center  position on the triangle
  /// @param[in,out] memory  reused by further calls for the same mesh
  /// @return the mean; 0 if all areas are 0
  double over(const Vector3& center, Index triangle, double radius, Memory& memory) const;

private:
  const conformal::Triangles& Triangles;
  Adjacency Around;
  Points Centroids;
  Eigen::VectorXd Areas, Values; // H at each triangle
};
}

#endif

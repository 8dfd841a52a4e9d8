/// Set up the equations of fairing (FairFit.h): squared distances of samples to a mesh, and the
/// change of mean curvature over the mesh. Own construction, since the moves of vertices along
/// their normals are the only unknowns. The Laplacian for the curvature is that
/// of \cite Pinkall1993.

#ifndef ConformalFairEquations_h
#define ConformalFairEquations_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshTopology.h"

#include <functional>
#include <vector>

namespace conformal
{
constexpr Index NumberOfProbes = 8; ///< number of random vectors that represent a covariance

/// Symmetric tensors, one for each vertex, #V by 6. The columns are xx, yy, zz, yz, xz and xy.
using Tensors = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Options that select the samples to which the surface is fitted.
struct FairSamplesOptions
{
  double OutlierRatio = 6.0;       ///< limit of the distance of a sample, see LocalScale.h
  Index SamplesPerRound = 1000000; ///< maximum number of samples; a larger cloud is thinned
  unsigned int RandomSeed = 1;     ///< seed of the choice of samples
  /// Test whether a sample is used. If empty, all samples are used.
  std::function<bool(const Vector3&)> Belongs;
};

/// Represent the squared distances of samples to a mesh, as a function of the moves u of the
/// vertices along their normals. The distances are linearized. The squared distances of the samples
/// with foot points (closest points) in triangle r are then u A_r u - 2 u g_r + s_r.
class SampleDistances
{
public:
  /// @param[in] normals  vertex normals, #V by 3
  /// @param[in] neighbors  result of vertexNeighbors() for the triangles of the mesh
  /// @throws Aborted
  /// @post the same bits for any number of threads and ranks
  SampleDistances(const TrainingSamples& samples, const FairSamplesOptions& options,
    const Mesh& mesh, const Points& normals, const Adjacency& neighbors, const Run& run = {});

  /// Sum of the squared distances over all triangles, each multiplied by a precision: u A u - 2 u g
  /// + s. The precision of a triangle is the inverse of the variance of its samples.
  struct Sum
  {
    SparseMatrix Matrix;   ///< A
    Eigen::VectorXd Right; ///< g
    double Constant = 0.0; ///< s
    /// Random vectors with covariance A. For noise of variance 1, g has the same covariance.
    Columns Probes;
  };
  /// @param[in] precisions  precision at each vertex, #V; a triangle has the mean of its corners
  Sum sum(const Eigen::VectorXd& precisions) const;

  /// Compute the squared distances after the given moves. Each corner of a triangle gets a third of
  /// the sum of the triangle.
  Eigen::VectorXd squaresAt(const Eigen::VectorXd& displacements) const;

  /// Compute the expected increase of the squared distances by random moves of mean zero.
  Eigen::VectorXd increaseAt(const Eigen::VectorXd& deviations) const;

  /// Return the number of samples.
  double count() const { return this->Count; }
  /// Return the number of samples at each vertex. Each corner of a triangle gets a third of the
  /// samples of the triangle.
  Eigen::VectorXd countsAt() const;

  /// Return the sum of the weights of all samples.
  double mass() const { return this->Mass; }

  /// Return the sum of the weights of the samples in each triangle, #F.
  const std::vector<double>& masses() const { return this->Masses; }

private:
  struct OfTriangle
  {
    Eigen::Matrix3d Products = Eigen::Matrix3d::Zero();
    Vector3 Right = Vector3::Zero();
    double Constant = 0.0, Count = 0.0;
  };
  /// Compute u A_r u + factor (s_r - 2 u g_r) for each triangle, and add a third to each corner.
  Eigen::VectorXd quadraticAt(const Eigen::VectorXd& u, double factor) const;

  Triangles Corners;
  Index Size; // number of vertices
  std::vector<OfTriangle> Sums;
  std::vector<double> Masses;
  double Count = 0.0, Mass = 0.0;
};

/// Represent the mean curvature of a mesh as a linear function h + C u of the moves u of the
/// vertices along their normals. The matrix is C = M^-1 L. L is the Laplacian of
/// \cite Pinkall1993 and M contains the areas around the vertices.
///
/// The flat triangles of a fitted mesh pass through the middle of the samples. On ridges, the
/// vertices are therefore outside of the object. The curvature h is that of the smooth surface,
/// whose vertices are moved inward there (lowerVertices() of Surface/CurvedTriangles.h).
class CurvatureChange
{
public:
  CurvatureChange(const Mesh& mesh, const Points& normals);

  /// Compute g g^T at each vertex, where g is the gradient of the curvature h + C u. The tensor is
  /// integrated over a third of the triangles around the vertex.
  Tensors squaresAt(const Eigen::VectorXd& displacements) const;
  /// Compute the tensors of squaresAt() for the curvature C u, without h.
  Tensors homogeneousSquaresAt(const Eigen::VectorXd& deviations) const;

  /// Penalty of the change of curvature: the sum of squared gradients, divided by the variances of
  /// the gradients. As a function of the moves u, the penalty is u K u + 2 u f + constant.
  struct Energy
  {
    SparseMatrix Matrix;   ///< K
    Eigen::VectorXd Force; ///< f
    Columns Probes;        ///< random vectors with covariance K
  };
  /// @param[in] variances  expected value of the tensors of squaresAt(), not zero
  /// @param[in] sharp  whether each vertex is on a crease, #V. Triangles at such a vertex have only
  ///   a small weight, which keeps the equations regular.
  Energy energy(const Tensors& variances, const std::vector<bool>& sharp) const;

private:
  Tensors squaresOf(const Eigen::VectorXd& curvatures) const;

  Triangles Corners;
  /// Gradients of the barycentric coordinates of each triangle, multiplied by the square root of
  /// the area.
  std::vector<Eigen::Matrix3d> Slopes;
  Eigen::VectorXd Curvatures; // h
  SparseMatrix Change;        // C
};
}

#endif

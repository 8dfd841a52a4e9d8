/// Set up the equations of fairing, which removes noise from a mesh fitted to samples (FairFit.h).
/// Fairing minimizes the squared distances of the samples to the mesh, plus the change of mean
/// curvature along the mesh. Own construction, in which the only unknowns are the moves of the
/// vertices along their normals. The curvature is computed with the Laplacian of \cite Pinkall1993.

#ifndef ConformalFairEquations_h
#define ConformalFairEquations_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshTopology.h"

#include <array>
#include <functional>
#include <vector>

namespace conformal
{
constexpr Index NumberOfProbes = 8; ///< number of random vectors that represent a covariance matrix

/// Symmetric 3 by 3 tensors, one for each of #V vertices, #V by 6. The columns are xx, yy, zz, yz,
/// xz and xy.
using Tensors = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Symmetric 3 by 3 matrix: entries 00, 01, 02, 11, 12 and 22
using SymmetricMatrix = std::array<double, 6>;

/// Options that select the samples to which the surface is fitted.
struct FairSamplesOptions
{
  /// A sample is an outlier if its distance from the surface exceeds the usual distance of nearby
  /// samples by this factor. Outliers are ignored. See LocalScale.h.
  double OutlierRatio = 6.0;
  Index SamplesPerRound = 1000000; ///< maximum number of samples, selected at random
  unsigned int RandomSeed = 1;     ///< seed of the selection of samples
  /// Test whether a sample is used. If empty, all samples are used.
  std::function<bool(const Vector3&)> Belongs;
};

/// Squared distances of samples to a mesh, as a function of the moves u of the vertices along their
/// normals. Each distance is measured along the normal, and is a linear function of u. The foot
/// point of a sample is its closest point on the mesh. The samples with foot points in triangle r
/// have a sum of squared distances of u A_r u - 2 u g_r + s_r, with a matrix A_r, a vector g_r and
/// a number s_r.
class SampleDistances
{
public:
  /// @param[in] mesh  mesh whose triangles must outlive this object
  /// @param[in] normals  vertex normals, #V by 3
  /// @param[in] neighbors  result of vertexNeighbors() for the triangles of the mesh
  /// @throws Aborted
  /// @post The result does not depend on the number of threads or ranks (processes), bit by bit.
  SampleDistances(const TrainingSamples& samples, const FairSamplesOptions& options,
    const Mesh& mesh, const Points& normals, const Adjacency& neighbors, const Run& run = {});

  /// Sum of the squared distances of all samples, weighted by the precision of their triangles. As
  /// a function of u, the sum is u A u - 2 u g + s. A precision is the inverse of the variance of
  /// the noise, up to a common factor.
  struct Sum
  {
    SparseMatrix Matrix;   ///< A
    Eigen::VectorXd Right; ///< g
    double Constant = 0.0; ///< s
    /// Random vectors with covariance A. If the variance of the noise is 1 / precision, A is also
    /// the covariance of g.
    Columns Probes;
  };
  /// @param[in] precisions  precision at each vertex, #V. The precision of a triangle is the mean
  ///   of the precisions at its corners.
  /// @param[in] numberOfProbes  number of random vectors, at most NumberOfProbes
  Sum sum(const Eigen::VectorXd& precisions, Index numberOfProbes = NumberOfProbes,
    const Run& run = {}) const;

  /// Compute the sum of squared distances at each vertex after the given moves, #V. Each triangle
  /// contributes a third of its sum to each of its corners.
  Eigen::VectorXd squaresAt(const Eigen::VectorXd& displacements) const;

  /// Compute the part of squaresAt() that is quadratic in the moves. If the moves are random with
  /// mean zero, the mean of this part is the expected increase of squaresAt().
  /// @param[in] deviations  random move of each vertex along its normal, #V
  Eigen::VectorXd increaseAt(const Eigen::VectorXd& deviations) const;

  /// Return the number of samples.
  double count() const { return this->Count; }
  /// Return the number of samples at each vertex, #V. Each triangle contributes a third of its
  /// samples to each of its corners.
  Eigen::VectorXd countsAt() const;

  /// Return the sum of the weights of all samples.
  double mass() const { return this->Mass; }

  /// Return the sum of the weights of the samples in each triangle, #F.
  const std::vector<double>& masses() const { return this->Masses; }

private:
  struct OfTriangle
  {
    SymmetricMatrix Products{};
    Vector3 Right = Vector3::Zero();
    double Constant = 0.0, Count = 0.0;
  };
  /// Compute u A_r u + factor (s_r - 2 u g_r) for each triangle r, and add a third of this value to
  /// each corner.
  Eigen::VectorXd quadraticAt(const Eigen::VectorXd& u, double factor) const;

  const Triangles& Corners;
  Index Size; // number of vertices
  std::vector<OfTriangle> Sums;
  std::vector<double> Masses;
  double Count = 0.0, Mass = 0.0;
};

/// Mean curvature of a mesh, as a linear function h + C u of the moves u of the vertices along
/// their normals. The vector h is the curvature before the moves. The matrix is C = M^-1 L. Here L
/// is the Laplacian of \cite Pinkall1993, and M is the diagonal matrix of the areas around the
/// vertices.
///
/// On a ridge, the flat triangles of a fitted mesh intersect the object: their corners are outside,
/// and their centers are inside. To compute h, the vertices are first moved onto a smooth surface,
/// on ridges inward (lowerVertices() of Surface/CurvedTriangles.h).
class CurvatureChange
{
public:
  /// @param[in] mesh  mesh whose triangles must outlive this object
  CurvatureChange(const Mesh& mesh, const Points& normals, const Run& run = {});

  /// Compute the tensor g g^T at each vertex, where g is the gradient of the curvature h + C u. The
  /// tensor is integrated over a third of the area of each triangle around the vertex.
  Tensors squaresAt(const Eigen::VectorXd& displacements, const Run& run = {}) const;
  /// Compute the tensors g g^T of squaresAt() for the curvature C u, without h.
  Tensors homogeneousSquaresAt(const Eigen::VectorXd& deviations, const Run& run = {}) const;

  /// Penalty for the change of curvature. The penalty is a sum over all triangles: the squared
  /// gradient of the curvature, divided by the variance of this gradient. As a function of the
  /// moves u, the penalty is u K u + 2 u f + constant.
  struct Energy
  {
    /// Return K, or the rows and columns of K for some vertices. K couples three rings of
    /// neighbors, and needs more memory than its factors.
    SparseMatrix matrix() const;
    SparseMatrix principalPart(const std::vector<int>& ids) const;
    /// Return the sum of the diagonal of K.
    double trace() const;

    const SparseMatrix* Change = nullptr; ///< C, of the CurvatureChange
    SparseMatrix Differences;             ///< D, where K = C^T D C
    Eigen::VectorXd Force;                ///< f
    Columns Probes;                       ///< random vectors with covariance K
  };
  /// @param[in] variances  expected value of the tensors of squaresAt(), not zero
  /// @param[in] sharp  whether each vertex is on a crease (sharp edge of the object), #V. Triangles
  ///   at a crease have the relative weight 0.0001, which keeps the equations regular.
  /// @param[in] numberOfProbes  number of random vectors, at most NumberOfProbes
  Energy energy(const Tensors& variances, const std::vector<bool>& sharp,
    Index numberOfProbes = NumberOfProbes, const Run& run = {}) const;

private:
  Tensors squaresOf(const Eigen::VectorXd& curvatures, const Run& run) const;
  /// Compute the gradients of the barycentric coordinates of a triangle, multiplied by the square
  /// root of the area.
  Eigen::Matrix3d slopesOf(Index r) const;

  const Triangles& Corners;
  const Points Places;        // vertices moved onto a smooth surface
  double SmallestArea = 0.0;  // of a triangle
  Eigen::VectorXd Curvatures; // h
  SparseMatrix Change;        // C
};
}

#endif

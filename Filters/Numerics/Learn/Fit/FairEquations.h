/// Equations of fairing: squared distances of samples, and the change of curvature of a mesh; own
/// construction.

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
constexpr Index NumberOfProbes = 8; ///< random vectors for covariances

/// Symmetric tensors of the vertices, #V by 6: xx, yy, zz, yz, xz, xy.
using Tensors = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Which samples count.
struct FairSamplesOptions
{
  double OutlierRatio = 6.0;                   ///< see LocalScale.h
  Index SamplesPerRound = 1000000;             ///< of a larger cloud
  unsigned int RandomSeed = 1;                 ///< of the choice of these samples
  std::function<bool(const Vector3&)> Belongs; ///< whether a sample counts; empty for all
};

/// What samples ask of the vertices of a mesh that move by u along their normals. Linearized, the
/// squared distances in a triangle are u A_r u - 2 u g_r + s_r.
class SampleDistances
{
public:
  /// @param[in] normals    #V by 3, of the vertices
  /// @param[in] neighbors  vertexNeighbors of the triangles
  /// @throws Aborted
  /// @post the same bits for any number of threads and ranks
  SampleDistances(const TrainingSamples& samples, const FairSamplesOptions& options,
    const Mesh& mesh, const Points& normals, const Adjacency& neighbors, const Run& run = {});

  /// Sum over the triangles, each times its precision: u A u - 2 u g + s.
  struct Sum
  {
    SparseMatrix Matrix;   ///< A
    Eigen::VectorXd Right; ///< g
    double Constant = 0.0; ///< s
    Columns Probes;        ///< random vectors of covariance A, which is that of g for noise of 1
  };
  /// @param[in] precisions  #V; a triangle has the mean of its corners
  Sum sum(const Eigen::VectorXd& precisions) const;

  /// Squared distances after displacements; a third of a triangle's at each of its corners.
  Eigen::VectorXd squaresAt(const Eigen::VectorXd& displacements) const;

  /// Mean increase of the squared distances by random deviations of mean zero.
  Eigen::VectorXd increaseAt(const Eigen::VectorXd& deviations) const;

  /// Number of the samples; their number at each vertex, a third of a triangle's at each corner.
  double count() const { return this->Count; }
  Eigen::VectorXd countsAt() const;

  /// Weight of the samples.
  double mass() const { return this->Mass; }

  /// #F, weight of the samples that have their foot points in each triangle.
  const std::vector<double>& masses() const { return this->Masses; }

private:
  struct OfTriangle
  {
    Eigen::Matrix3d Products = Eigen::Matrix3d::Zero();
    Vector3 Right = Vector3::Zero();
    double Constant = 0.0, Count = 0.0;
  };
  /// u A_r u + factor (s_r - 2 u g_r), a third at each corner.
  Eigen::VectorXd quadraticAt(const Eigen::VectorXd& u, double factor) const;

  Triangles Corners;
  Index Size; // of the vertices
  std::vector<OfTriangle> Sums;
  std::vector<double> Masses;
  double Count = 0.0, Mass = 0.0;
};

/// Mean curvature of a mesh, and how it changes with displacements u along the normals: h + C u
/// with C = M^-1 L, the Laplacian of \cite Pinkall1993.
///
/// The mesh is one that was fitted by least squares. Its flat triangles lie in the middle of the
/// samples, its vertices outside of ridges: h is that of a smooth surface with its vertices moved
/// back.
class CurvatureChange
{
public:
  CurvatureChange(const Mesh& mesh, const Points& normals);

  /// Compute the squared gradients of the curvature h + C u at each vertex: the integral of the
  /// tensor over a third of the triangles around the vertex.
  Tensors squaresAt(const Eigen::VectorXd& displacements) const;
  /// Compute the squared gradients of C u at each vertex.
  Tensors homogeneousSquaresAt(const Eigen::VectorXd& deviations) const;

  /// Energy of third order, the sum of squared gradients divided by their variances,
  /// u K u + 2 u f + constant. It is zero for spheres and cylinders.
  struct Energy
  {
    SparseMatrix Matrix;   ///< K
    Eigen::VectorXd Force; ///< f
    Columns Probes;        ///< random vectors of covariance K
  };
  /// @param[in] variances  expected squares at each vertex, not zero. They differ by direction, so
  ///   that a ridge is smoothed along, but not across.
  /// @param[in] sharp      #V, vertices on creases; the energy is not summed around them, except
  ///   for a small share that keeps the equations regular
  Energy energy(const Tensors& variances, const std::vector<bool>& sharp) const;

private:
  Tensors squaresOf(const Eigen::VectorXd& curvatures) const;

  Triangles Corners;
  /// For each triangle, gradients of the barycentric weights times the square root of its area.
  std::vector<Eigen::Matrix3d> Slopes;
  Eigen::VectorXd Curvatures; // h
  SparseMatrix Change;        // C
};
}

#endif

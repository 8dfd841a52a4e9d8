/// Fit the vertices of a triangle mesh to samples of a surface by least squares.
///
/// Own construction: the fit minimizes the squared-distance function of \cite Pottmann2006, but
/// omits the curvature term of this function. Without this term, a few iterations still suffice.

#ifndef ConformalLeastSquaresFit_h
#define ConformalLeastSquaresFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Fit/LearnedMesh.h"
#include "Search/TriangleTree.h"

#include <functional>
#include <memory>
#include <vector>

namespace conformal
{
/// Options of leastSquaresFit(). The fit minimizes an energy, a sum of terms for the distances of
/// samples, and smoothness terms. The mean mass is the total weight of the samples that are used,
/// divided by the number of vertices. The smoothness is the weight of the smoothness terms at a
/// vertex, divided by the mean mass.
struct LeastSquaresFitOptions
{
  int Iterations = 10; ///< number of iterations
  /// Smoothness in the first iteration. Between the first and the last iteration, the smoothness
  /// changes by a constant factor per iteration.
  double FirstSmoothness = 0.01;
  double LastSmoothness = 0.01; ///< smoothness in the last iteration
  /// Factor by which the smoothness is multiplied in directions along the surface. A value above 1
  /// makes the triangles more nearly equilateral.
  double Evenness = 1.0;
  /// A sample is an outlier if its distance from the surface exceeds the usual distance of nearby
  /// samples by this factor. See LocalScale.h.
  double OutlierRatio = 6.0;

  /// Whether samples farther from the surface have larger weights. With larger weights, the fit
  /// reaches the ends of limbs (thin parts). The weight of a sample is its distance from the
  /// surface, divided by the root mean square distance, clamped to [0.3, 2.8].
  ///
  /// If Guide (see below) is null, this option also moves vertices without samples nearby. In the
  /// second half of the iterations, these vertices are pulled along their normals toward their
  /// nearest samples. By this pull, a surface that covers a hollow moves into the hollow.
  bool AutomaticPriority = true;

  /// Surface to which vertices without samples are pulled along their normals, or null. The weight
  /// of the pull is a tenth of the mean mass. Vertices over holes in the samples are not pulled if
  /// the holes are wider than eight edge lengths of the mesh.
  std::shared_ptr<const TriangleTree> Guide;

  /// Maximum number of samples in an iteration. Each iteration uses different samples.
  Index SamplesPerIteration = 1000000;
  unsigned int RandomSeed = 1; ///< seed of the selection of samples
  /// Function that returns whether a sample is used; if empty, all samples are used.
  std::function<bool(const Vector3&)> Belongs;
};

/// Fit the vertices of a mesh to samples.
///
/// Each iteration selects samples, and projects each of them to its foot point, the closest point
/// on the surface. Then the vertices are moved to minimize the energy of SurfaceEquations.h. This
/// energy has terms for the distances of the samples, and smoothness terms. The weight of the
/// smoothness terms at a vertex is called the stiffness of the vertex. The stiffness is the
/// smoothness times the mean mass, see LeastSquaresFitOptions. At vertices without samples nearby,
/// the stiffness is larger, so that the surface is interpolated there. In the last five iterations,
/// the stiffness is also larger at folds. At a fold, normals of neighboring triangles differ by
/// more than 90 degrees.
///
/// Outliers are ignored: samples much farther from the surface than neighboring samples
/// (LocalScale.h).
///
/// @param[in,out] mesh  mesh in the coordinates of the samples. The samples are scaled to a maximum
///   distance of 1 from their centroid. One record per iteration is appended to mesh.History.
/// @return for each triangle, the total weight of the samples projected to this triangle in the
///   last iteration. Without iterations, all values are 0.
/// @throws Aborted
std::vector<double> leastSquaresFit(const TrainingSamples& samples,
  const LeastSquaresFitOptions& options, LearnedMesh& mesh, const Run& run = {});
}

#endif

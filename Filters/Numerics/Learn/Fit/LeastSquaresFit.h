/// Fit the vertices of a triangle mesh to samples by least squares. This is the last stage of batch
/// training. Own construction: the squared distance of \cite Pottmann2006 is used without its
/// curvature term, because a few iterations suffice with it.

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
struct LeastSquaresFitOptions
{
  int Iterations = 10;
  /// Smoothness of the first iteration; then it changes geometrically.
  double FirstSmoothness = 0.01;
  double LastSmoothness = 0.01; ///< smoothness of the last iteration
  double Evenness = 1.0;        ///< weight of even triangles, see SurfaceEquations.h
  double OutlierRatio = 6.0;    ///< limit for outliers, see LocalScale.h

  /// Whether to weight samples by distance, so that the fit reaches limb ends. The weight is the
  /// distance from the surface divided by the root mean square distance, clamped to [0.3, 2.8].
  /// Without a Guide, each vertex without samples is also pulled along its normal to the nearest
  /// sample. This moves fillings over hollows inward.
  bool AutomaticPriority = true;

  /// Surface that guides vertices between samples that are far apart, or null. Vertices without
  /// samples are pulled to this surface along their normals, with a tenth of the weight of a
  /// vertex's samples. Vertices over holes wider than eight edges are not pulled.
  std::shared_ptr<const TriangleTree> Guide;

  /// Maximum number of samples in an iteration; each iteration selects others.
  Index SamplesPerIteration = 1000000;
  unsigned int RandomSeed = 1; ///< seed of this selection
  /// Test whether to use a sample; if empty, all are used.
  std::function<bool(const Vector3&)> Belongs;
};

/// Fit the vertices of a mesh to samples.
///
/// Each iteration finds the foot point of every sample on the surface. It then moves the vertices
/// to minimize the sum of SurfaceEquations.h. The stiffness in this sum is the smoothness times the
/// mean weight of a vertex's samples. The stiffness is increased at vertices without samples
/// nearby, where the surface is interpolated. In the last iterations, it is also increased at
/// folds.
///
/// Outliers are ignored: samples much farther from the surface than their neighbors (LocalScale.h).
///
/// @param[in,out] mesh  mesh with vertices in the samples' unit; its history gets one record per
///   iteration
/// @return for each triangle, the total weight of the samples with foot points in it, in the last
///   iteration; zeros if there are no iterations
/// @throws Aborted
std::vector<double> leastSquaresFit(const TrainingSamples& samples,
  const LeastSquaresFitOptions& options, LearnedMesh& mesh, const Run& run = {});
}

#endif

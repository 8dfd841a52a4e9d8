/// Least-squares fit of the vertices of a triangle mesh to samples, the last stage of batch
/// training; own construction on the squared distance of \cite Pottmann2006.

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
  double FirstSmoothness = 0.01; ///< in the first iteration, then decreasing geometrically
  double LastSmoothness = 0.01;  ///< in the last iteration
  double Evenness = 1.0;         ///< of triangles, see SurfaceEquations.h
  double OutlierRatio = 6.0;     ///< see LocalScale.h

  /// Weight a sample by its distance from the surface, in units of the root mean square, clamped to
  /// [0.3, 2.8], so that the fit reaches limb ends. Without a Guide, also pull each vertex without
  /// samples along its normal to the nearest sample, so that fillings over hollows are pulled in.
  bool AutomaticPriority = true;

  /// Surface between samples that are far apart, or null. Vertices between such samples are pulled
  /// to it along their normals, with a tenth of the weight of a vertex's samples. Vertices over
  /// holes wider than eight edges are then not pulled.
  std::shared_ptr<const TriangleTree> Guide;

  Index SamplesPerIteration = 1000000; ///< of a larger cloud, different samples in each iteration
  unsigned int RandomSeed = 1;         ///< for the selection of these samples
  std::function<bool(const Vector3&)> Belongs; ///< whether to use a sample; empty for all
};

/// Fit a mesh to samples.
///
/// Each iteration finds the foot point of every sample on the surface, then the vertices that
/// minimize the distances of SurfaceEquations.h. The stiffness is the smoothness times the mean
/// weight of a vertex's samples. It is increased at vertices without samples nearby, where the
/// surface is interpolated, and at folds in the last iterations.
///
/// Outliers, samples much farther from the surface than their neighbors, are ignored
/// (LocalScale.h).
///
/// @param[in,out] mesh  vertices in the samples' unit; the history gets one record per iteration
/// @return for each triangle, the weight of the samples with foot points in it in the last
///   iteration; zeros without iterations
/// @throws Aborted
std::vector<double> leastSquaresFit(const TrainingSamples& samples,
  const LeastSquaresFitOptions& options, LearnedMesh& mesh, const Run& run = {});
}

#endif

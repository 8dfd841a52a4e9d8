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
  double FirstSmoothness = 0.01; ///< in the first iteration, then falling in equal ratios
  double LastSmoothness = 0.01;  ///< in the last iteration
  double Evenness = 1.0;         ///< of triangles, see SurfaceEquations.h
  double OutlierRatio = 6.0;     ///< see LocalScale.h

  /// Weight a sample by its distance from the surface, in units of the root mean square and between
  /// 0.3 and 2.8, so that the fit reaches tips; and where there is no Guide, draw a vertex without
  /// samples along its normal to the nearest sample there, so that lids over hollows come down.
  bool AutomaticPriority = true;

  /// Surface between samples that lie far from each other, or null. Vertices between such samples
  /// are drawn to it along their normals, with a tenth of the weight of a vertex's samples;
  /// vertices over holes more than eight edges wide are then not drawn at all.
  std::shared_ptr<const TriangleTree> Guide;

  Index SamplesPerIteration = 1000000; ///< of a larger cloud, other samples in each iteration
  unsigned int RandomSeed = 1;         ///< of the choice of these samples
  std::function<bool(const Vector3&)> Belongs; ///< whether a sample counts; empty for all
};

/// Fit a mesh to samples. Each iteration finds the foot point of every sample on the surface, then
/// the vertices that minimize the distances in the sense of SurfaceEquations.h. The stiffness is
/// the smoothness times the mean weight of a vertex's samples. It is raised at vertices without
/// samples around, where the surface is drawn straight across, and in the last iterations at folds.
///
/// Samples much farther from the surface than the samples around them are left out (LocalScale.h).
///
/// @param[in,out] mesh  vertices in the samples' unit; the history gets one record per iteration
/// @return for each triangle the weight of the samples that have their foot points in it in the
/// last
///         iteration; zeros without iterations
/// @throws Aborted
std::vector<double> leastSquaresFit(const TrainingSamples& samples,
  const LeastSquaresFitOptions& options, LearnedMesh& mesh, const Run& run = {});
}

#endif

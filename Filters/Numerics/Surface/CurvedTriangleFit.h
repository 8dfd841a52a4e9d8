/// Fit curved triangles to a point cloud by the Gauss-Newton steps of \cite Pottmann2006.

#ifndef ConformalCurvedTriangleFit_h
#define ConformalCurvedTriangleFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Surface/CurvedTriangles.h"

namespace conformal
{
struct CurvedTriangleFitOptions
{
  int NumberOfFitRounds = 6; ///< number of iterations, at least 0
  /// Weight of the regularization, at least 0; larger values smooth noise.
  double FitSmoothness = 0.01;
};

/// Fit curved triangles to samples by least squares.
///
/// Each iteration finds the foot point of every sample on the curved triangles. It then makes one
/// Gauss-Newton step that reduces the distances along the normals at the foot points. The unknowns
/// of a vertex are an offset d along its normal and two tilts of the normal. The surface therefore
/// does not slide tangentially, and its map to the sphere is preserved. The regularization is
/// lambda |L d|^2 + lambda / 10 (h / 4)^2 |n - n'|^2. Here L is the uniform Laplacian, n' the mean
/// normal of the adjacent triangles and h the mean length of the adjacent edges. lambda is the
/// smoothness times the mean weight of the samples of a vertex. Outliers are ignored: samples much
/// farther from the surface than their neighbors (LocalScale.h).
///
/// @throws std::invalid_argument if an option is out of range
/// @throws Aborted
CurvedTriangles fitCurvedTriangles(const CurvedTriangles& start, const TrainingSamples& samples,
  const CurvedTriangleFitOptions& options = {}, const Run& run = {});
}

#endif

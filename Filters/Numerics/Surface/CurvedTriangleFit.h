/// Fits curved triangles to a point cloud.
/// Gauss-Newton steps of \cite Pottmann2006.

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
  int NumberOfFitRounds = 6;   ///< at least 0
  double FitSmoothness = 0.01; ///< not negative; larger values smooth noise
};

/// In each round: the foot point of every sample on the curved triangles, then one Gauss-Newton
/// step of the distances along the normals there. Unknown are, for each vertex, an offset d along
/// its normal and two tilts of the normal, so that the surface slides nowhere along itself and its
/// map to the sphere stays as it is. It is held by
///     lambda |L d|^2 + lambda / 10 (h / 4)^2 |n - n'|^2,
/// with L the uniform Laplacian, n' the mean normal of the triangles around and h the mean length
/// of the edges around; lambda is the smoothness times the mean weight of the samples of a vertex.
/// Samples much farther away than those around them are left out (LocalScale.h).
///
/// @throws std::invalid_argument if an option is out of range
/// @throws Aborted
CurvedTriangles fitCurvedTriangles(const CurvedTriangles& start, const TrainingSamples& samples,
  const CurvedTriangleFitOptions& options = {}, const Run& run = {});
}

#endif

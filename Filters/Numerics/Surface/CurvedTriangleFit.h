/// Fit curved triangles (cubic patches over the triangles of a mesh) to a point cloud by least
/// squares, with the Gauss-Newton steps of \cite Pottmann2006.

#ifndef ConformalCurvedTriangleFit_h
#define ConformalCurvedTriangleFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Surface/CurvedTriangles.h"

namespace conformal
{
/// Parameters of fitCurvedTriangles().
struct CurvedTriangleFitOptions
{
  int NumberOfFitRounds = 6; ///< number of iterations, at least 0
  /// Weight of the regularization (see fitCurvedTriangles()) relative to the samples, at least 0.
  /// Larger values smooth noise.
  double FitSmoothness = 0.01;
};

/// Fit curved triangles to samples by least squares.
///
/// Each iteration finds the foot point (closest point) of every sample on the curved triangles. One
/// Gauss-Newton step then reduces the distances along the normals at the foot points. Each vertex
/// has three unknowns: an offset d along the vertex normal n, and two tilts of n. Vertices
/// therefore move only along their normals, and do not slide along the surface. A map of the
/// surface to the sphere (one position on the sphere for each vertex) thus remains valid.
///
/// The regularization is a sum over all vertices. The term of a vertex is
///
///     lambda (L d)^2 + lambda / 10 (h / 4)^2 |n - n'|^2
///
/// Here L d is the uniform Laplacian of the offsets: d minus the mean d of the neighbors. The
/// second term tilts n toward n', the mean normal of the adjacent triangles. The length h is the
/// mean length of the adjacent edges. The factor lambda is FitSmoothness times the total weight of
/// the samples, divided by the number of vertices.
///
/// Outliers are ignored. An outlier is a sample much farther from the surface than neighboring
/// samples (LocalScale.h).
///
/// @param[in] start  initial curved triangles over a closed mesh
/// @param[in] samples  points to which the triangles are fitted, of about the size and position of
///   `start`
/// @throws std::invalid_argument if an option is out of range, or if the size of the samples is
///   very different from the size of `start`
/// @throws Aborted
CurvedTriangles fitCurvedTriangles(const CurvedTriangles& start, const TrainingSamples& samples,
  const CurvedTriangleFitOptions& options = {}, const Run& run = {});
}

#endif

/// Fit a closed mesh to samples of a surface. All triangles of the mesh are about equally large.
///
/// Own construction, not from a publication: least-squares fits alternate with remeshing (making
/// new triangles). Good (nearly equilateral) triangles can be made when the shape of the surface is
/// known. Each fit improves the shape.

#ifndef ConformalAdaptiveFit_h
#define ConformalAdaptiveFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Fit/FitOptions.h"
#include "Learn/Fit/LearnedMesh.h"
#include "Search/TriangleTree.h"

#include <functional>
#include <memory>

namespace conformal
{
/// Options of fitAdaptively().
struct AdaptiveFitOptions : FitOptions
{
  Index NumberOfVertices = 12962; ///< number of vertices of the fitted mesh
  /// Number of samples per vertex in each iteration of the final fit.
  Index SamplesPerVertex = 12;
  unsigned int RandomSeed = 1; ///< seed of the selection of samples
  /// Function called with intermediate meshes; may be empty. A turn is a fit followed by remeshing.
  /// The intermediate meshes are:
  /// - the start surface, before and after remeshing,
  /// - the fitted mesh of each turn, before remeshing,
  /// - the final mesh.
  MeshObserver Observer;
};

/// Start surface of a fit, with settings of the fit. The surface is closed, of genus zero, and near
/// the samples. Positions are in the samples' unit: the samples are scaled to a maximum distance of
/// 1 from their centroid.
struct AdaptiveStart : LearnedMesh
{
  /// Number of turns before the final fit. A turn is a fit followed by remeshing.
  int Turns = 3;
  int IterationsPerTurn = 2; ///< number of iterations of the fit in each turn
  /// A sample is an outlier if its distance from the surface exceeds the usual distance of nearby
  /// samples by this factor. See LocalScale.h.
  double OutlierRatio = 10.0;
  /// Function that returns whether a sample is used; if empty, all samples are used.
  std::function<bool(const Vector3&)> Belongs;
  /// Surface to which the fit pulls vertices without samples nearby (LeastSquaresFit.h), or null.
  std::shared_ptr<const TriangleTree> Guide;
};

/// Fit a closed mesh of options.NumberOfVertices vertices to the samples. The triangles are nearly
/// equilateral and of about equal size, also on limbs (thin parts of the surface). The mesh is in
/// the samples' unit (maximum radius 1). It has no map to the sphere.
///
/// First, the start surface is remeshed (Remeshing.h). Then several turns follow. Each turn fits
/// the mesh to the samples (LeastSquaresFit.h) and remeshes the fitted mesh. The fit minimizes
/// distances of the samples, plus smoothness terms with a weight. In each turn, this weight
/// decreases from iteration to iteration. The final fit moves vertices, but keeps the triangles.
/// Then the noise of the samples is removed from the surface (FairFit.h). Where triangles cut off
/// sharp edges of the object, vertices are finally moved onto these edges (SharpEdges.h).
///
/// The noise of the samples is estimated before the final fit (NoiseEstimate.h). For the estimate,
/// distances of samples from two meshes are compared. One mesh is that before the final fit, and
/// the other one has a quarter of the vertices. With more noise, the final fit is smoother.
///
/// Large noise is detected earlier, from the distances of samples to the fitted mesh of the first
/// turn. If the noise is large relative to the edge length, the fit of this turn is repeated. In
/// the repeated fit and in later turns, the weight of the smoothness terms is larger, and constant.
///
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
///   (processes)
FittedMesh fitAdaptively(const TrainingSamples& samples, const AdaptiveFitOptions& options,
  const AdaptiveStart& start, const Run& run = {});
}

#endif

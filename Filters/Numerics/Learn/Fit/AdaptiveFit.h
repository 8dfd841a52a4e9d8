/// Fit a mesh with triangles of equal size to samples. Own construction: remeshing alternates with
/// least-squares fits, because the final surface, which determines good triangles, is not known at
/// first.

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
struct AdaptiveFitOptions : FitOptions
{
  Index NumberOfVertices = 12962;
  Index SamplesPerVertex = 12; ///< number of samples per vertex in an iteration of the final fit
  unsigned int RandomSeed = 1;
  /// Function called with the remeshed start, the mesh of each turn, and the final mesh; may be
  /// empty.
  MeshObserver Observer;
};

/// Start of a fit: a closed surface of genus zero near the samples, in the samples' unit.
struct AdaptiveStart : LearnedMesh
{
  /// Number of alternations (turns) of fit and remeshing before the final fit.
  int Turns = 3;
  int IterationsPerTurn = 2;                   ///< number of iterations of the fit in each turn
  double OutlierRatio = 10.0;                  ///< limit for outliers, see LocalScale.h
  std::function<bool(const Vector3&)> Belongs; ///< test whether to use a sample; may be empty
  /// Guide of the fit, see LeastSquaresFit.h; may be null.
  std::shared_ptr<const TriangleTree> Guide;
};

/// Fit a closed mesh of options.NumberOfVertices vertices through the samples. Its triangles are
/// nearly equilateral and of about equal size, including those on limbs. The mesh is in the
/// samples' unit and has no map to the sphere.
///
/// The start is remeshed (Remeshing.h) and fitted (LeastSquaresFit.h) alternately, with decreasing
/// smoothness. The final fit keeps the connectivity. The surface is then made fair (FairFit.h).
/// Where triangles cut off sharp edges of the object, vertices are finally moved onto these edges
/// (SharpEdges.h).
///
/// The noise is estimated from the errors of this mesh and of a mesh with a quarter of the vertices
/// (NoiseEstimate.h). The estimate determines the smoothness of the final fit. If the noise is
/// large relative to the edges, the first turn is repeated with a stiffer surface.
///
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
FittedMesh fitAdaptively(const TrainingSamples& samples, const AdaptiveFitOptions& options,
  const AdaptiveStart& start, const Run& run = {});
}

#endif

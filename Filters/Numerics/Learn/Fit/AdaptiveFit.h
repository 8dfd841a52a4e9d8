/// Fit of a mesh whose triangles follow the surface, by alternating remeshing and least squares;
/// own construction.

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
  Index SamplesPerVertex = 12; ///< per iteration of the final fit
  unsigned int RandomSeed = 1;
  MeshObserver Observer; ///< called with the remeshed start, each turn, and the fit; may be empty
};

/// Closed surface of genus zero near the samples, in their unit, from which the fit starts.
struct AdaptiveStart : LearnedMesh
{
  int Turns = 3;                               ///< of fit and remeshing, before the last fit
  int IterationsPerTurn = 2;                   ///< of the fit
  double OutlierRatio = 10.0;                  ///< see LocalScale.h
  std::function<bool(const Vector3&)> Belongs; ///< see LeastSquaresFit.h; may be empty
  std::shared_ptr<const TriangleTree> Guide;   ///< see LeastSquaresFit.h; may be null
};

/// Fit a closed mesh of options.NumberOfVertices vertices through the samples. Its triangles are
/// nearly equilateral and of equal size, including those on limbs. It is in the samples' unit, and
/// not mapped to the sphere.
///
/// The start is remeshed (Remeshing.h) and fitted (LeastSquaresFit.h) alternately, with decreasing
/// smoothness. The final fit keeps the connectivity. Then vertices move onto sharp edges that
/// triangles cut off (SharpEdges.h).
///
/// The noise is estimated from the errors of this mesh and of a mesh of a quarter of its vertices
/// (NoiseEstimate.h). It determines the smoothness of the final fit. Noise that is large relative
/// to the edges is detected after the first turn, which is then repeated with a stiffer surface.
///
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
FittedMesh fitAdaptively(const TrainingSamples& samples, const AdaptiveFitOptions& options,
  const AdaptiveStart& start, const Run& run = {});
}

#endif

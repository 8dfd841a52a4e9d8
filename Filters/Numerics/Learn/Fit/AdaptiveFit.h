/// Fit of a mesh whose triangles follow the surface: remeshing and least squares in turns; own
/// construction.

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
  Index SamplesPerVertex = 12; ///< in an iteration of the last fit
  unsigned int RandomSeed = 1;
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

/// Closed mesh of options.NumberOfVertices vertices through the samples, all of its triangles
/// nearly equilateral and of one size, on limbs too; in the samples' unit, and not mapped to the
/// sphere.
///
/// The start is remeshed (Remeshing.h) and fitted (LeastSquaresFit.h) in turns, from smooth to
/// fine; the last fit keeps the connectivity. Then the surface is made fair (FairFit.h), and
/// vertices move onto sharp edges that the triangles cut off (SharpEdges.h).
///
/// The noise is estimated from the errors of this mesh and of a mesh of a quarter of its vertices
/// (NoiseEstimate.h), and sets the smoothness of the last fit. Noise that is large against the
/// edges shows after the first turn, which is then repeated with a stiffer surface.
///
/// @throws Aborted
/// @post the result depends only on the arguments, not on threads or ranks
FittedMesh fitAdaptively(const TrainingSamples& samples, const AdaptiveFitOptions& options,
  const AdaptiveStart& start, const Run& run = {});
}

#endif

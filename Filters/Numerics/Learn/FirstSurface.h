/// Make the surfaces from which an adaptive mesh is fitted; used by StartSearch.h. Own
/// construction: there are several ways to make a start surface, because no single one suits all
/// shapes.

#ifndef ConformalFirstSurface_h
#define ConformalFirstSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Learn/Fit/AdaptiveFit.h"
#include "Mesh/Mesh.h"
#include "Search/TriangleTree.h"

#include <memory>

namespace conformal
{
/// Closed start surface in the samples' unit, with settings of the fit that depend on the kind of
/// start.
struct FirstSurface : AdaptiveStart
{
  StartReport Report;
};

/// Learn a start surface from the sphere, on a geodesic network with a quarter of the neurons. It
/// is not fitted by least squares.
/// @param[in] observer  function called after each level; may be empty
/// @throws NumericalFailure at the first level whose network spans parts without samples or is
///   stretched over limbs, unless options.StartingShape is Sphere
/// @throws Aborted
FirstSurface firstSurfaceFromSphere(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MeshObserver& observer, const Run& run = {});

/// Make a hull of the samples (GenusZeroHull.h). The grid spacing is chosen by the density of the
/// samples, but is no finer than the learned mesh requires.
/// @throws Aborted
FirstSurface firstSurfaceFromHull(const TrainingSamples& samples,
  const ConformalSOMOptions& options, HullMethod method, const Run& run = {});

/// Make a start surface from a mesh by orienting its triangles outward.
/// @param[in] mesh   closed mesh in the samples' unit
/// @param[in] guide  guide of the fit (LeastSquaresFit.h), if the samples are vertices of the mesh;
///   may be null
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or extends more than
///   four times as far from the samples' center as the samples do
/// @throws Aborted
FirstSurface firstSurfaceFromMesh(
  const Mesh& mesh, std::shared_ptr<const TriangleTree> guide, const Run& run = {});

/// Throw if a mesh, in the samples' unit, extends more than four times as far from the samples'
/// center as the samples do. All samples would be closest to one or two vertices of such a mesh.
/// @throws std::invalid_argument
void requireNear(const Points& mesh);

/// Return the vertices of a surface and evenly spaced points on its large triangles. A triangle is
/// large if its area exceeds the surface area divided by `wanted`.
/// @param[in] wanted  number by which the area is divided, and maximum number of added points
Points withPointsBetween(const Mesh& surface, Index wanted);
}

#endif

/// Surfaces from which an adaptive mesh is fitted; used by StartSearch.h.
/// Own construction: several starts, since no single one suits all shapes.

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
/// Closed surface in the samples' unit, with its settings of the fit.
struct FirstSurface : AdaptiveStart
{
  StartReport Report;
};

/// Learn from the sphere on a geodesic network of a quarter of the neurons, without a fit.
/// @param[in] observer  called after each level; may be empty
/// @throws NumericalFailure at the first level whose network spans parts without samples or is
///   stretched over limbs, unless options.StartingShape is Sphere
/// @throws Aborted
FirstSurface firstSurfaceFromSphere(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MeshObserver& observer, const Run& run = {});

/// Make a hull of the samples (GenusZeroHull.h). Its spacing follows the density of the samples,
/// but is no finer than the mesh requires.
/// @throws Aborted
FirstSurface firstSurfaceFromHull(const TrainingSamples& samples,
  const ConformalSOMOptions& options, HullMethod method, const Run& run = {});

/// Orient a mesh outward as the initial surface.
/// @param[in] mesh   in the samples' unit
/// @param[in] guide  of the fit, if the samples are vertices of the mesh; may be null
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or extends more than
///   four times as far from the samples' center as the samples do
/// @throws Aborted
FirstSurface firstSurfaceFromMesh(
  const Mesh& mesh, std::shared_ptr<const TriangleTree> guide, const Run& run = {});

/// Throw unless a mesh, in the samples' unit, extends at most four times as far from the samples'
/// center as the samples do. On a larger mesh, all samples would be closest to one or two vertices.
/// @throws std::invalid_argument
void requireNear(const Points& mesh);

/// Return the vertices of a surface and evenly spaced points on its large triangles. A triangle is
/// large if its area exceeds the surface area divided by `wanted`.
/// @param[in] wanted  divisor of the area; at most as many points are added
Points withPointsBetween(const Mesh& surface, Index wanted);
}

#endif

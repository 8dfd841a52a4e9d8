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
/// Closed surface in the samples' unit, with the settings of the fit that suit it.
struct FirstSurface : AdaptiveStart
{
  StartReport Report;
};

/// Learn from the sphere on a geodesic network of a quarter of the neurons, without a fit.
/// @throws NumericalFailure as soon as a level of the network spans parts without samples or is
///         stretched over limbs, unless options.StartingShape is Sphere
/// @param[in] observer  called after each level; may be empty
/// @throws Aborted
FirstSurface firstSurfaceFromSphere(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MeshObserver& observer, const Run& run = {});

/// Make a hull of the samples (GenusZeroHull.h), as fine as the samples are dense and no finer than
/// the mesh needs.
/// @throws Aborted
FirstSurface firstSurfaceFromHull(const TrainingSamples& samples,
  const ConformalSOMOptions& options, HullMethod method, const Run& run = {});

/// Take a mesh, in the samples' unit, and orient it outward.
/// @param[in] guide  of the fit, if the samples are vertices of the mesh; may be null
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or reaches more than
///         four times as far from the samples' middle as the samples do
/// @throws Aborted
FirstSurface firstSurfaceFromMesh(
  const Mesh& mesh, std::shared_ptr<const TriangleTree> guide, const Run& run = {});

/// Throw unless a mesh, in the samples' unit, reaches at most four times as far from the samples'
/// middle as the samples do: from farther away all samples would draw one or two of its vertices.
/// @throws std::invalid_argument
void requireNear(const Points& mesh);

/// Vertices of a surface, and points evenly spread over those of its triangles that are larger than
/// an even share of its area.
/// @param[in] wanted  number of shares; at most as many points are added
Points withPointsBetween(const Mesh& surface, Index wanted);
}

#endif

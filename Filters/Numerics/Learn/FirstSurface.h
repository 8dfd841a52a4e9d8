/// Make a start surface: the closed surface that is fitted to samples to learn an adaptive mesh.
/// StartSearch.h selects among the functions of this file.
///
/// Own construction, not from a publication: there are several ways to make a start surface. No
/// single start surface suits all shapes.

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
/// Closed start surface in the samples' unit (maximum radius 1), with settings of the fit. The
/// settings depend on how the surface was made.
struct FirstSurface : AdaptiveStart
{
  StartReport Report; ///< properties of the start surface
};

/// Learn a start surface from the unit sphere, on geodesic networks of increasing frequency. The
/// finest network has a quarter of the neurons of the learned mesh. The surface is not fitted by
/// least squares.
/// @param[in] observer  function called after each network; may be empty
/// @throws NumericalFailure if a network spans parts without samples, or has many obtuse triangles
///   because it is stretched over limbs. If options.StartingShape is Sphere, this exception is not
///   thrown.
/// @throws Aborted
FirstSurface firstSurfaceFromSphere(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MeshObserver& observer, const Run& run = {});

/// Make a start surface from a hull of the samples (GenusZeroHull.h). The grid spacing is adapted
/// to the density of the samples, but is not finer than the learned mesh requires.
/// @param[in] method  method by which the hull is made
/// @throws Aborted
FirstSurface firstSurfaceFromHull(const TrainingSamples& samples,
  const ConformalSOMOptions& options, HullMethod method, const Run& run = {});

/// Make a start surface from a mesh by orienting its triangles outward.
/// @param[in] mesh   closed mesh in the samples' unit
/// @param[in] guide  surface that guides the fit between samples (LeastSquaresFit.h), or null. A
///   guide is given if the samples are vertices of the mesh.
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or has a coordinate
///   above 4 in magnitude
/// @throws Aborted
FirstSurface firstSurfaceFromMesh(
  const Mesh& mesh, std::shared_ptr<const TriangleTree> guide, const Run& run = {});

/// Throw an exception if a mesh, in the samples' unit, has a coordinate above 4 in magnitude. All
/// samples would then be closest to one or two vertices of the mesh. In this unit, the center of
/// the samples is the origin, and their maximum radius is 1.
/// @param[in] mesh  vertices of the mesh, #V by 3
/// @throws std::invalid_argument
void requireNear(const Points& mesh);

/// Return the vertices of a surface, followed by evenly spaced points on its large triangles. A
/// triangle is large if its area is at least the surface area divided by `wanted`.
/// @param[in] wanted  approximate maximum number of added points
Points withPointsBetween(const Mesh& surface, Index wanted);
}

#endif

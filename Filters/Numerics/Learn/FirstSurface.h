/// Make a start surface, the closed surface with which learning begins. To learn an adaptive mesh
/// (with triangles of about equal size), the start surface is then fitted to samples. StartSearch.h
/// decides which function of this file is called.
///
/// Own construction, not from a publication: a start surface is made from a sphere, from a hull, or
/// from a given mesh. No single start surface suits all shapes.

#ifndef ConformalFirstSurface_h
#define ConformalFirstSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/CloudThinning.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Learn/Fit/AdaptiveFit.h"
#include "Mesh/Mesh.h"
#include "Search/TriangleTree.h"

#include <memory>

namespace conformal
{
/// Closed start surface, with settings for its fit to the samples. The settings depend on how the
/// surface was made. Positions are in the samples' unit: the maximum distance of a sample from the
/// centroid of the samples is 1.
struct FirstSurface : AdaptiveStart
{
  StartReport Report; ///< properties of the start surface
};

/// Learn a start surface from the unit sphere, by batch training on geodesic networks of increasing
/// frequency (BatchTraining.h). A network is a subdivided icosahedron. The frequency is the number
/// of segments per edge of the icosahedron. Training moves the vertices, called neurons, toward the
/// samples. The neurons of the finest network are the vertices of the start surface. The start
/// surface has about a quarter of the vertices of the mesh to learn.
/// @param[in] observer  function called after each network; may be empty
/// @throws NumericalFailure if a trained network spans areas without samples, or has many obtuse
///   triangles. Obtuse triangles indicate that the network is stretched over limbs (thin parts of
///   the object). If options.StartingShape is Sphere, this exception is not thrown.
/// @throws Aborted
FirstSurface firstSurfaceFromSphere(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MeshObserver& observer, const Run& run = {});

/// Make a start surface from a hull, a closed surface around the samples (GenusZeroHull.h). The
/// hull is computed on a grid. The grid spacing is adapted to the density of the samples, and to
/// the edge length of the mesh to learn. If options.Genus is AsFound, the hull keeps handles whose
/// width, and that of their opening, is at least 4 grid spacings or sample spacings.
/// @param[in] method  method by which the hull is made
/// @throws Aborted
FirstSurface firstSurfaceFromHull(const TrainingSamples& samples,
  const ConformalSOMOptions& options, HullMethod method, const Run& run = {});

/// Make a start surface from a mesh by orienting its triangles outward.
/// @param[in] mesh   closed mesh in the samples' unit
/// @param[in] guide  surface to which the fit pulls vertices without samples nearby
///   (LeastSquaresFit.h), or null. A guide is given if the samples are vertices of the mesh.
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or has a coordinate
///   above 4 in magnitude
/// @throws Aborted
FirstSurface firstSurfaceFromMesh(
  const Mesh& mesh, std::shared_ptr<const TriangleTree> guide, const Run& run = {});

/// Throw an exception if a mesh in the samples' unit has a coordinate above 4 in magnitude. In the
/// samples' unit, the center of the samples is the origin, and their maximum radius is 1. If a mesh
/// were much larger, all samples would be closest to one or two of its vertices.
/// @param[in] mesh  vertices of the mesh, #V by 3
/// @throws std::invalid_argument
void requireNear(const Points& mesh);

/// Return the vertices of a surface, followed by evenly spaced points on its large triangles, with
/// normals. A triangle is large if its area is at least the surface area divided by `wanted`.
/// @param[in] wanted  approximate maximum number of added points
OrientedPoints withPointsBetween(const Mesh& surface, Index wanted);
}

#endif

/// Build one mesh of the sphere for several mapped surfaces, whose triangles have sides of equal
/// length on the surfaces. Own construction: the split, collapse, flip and relax operations of
/// \cite Botsch2004, measured by the mean metric of the surfaces. A mesh with equal sides on the
/// sphere would have thin triangles wherever a map stretches the directions differently.

#ifndef ConformalMeanMetricMesh_h
#define ConformalMeanMetricMesh_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Sphere/SphereLocator.h"

#include <vector>

namespace conformal
{
/// Surface with its map to the sphere, and the locator of the map's triangles.
struct LocatedSurface
{
  const MappedMesh* Surface = nullptr;
  /// Triangles of the surface, counter-clockwise on the sphere seen from outside.
  const conformal::Triangles* Triangles = nullptr;
  const SphereLocator* Locator = nullptr;
};

/// Change a mesh of the sphere until its sides have about equal length in the mean metric.
///
/// The length of a side in the mean metric is the root mean square of its lengths on all surfaces.
/// The ends of the side on a surface are the points with the directions of its ends on the sphere.
/// Each surface is scaled to area 1, so that large surfaces have no larger influence than others.
/// Let X be the function that maps a direction to the points of all #S surfaces, a vector of 3 #S
/// coordinates. The mean metric is then the Euclidean metric of X, up to a constant factor.
///
/// Every round splits long sides, collapses short sides, flips sides until the triangles are
/// Delaunay triangles, and moves points to the centroid of their triangles. All lengths, angles and
/// areas are those of X. A change that would turn a triangle of the sphere over is skipped.
/// @param[in] surfaces        surfaces, at least one
/// @param[in] start           closed mesh of the sphere without flipped triangles
/// @param[in] numberOfPoints  target number of points. The number of points of the result differs
///   from it by at most 2 percent.
/// @return mesh of the sphere without flipped triangles; positions are unit vectors
/// @throws Aborted
/// @post the result does not depend on the number of threads
Mesh remeshByMeanMetric(const std::vector<LocatedSurface>& surfaces, const Mesh& start,
  Index numberOfPoints, const Run& run = {});
}

#endif

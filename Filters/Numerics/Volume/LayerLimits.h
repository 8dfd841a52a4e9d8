/// Limit how far the layers of a surface may be from it, so that they do not cross each other, by
/// the shrinking balls of \cite Ma2012.

#ifndef ConformalLayerLimits_h
#define ConformalLayerLimits_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Largest distances of layers from each vertex, along the normal.
struct LayerLimits
{
  std::vector<double> Inward;  ///< #V, at least 0
  std::vector<double> Outward; ///< #V, at least 0
  /// Number of triangles of layers that are inverted or cross another triangle of their layer. The
  /// number is 0 unless the surface itself crosses or folds.
  Index NumberOfFaults = 0;

  /// Return the depth of a layer at a vertex: the wanted depth, within the limits.
  double depthAt(Index vertex, double wanted) const;
};

/// Compute the limits of layers at given depths. On either side of the surface, a ball that touches
/// the surface at the vertex shrinks until no other vertex is in it, \cite Ma2012 section 3. All
/// points on the normal inside of this ball have the vertex as their closest point of the surface.
/// Normals inside of their balls therefore never meet, and layers do not cross. The limit is 0.9
/// radii of the ball.
///
/// Implementation note: limits of neighbors differ by at most their distance, so that layers stay
/// smooth where a limit begins. Between vertices, a mesh is not the smooth surface of the paper.
/// Each layer is therefore tested for inverted triangles, and for triangles that cross. There,
/// limits are reduced until the layer has none.
/// @param[in] surface  closed mesh
/// @param[in] normals  #V by 3 unit vectors outward; zero vectors get the limit 0
/// @param[in] depths  depths of the layers, positive outward
LayerLimits limitLayers(const Mesh& surface, const Points& normals,
  const std::vector<double>& depths, const Run& run = {});

/// Compute the positions of a layer: the vertices moved along their normals.
Points layerPositions(
  const Mesh& surface, const Points& normals, const LayerLimits& limits, double depth);
}

#endif

/// Compute features of a closed surface: numbers at each vertex by which registration matches
/// similar parts of two surfaces.
///
/// Own construction, not from a publication: features are computed mainly from geodesic distances.
/// These distances do not depend on the position and orientation of the surface. If the surface
/// bends, the distances change little.

#ifndef ConformalSphereFeatures_h
#define ConformalSphereFeatures_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Register/SphereSamples.h"

#include <vector>

namespace conformal
{
/// Options of geodesicFeatures().
struct GeodesicFeatureOptions
{
  /// Number of vertices from which geodesic distances are computed. The vertices are spread evenly
  /// over the surface.
  int NumberOfSources = 120;
  /// Radii for the features that measure the surface area near a vertex, see geodesicFeatures(). A
  /// radius is a multiple of the square root of the surface area.
  std::vector<double> Radii = { 0.17, 0.35 };
};

/// Compute features from geodesic distances.
///
/// The first feature of a vertex is the logarithm of its mean geodesic distance to all points of
/// the surface. This feature is large at limb ends (ends of thin parts). Each radius adds one
/// feature: the logarithm of the surface area near the vertex. Here the area is weighted by a
/// Gaussian function of the geodesic distance from the vertex. The width of the Gaussian function
/// is the radius. The area features are small on thin limbs.
///
/// Geodesic distances are lengths of paths along edges and straight across pairs of triangles. The
/// unit of these distances is the square root of the surface area.
/// @return #V rows: one column for the mean distance, then one column for each radius
Rows geodesicFeatures(
  const Mesh& surface, const GeodesicFeatureOptions& options = {}, const Run& run = {});

/// Compute the proximity of each vertex to landmarks, selected points of the surface.
///
/// Let d_k be the geodesic distance of a vertex from landmark k, as in geodesicFeatures(). The
/// proximity to landmark k is 1 / d_k, divided by the sum of 1 / d_j over all landmarks j. Between
/// two landmarks, proximities depend on the ratio of the distances. A point halfway along a short
/// leg thus has the same proximities as a point halfway along a long leg.
///
/// All columns are divided by one number, so that the area-weighted variances of the columns have
/// the sum 1.
/// @param[in] landmarks  #L positions on the surface, at least 2
/// @return #V by #L
Rows landmarkProximities(const Mesh& surface, const Points& landmarks, const Run& run = {});

/// Compute the mean curvature, smoothed by diffusion. The curvature is multiplied by the square
/// root of the surface area. The result is independent of the size of the surface.
/// @param[in] scale  approximate smoothing length, as a multiple of the square root of the area
/// @return one value for each vertex
Eigen::VectorXd smoothMeanCurvature(const Mesh& surface, double scale, const Run& run = {});

/// Shift and scale each column of features to weighted mean 0 and variance 1. A constant column
/// becomes 0.
/// @param[in] weights  weight of each row, for example the vertex areas; not all weights are zero
void normalizeFeatures(Rows& features, const Eigen::VectorXd& weights);
}

#endif

/// Compute features of a closed surface that are invariant to position, orientation and bending.
/// Own construction: features are computed from geodesic distances, because these do not change
/// under bending.

#ifndef ConformalSphereFeatures_h
#define ConformalSphereFeatures_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Register/SphereSamples.h"

#include <vector>

namespace conformal
{
struct GeodesicFeatureOptions
{
  /// Number of sources of geodesic distances, spread evenly over the surface.
  int NumberOfSources = 120;
  /// Radii of the features of nearby area, in units of the square root of the area.
  std::vector<double> Radii = { 0.17, 0.35 };
};

/// Compute features by geodesic distance.
///
/// The first feature of a vertex is the logarithm of its mean geodesic distance to all parts of the
/// surface. This feature is large at limb ends. For each radius, a further feature is the logarithm
/// of the nearby area, weighted by a Gaussian of the geodesic distance. These features are small on
/// thin limbs. Geodesic paths run along edges and across pairs of triangles.
/// @return #V rows, one column for the mean distance and one for each radius
Rows geodesicFeatures(
  const Mesh& surface, const GeodesicFeatureOptions& options = {}, const Run& run = {});

/// Compute the mean curvature times the square root of the area, smoothed by diffusion.
/// @param[in] scale  approximate smoothing length, in units of the square root of the area
Eigen::VectorXd smoothMeanCurvature(const Mesh& surface, double scale, const Run& run = {});

/// Shift and scale each column to mean 0 and variance 1.
/// @param[in] weights  weight of each row; not all are zero
void normalizeFeatures(Rows& features, const Eigen::VectorXd& weights);
}

#endif

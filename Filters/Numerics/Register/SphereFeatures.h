/// Features of a closed surface that do not depend on where it lies or how it is bent.
/// Own construction: features by geodesic distance do not change under bending.

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
  int NumberOfSources = 120; ///< spread evenly over the surface
  /// Of the area's square root, each for a feature: how much area is that near.
  std::vector<double> Radii = { 0.17, 0.35 };
};

/// For each vertex the logarithm of its mean geodesic distance to the surface, then for each radius
/// that of the area around it, weighted by a Gaussian of the geodesic distance. The first one is
/// large at the ends of limbs, the others are small on thin ones.
/// Distances are along edges and across pairs of triangles.
/// @return #V rows, one column for the mean distance and one for each radius
Rows geodesicFeatures(
  const Mesh& surface, const GeodesicFeatureOptions& options = {}, const Run& run = {});

/// The mean curvature times the square root of the area, smoothed by a diffusion.
/// @param[in] scale  of the area's square root: about how far it is smoothed
Eigen::VectorXd smoothMeanCurvature(const Mesh& surface, double scale, const Run& run = {});

/// Shift and scale each column to mean 0 and variance 1.
/// @param[in] weights  of the rows, not all zero
void normalizeFeatures(Rows& features, const Eigen::VectorXd& weights);
}

#endif

/// Curvatures and sulcal depth of a closed surface at each vertex, \cite CohenSteiner2003 and \cite
/// Boucher2009.

#ifndef ConformalSurfaceShape_h
#define ConformalSurfaceShape_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct SurfaceShapeOptions
{
  /// In units of the square root of the area, in [0, 1]; 0 for no smoothing
  double CurvatureScale = 0.01;
  double DepthScale = 0.1; ///< in units of the square root of the area, in [0.001, 1]
};

/// Shape of a surface: one number for each vertex.
struct SurfaceShape
{
  Eigen::VectorXd MeanCurvature;     ///< positive on bulges
  Eigen::VectorXd GaussianCurvature; ///< positive on domes and pits, negative on saddles
  Eigen::VectorXd SulcalDepth;       ///< positive in folds, negative on ridges; of mean 0
};

/// Measure curvatures and depth of a surface.
///
/// Curvatures are the integrals of \cite CohenSteiner2003 over edges and vertices, divided by the
/// vertex areas of \cite Meyer2003. They are then smoothed by one implicit step of a diffusion over
/// a distance of about the scale. Depth is the depth potential u of \cite Boucher2009 with
///
///     u / s^2 - Laplacian u = 2 (mean of H - H),
///
/// with H the mean curvature and s the scale. Where the surface is nearly flat over that distance,
/// u is its height below its neighborhood.
/// @throws std::invalid_argument if a scale is out of range, or the surface has no area
/// @throws Aborted
/// @post the result does not depend on the number of threads
SurfaceShape measureSurfaceShape(
  const Mesh& surface, const SurfaceShapeOptions& options = {}, const Run& run = {});

/// Integrate the mean curvature around each vertex. Each edge contributes half its length times
/// half the angle between its two normals; the vertex at the other end receives an equal share.
Eigen::VectorXd meanCurvatureIntegrals(const Mesh& surface);

/// Integrate the Gaussian curvature around each vertex: two pi minus the sum of its angles. The
/// total over a closed surface is two pi times its Euler number.
Eigen::VectorXd gaussianCurvatureIntegrals(const Mesh& surface);

/// Compute the area nearest to each vertex within its triangles. An obtuse triangle is divided into
/// a half and two quarters. These areas give correct curvatures for vertices anywhere on a sphere.
Eigen::VectorXd nearestAreas(const Mesh& surface);

/// Compute a density from its integrals around the vertices, after one implicit step of a
/// diffusion. The step keeps the sum and the bounds of all values.
/// @param[in] areas      around the vertices, above 0
/// @param[in] time       square of the smoothing length
/// @param[in] integrals  one column for each function
Columns smoothDensities(const Mesh& surface, const Eigen::VectorXd& areas, double time,
  Columns integrals, const Run& run = {});
}

#endif

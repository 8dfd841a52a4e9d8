/// Measure curvatures and sulcal depth at each vertex of a closed surface, \cite CohenSteiner2003
/// and \cite Boucher2009.

#ifndef ConformalSurfaceShape_h
#define ConformalSurfaceShape_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct SurfaceShapeOptions
{
  /// Smoothing length of curvatures, in units of the square root of the area, in [0, 1]; 0 for no
  /// smoothing.
  double CurvatureScale = 0.01;
  /// Length scale of the depth, in units of the square root of the area, in [0.001, 1].
  double DepthScale = 0.1;
};

/// Shape of a surface, with one number for each vertex in each vector.
struct SurfaceShape
{
  Eigen::VectorXd MeanCurvature;     ///< positive on bulges
  Eigen::VectorXd GaussianCurvature; ///< positive on domes and pits, negative on saddles
  Eigen::VectorXd SulcalDepth;       ///< positive in folds, negative on ridges; the mean is 0
};

/// Measure curvatures and depth of a surface.
///
/// Curvatures are the integrals of \cite CohenSteiner2003 over edges and vertices, divided by the
/// vertex areas of \cite Meyer2003. They are then smoothed by one implicit step of a diffusion,
/// over a distance of about CurvatureScale. Depth is the depth potential u of \cite Boucher2009
/// with
///
///     u / s^2 - Laplacian u = 2 (mean of H - H),
///
/// where H is the mean curvature and s is DepthScale. Where the surface is nearly flat over the
/// distance s, u is the depth of a point below its neighborhood.
/// @throws std::invalid_argument if a scale is out of range, or the surface has no area
/// @throws Aborted
/// @post the result does not depend on the number of threads
SurfaceShape measureSurfaceShape(
  const Mesh& surface, const SurfaceShapeOptions& options = {}, const Run& run = {});

/// Integrate the mean curvature around each vertex. Each edge contributes half its length times
/// half the angle between the normals of its two triangles to each of its ends.
Eigen::VectorXd meanCurvatureIntegrals(const Mesh& surface);

/// Integrate the Gaussian curvature around each vertex: two pi minus the sum of the triangles'
/// angles at the vertex. The total over a closed surface is two pi times its Euler number.
Eigen::VectorXd gaussianCurvatureIntegrals(const Mesh& surface);

/// Compute, for each vertex, the area of the adjacent triangles that is closer to this vertex than
/// to their other vertices. An obtuse triangle is divided differently: half of its area belongs to
/// the obtuse corner, a quarter to each other corner. These areas give correct curvatures for
/// vertices anywhere on a sphere.
Eigen::VectorXd nearestAreas(const Mesh& surface);

/// Divide integrals around the vertices by their areas to get densities, and smooth these by one
/// implicit step of a diffusion. The step preserves the sum, and does not exceed the bounds of the
/// values.
/// @param[in] areas      area of each vertex, above 0
/// @param[in] time       duration of the diffusion: the square of the smoothing length
/// @param[in] integrals  integrals around the vertices, with one column for each function
Columns smoothDensities(const Mesh& surface, const Eigen::VectorXd& areas, double time,
  Columns integrals, const Run& run = {});
}

#endif

/// Measure curvatures and sulcal depth (depth in folds) at each vertex of a closed surface,
/// \cite CohenSteiner2003 and \cite Boucher2009.

#ifndef ConformalSurfaceShape_h
#define ConformalSurfaceShape_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct SurfaceShapeOptions
{
  /// Smoothing length of curvatures, divided by the square root of the surface area, in [0, 1].
  /// With 0, curvatures are not smoothed.
  double CurvatureScale = 0.01;
  /// Length scale s of the depth (see measureSurfaceShape()), divided by the square root of the
  /// surface area, in [0.001, 1].
  double DepthScale = 0.03;
};

/// Shape of a surface, with one number for each vertex in each vector.
struct SurfaceShape
{
  Eigen::VectorXd MeanCurvature;     ///< positive on bulges
  Eigen::VectorXd GaussianCurvature; ///< positive on peaks and pits, negative on saddles
  Eigen::VectorXd SulcalDepth;       ///< positive in folds, negative on ridges; the mean is 0
};

/// Measure curvatures and depth of a surface.
///
/// Curvatures are the integrals of \cite CohenSteiner2003 over edges and vertices, divided by the
/// vertex areas of \cite Meyer2003. The curvatures are then smoothed by one implicit step of a
/// diffusion. The smoothing length is given by CurvatureScale. Let H be the mean curvature, and s
/// the length given by DepthScale. The depth is the depth potential u of \cite Boucher2009 with
///
///     u / s^2 - Laplacian u = 2 (mean(H) - H).
///
/// Where the surface is nearly flat over distances of about s, u is the depth of a point below its
/// neighborhood.
/// @throws std::invalid_argument if a scale is out of range, or if the surface has no area
/// @throws Aborted
/// @post the result does not depend on the number of threads
SurfaceShape measureSurfaceShape(
  const Mesh& surface, const SurfaceShapeOptions& options = {}, const Run& run = {});

/// Integrate the mean curvature around each vertex. Each edge contributes to both of its ends. Let
/// phi be the angle between the normals of the two adjacent triangles. The contribution to an end
/// is half the length of the edge times phi / 2.
Eigen::VectorXd meanCurvatureIntegrals(const Mesh& surface);

/// Integrate the Gaussian curvature around each vertex. The integral is 2 pi minus the sum of the
/// angles of the adjacent triangles at the vertex. The total over a closed surface is 2 pi times
/// the Euler number, which is 2 if the surface has no handles.
Eigen::VectorXd gaussianCurvatureIntegrals(const Mesh& surface);

/// Compute the area around each vertex: the part of the adjacent triangles that is closer to this
/// vertex than to any other. Obtuse triangles are divided differently: half of their area belongs
/// to the obtuse corner, and a quarter to each other corner. With these areas, curvatures are
/// correct for every mesh whose vertices are on a sphere.
Eigen::VectorXd nearestAreas(const Mesh& surface);

/// Divide integrals around the vertices by the areas of the vertices. The quotients are called
/// densities. If the integrals are those of a curvature, the densities are its values. Smooth the
/// densities by one implicit step of a diffusion. The step preserves the integral over the surface.
/// The smoothed values are in the range of the original values.
/// @param[in] areas  area of each vertex, above 0
/// @param[in] time  duration of the diffusion: the square of the smoothing length
/// @param[in] integrals  integrals around the vertices, with one column for each function
Columns smoothDensities(const Mesh& surface, const Eigen::VectorXd& areas, double time,
  Columns integrals, const Run& run = {});
}

#endif

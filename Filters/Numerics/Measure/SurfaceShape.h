/// The shape of a closed surface around each vertex: curvatures, and how deep it lies in a fold.

#ifndef ConformalSurfaceShape_h
#define ConformalSurfaceShape_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct SurfaceShapeOptions
{
  double CurvatureScale = 0.01; ///< of the area's square root, in [0, 1]; 0 smooths nothing
  double DepthScale = 0.1;      ///< of the area's square root, in [0.001, 1]
};

/// One number for each vertex.
struct SurfaceShape
{
  Eigen::VectorXd MeanCurvature;     ///< above 0 where the surface bulges out
  Eigen::VectorXd GaussianCurvature; ///< above 0 on domes and pits, below 0 on saddles
  Eigen::VectorXd SulcalDepth;       ///< above 0 in folds, below 0 on ridges; of mean 0
};

/// Curvatures are those of \cite CohenSteiner2003, of edges and of vertices, over the vertices'
/// areas of \cite Meyer2003, and then smoothed by one implicit step of a diffusion: over a distance
/// of about the scale. Depth is the depth potential u of \cite Boucher2009 with
///
///     u / s^2 - Laplacian u = 2 (mean of H - H),
///
/// H being the mean curvature and s the scale: where the surface is nearly flat over that distance,
/// its height below its neighborhood.
/// @throws std::invalid_argument if a scale is out of range, or the surface has no area
/// @throws Aborted
/// @post the result does not depend on the number of threads
SurfaceShape measureSurfaceShape(
  const Mesh& surface, const SurfaceShapeOptions& options = {}, const Run& run = {});

/// The integral of the mean curvature around each vertex: of each of its edges half of the angle
/// between the two normals times half of the length, which the vertex at the other end shares.
Eigen::VectorXd meanCurvatureIntegrals(const Mesh& surface);

/// The integral of the Gaussian curvature: two pi less the angles around the vertex. All of a
/// closed surface add up to two pi times its Euler number.
Eigen::VectorXd gaussianCurvatureIntegrals(const Mesh& surface);

/// The area that is nearer to a vertex than to others of its triangles; of obtuse triangles a half
/// and two quarters. With it the curvatures of vertices on a sphere are right wherever they lie.
Eigen::VectorXd nearestAreas(const Mesh& surface);

/// The density whose integrals around the vertices are given, after one implicit step of a
/// diffusion. No value becomes larger or smaller than all of them were, sums are kept.
/// @param[in] areas  around the vertices, above 0
/// @param[in] time   square of the length over which it is smoothed
/// @param[in] integrals  one column for each function
Columns smoothDensities(const Mesh& surface, const Eigen::VectorXd& areas, double time,
  Columns integrals, const Run& run = {});
}

#endif

/// Compute velocities and rates of strain of a moving surface.
///
/// Own construction of the finite differences. The strain rate is half of the change of the metric,
/// \cite Truesdell1960, sect. 82.

#ifndef ConformalSurfaceMotion_h
#define ConformalSurfaceMotion_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Surface at a time. The maps of all times correspond.
struct MovingSurface
{
  double Time = 0.0;
  MappedMesh Surface;
};

/// Motion of a surface at one time. Velocities have the unit of length divided by the unit of time.
/// Rates have the unit 1 / time.
struct SurfaceMotion
{
  Points Velocities;              ///< #V by 3, velocity of each vertex
  std::vector<double> Normal;     ///< #V, component of the velocity along the outward normal
  Points Tangential;              ///< #V by 3, component of the velocity along the surface
  std::vector<double> AreaRates;  ///< #V, relative growth of areas per time
  std::vector<double> ShearRates; ///< #V, half of the difference of the principal strain rates
};

/// Compute the motion of a surface from the surfaces before and after it.
///
/// The velocity of a vertex is the derivative in time of the positions with the same direction on
/// the sphere. Let G be the metric of a triangle, the dot products
/// of two of its edges. The strain rate is D = G^-1 (dG/dt) / 2. The area rate is the trace of D.
/// The shear rate is half of the difference of the eigenvalues of D. Vertices get means over their
/// triangles, weighted by area. Derivatives are finite differences of three times. Their errors are
/// of second order, also if the times are not evenly spaced.
/// @param[in] before, after  surfaces at an earlier and a later time. For one-sided differences,
///   one of them is `surface` itself.
/// @throws std::invalid_argument if times do not ascend
SurfaceMotion computeMotion(const MovingSurface& before, const MovingSurface& surface,
  const MovingSurface& after, const Run& run = {});

/// Interpolate the positions of a surface in directions on the sphere. The map of the surface can
/// be mirrored.
Points positionsInDirections(
  const MappedMesh& surface, const Points& directions, const Run& run = {});

/// Move the vertices of a surface to another time: interpolate in time between the surface and a
/// later surface with a corresponding map.
/// @param[in] fraction  0 at the time of `surface`, 1 at the time of `later`
Points positionsBetween(const MappedMesh& surface, const MappedMesh& later, double fraction);
}

#endif

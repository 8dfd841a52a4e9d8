/// Change the sphere map of a surface so that it balances angles and areas. Own construction, for
/// textures: a map of a small mesh, computed by globalConformalMap(), is transferred to the points
/// of the surface, so that the cost hardly depends on the size of the surface.

#ifndef ConformalBalancedPositions_h
#define ConformalBalancedPositions_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Compute sphere positions that balance angles and areas.
///
/// The surface is sampled at the points of an adaptive sphere (makeAdaptiveSphere()) whose density
/// is the area of the surface. globalConformalMap() maps this mesh with the given balance. The
/// positions of the surface's points are interpolated linearly in the triangles of this mesh.
///
/// @param[in] surface  surface with a sphere map. If the map reverses orientation, the result does
///   not.
/// @param[in] areaBalance  trade-off, in [0, 1]; see GlobalConformalMapOptions::AreaBalance
/// @return #V by 3 unit vectors
/// @throws std::invalid_argument if the map does not cover the sphere exactly once, or if
///   areaBalance is out of range
/// @throws NumericalFailure if no map of the small mesh is found
/// @post the result does not depend on the number of threads
Points balancedPositions(const MappedMesh& surface, double areaBalance, const Run& run = {});
}

#endif

/// A closed mesh thinned and mapped to the sphere, for learning to start from; used by
/// trainConformalSOM.

#ifndef ConformalSurfaceStart_h
#define ConformalSurfaceStart_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <optional>

namespace conformal
{
/// The surface thinned and mapped to the sphere without folds, to be resampled at the neurons.
/// @param[in] surface      closed, of genus zero, triangles counter-clockwise seen from outside
/// @param[in] areaBalance  of the map, see ProgressiveSphereMap.h
/// @return nothing if the surface cannot be mapped: it winds so much that the sphere has no room
///         for it
/// @throws Aborted
std::optional<MappedMesh> thinAndMap(const Mesh& surface, double areaBalance, const Run& run);

/// The vertices of a surface, and points evenly spread over those of its triangles that are larger
/// than an even share of its area.
/// @param[in] wanted  shares; there will be no more points between the vertices
Points withPointsBetween(const Mesh& surface, Index wanted);

/// What thinAndMap() takes, in nanoseconds as in Steps.
double workOfThinAndMap(double numberOfVertices);
}

#endif

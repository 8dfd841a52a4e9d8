/// Write FreeSurfer files: surfaces, spheres, and values at points of surfaces.

#ifndef ConformalFreeSurferWriter_h
#define ConformalFreeSurferWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a triangle mesh as a FreeSurfer surface file. Points are written as floats.
/// @return the bytes of the file
/// @throws std::invalid_argument if a polygon has more than 3 corners. Also thrown if floats cannot
///   represent the points: they are too large, too small, or too far from the origin
/// @throws Aborted if the progress callback of `run` returns false
std::string makeFreeSurferSurface(const SurfaceData& surface, const Run& run = {});

/// Write a triangle mesh, mapped to a sphere of radius 100, as a FreeSurfer surface file. The
/// position of each point is 100 times its tuple in the array "SpherePosition", its position on the
/// unit sphere.
/// @return the bytes of the file
/// @throws std::invalid_argument if "SpherePosition" is missing, or a position is zero or not
///   finite. Also thrown if a polygon has more than 3 corners
/// @throws Aborted if the progress callback of `run` returns false
std::string makeFreeSurferSphere(const SurfaceData& surface, const Run& run = {});

/// Write values at points as a FreeSurfer curv file. The array must have 1 component. The file has
/// the new format of curv files, in which values are floats.
/// @param[in] numberOfPolygons  number of polygons of the surface to which the values belong;
///   stored in the file
/// @return the bytes of the file
/// @throws std::invalid_argument if a finite value is beyond the range of floats
/// @throws Aborted if the progress callback of `run` returns false
std::string makeFreeSurferCurv(
  const NamedArray& values, std::size_t numberOfPolygons, const Run& run = {});
}

#endif

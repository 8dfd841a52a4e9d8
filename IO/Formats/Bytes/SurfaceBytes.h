/// Surfaces and clouds as the bytes of a file. What is written is read back the same.

#ifndef ConformalSurfaceBytes_h
#define ConformalSurfaceBytes_h

#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// OFF as text: "Normals", "RGB" or "RGBA", "TCoords" of the points, colours and "ColorIndex" of
/// the polygons. Other arrays are left out.
/// @throws ParseError if the caller says stop; so do all others
std::string makeOFF(const SurfaceData& surface, const ParseProgress& progress = {});

/// Gu's .m: "SpherePosition" as trait sph, "Normals", "TCoords", "RGB" of the points, "RGB" of the
/// polygons. Other arrays are left out.
/// @throws std::invalid_argument if a "SpherePosition" has no direction
std::string makeGuMesh(const SurfaceData& surface, const ParseProgress& progress = {});

/// Points as text with names of the columns in a remark, if there are more than x, y and z. All
/// arrays; those of several components other than "Normals" and "RGB" become several columns.
std::string makeTextCloud(const SurfaceData& surface, const ParseProgress& progress = {});

/// PLY, binary little endian, all arrays of points and polygons. 8-byte integers become doubles, a
/// blank in a name becomes an underscore.
std::string makePLY(const SurfaceData& surface, const ParseProgress& progress = {});

/// FreeSurfer's triangles. Points are written as floats.
/// @throws std::invalid_argument if a polygon has more than 3 corners, or a point is too far for
/// floats
std::string makeFreeSurferSurface(const SurfaceData& surface, const ParseProgress& progress = {});

/// FreeSurfer's triangles on the sphere of radius 100: "SpherePosition" are the points.
/// @throws std::invalid_argument if it is missing or has no direction, or a polygon has more than 3
/// corners
std::string makeFreeSurferSphere(const SurfaceData& surface, const ParseProgress& progress = {});

/// FreeSurfer's curv, the new layout, of an array of 1 component. Values are written as floats.
std::string makeFreeSurferCurv(
  const NamedArray& values, std::size_t numberOfPolygons, const ParseProgress& progress = {});

/// GIFTI, compressed, all arrays of points.
/// @throws std::invalid_argument if a polygon has more than 3 corners, or there is none
std::string makeGIFTI(const SurfaceData& surface, const ParseProgress& progress = {});
}

#endif

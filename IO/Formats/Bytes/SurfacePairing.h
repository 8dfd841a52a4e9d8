/// Add data of a second file to a surface: values at points, or positions of points on the unit
/// sphere.

#ifndef ConformalSurfacePairing_h
#define ConformalSurfacePairing_h

#include "Bytes/ByteReader.h"
#include "Bytes/SurfaceData.h"

#include <functional>
#include <string>

namespace conformal
{
/// Function that parses an opened file.
using ParseSurfaceFile = std::function<SurfaceResult(ByteReader&)>;

/// Read a sphere file, and add its points to a surface as the array "SpherePosition" (Float64). A
/// sphere file contains the mesh of the surface, with its points on a sphere around the origin. The
/// sphere file and the surface must have equal numbers of points, and equal polygons. The points of
/// the sphere are scaled to unit length. An existing array "SpherePosition" is replaced.
///
/// If the path is empty, or the status of the surface is an error, the function does nothing. If
/// reading the sphere file fails, the surface becomes empty and gets the status of the sphere file.
void addSphere(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);

/// Read a file of point arrays and append these arrays to a surface, with unique names. Each array
/// must have one tuple for each point of the surface.
///
/// If the path is empty, or the status of the surface is an error, the function does nothing. If
/// reading the file fails, the surface becomes empty and gets the status of the file.
void addPointArrays(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);
}

#endif

/// Add the data of further files to a surface: positions on the sphere, or values at points.

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

/// Read a sphere file and add its points to a surface, as the array "SpherePosition" (Float64). The
/// sphere must have the same number of points and the same polygons as the surface. The vectors are
/// scaled to unit length. An existing array "SpherePosition" is replaced.
///
/// If the path is empty, or the status of the surface is an error, the function does nothing. If
/// reading the sphere fails, the surface becomes empty and gets the status of the sphere.
void addSphere(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);

/// Read a file of point arrays and append these arrays to a surface, with unique names. Each array
/// must have one tuple for each point of the surface.
///
/// If the path is empty, or the status of the surface is an error, the function does nothing. If
/// reading the file fails, the surface becomes empty and gets the status of the file.
void addPointArrays(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);
}

#endif

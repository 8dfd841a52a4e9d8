/// Add the data of other files to a surface: its positions on the sphere, and values at its points.

#ifndef ConformalSurfacePairing_h
#define ConformalSurfacePairing_h

#include "Bytes/ByteReader.h"
#include "Bytes/SurfaceData.h"

#include <functional>
#include <string>

namespace conformal
{
/// Parser of an opened file.
using ParseSurfaceFile = std::function<SurfaceResult(ByteReader&)>;

/// Read a sphere file with the same polygons as the surface. The points of the sphere become the
/// array "SpherePosition" (Float64, unit length) of the surface; an existing array is replaced.
/// Nothing is done if the file name is empty or the surface was not read. If reading the sphere
/// fails, its status becomes the status of the surface.
void addSphere(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);

/// Read a file of point arrays and append these arrays to the surface, with unique names.
void addPointArrays(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);
}

#endif

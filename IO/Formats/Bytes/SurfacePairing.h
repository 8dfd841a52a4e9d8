/// Add the data of other files to a surface: its sphere, and values at its points.

#ifndef ConformalSurfacePairing_h
#define ConformalSurfacePairing_h

#include "Bytes/ByteReader.h"
#include "Bytes/SurfaceData.h"

#include <functional>
#include <string>

namespace conformal
{
/// Parse an opened file.
using ParseSurfaceFile = std::function<SurfaceResult(ByteReader&)>;

/// Read the file of a sphere with the same polygons. Its points become the array "SpherePosition"
/// (Float64, unit length) of the surface, and replace an existing one. Nothing is done if the name
/// is empty or the surface was not read. A failure becomes the status of the surface.
void addSphere(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);

/// Read a file of point arrays and append them with unique names.
void addPointArrays(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse);
}

#endif

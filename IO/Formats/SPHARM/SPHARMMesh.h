/// Parse and write meshes of SPHARM-PDM: surfaces (_surf) and their spheres (_para) as legacy VTK
/// files.

#ifndef ConformalSPHARMMesh_h
#define ConformalSPHARMMesh_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string>
#include <string_view>

namespace conformal
{
/// Read the points (float or double) and polygons of a legacy VTK file of a POLYDATA, text or
/// binary, versions 1.0 to 5.1. Vertices and lines are skipped; the file is not read beyond the
/// first arrays.
SurfaceResult parseSPHARMMesh(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of a legacy VTK file of a POLYDATA.
bool looksLikeSPHARMMesh(std::string_view start);

/// Return the name of the file of the sphere: "_para" before the extension, in place of "_surf" if
/// present.
std::string sphereNameOf(const std::string& path);

/// Write the surface, or its "SpherePosition" in place of its points, as text of version 3.0.
/// Numbers are read back unchanged.
/// @throws std::invalid_argument if there are polygons other than triangles. For the sphere, also
///   without "SpherePosition" or with one that has no direction.
/// @throws Aborted
std::string makeSPHARMSurface(const SurfaceData& surface, const Run& run = {});
std::string makeSPHARMSphere(const SurfaceData& surface, const Run& run = {});
}

#endif

/// Parse and write meshes of SPHARM-PDM: surfaces (files _surf) and spheres (files _para) as legacy
/// VTK files.

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
/// binary, versions 1.0 to 5.1. Vertices and lines are skipped. Arrays, and everything after them,
/// are not read.
SurfaceResult parseSPHARMMesh(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of a legacy VTK file of a POLYDATA.
bool looksLikeSPHARMMesh(std::string_view start);

/// Return the name of the sphere file that belongs to a surface file: "_para" replaces "_surf"
/// before the extension, or is inserted there.
std::string sphereNameOf(const std::string& path);

/// Write the surface as text of version 3.0. makeSPHARMSphere() writes "SpherePosition" in place of
/// the points. The same numbers are read back from the text.
/// @throws std::invalid_argument if there are polygons other than triangles; for the sphere, also
///   if "SpherePosition" is missing or a position has no direction
/// @throws Aborted
std::string makeSPHARMSurface(const SurfaceData& surface, const Run& run = {});
std::string makeSPHARMSphere(const SurfaceData& surface, const Run& run = {});
}

#endif

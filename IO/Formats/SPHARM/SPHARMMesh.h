/// Parse and write meshes of the program SPHARM-PDM, in the legacy format of VTK. A surface is in a
/// file named *_surf. Its map to the sphere is in a file named *_para, which contains the same mesh
/// with points on the unit sphere.

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
/// Read the points (float or double) and polygons of a legacy VTK file with a data set POLYDATA.
/// The file may be text or binary, of version 1.0 to 5.1. Vertex cells and line cells are skipped.
/// The parser stops at the first array, so that arrays are not read.
SurfaceResult parseSPHARMMesh(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file identify a legacy VTK file with a data set POLYDATA.
bool looksLikeSPHARMMesh(std::string_view start);

/// Return the name of the sphere file that belongs to a surface file. If the name of the surface
/// file ends with "_surf" before the extension, "_para" replaces "_surf". Otherwise, "_para" is
/// inserted before the extension.
std::string sphereNameOf(const std::string& path);

/// Write a surface as a legacy VTK text file of version 3.0. makeSPHARMSurface() writes the points
/// of the surface. makeSPHARMSphere() instead writes the positions "SpherePosition", scaled to unit
/// length. Numbers have enough digits to be read back exactly.
/// @throws std::invalid_argument if a polygon is not a triangle. makeSPHARMSphere() also throws if
///   "SpherePosition" is missing, or a position is zero or not finite
/// @throws Aborted if the progress callback of `run` returns false
std::string makeSPHARMSurface(const SurfaceData& surface, const Run& run = {});
std::string makeSPHARMSphere(const SurfaceData& surface, const Run& run = {});
}

#endif

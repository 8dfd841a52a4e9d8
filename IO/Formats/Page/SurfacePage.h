/// Write a web page that shows a surface beside its sphere.

#ifndef ConformalSurfacePage_h
#define ConformalSurfacePage_h

#include "Base/Run.h"
#include "Bytes/ParseStatus.h"
#include "Bytes/SurfaceData.h"

#include <array>
#include <string>
#include <string_view>

namespace conformal
{
struct SurfacePageOptions
{
  std::string Title;
  /// Array shown first; if empty the picture, else colors, else an array that varies
  std::string ColorArrayName;
  /// Whether the picture repeats outside of [0, 1] instead of its border
  bool RepeatsTexture = false;
  /// Initial directions to the right, up, and towards the viewer: rows of unit length, in the
  /// coordinates of the surface.
  std::array<double, 9> SurfaceAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::array<double, 9> SphereAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }; ///< likewise of the sphere
};

/// Return the sphere positions of a surface that a page can show.
/// @throws std::invalid_argument for a surface without triangles, with other polygons, with too
///   many points, or without a direction for each point in "SpherePosition"
const NamedArray& requirePageSurface(const SurfaceData& surface);

/// Write a self-contained HTML file. Positions have 16 bits for each coordinate within the bounds
/// of the surface, positions on the sphere 2 times 16 bits. Values have 65535 steps over the range
/// of their array; integers are exact. Values that are not finite are shown as missing. Points and
/// triangles are ordered along the sphere.
///
/// Arrays of 3 or 4 bytes for each point are colors. Other arrays of several components are shown
/// by the length of their tuples. "Normals" and "vtkGhostType" are omitted.
///
/// @param[in] surface  triangles with a point array "SpherePosition" and, for a picture, "TCoords",
///   v counted from its bottom
/// @param[in] jpeg     the picture; none if empty
/// @param[in] threeJS  a classic or CommonJS build of three.js
/// @throws std::invalid_argument as requirePageSurface(), and for a missing array and positions
///   that are not finite
/// @throws Aborted
std::string makeSurfacePage(const SurfaceData& surface, std::string_view jpeg,
  std::string_view threeJS, const SurfacePageOptions& options = {}, const Run& run = {});
}

#endif

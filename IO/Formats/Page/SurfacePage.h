/// Write a web page that shows a surface beside its map to the sphere.

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
  /// Name of the array that is shown as color when the page opens. If empty, the picture (texture)
  /// of the surface is shown. Without a picture, the array "RGB" or "RGBA" is shown, or else the
  /// first array that is not constant
  std::string ColorArrayName;
  /// Whether the picture is repeated for texture coordinates outside of [0, 1]. Otherwise, the
  /// pixels of its border are repeated
  bool RepeatsTexture = false;
  /// Initial view of the surface. The rows are unit vectors that point right, up, and towards the
  /// viewer, in the coordinates of the surface
  std::array<double, 9> SurfaceAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::array<double, 9> SphereAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }; ///< initial view of the sphere
};

/// Check that a page can show a surface, and return its array "SpherePosition".
/// @throws std::invalid_argument if the surface has no polygons, polygons that are not triangles,
///   or too many points for 32-bit ids. Also thrown if "SpherePosition" is missing, or a position
///   is zero or not finite
const NamedArray& requirePageSurface(const SurfaceData& surface);

/// Write a self-contained HTML file with rounded numbers. Each coordinate of a point is stored in
/// 16 bits, relative to the bounds of the surface. Each position on the sphere is stored in 2 times
/// 16 bits. The values of an array are rounded to 65535 levels between their minimum and maximum.
/// Arrays of integers with 1 component are an exception: their values are exact if the range is
/// below 2^32. Values that are not finite are shown as missing. Points and triangles are sorted by
/// their position on the sphere, so that the data compress well.
///
/// Arrays of 3 or 4 bytes for each point are shown as colors. For other arrays of several
/// components, the page shows the lengths of the tuples. "SpherePosition", "Normals", "TCoords" and
/// "vtkGhostType" are not shown as color.
///
/// @param[in] surface  triangles with a point array "SpherePosition". If there is a picture, the
///   surface also has "TCoords", with v counted from the bottom of the picture
/// @param[in] jpeg     picture as a JPEG file; if empty, there is no picture
/// @param[in] threeJS  text of the library three.js, as a classic script or a CommonJS module
/// @throws std::invalid_argument as requirePageSurface(). Also thrown if the array ColorArrayName
///   or required texture coordinates are missing, or a coordinate is not finite
/// @throws Aborted if the progress callback of `run` returns false
std::string makeSurfacePage(const SurfaceData& surface, std::string_view jpeg,
  std::string_view threeJS, const SurfacePageOptions& options = {}, const Run& run = {});
}

#endif

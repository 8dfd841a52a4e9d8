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
  /// Array shown first. If empty, the picture is shown first, or else colors, or else an array that
  /// varies
  std::string ColorArrayName;
  /// Whether the picture is repeated outside of [0, 1]; otherwise its border is repeated there
  bool RepeatsTexture = false;
  /// Initial view of the surface: directions to the right, up, and towards the viewer. They are
  /// rows of unit length, in the coordinates of the surface.
  std::array<double, 9> SurfaceAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::array<double, 9> SphereAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }; ///< initial view of the sphere
};

/// Return the sphere positions of a surface that a page can show.
/// @throws std::invalid_argument for a surface without triangles, with other polygons, with too
///   many points, or without a direction for each point in "SpherePosition"
const NamedArray& requirePageSurface(const SurfaceData& surface);

/// Write a self-contained HTML file. Positions in space have 16 bits for each coordinate, within
/// the bounds of the surface. Positions on the sphere have 2 times 16 bits. Values have 65535 steps
/// over the range of their array; integers are exact. Values that are not finite are shown as
/// missing. Points and triangles are ordered along the sphere.
///
/// Arrays of 3 or 4 bytes for each point are colors. Other arrays of several components are shown
/// by the length of their tuples. "Normals" and "vtkGhostType" are omitted.
///
/// @param[in] surface  triangles with a point array "SpherePosition" and, for a picture, "TCoords",
///   v counted from its bottom
/// @param[in] jpeg     picture as a JPEG file; if empty, there is no picture
/// @param[in] threeJS  text of a classic or CommonJS build of three.js
/// @throws std::invalid_argument as requirePageSurface(), for a missing array, and for positions
///   that are not finite
/// @throws Aborted
std::string makeSurfacePage(const SurfaceData& surface, std::string_view jpeg,
  std::string_view threeJS, const SurfacePageOptions& options = {}, const Run& run = {});
}

#endif

/// Writer of a web page that shows a surface beside its sphere.

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
  std::string ColorArrayName;  ///< shown first; if empty the picture, else colors, else what varies
  bool RepeatsTexture = false; ///< beyond [0, 1] the picture comes again, instead of its border
  /// What the viewer has to the right, above, and towards himself at first: rows of unit length, in
  /// the coordinates of the surface.
  std::array<double, 9> SurfaceAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::array<double, 9> SphereAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }; ///< likewise of the sphere
};

/// The places on the sphere of a surface that a page can show.
/// @throws std::invalid_argument for a surface without triangles, with other polygons, with too
/// many
///   points, or without a direction for each point in "SpherePosition"
const NamedArray& requirePageSurface(const SurfaceData& surface);

/// An HTML file with all that it needs inside. Positions have 16 bits for each coordinate within
/// the surface's bounds, places on the sphere 2 times 16 bits, values 65535 steps of their array's
/// range; whole numbers stay as they are. Values that are not finite are shown as none. Points and
/// triangles come in an order along the sphere.
///
/// Arrays are colors if they have 3 or 4 bytes for each point; other arrays of several components
/// are shown by the length of their tuples. "Normals" and "vtkGhostType" are left out.
///
/// @param[in] surface  triangles with a point array "SpherePosition" and, for a picture, "TCoords",
///   v counted from its bottom
/// @param[in] jpeg     the picture; none if empty
/// @param[in] threeJS  a classic or CommonJS build of three.js
/// @throws std::invalid_argument as requirePageSurface() does, and for an array that is missing and
///   places that are not finite
/// @throws Aborted
std::string makeSurfacePage(const SurfaceData& surface, std::string_view jpeg,
  std::string_view threeJS, const SurfacePageOptions& options = {}, const Run& run = {});
}

#endif

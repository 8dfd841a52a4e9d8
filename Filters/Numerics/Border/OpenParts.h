/// Decide which parts of a closed surface around points are holes, and which parts are beyond the
/// border of a sheet: a surface that ends where the points end. The decision is our own
/// construction, not from a publication.

#ifndef ConformalOpenParts_h
#define ConformalOpenParts_h

#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Whether the learned surface has a border.
enum class Border
{
  Automatic, ///< Open if one unsupported part is larger than a hole is, otherwise Closed
  Closed,    ///< the surface is closed; all parts without points are filled
  Open       ///< the surface ends where the points end, except for small holes
};

struct BorderOptions
{
  conformal::Border Border = conformal::Border::Automatic;
  /// Maximum radius of holes that are filled, in the unit of the positions; finite, at least 0. If
  /// 0, holes with less than a tenth of the area of the largest part without points are filled.
  double HoleSize = 0.0;
};

/// Parts of a closed surface that are beyond the border of a sheet.
struct OpenParts
{
  std::vector<char> Marks; ///< #V, 1 for vertices of these parts and of islands
  double Fraction = 0.0;   ///< area of these parts as a fraction of the surface area
  /// Area of islands as a fraction of the surface area. Islands are parts with points that are
  /// separated from the largest such part.
  double IslandFraction = 0.0;
  /// Area of the largest part without points, left open or filled, as a fraction of the area
  double LargestFraction = 0.0;
  bool any() const { return this->Fraction > 0.0; }
};

/// Support at which a vertex is as far from the points as the border of a sheet may be.
constexpr double HalfSupport = 0.5;

/// Minimum fraction of the surface area of the largest part without points, for which Automatic is
/// Open. A scan from one side lacks a third or more, a scan from three sides a sixth or less.
constexpr double OpenFraction = 0.22;

/// Find the parts of a surface that are left open. A part is a connected set of vertices with a
/// support below HalfSupport. If options.Border is Open, the largest part is always left open.
///
/// @param[in] mesh     closed
/// @param[in] support  #V values in [0, 1], see supportOfVertices()
OpenParts findOpenParts(
  const Mesh& mesh, const std::vector<double>& support, const BorderOptions& options);
}

#endif

/// Fit smooth border curves to the points of a scan: closed curves on a surface, along which the
/// points end. The fit is our own construction, not from a publication.

#ifndef ConformalBorderCurve_h
#define ConformalBorderCurve_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Search/TriangleTree.h"

#include <vector>

namespace conformal
{
/// Closed curve on a surface. Seen from outside of the surface, the part with points is on the
/// left. The last node is followed by the first.
struct BorderCurve
{
  Points Positions; ///< #N by 3
  Points Normals;   ///< #N by 3, unit normals of the surface
  Points Outward;   ///< #N by 3, unit vectors along the surface, to the side without points
};

/// Return the curves between marked and unmarked vertices of a closed mesh. Each node is on an
/// edge, where the interpolated support is HalfSupport. Normals and Outward are empty.
/// @param[in] open     #V, 1 for vertices beyond the border, see findOpenParts()
/// @param[in] support  #V values, below HalfSupport at marked vertices
std::vector<BorderCurve> firstBorders(
  const Mesh& mesh, const std::vector<char>& open, const std::vector<double>& support);

/// Surface on which curves are fitted, with what queries need.
struct BorderSurface
{
  explicit BorderSurface(const conformal::Mesh& mesh, const Run& run = {});

  const conformal::Mesh& Mesh;
  TriangleTree Tree;
  Points VertexNormals;
  double EdgeLength; ///< mean
};

/// Return how far from the first borders points are used by fitBorders().
/// @param[in] spacing  spacing of the points, an upper bound
double reachOfFit(const BorderSurface& surface, double spacing);

/// Move curves to where the points end. Along a curve, the farthest points on the outer side are
/// found, in windows of seven spacings. Among evenly distributed points, the border is farther out
/// than the second of them by twice the area of a point, divided by the length of the window. A
/// smoothing spline through these places is the new curve. It follows waves longer than about 16
/// spacings. Five rounds are made.
///
/// @param[in] borders  result of firstBorders()
/// @param[in] points   all points of the scan within reachOfFit() of the curves
/// @return curves with normals. Curves with less than 8 nodes are not moved.
/// @throws Aborted
std::vector<BorderCurve> fitBorders(const std::vector<BorderCurve>& borders,
  const BorderSurface& surface, const Points& points, const Run& run = {});
}

#endif

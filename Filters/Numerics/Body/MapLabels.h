/// Measure labels that are painted in a map, such as segmented cells, on the surface of the body.
/// Areas are sums over parts of the body's triangles. Perimeters are by the Crofton formula,
/// \cite Legland2007.

#ifndef ConformalMapLabels_h
#define ConformalMapLabels_h

#include "Base/Run.h"
#include "Body/MapImage.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Measures of one label on the surface.
struct LabelMeasure
{
  int Label = 0;
  Index NumberOfPixels = 0;
  double Area = 0.0;
  double Perimeter = 0.0;
  Vector3 Centroid = { 0, 0, 0 }; ///< point of the surface closest to the mean of the positions
  /// Direction in which the label is longest, a unit vector; zero for a label without extent
  Vector3 LongAxis = { 0, 0, 0 };
  /// Ratio of the standard deviations of the positions along the longest and the second axis, at
  /// least 1
  double Elongation = 1.0;
  int NumberOfNeighbors = 0; ///< number of other labels that are adjacent
};

struct MapLabels
{
  std::vector<int> VertexLabels;      ///< label at the position of each vertex on the map, #V
  std::vector<LabelMeasure> Measures; ///< in ascending order of labels; label 0 is left out
};

/// Measure the labels of a map. Label 0 is the background.
///
/// Area: each triangle of the body is divided until its parts are in one label, or smaller than an
/// eighth of a pixel. The division of the body is that of the pixels, so that areas do not depend
/// on the projection, and their sum is the area of the surface.
///
/// Perimeter: L = pi / 2 sum w_k s_k N_k over eight directions to pixels nearby, \cite Legland2007
/// section 2.2. N_k is the number of pairs of pixels of which one has the label. On the surface,
/// s_k is the spacing of the lines through pixels, and w_k is the share of angles nearest to the
/// direction; both are computed at each pair. Own construction: the directions are chosen at each
/// pixel, from a reduced basis of the lattice of pixels on the surface, so that they are about
/// evenly spaced also where pixels are sheared or oblong. For a smooth outline of many pixels, the
/// error is about 1 %; near the poles of Mollweide and Mercator maps, it is up to 4 %.
///
/// Own construction: parts of pixels whose middle is beyond the outline of the map have the label
/// of a neighboring pixel. Neighbors beyond the outline are found on the sphere. Labels that are
/// separated by a line of one background pixel are neighbors.
/// @param[in] body  body with a sphere map whose north pole is (0, 0, 1)
/// @param[in] labels  label of each pixel; labels outside of the map are ignored
/// @throws std::invalid_argument if there are no pixels or no triangles, if the number of labels is
///   not that of the pixels, or if a triangle has a point that is not finite
MapLabels measureMapLabels(const MappedMesh& body, const MapImage& image,
  const std::vector<int>& labels, const Run& run = {});
}

#endif

/// Make a closed surface of genus zero around a point cloud. Own construction: the surface bounds a
/// set of grid nodes without handles, because such a surface has genus zero for any cloud.

#ifndef ConformalGenusZeroHull_h
#define ConformalGenusZeroHull_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Hull/DistanceBasins.h"
#include "Hull/FreudenthalGrid.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Method that classifies space as inside or outside of a cloud.
enum class HullMethod
{
  /// Distance; or WindingNumbers, if the hull by Distance seems wrong and the other is better; see
  /// chooseHull().
  Automatic,
  Distance,      ///< classify by distance to the data: small holes are closed
  WindingNumbers ///< classify by winding numbers of all points: holes are closed by extrapolation
};

struct GenusZeroHullOptions
{
  HullMethod Method = HullMethod::Distance;
  double Spacing = 0.016; ///< grid spacing, in units of the maximum radius
  /// Distance from the data to the surface, in grid spacings; for method Distance.
  double Offset = 1.0;
  double Persistence = 1.5; ///< parameter of findOutside() in DistanceBasins.h; for method Distance
  int SmoothingPasses = 10; ///< number of smoothing passes over the surface, at least 0
};

/// Valid ranges of GenusZeroHullOptions. With an offset below 0.87, a sample in the middle of a
/// grid cube could have no node within the offset.
struct GenusZeroHullLimits
{
  static constexpr double MinimumSpacing = 0.002, MaximumSpacing = 0.2;
  static constexpr double MinimumOffset = 0.9, MaximumOffset = 10.0;
  static constexpr double MinimumPersistence = 1.1, MaximumPersistence = 10.0;
  static constexpr int MaximumSmoothingPasses = 1000;
};

/// Region near the data from which a hull was made.
class HullData
{
public:
  HullData() = default;

  /// @param[in] nodes  1 for each node next to data of the hull, else 0
  HullData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& nodes);

  /// Return whether a sample, in the normalized frame, lies within about two spacings of the data
  /// of the hull. The function returns false for outliers and for samples away from the largest
  /// connected component. With HullMethod::WindingNumbers, it also returns false for samples inside
  /// and away from the surface.
  bool contains(const Vector3& sample) const;

private:
  FreudenthalGrid Grid;
  std::vector<bool> Nodes;
};

/// Hull in the normalized frame of the samples, with measures of its construction.
struct GenusZeroHullResult : Mesh
{
  HullData Data;

  HullMethod Method = HullMethod::Distance; ///< method that made this hull; never Automatic
  double Noise = 0.0;       ///< estimated standard deviation of the noise; for WindingNumbers
  bool NormalsUsed = false; ///< whether the normals of the samples were used; for WindingNumbers
  /// Kernel width of the winding numbers, larger for noisy points; for WindingNumbers.
  double Width = 0.0;
  double Spacing = 0.0; ///< grid spacing: that of the options, or a multiple of it
  /// Distance: number of nodes deeper inside than the offset, 0 if nothing is enclosed.
  /// WindingNumbers: number of nodes of the solid.
  Index NumberOfInsideNodes = 0;
  /// Euler number of the solid before its handles were cut: 1 minus the number of handles.
  Index EulerNumber = 1;
  /// Number of nodes removed to cut handles, or added to fill them.
  Index NumberOfCutNodes = 0;
  /// Distance: number of cut nodes that are deeper inside than the offset. WindingNumbers: number
  /// of changed nodes that are clearly inside or outside.
  Index NumberOfCutInsideNodes = 0;
  /// Largest number of nodes near data that must be cut to open a handle; for Distance.
  Index NumberOfCutDataNodes = 0;
  /// Whether handles exist in the hull by distance only, not by winding numbers.
  bool HandlesByChance = false;
  DataHole LargestHole;             ///< largest hole closed in the data, in the normalized frame
  bool Leaks = false;               ///< value of OutsideNodes::Leaks; for Distance
  Index NumberOfSamplesOutside = 0; ///< number of samples outside of the surface and not near it
  /// Number of samples inside of the surface and not near it: inner parts.
  Index NumberOfSamplesInside = 0;
};

/// Return whether the object itself seems to have handles, or parts that touch each other.
///
/// The cut of a handle of the object removes inside nodes, or removes nodes near data even if it
/// avoids them as far as possible. A handle that exists only because limbs are closer than the
/// offset is cut without either. One removed inside node per handle is tolerated, since it may be a
/// gap in sparse data. Return false for a hull without inside nodes, and if HandlesByChance is set.
bool hasHandles(const GenusZeroHullResult& hull);

/// Return whether a hull is unreliable, which has four possible causes. Holes in the data are too
/// large for classification by distance; nothing is inside; the object has handles; or more than
/// 0.5 % of the samples are outside and away from the surface.
bool seemsWrong(const GenusZeroHullResult& hull, const TrainingSamples& samples);

/// Compute the area of both sides of all cuts through handles of the object, as a fraction of the
/// surface area, in [0, 1]. Return 0 if hasHandles() is false.
double cutFraction(const GenusZeroHullResult& hull);

/// Make one closed surface of genus zero around a cloud. Its distance from the data is about the
/// offset.
///
/// 1. Compute the distance to the data on a grid (CloudDistance.h).
/// 2. Classify nodes as outside or not by persistence, which closes holes in the data
///    (DistanceBasins.h). The solid is the largest connected component of the nodes that are not
///    outside.
/// 3. Cut the handles of the solid (GridSolid.h), so that it has the topology of a ball.
/// 4. Extract the surface of the solid by marching tetrahedra, and smooth it (LevelSetSurface.h).
///
/// With HullMethod::WindingNumbers, the solid is made by solidByWindingNumbers() and its surface
/// passes through the data. If the cloud is flat or has too few points, or if nothing is inside,
/// HullMethod::Distance is used instead.
///
/// The surface is closed and of genus zero by construction, for any data. If the samples are too
/// sparse for the grid, nothing is inside and the solid is disconnected. If its largest component
/// has less than half of the samples, all steps are repeated with twice the spacing.
///
/// Memory: at most 17 bytes per node during the computation. A grid of spacing h has at most (2 / h
/// + 2 Offset + 8)^3 nodes, 2.7 million by default. The samples are not copied.
///
/// @param[in] samples  at least one sample, of any affine rank; only a cloud of affine rank 3 has
///   an inside
/// @throws std::invalid_argument if there are no samples or an option is out of range
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes
///   (CloudDistance.h)
/// @post the result depends only on the arguments, not on the number of threads
GenusZeroHullResult makeGenusZeroHull(
  const TrainingSamples& samples, const GenusZeroHullOptions& options = {}, const Run& run = {});

/// Make the hull by HullMethod::Distance. If it seems wrong (seemsWrong()), make the hull by
/// HullMethod::WindingNumbers too, and return that if it is better.
///
/// Handles that occur in both hulls are handles of the object. If the points are very noisy,
/// winding numbers are unreliable and the hull by distance is kept.
/// @param[in] options  options for HullMethod::Distance; Method is ignored
/// @param[in] winding  options for HullMethod::WindingNumbers; Method is ignored
GenusZeroHullResult chooseHull(const TrainingSamples& samples, GenusZeroHullOptions options,
  GenusZeroHullOptions winding, const Run& run = {});
}

#endif

/// Closed surface of genus zero around a point cloud.
/// Own construction: a grid solid without handles bounds a surface of genus zero for any cloud.

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
/// Classifier of inside and outside.
enum class HullMethod
{
  Automatic,     ///< Distance; where that hull seems wrong, WindingNumbers if theirs does not, see
                 ///< chooseHull()
  Distance,      ///< distance to the data: inside is what they enclose but for small holes
  WindingNumbers ///< winding number of all points: holes are closed as the other points imply
};

struct GenusZeroHullOptions
{
  HullMethod Method = HullMethod::Distance;
  double Spacing = 0.016;   ///< of the grid, in units of the largest radius
  double Offset = 1.0;      ///< Distance: of the surface from the data, in spacings
  double Persistence = 1.5; ///< Distance: see DistanceBasins.h
  int SmoothingPasses = 10; ///< of the surface
};

/// What the options may be. An offset below 0.87 would let samples slip between the nodes.
struct GenusZeroHullLimits
{
  static constexpr double MinimumSpacing = 0.002, MaximumSpacing = 0.2;
  static constexpr double MinimumOffset = 0.9, MaximumOffset = 10.0;
  static constexpr double MinimumPersistence = 1.1, MaximumPersistence = 10.0;
  static constexpr int MaximumSmoothingPasses = 1000;
};

/// Where the data are that a hull was made of.
class HullData
{
public:
  HullData() = default;

  /// @param[in] nodes  1 for the nodes next to these data, else 0
  HullData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& nodes);

  /// Whether a sample, in the normalized frame, is data of the hull, or within a spacing or two of
  /// such. False for outliers and for what lies apart from the largest piece; where winding numbers
  /// told the inside, also for what lies inside apart from the surface.
  bool contains(const Vector3& sample) const;

private:
  FreudenthalGrid Grid;
  std::vector<bool> Nodes;
};

/// The hull in the samples' normalized frame, and how it was found.
struct GenusZeroHullResult : Mesh
{
  HullData Data;

  HullMethod Method = HullMethod::Distance; ///< that was used
  double Noise = 0.0;               ///< WindingNumbers: that was found, its standard deviation
  bool NormalsUsed = false;         ///< WindingNumbers: whether those of the samples were of use
  double Width = 0.0;               ///< WindingNumbers: of their kernel; more than usual with noise
  double Spacing = 0.0;             ///< of the grid: that of the options, or a multiple
  Index NumberOfInsideNodes = 0;    ///< farther inside than the offset; 0 where nothing is enclosed
  Index EulerNumber = 1;            ///< of the solid before its handles were cut: 1 - handles
  Index NumberOfCutNodes = 0;       ///< where handles were cut
  Index NumberOfCutInsideNodes = 0; ///< of these, those that count as NumberOfInsideNodes
  Index NumberOfCutDataNodes = 0;   ///< where data must be cut to open a handle: nodes near them
  bool HandlesByChance = false;     ///< of the distance: winding numbers see none
  DataHole LargestHole;             ///< closed in the data, in the normalized frame
  bool Leaks = false;               ///< see OutsideNodes
  Index NumberOfSamplesOutside = 0; ///< samples apart from the surface that are not inside
  Index NumberOfSamplesInside = 0;  ///< samples inside, apart from the surface: inner parts
};

/// Whether the object itself seems to have handles, or parts that touch: then a cut goes through
/// its inside, or through its data however well it avoids them. Handles of the offset, between
/// limbs closer than it, need neither; one node inside for each handle may be a gap in sparse data.
/// A shell around points that enclose nothing has none, nor have those by chance.
bool hasHandles(const GenusZeroHullResult& hull);

/// Whether a hull is to be mistrusted: holes in the data are too large to tell the inside by the
/// distance, nothing is inside, there are handles, or samples are left out.
bool seemsWrong(const GenusZeroHullResult& hull, const TrainingSamples& samples);

/// Share of the surface's area that was made by cutting such handles: both sides of each cut. 0 if
/// hasHandles() is false.
double cutFraction(const GenusZeroHullResult& hull);

/// Wrap a cloud into one closed surface of genus zero, at about the offset from the data.
///
/// 1. The distance to the data is found on a grid (CloudDistance.h).
/// 2. The outside is told from the inside by persistence, so that holes in the data are closed
///    (DistanceBasins.h). The solid is all that is not outside; its largest piece is kept.
/// 3. Handles are cut open (GridSolid.h), so that the solid is a ball.
/// 4. Its surface is taken by marching tetrahedra and smoothed (LevelSetSurface.h).
///
/// With WindingNumbers, the solid is that of IndicatorSolid.h and its surface goes through the
/// data; where a cloud is flat or has too few points for it, and where it finds nothing inside, the
/// hull is made by the distance.
///
/// It is closed and of genus zero by construction, whatever the data. If the samples are too far
/// apart for the grid, nothing is inside and they fall to pieces; then, that is where the
/// largest piece holds less than half of the samples, all is done again with twice the spacing.
///
/// Memory: at most 17 bytes a node while it runs; the grid of spacing h has at most
/// (2 / h + 2 Offset + 8)^3 nodes, 2.7 million by default. The samples are not copied.
///
/// @param[in] samples  at least one; of any rank, though only a cloud of rank 3 has an inside
/// @throws std::invalid_argument if there are no samples or an option is out of range
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes
///   (CloudDistance.h)
/// @post the result depends only on the arguments, not on threads
GenusZeroHullResult makeGenusZeroHull(
  const TrainingSamples& samples, const GenusZeroHullOptions& options = {}, const Run& run = {});

/// The hull by the distance; where it seems wrong, and one by winding numbers does not, the latter.
/// Handles that both have are the object's own. Much noise leaves winding numbers
/// little to go by, and the hull by the distance is kept.
/// @param[in] options  of the former; its Method is not used
/// @param[in] winding  of the latter; likewise
GenusZeroHullResult chooseHull(const TrainingSamples& samples, GenusZeroHullOptions options,
  GenusZeroHullOptions winding, const Run& run = {});
}

#endif

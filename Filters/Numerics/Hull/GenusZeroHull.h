/// Make a closed surface, the hull, around a point cloud. The method is an own construction, not
/// from a publication. The surface is the boundary of a set of grid nodes. Usually, the set has the
/// topology of a ball. Its genus is then zero, since the boundary of a ball is a sphere. All
/// lengths are in the normalized coordinates of the samples. In normalized coordinates, the
/// weighted centroid is the origin, and the largest distance of a sample from the origin is 1.

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
/// Method that classifies positions as inside or outside of a cloud.
enum class HullMethod
{
  /// First use Distance. If the hull by Distance seems wrong and a hull by WindingNumbers is
  /// better, use WindingNumbers; see chooseHull().
  Automatic,
  Distance,      ///< classify by the distance to the points: small holes are closed
  WindingNumbers ///< classify by winding numbers of all points: holes are closed by extrapolation
};

/// Genus of the hull.
enum class HullGenus
{
  Zero,   ///< all handles are removed
  AsFound ///< handles that are as wide as HandleWidth are kept, see removeThinHandles()
};

struct GenusZeroHullOptions
{
  HullMethod Method = HullMethod::Distance;
  /// Grid spacing. The unit is the largest distance of a sample from the origin.
  double Spacing = 0.016;
  /// Distance between the points and the surface, in grid spacings. Used by method Distance.
  double Offset = 1.0;
  /// A hole is closed if the cavity behind the hole is wider by at least this factor. See
  /// `persistence` of findOutside(). Used by method Distance.
  double Persistence = 1.5;
  HullGenus Genus = HullGenus::Zero;
  /// Minimum width of handles and of their openings that are kept. The unit is the grid spacing, or
  /// the mean spacing of the samples if it is larger, see spacingOfData(). Used if Genus is
  /// AsFound.
  double HandleWidth = 4.0;
  int SmoothingPasses = 10; ///< number of smoothing passes over the surface, at least 0
};

/// Valid ranges of GenusZeroHullOptions. The offset must not be below 0.87 (half the diagonal of a
/// cube). Otherwise, a sample in the middle of a grid cube could have no node within the offset.
struct GenusZeroHullLimits
{
  static constexpr double MinimumSpacing = 0.002, MaximumSpacing = 0.2;
  static constexpr double MinimumOffset = 0.9, MaximumOffset = 10.0;
  static constexpr double MinimumPersistence = 1.1, MaximumPersistence = 10.0;
  static constexpr double MinimumHandleWidth = 0.0, MaximumHandleWidth = 1000.0;
  static constexpr int MaximumSmoothingPasses = 1000;
};

/// Region near the points that determined the surface of a hull, stored as a set of grid nodes.
/// Outliers, for example, are not among these points.
class HullData
{
public:
  HullData() = default;

  /// @param[in] nodes  1 for each node near the points that determined the surface, else 0
  HullData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& nodes);

  /// Return whether a sample is within about two grid spacings of the points that determined the
  /// surface. Let the solid be the connected set of nodes inside of the surface. The result is
  /// false for outliers, and for samples away from the solid. With HullMethod::WindingNumbers, the
  /// result is also false for samples deep inside of the surface.
  bool contains(const Vector3& sample) const;

private:
  FreudenthalGrid Grid;
  std::vector<bool> Nodes;
};

/// Closed surface around the samples, with measures of its construction. The surface is the
/// boundary of a set of grid nodes, the solid.
struct GenusZeroHullResult : Mesh
{
  HullData Data;

  HullMethod Method = HullMethod::Distance; ///< method that made this hull; never Automatic
  double Noise = 0.0;       ///< estimated standard deviation of the noise; set by WindingNumbers
  bool NormalsUsed = false; ///< whether the normals of the samples were used; set by WindingNumbers
  /// Kernel width (smoothing radius) of the winding numbers, which increases with the noise. Set by
  /// WindingNumbers.
  double Width = 0.0;
  double Spacing = 0.0; ///< grid spacing: the option Spacing, or a multiple of it
  /// With method Distance, the number of enclosed nodes (nodes farther than the offset from the
  /// points). With method WindingNumbers, the number of nodes of the solid.
  Index NumberOfInsideNodes = 0;
  /// Euler number of the solid before its handles were removed: 1 minus the number of handles.
  Index EulerNumber = 1;
  /// Number of nodes removed from the solid to cut handles, or added to fill handles.
  Index NumberOfCutNodes = 0;
  Index NumberOfHandles = 0; ///< number of handles of the surface; 0 unless Genus is AsFound
  /// With method Distance, the number of enclosed nodes that were removed. With method
  /// WindingNumbers, the number of changed nodes that were clearly inside or outside: their winding
  /// number differed from the isovalue by more than 0.25.
  Index NumberOfCutInsideNodes = 0;
  /// Number of nodes near points in the cut through a handle, maximum over all handles. Set by
  /// method Distance.
  Index NumberOfCutDataNodes = 0;
  /// Whether the handles of this hull are due to chance: the object from which the cloud was
  /// measured has no handles. chooseHull() sets this member in hulls by method Distance, if the
  /// hull by WindingNumbers has no handles.
  bool HandlesByChance = false;
  DataHole LargestHole; ///< largest hole of the cloud that was closed
  /// Whether a hole of the cloud is about as wide as the cavity behind it. Set by method Distance.
  bool Leaks = false;
  Index NumberOfSamplesOutside = 0; ///< number of samples outside of the surface and not near it
  /// Number of samples inside of the surface and not near it, for example on inner parts.
  Index NumberOfSamplesInside = 0;
};

/// Return whether the object itself seems to have handles, or parts that touch each other.
///
/// A node is called enclosed if it is on the inside, and farther than the offset from all points.
/// If the object has a handle, the cut through the handle removes enclosed nodes, or nodes near
/// points. If two limbs (thin parts of the object) are closer to each other than twice the offset,
/// the solid has a handle that the object does not have. The cut between the limbs removes no
/// enclosed nodes and no nodes near points.
///
/// A few removed nodes are tolerated, since sparse points can have gaps:
/// - one enclosed node per handle, at most four in total,
/// - three nodes near points.
///
/// Return false if no node is enclosed, if HandlesByChance is set, or if Genus was AsFound: the
/// handles of the object were then not cut.
bool hasHandles(const GenusZeroHullResult& hull);

/// Return whether a hull is unreliable. There are four possible causes:
///
/// - A hole in the cloud is too large for method Distance: the member Leaks is true.
/// - The points enclose nothing.
/// - The object has handles (hasHandles()).
/// - More than 0.5 % of the samples are outside of the surface and not near it.
bool seemsWrong(const GenusZeroHullResult& hull, const TrainingSamples& samples);

/// Return whether the solid of a hull had many handles that were cut by many nodes: more than four
/// handles, and at least three nodes for each. A sheet that is thinner than the spacing of the
/// samples has this property. Between the samples, the solid has holes through the sheet.
bool isTorn(const GenusZeroHullResult& hull);

/// Compute the fraction of the surface that is due to cuts through handles of the object: the area
/// of both sides of all cuts, divided by the area of the surface. The fraction is in [0, 1]. Return
/// 0 if hasHandles() is false.
double cutFraction(const GenusZeroHullResult& hull);

/// Make one closed surface of genus zero around a cloud. With HullMethod::Distance, the distance
/// between the points and the surface is about the offset, and the steps are:
///
/// 1. Compute the distance to the points at the nodes of a grid (CloudDistance.h).
/// 2. Classify each node as outside or not (DistanceBasins.h). This step closes holes in the cloud.
///    The largest connected component of the nodes that are not outside is called the solid.
/// 3. Cut the handles of the solid (GridSolid.h), so that the solid has the topology of a ball. If
///    options.Genus is AsFound, only remove handles that are thin or have a narrow opening
///    (ThinHandles.h).
/// 4. Extract the surface of the solid by marching tetrahedra, and smooth the surface
///    (LevelSetSurface.h).
///
/// With HullMethod::WindingNumbers, the solid is made by solidByWindingNumbers()
/// (IndicatorSolid.h), and its surface passes through the points. If the cloud is flat or has too
/// few points, or if nothing is inside, HullMethod::Distance is used instead.
///
/// The surface is closed by construction, for any cloud. Its genus is zero, unless options.Genus is
/// AsFound. If the samples are too
/// sparse for the grid, all steps are repeated with twice the spacing. The samples are too sparse
/// if two conditions hold:
/// - Nothing is enclosed, or a hole is about as wide as the cavity behind it.
/// - More than half of the samples are outside of the solid and not near it.
///
/// Memory: at most 17 bytes per node during the computation. Let h be the grid spacing. With
/// HullMethod::Distance, the grid has at most (2 / h + 2 Offset + 8)^3 nodes, 2.5 million by
/// default. The samples are not copied.
///
/// @param[in] samples  at least one sample, of any affine rank; only a cloud of affine rank 3
///   encloses a volume
/// @throws std::invalid_argument if there are no samples or an option is out of range
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes
///   (CloudDistance.h)
/// @post the result depends only on the arguments, not on the number of threads
GenusZeroHullResult makeGenusZeroHull(
  const TrainingSamples& samples, const GenusZeroHullOptions& options = {}, const Run& run = {});

/// Make the hull by HullMethod::Distance. If seemsWrong() or isTorn() is true for this hull, make a
/// second hull by HullMethod::WindingNumbers. Return the second hull if it is better, else the
/// first.
///
/// The second hull is better if three conditions hold:
/// - hasHandles() is false for the second hull. If both hulls have handles, the object has handles.
/// - The member Noise of the second hull is at most 0.004, since winding numbers of very noisy
///   points are unreliable. If Leaks is true for the first hull, any noise is allowed.
/// - Few samples are outside of the second hull: not more than outside of the first hull, or at
///   most one in 4000. If Leaks is true for the first hull, one in 200 is allowed.
///
/// If the first hull is torn, and the second is torn or not better, hulls by HullMethod::Distance
/// with 1.5, 2 and 3 times the offset are made. The first of them whose handles are cut by at most
/// eight nodes is returned.
/// @param[in] options  options for HullMethod::Distance; the member Method is ignored
/// @param[in] winding  options for HullMethod::WindingNumbers; the member Method is ignored
GenusZeroHullResult chooseHull(const TrainingSamples& samples, GenusZeroHullOptions options,
  GenusZeroHullOptions winding, const Run& run = {});
}

#endif

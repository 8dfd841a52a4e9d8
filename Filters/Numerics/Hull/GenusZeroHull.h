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
  Automatic, ///< Distance, unless that hull seems wrong and the one of WindingNumbers does not; see
             ///< chooseHull()
  Distance,  ///< distance to the data: the enclosed region is inside, small holes are closed
  WindingNumbers ///< winding number of all points: holes are closed by extrapolation
};

struct GenusZeroHullOptions
{
  HullMethod Method = HullMethod::Distance;
  double Spacing = 0.016;   ///< grid spacing, in units of the maximum radius
  double Offset = 1.0;      ///< Distance: from the data to the surface, in spacings
  double Persistence = 1.5; ///< Distance: see DistanceBasins.h
  int SmoothingPasses = 10; ///< of the surface, at least 0
};

/// Valid ranges of GenusZeroHullOptions. With an offset below 0.87, samples could lie between nodes
/// without any node within the offset.
struct GenusZeroHullLimits
{
  static constexpr double MinimumSpacing = 0.002, MaximumSpacing = 0.2;
  static constexpr double MinimumOffset = 0.9, MaximumOffset = 10.0;
  static constexpr double MinimumPersistence = 1.1, MaximumPersistence = 10.0;
  static constexpr int MaximumSmoothingPasses = 1000;
};

/// Region of the data from which a hull was made.
class HullData
{
public:
  HullData() = default;

  /// @param[in] nodes  1 for the nodes next to data of the hull, else 0
  HullData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& nodes);

  /// Return whether a sample, in the normalized frame, lies within about two spacings of the data
  /// of the hull. Outliers and samples apart from the largest connected component are excluded.
  /// With HullMethod::WindingNumbers, samples inside and apart from the surface are excluded, too.
  bool contains(const Vector3& sample) const;

private:
  FreudenthalGrid Grid;
  std::vector<bool> Nodes;
};

/// Hull in the normalized frame of the samples, with measures of its construction.
struct GenusZeroHullResult : Mesh
{
  HullData Data;

  HullMethod Method = HullMethod::Distance; ///< classifier used; never Automatic
  double Noise = 0.0;       ///< WindingNumbers: estimated standard deviation of the noise
  bool NormalsUsed = false; ///< WindingNumbers: whether the normals of the samples were usable
  double Width = 0.0;   ///< WindingNumbers: kernel width; larger than the default for noisy points
  double Spacing = 0.0; ///< of the grid: that of the options, or a multiple
  Index NumberOfInsideNodes = 0;    ///< deeper inside than the offset; 0 if nothing is enclosed
  Index EulerNumber = 1;            ///< of the solid before its handles were cut: 1 - handles
  Index NumberOfCutNodes = 0;       ///< nodes removed to cut handles
  Index NumberOfCutInsideNodes = 0; ///< cut nodes that are counted in NumberOfInsideNodes
  Index NumberOfCutDataNodes = 0;   ///< nodes near data that must be cut to open a handle
  bool HandlesByChance = false;     ///< handles exist in the distance only, not in winding numbers
  DataHole LargestHole;             ///< largest hole closed in the data, in the normalized frame
  bool Leaks = false;               ///< see OutsideNodes
  Index NumberOfSamplesOutside = 0; ///< samples apart from the surface and not inside
  Index NumberOfSamplesInside = 0;  ///< samples inside and apart from the surface: inner parts
};

/// Return whether the object itself seems to have handles, or parts that touch.
///
/// The cut of such a handle removes inside nodes, or removes data however well it avoids them. A
/// handle of the offset, between limbs closer than the offset, needs neither. One inside node for
/// each handle is tolerated, since it may be a gap in sparse data. Returns false for a hull without
/// inside nodes, and for handles by chance.
bool hasHandles(const GenusZeroHullResult& hull);

/// Return whether a hull is unreliable: holes in the data are too large for classification by
/// distance, nothing is inside, the object has handles, or samples are left out.
bool seemsWrong(const GenusZeroHullResult& hull, const TrainingSamples& samples);

/// Compute the fraction of the surface area that lies on both sides of the cuts through handles of
/// the object, in [0, 1]. Returns 0 if hasHandles() is false.
double cutFraction(const GenusZeroHullResult& hull);

/// Wrap a cloud into one closed surface of genus zero, at about the offset from the data.
///
/// 1. Compute the distance to the data on a grid (CloudDistance.h).
/// 2. Classify nodes as inside or outside by persistence, which closes holes in the data
///    (DistanceBasins.h). The solid is the largest connected component of all nodes that are not
///    outside.
/// 3. Cut handles open (GridSolid.h), so that the solid is a ball.
/// 4. Extract its surface by marching tetrahedra and smooth it (LevelSetSurface.h).
///
/// With HullMethod::WindingNumbers, the solid is that of IndicatorSolid.h and its surface passes
/// through the data. If the cloud is flat or has too few points, or if nothing is inside, the hull
/// falls back to HullMethod::Distance.
///
/// The surface is closed and of genus zero by construction, for any data. If the samples are too
/// sparse for the grid, nothing is inside and the solid is disconnected. If its largest component
/// has less than half of the samples, all steps are repeated with twice the spacing.
///
/// Memory: at most 17 bytes a node during the computation. A grid of spacing h has at most (2 / h +
/// 2 Offset + 8)^3 nodes, 2.7 million by default. The samples are not copied.
///
/// @param[in] samples  at least one, of any affine rank; only a cloud of affine rank 3 has an
///   inside
/// @throws std::invalid_argument if there are no samples or an option is out of range
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes
///   (CloudDistance.h)
/// @post the result depends only on the arguments, not on the number of threads
GenusZeroHullResult makeGenusZeroHull(
  const TrainingSamples& samples, const GenusZeroHullOptions& options = {}, const Run& run = {});

/// Make the hull by HullMethod::Distance, and replace it by that of HullMethod::WindingNumbers if
/// only the first seems wrong.
///
/// Handles that occur in both hulls are those of the object. If the points are very noisy, winding
/// numbers are unreliable and the hull by distance is kept.
/// @param[in] options  for HullMethod::Distance; its Method is ignored
/// @param[in] winding  for HullMethod::WindingNumbers; its Method is ignored
GenusZeroHullResult chooseHull(const TrainingSamples& samples, GenusZeroHullOptions options,
  GenusZeroHullOptions winding, const Run& run = {});
}

#endif

/// Separate the outer and the inner layer of a shell: a cloud of points on both sides of a wall
/// around a cavity. Level sets of volumes and scans of hollow objects are such clouds. The method
/// is our own construction.

#ifndef ConformalNestedLayers_h
#define ConformalNestedLayers_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Search/PointTree.h"

#include <memory>
#include <vector>

namespace conformal
{
/// Layer of a shell that is learned.
enum class Side
{
  Outer, ///< leave out the inner layer
  Inner, ///< leave out all but the inner layer
  Both   ///< leave out nothing
};

/// Outer and inner layer of a cloud.
struct NestedLayers
{
  /// Return whether the cloud has two layers.
  bool found() const { return this->Sorted != nullptr; }

  /// Return whether a point is on the inner layer: the nearest sorted sample is on it.
  bool isInner(const Vector3& x) const;

  /// Samples, and for each whether it is on the inner layer.
  struct SortedSamples
  {
    PointTree Tree;
    std::vector<char> IsInner;
  };
  std::shared_ptr<const SortedSamples> Sorted;
};

/// Find the outer and the inner layer of a cloud, in the samples' unit. The cloud has two layers if
/// all of these conditions hold:
/// - The samples enclose a cavity. A region that the outside reaches through a hole whose
///   radius is more than about four spacings of the samples is no cavity.
/// - At most a tenth of the samples at the cavity are also at the outside (the sides of one
///   layer would be at both).
/// - At least one of fifty samples is on the inner layer: at the cavity, or connected to such
///   samples by samples that are not at the outside.
/// - The wall is nearly empty: between the inner layer and the nearest samples at the outside,
///   samples are less dense than at both ends. Noise is denser there.
///
/// The wall must be thicker than about 0.03, than twice the spacing of the samples, and than six
/// standard deviations of the noise. About 40,000 samples are sorted. All ranks return equal
/// results.
NestedLayers findNestedLayers(const TrainingSamples& samples, const Run& run = {});
}

#endif

/// Find the voxels outside of an object in an image. Own construction: what is outside is decided
/// by a ball that rolls over the object from the border of the image (a closing, \cite Serra1982).
/// Cavities, and openings that are narrower than the ball, thus belong to the object, and a shell
/// of cells has only its outer surface.

#ifndef ConformalOutsideMask_h
#define ConformalOutsideMask_h

#include "Base/Run.h"
#include "Volume/VolumeImage.h"

#include <cstdint>

namespace conformal
{
/// Largest radius of the ball [voxels].
constexpr double MaximumClosing = 100.0;

struct OutsideMaskOptions
{
  double Level = 0.0; ///< voxels above this value belong to the object
  /// Radius of the ball, in [0, MaximumClosing] [voxels]. Openings up to twice as wide are closed.
  double ClosingRadius = 2.0;
  bool LargestObject = true; ///< whether all objects but the largest are outside
};

/// Mark the voxels that are outside of the object. A voxel is outside if it is below the level, and
/// if a ball that contains it reaches the border of the image without touching the object. The
/// space around the image is outside.
/// @return for each voxel, 1 outside and 0 inside of the object
/// @throws std::invalid_argument if an option is out of range
std::vector<std::uint8_t> markOutside(
  const VolumeImage& volume, const OutsideMaskOptions& options, const Run& run = {});
}

#endif

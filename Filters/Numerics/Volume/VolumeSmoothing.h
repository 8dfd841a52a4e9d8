/// Smooth images of three dimensions by a Gaussian, applied along one axis after the other,
/// \cite Lindeberg1994 section 2 (separable Gaussian).

#ifndef ConformalVolumeSmoothing_h
#define ConformalVolumeSmoothing_h

#include "Base/Run.h"
#include "Volume/VolumeImage.h"

namespace conformal
{
/// Largest standard deviation of the Gaussian [voxels].
constexpr double MaximumSmoothing = 100.0;

/// Replace the values by means weighted by a Gaussian. The Gaussian ends at four standard
/// deviations. Values beyond the image are those of the nearest voxel in it.
/// @param[in] deviation  standard deviation, in [0, MaximumSmoothing] [voxels]; 0 changes nothing
void smoothVolume(VolumeImage& volume, double deviation, const Run& run = {});
}

#endif

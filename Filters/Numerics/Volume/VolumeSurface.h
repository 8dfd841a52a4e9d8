/// Sample the outer surface of an object in an image by points: the crossings of a level with the
/// edges between neighboring voxels, \cite Lorensen1987.

#ifndef ConformalVolumeSurface_h
#define ConformalVolumeSurface_h

#include "Base/Run.h"
#include "Volume/VolumeImage.h"

namespace conformal
{
struct VolumeSurfaceOptions
{
  double Smoothing = 1.5;     ///< standard deviation of a Gaussian, see smoothVolume() [voxels]
  bool UseOtsuLevel = true;   ///< whether the level is that of otsuLevel()
  double Level = 0.0;         ///< level, if UseOtsuLevel is false
  double ClosingRadius = 2.0; ///< see OutsideMaskOptions [voxels]
  bool LargestObject = true;  ///< see OutsideMaskOptions
};

/// Points on the outer surface of an object.
struct VolumeSurface
{
  Points Positions;               ///< #P by 3
  Points Normals;                 ///< #P by 3 unit vectors towards the outside
  double Level = 0.0;             ///< level that was used
  bool ExceedsEverywhere = false; ///< whether all values exceed the level; then there are no points
  /// Fraction of the points at the border of the image, where the object is cut
  double CutFraction = 0.0;
};

/// Find the points where the smoothed values cross the level between two neighboring voxels, one in
/// the object and one outside. Crossings are interpolated linearly. Outside of the image, the
/// values are the smallest value of the image; an object that the image cuts is thus closed half a
/// voxel or less beyond its border. Normals are directions of descent: gradients by differences
/// of neighbors, interpolated like the position.
/// @param[in] volume  finite values, at least one voxel
/// @throws std::invalid_argument if there are no voxels, if an option is out of range, or if the
///   axes of the image are not finite, or not independent
VolumeSurface sampleVolumeSurface(
  VolumeImage volume, const VolumeSurfaceOptions& options = {}, const Run& run = {});
}

#endif

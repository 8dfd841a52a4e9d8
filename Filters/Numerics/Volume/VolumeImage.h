/// Define images of three dimensions, and interpolate their values linearly between the middles of
/// voxels. Own construction: beyond the image, values are those of its border, so that a position
/// that rounding moves out of the image has a value.

#ifndef ConformalVolumeImage_h
#define ConformalVolumeImage_h

#include "Base/Types.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace conformal
{
/// Image of voxels, each with one value. The voxel (i, j, k) has the id
/// i + Size[0] * (j + Size[1] * k). Its middle is at Origin + Axes * (i, j, k).
struct VolumeImage
{
  std::array<Index, 3> Size = { 0, 0, 0 };
  std::vector<float> Values; ///< finite
  Vector3 Origin = { 0, 0, 0 };
  /// Columns are the steps from a voxel to the next along i, j and k: direction times spacing.
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();

  Index size() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  Index id(Index i, Index j, Index k) const { return i + this->Size[0] * (j + this->Size[1] * k); }
  /// Return a value. Indices outside of the image are clamped to it.
  float clampedAt(Index i, Index j, Index k) const
  {
    return this->Values[this->id(std::clamp<Index>(i, 0, this->Size[0] - 1),
      std::clamp<Index>(j, 0, this->Size[1] - 1), std::clamp<Index>(k, 0, this->Size[2] - 1))];
  }
  /// Return the edge of a cube with the volume of a voxel.
  double voxelSize() const { return std::cbrt(std::abs(this->Axes.determinant())); }
};

/// Interpolate the value at a position between voxels linearly along each axis. Positions outside
/// of the image have the value of the closest position inside, along the axes of the image.
/// @param[in] index  position in voxels: (i, j, k) is the middle of a voxel; finite
inline double interpolate(const VolumeImage& volume, const Vector3& index)
{
  std::array<Index, 3> first, last;
  Vector3 weight;
  for (int a = 0; a < 3; ++a)
  {
    const auto end = static_cast<double>(volume.Size[a] - 1);
    const double place = std::clamp(index[a], 0.0, end);
    first[a] = static_cast<Index>(place);
    last[a] = std::min(first[a] + 1, volume.Size[a] - 1);
    weight[a] = place - static_cast<double>(first[a]);
  }
  const auto row = [&](Index j, Index k)
  {
    const double begin = volume.Values[volume.id(first[0], j, k)];
    return begin + weight[0] * (volume.Values[volume.id(last[0], j, k)] - begin);
  };
  const auto plane = [&](Index k)
  {
    const double begin = row(first[1], k);
    return begin + weight[1] * (row(last[1], k) - begin);
  };
  const double begin = plane(first[2]);
  return begin + weight[2] * (plane(last[2]) - begin);
}
}

#endif

/// Define images of three dimensions, and interpolate their values between the middles of voxels,
/// \cite Keys1981.

#ifndef ConformalVolumeImage_h
#define ConformalVolumeImage_h

#include "Base/Types.h"

#include <Eigen/LU>

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
  /// Return the edge of a cube with the volume of a voxel.
  double voxelSize() const { return std::cbrt(std::abs(this->Axes.determinant())); }
};

/// Interpolate the value at a position between voxels by cubic convolution, \cite Keys1981 with a =
/// -1/2. The result is limited to the range between the smallest and the largest value of the
/// image. Positions outside of the image have the value of the closest position inside, along the
/// axes of the image.
/// @param[in] index  position in voxels: (i, j, k) is the middle of a voxel; finite
/// @param[in] lowest, highest  range of the values of the image
double interpolate(const VolumeImage& volume, const Vector3& index, double lowest, double highest);
}

#endif

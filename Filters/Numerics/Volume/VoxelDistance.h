/// Compute distances between voxels, \cite Felzenszwalb2012.

#ifndef ConformalVoxelDistance_h
#define ConformalVoxelDistance_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace conformal
{
/// Mark the voxels that are farther than a radius from all voxels of a set. The exact square
/// distance is computed along one axis after the other, \cite Felzenszwalb2012 section 2.1.
/// @param[in] size    numbers of voxels along i, j and k
/// @param[in] set     for each voxel, 1 in the set and 0 elsewhere
/// @param[in] radius  at least 0 [voxels]. With 0, the voxels that are not in the set are marked.
std::vector<std::uint8_t> farFrom(const std::array<Index, 3>& size,
  const std::vector<std::uint8_t>& set, double radius, const Run& run = {});
}

#endif

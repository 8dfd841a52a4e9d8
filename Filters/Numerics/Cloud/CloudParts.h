/// Divide a point cloud into parts by the distance between neighbors. The method is our own
/// construction: a union of neighbor pairs.

#ifndef ConformalCloudParts_h
#define ConformalCloudParts_h

#include "Base/Types.h"
#include "Cloud/SampleSpacing.h"

#include <vector>

namespace conformal
{
/// Divide a cloud into parts. Points within a distance of each other are in the same part, if one
/// is among the twelve nearest points of the other. On scan lines, whose points are much closer
/// along the lines than across them, points within two spacings are also in the same part, if one
/// is in the neighborhood of the other (SampleSpacing.h).
/// @param[in] points  #P by 3 coordinates
/// @param[in] spacing  spacing of the points
/// @param[in] reach  distance, in the unit of the points
/// @return part of each point: the id of one of the points of the part
std::vector<int> partsOfCloud(const Points& points, const SampleSpacing& spacing, double reach);
}

#endif

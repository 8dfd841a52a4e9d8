// Issue warnings about a point cloud. Several filters use the same warnings. The calling filter
// decides whether a warning is needed.
#ifndef GlueCloudWarnings_h
#define GlueCloudWarnings_h

#include "Base/Types.h"        // for Index
#include "Hull/NestedLayers.h" // for Side

class vtkObject;

namespace glue
{
/// Warn that some points are not finite.
void WarnOfNonFinitePoints(vtkObject* self, conformal::Index count);
/// Warn that handles of the hull (a closed surface around the points) were cut open.
/// @param[in] cutFraction  area of the cuts, as a fraction of the hull's area
void WarnOfCutHandles(vtkObject* self, double cutFraction);
/// Warn that the normals of the points are not used, because the normals contradict each other.
void WarnOfUnusedNormals(vtkObject* self);
/// Warn that some points are outside of the hull and far from it: outliers, or separate parts.
void WarnOfPointsApart(vtkObject* self, conformal::Index count, conformal::Index total);
/// Warn that the ground under the object was left out.
void WarnOfGround(vtkObject* self, conformal::Index count, conformal::Index total);
/// Warn that a ground was to be left out, and none was found.
void WarnOfMissingGround(vtkObject* self);
/// Warn that the other layer of a shell was left out.
void WarnOfLayer(
  vtkObject* self, conformal::Index count, conformal::Index total, conformal::Side side);
/// Warn that some points are inside the hull and far from its surface: inner parts, or outliers.
void WarnOfPointsInside(vtkObject* self, conformal::Index count, conformal::Index total);
}

#endif

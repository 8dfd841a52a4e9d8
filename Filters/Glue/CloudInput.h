// Read a point cloud for the numerical core (Filters/Numerics). Points far from all others, such as
// markers of invalid points, and copies of points are detected and skipped.
#ifndef GlueCloudInput_h
#define GlueCloudInput_h

#include "Base/CoordinateFrame.h" // for CoordinateFrame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Run.h"             // for Run
#include "Base/Types.h"           // for Points, PointView, NumberView
#include "Cloud/FarPoints.h"      // for FarPoints

#include <functional> // for Skip

class vtkObject;
class vtkPointSet;

namespace glue
{
/// Points of a cloud in a coordinate frame: coordinates are divided by the unit of the frame. Far
/// points are points far from all others. The unit is computed without far points. Coordinates of
/// far points in the frame are possibly huge or infinite. All users must skip far points.
struct CloudInput
{
  conformal::CoordinateFrame Frame;
  /// View (access without a copy) of the points in coordinates of the frame. The view refers to the
  /// array of the input, or to Copy.
  conformal::PointView View;
  conformal::FarPoints Far; ///< points far from all others
  /// Number of copies of points on all ranks, see SkipCopies()
  conformal::Index NumberOfCopies = 0;
  /// Function that returns whether to skip a point, because it is a ghost point, a far point, or a
  /// copy of another point. If there are no points to skip, the function is empty.
  std::function<bool(conformal::Index)> Skip;
  conformal::Points Copy; ///< copy of the points, if the input has neither floats nor doubles
};

/// Read a cloud. If a polygon of the input uses a far point, the input is regarded as a surface,
/// and no point is treated as far.
/// @param[in] input       points to read; must outlive cloud.View
/// @param[in] priorities  one number for each point: the importance of the point for a later
///   computation. May be empty. The search for far points ignores points without a positive and
///   finite priority.
/// @param[in] surface     second data set, or null. The frame is computed from the points of the
///   cloud and of this data set.
/// @param[in] reduce      object that adds integers over all ranks (processes); each rank has a
///   part of the points
/// @param[out] cloud      default-constructed object to fill. Do not move the object afterward,
///   since View and Skip may refer to Copy.
void ReadCloud(vtkPointSet* input, const conformal::NumberView& priorities, vtkPointSet* surface,
  const conformal::Reduce& reduce, CloudInput& cloud);

/// Skip the copies of points, so that each position is used once: of the points with the same
/// coordinates that are not skipped otherwise, only the first is used. All ranks must call this
/// function.
/// @param[in] priorities  one number for each point, as in ReadCloud(). May be empty. Points
/// without
///   a positive and finite priority are ignored.
/// @param[in,out] cloud  cloud of ReadCloud(). NumberOfCopies is set, and Skip is extended.
void SkipCopies(const conformal::NumberView& priorities, const conformal::Reduce& reduce,
  const conformal::Run& run, CloudInput& cloud);

/// If there are far points, issue a warning.
void WarnOfFarPoints(vtkObject* self, const conformal::FarPoints& far);
}

#endif

// Read the points of a cloud for the numerical core. Points far from all others are left out.
#ifndef GlueCloudInput_h
#define GlueCloudInput_h

#include "Base/CoordinateFrame.h" // for CoordinateFrame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView, NumberView
#include "Cloud/FarPoints.h"      // for FarPoints

#include <functional> // for Skip

class vtkObject;
class vtkPointSet;

namespace glue
{
/// Points of a cloud, and the coordinate frame in which they are given. The frame is computed
/// without far points. Coordinates of far points are invalid in the frame, so these points must be
/// skipped.
struct CloudInput
{
  conformal::CoordinateFrame Frame;
  /// Points in coordinates of the frame; refers to the input's own array or to Copy.
  conformal::PointView View;
  conformal::FarPoints Far;
  std::function<bool(conformal::Index)> Skip; ///< test for ghosts and far points; may be empty
  conformal::Points Copy;
};

/// Read a cloud. If a polygon uses a far point, the data are regarded as a surface and no point is
/// treated as far.
/// @param[in] input       points to read; must outlive cloud.View
/// @param[in] priorities  one number for each point, or empty. The search for far points ignores
///   points whose priority is not positive and finite.
/// @param[in] surface     surface whose points determine the frame together with the cloud, or null
/// @param[in] reduce      sum over the ranks that hold parts of the points
/// @param[out] cloud      default-constructed object to fill. Do not move it afterward, since View
///   and Skip may refer to Copy.
void ReadCloud(vtkPointSet* input, const conformal::NumberView& priorities, vtkPointSet* surface,
  const conformal::Reduce& reduce, CloudInput& cloud);

/// Issue a warning if there are far points.
void WarnOfFarPoints(vtkObject* self, const conformal::FarPoints& far);
}

#endif

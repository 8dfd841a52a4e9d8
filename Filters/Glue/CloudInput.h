// Read the points of a cloud for the numerical core, without points far from all others.
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
/// Cloud in a frame that is computed without its far points. Far points are invalid in the frame
/// and must be skipped.
struct CloudInput
{
  conformal::CoordinateFrame Frame;
  conformal::PointView View; ///< the points in the frame, in place or in Copy
  conformal::FarPoints Far;
  std::function<bool(conformal::Index)> Skip; ///< test for ghosts and far points; may be empty
  conformal::Points Copy;
};

/// Read a cloud. Points of polygons are part of a surface: if one of these is far from the others,
/// no point is treated as far.
/// @param[in] input       must outlive the view
/// @param[in] priorities  points without a positive priority are not examined; may be empty
/// @param[in] surface     other data of the frame, or null
/// @param[in] reduce      sum over the ranks that hold parts of the points
/// @param[out] cloud      newly constructed, and not moved afterward
void ReadCloud(vtkPointSet* input, const conformal::NumberView& priorities, vtkPointSet* surface,
  const conformal::Reduce& reduce, CloudInput& cloud);

/// Warn of far points, if there are any.
void WarnOfFarPoints(vtkObject* self, const conformal::FarPoints& far);
}

#endif

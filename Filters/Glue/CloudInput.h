// Reads the points of a cloud for the numerical core, without those far from all others.
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
/// A cloud in a frame that is made without its far points. Far points have no meaning in the frame
/// and must be skipped.
struct CloudInput
{
  conformal::CoordinateFrame Frame;
  conformal::PointView View; ///< the points in the frame, where they lie or in Copy
  conformal::FarPoints Far;
  std::function<bool(conformal::Index)> Skip; ///< test for ghosts and far points; may be empty
  conformal::Points Copy;
};

/// Read a cloud. Points that polygons of the input use are part of a surface: where one of them
/// lies far from the others, no point is taken for a far one.
/// @param[in] input       must outlive the view
/// @param[in] priorities  points without a positive priority are not examined; may be empty
/// @param[in] surface     other data of the frame, or null
/// @param[in] reduce      adds up over the processes that hold parts of the points
/// @param[out] cloud      new, and not moved afterwards
void ReadCloud(vtkPointSet* input, const conformal::NumberView& priorities, vtkPointSet* surface,
  const conformal::Reduce& reduce, CloudInput& cloud);

/// Warn of far points, if there are any.
void WarnOfFarPoints(vtkObject* self, const conformal::FarPoints& far);
}

#endif

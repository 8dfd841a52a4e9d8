/// Convert coordinates, vectors and numbers of VTK to the types that the numerical core reads.
#ifndef GluePoints_h
#define GluePoints_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView

#include <functional> // for GhostTest
#include <vector>     // for the argument of FrameOf

class vtkDataArray;
class vtkPoints;
class vtkPointSet;
class vtkPolyData;

namespace glue
{
/// Return the name of the point array with a map to the sphere. The array has unit vectors of 3
/// doubles.
inline const char* SpherePositionName()
{
  return "SpherePosition";
}

/// Compute a common coordinate frame for the points of several data sets. Null pointers are
/// ignored.
/// @param[in] reduce  sum over all ranks, if each rank holds a part of the points
conformal::CoordinateFrame FrameOf(
  const std::vector<vtkPointSet*>& data, const conformal::Reduce& reduce = {});

/// Copy points, converted to a frame, as #P by 3 matrix. Return an empty matrix for null.
conformal::Points ToPoints(vtkPoints* points, const conformal::CoordinateFrame& frame);

/// Return a view of points that converts them to a frame. It refers to the points themselves, or to
/// `copy` if their type is neither float nor double. `copy` must outlive the view.
conformal::PointView ViewPoints(
  vtkPoints* points, const conformal::CoordinateFrame& frame, conformal::Points& copy);

/// Return a view of the numbers of an array with 1 component. It refers to the array itself, or to
/// `copy` if its type is neither float nor double. `copy` must outlive the view.
conformal::NumberView ViewNumbers(vtkDataArray* array, std::vector<double>& copy);

/// Return a function that returns whether a point is a ghost: hidden, or part of another piece. The
/// returned function is empty if there are no ghosts.
std::function<bool(conformal::Index)> GhostTest(vtkPointSet* input);

/// Return a view of the vectors of an array with 3 components. It refers to the array itself, or to
/// `copy` if its type is neither float nor double. `copy` must outlive the view.
/// @param[in] what  name of the array in the error message
/// @throws std::invalid_argument if the array is null or does not have 3 components
conformal::PointView ViewVectors(vtkDataArray* array, const char* what, conformal::Points& copy,
  const conformal::CoordinateFrame& frame = {});

/// Copy the vectors of an array with 3 components. Return false if the array is null or has another
/// number of components.
bool ToVectors(vtkDataArray* array, conformal::Points& vectors);

/// Copy a surface's map to the sphere, the point array "SpherePosition", normalized to unit length.
/// @throws std::invalid_argument if the point array "SpherePosition" is missing, does not have 3
///   components, or has a vector that is zero or not finite
conformal::Points ToSpherePositions(vtkPolyData* surface);

/// Copy the point array "SpherePosition" without normalizing it. Return false if the array is
/// missing.
/// @throws std::invalid_argument if the array does not have 3 components
bool FindSpherePositions(vtkPolyData* surface, conformal::Points& positions);
}

#endif

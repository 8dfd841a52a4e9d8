/// Coordinates, vectors and numbers of VTK as the core reads them.
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
/// Name of the point array with a map to the sphere: 3 doubles, unit length.
inline const char* SpherePositionName()
{
  return "SpherePosition";
}

/// Compute the common frame of all points of several data sets of one space; null pointers are
/// ignored.
/// @param[in] reduce  sum over the ranks, if each holds a part of the points
conformal::CoordinateFrame FrameOf(
  const std::vector<vtkPointSet*>& data, const conformal::Reduce& reduce = {});

/// Copy coordinates into a frame, #P by 3. A null pointer gives an empty matrix.
conformal::Points ToPoints(vtkPoints* points, const conformal::CoordinateFrame& frame);

/// View coordinates in a frame in place, or in `copy` if their type is neither float nor double.
/// `copy` must outlive the view.
conformal::PointView ViewPoints(
  vtkPoints* points, const conformal::CoordinateFrame& frame, conformal::Points& copy);

/// View the numbers of an array with 1 component in place, or in `copy` if their type is neither
/// float nor double. `copy` must outlive the view.
conformal::NumberView ViewNumbers(vtkDataArray* array, std::vector<double>& copy);

/// Return a predicate that is true for ghost points, which are hidden or belong to another piece.
/// The function is empty if there are no ghosts.
std::function<bool(conformal::Index)> GhostTest(vtkPointSet* input);

/// View the vectors of an array with 3 components in place, or in `copy` if their type is neither
/// float nor double. `copy` must outlive the view.
/// @param[in] what  name of the array in the error message
/// @throws std::invalid_argument if the array is null or does not have 3 components
conformal::PointView ViewVectors(vtkDataArray* array, const char* what, conformal::Points& copy,
  const conformal::CoordinateFrame& frame = {});

/// Copy the vectors of an array with 3 components. Return false if the array is null or has another
/// number of components.
bool ToVectors(vtkDataArray* array, conformal::Points& vectors);

/// Copy a surface's map to the sphere, normalized to unit length.
/// @throws std::invalid_argument if the point array "SpherePosition" is missing, does not have 3
///   components, or has a vector that is zero or not finite
conformal::Points ToSpherePositions(vtkPolyData* surface);

/// Copy the point array "SpherePosition" without normalizing it. Return false if there is none.
/// @throws std::invalid_argument if the array does not have 3 components
bool FindSpherePositions(vtkPolyData* surface, conformal::Points& positions);
}

#endif

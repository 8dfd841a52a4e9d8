/// Convert coordinates, vectors and numbers of VTK to types of the numerical core
/// (Filters/Numerics).
///
/// The numerical core computes in a coordinate frame: coordinates are divided by the unit of the
/// frame. A view is an object for reading an array without a copy. Each element is converted when
/// it is read.
#ifndef GluePoints_h
#define GluePoints_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView
#include "TorusMap/FlatTorus.h"   // for TorusPositions

#include <functional> // for GhostTest
#include <vector>     // for the argument of FrameOf

class vtkDataArray;
class vtkPoints;
class vtkPointSet;
class vtkPolyData;

namespace glue
{
/// Return the name of the point array that contains a map to the sphere. The array has a unit
/// vector of 3 doubles for each point.
inline const char* SpherePositionName()
{
  return "SpherePosition";
}

/// Return the name of the point array that contains a map to a flat torus. The array has 2 doubles
/// for each point, fractions of the two periods of the torus.
inline const char* TorusPositionName()
{
  return "TorusPosition";
}

/// Compute a common coordinate frame for the points of several data sets. Null pointers are
/// ignored.
/// @param[in] reduce  object that adds integers over all ranks (processes); needed if each rank has
///   a part of the points
conformal::CoordinateFrame FrameOf(
  const std::vector<vtkPointSet*>& data, const conformal::Reduce& reduce = {});

/// Copy points to a #P by 3 matrix, converted to a frame. If `points` is null, return an empty
/// matrix.
conformal::Points ToPoints(vtkPoints* points, const conformal::CoordinateFrame& frame);

/// Return a view of points that converts them to a frame. If the coordinates are floats or doubles,
/// the view refers to the memory of the points. Otherwise, the points are copied to `copy`, which
/// must outlive the view.
conformal::PointView ViewPoints(
  vtkPoints* points, const conformal::CoordinateFrame& frame, conformal::Points& copy);

/// Return a view of the numbers of an array with 1 component. If the numbers are floats or doubles,
/// the view refers to the memory of the array. Otherwise, the numbers are copied to `copy`, which
/// must outlive the view.
conformal::NumberView ViewNumbers(vtkDataArray* array, std::vector<double>& copy);

/// Return a test for ghost points: a function that returns whether a point is hidden, or owned by
/// another piece of the data. If there are no ghost points, the returned function is empty.
std::function<bool(conformal::Index)> GhostTest(vtkPointSet* input);

/// Return a view of the vectors of an array with 3 components. If the components are floats or
/// doubles, the view refers to the memory of the array. Otherwise, the vectors are copied to
/// `copy`, which must outlive the view.
/// @param[in] what   description of the array, for the error message
/// @param[in] frame  frame to which the vectors are converted
/// @throws std::invalid_argument if the array is null or does not have 3 components
conformal::PointView ViewVectors(vtkDataArray* array, const char* what, conformal::Points& copy,
  const conformal::CoordinateFrame& frame = {});

/// Copy the vectors of an array with 3 components. If the array is null or does not have 3
/// components, return false.
bool ToVectors(vtkDataArray* array, conformal::Points& vectors);

/// Return a copy of the point array "SpherePosition", which maps the surface to the sphere. The
/// copied vectors are normalized to unit length.
/// @throws std::invalid_argument if the point array "SpherePosition" is missing, or does not have 3
///   components. The message is different for a surface with a map to a flat torus.
/// @throws std::invalid_argument if a vector is zero or not finite
conformal::Points ToSpherePositions(vtkPolyData* surface);

/// Copy the point array "SpherePosition" without normalizing its vectors. If the array is missing,
/// return false.
/// @throws std::invalid_argument if the array does not have 3 components
bool FindSpherePositions(vtkPolyData* surface, conformal::Points& positions);

/// Return a copy of the point array "TorusPosition", which maps the surface to a flat torus.
/// @throws std::invalid_argument if the array is missing, does not have 2 components, or has a
///   number that is not finite
conformal::TorusPositions ToTorusPositions(vtkPolyData* surface);
}

#endif

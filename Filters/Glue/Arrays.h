/// Convert results of the numerical core to arrays, points and triangles of VTK. Every number is
/// checked, because filters write only finite numbers.
///
/// The numerical core (Filters/Numerics) computes in a coordinate frame: coordinates are divided by
/// the unit of the frame. The functions below convert lengths back to the user's unit.
#ifndef GlueArrays_h
#define GlueArrays_h

#include "Base/CoordinateFrame.h" // for lengths in a frame
#include "Base/Types.h"           // for Points, Triangles

#include <vector> // for numbers

class vtkFieldData;
class vtkPolyData;

namespace glue
{
/// Add an array of vectors: doubles with 3 components.
/// @throws std::overflow_error if a number is not finite
void AddVectors(vtkFieldData* data, const char* name, const conformal::Points& vectors);

/// Add an array of positions in the plane: doubles with 2 components.
/// @throws std::overflow_error if a number is not finite
void AddPlanePositions(vtkFieldData* data, const char* name,
  const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>& positions);

/// Add an array of numbers: doubles with 1 component.
/// @throws std::overflow_error if a number is not finite
void AddNumbers(vtkFieldData* data, const char* name, const std::vector<double>& values);

/// Add an array of ints with 1 component.
void AddIntegers(vtkFieldData* data, const char* name, const std::vector<int>& values);

/// Convert lengths from the unit of a frame to the user's unit. Add the converted lengths as an
/// array of doubles with 1 component.
/// @throws std::overflow_error if a converted length is not finite
void AddLengths(vtkFieldData* data, const char* name, std::vector<double> lengths,
  const conformal::CoordinateFrame& frame);

///@{
/// Add an array that contains a single number.
/// @throws std::overflow_error if the number is not finite
void AddNumber(vtkFieldData* data, const char* name, double value);
void AddNumber(vtkFieldData* data, const char* name, long long value);
///@}

/// Add an array with a single tuple of doubles.
/// @throws std::overflow_error if a number is not finite
void AddTuple(vtkFieldData* data, const char* name, const double* values, int components);

/// Convert lengths or coordinates from the unit of a frame to the user's unit, in place.
/// @param[in] size  number of values
/// @param[in] what  description of the values, for the error message
/// @throws std::overflow_error if a converted value exceeds the range of doubles
void LengthsFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what);

/// Convert areas from the unit of a frame to the user's unit, in place.
/// @param[in] size  number of values
/// @param[in] what  description of the values, for the error message
/// @throws std::overflow_error if a converted value exceeds the range of doubles
/// @throws std::overflow_error if the square of the unit is below 2^-960. Converted areas could
///   then be too small for doubles, and lose digits.
void AreasFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what);

/// Replace the content of a surface by triangles and their points. Points are converted from a
/// frame to the user's coordinates.
/// @throws std::overflow_error if a converted coordinate exceeds the range of doubles
void SetSurface(vtkPolyData* surface, const conformal::Points& points,
  const conformal::Triangles& triangles, const conformal::CoordinateFrame& frame);

/// Replace the polygons of a surface by triangles.
void SetTriangles(vtkPolyData* surface, const conformal::Triangles& triangles);

/// Remove the active normals of points and cells. Normals are wrong for other positions of the
/// points.
void RemoveNormals(vtkPolyData* surface);

/// Replace the points of a surface by points in double precision. The points are converted from a
/// frame to the user's coordinates.
/// @throws std::overflow_error if a converted coordinate exceeds the range of doubles
void SetPoints(
  vtkPolyData* surface, const conformal::Points& points, const conformal::CoordinateFrame& frame);
}

#endif

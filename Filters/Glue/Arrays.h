/// Convert results of the core to arrays, points and triangles of VTK. Every number is checked:
/// filters write finite numbers only.
#ifndef GlueArrays_h
#define GlueArrays_h

#include "Base/CoordinateFrame.h" // for lengths in a frame
#include "Base/Types.h"           // for Points, Triangles

#include <vector> // for numbers

class vtkFieldData;
class vtkPolyData;

namespace glue
{
/// Add an array of 3 doubles per tuple.
/// @throws std::overflow_error if a number is not finite
void AddVectors(vtkFieldData* data, const char* name, const conformal::Points& vectors);

/// Add an array of 1 double per tuple.
/// @throws std::overflow_error if a number is not finite
void AddNumbers(vtkFieldData* data, const char* name, const std::vector<double>& values);

/// Convert lengths of a frame to the user's unit and add them as an array of 1 double per tuple.
/// @throws std::overflow_error if a number is not finite
void AddLengths(vtkFieldData* data, const char* name, std::vector<double> lengths,
  const conformal::CoordinateFrame& frame);

///@{
/// Add an array of one number.
/// @throws std::overflow_error if the number is not finite
void AddNumber(vtkFieldData* data, const char* name, double value);
void AddNumber(vtkFieldData* data, const char* name, long long value);
///@}

/// Add an array of one tuple of doubles.
/// @throws std::overflow_error if a number is not finite
void AddTuple(vtkFieldData* data, const char* name, const double* values, int components);

/// Convert lengths or coordinates of a frame to the user's unit, in place.
/// @param[in] size  number of values
/// @param[in] what  name of the values in the error message
/// @throws std::overflow_error if a value leaves the range of doubles
void LengthsFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what);

/// Convert areas of a frame to the user's unit, in place.
/// @param[in] size  number of values
/// @param[in] what  name of the values in the error message
/// @throws std::overflow_error if a value leaves the range of doubles or the unit's square is below
///   2^-960, where areas would lose digits
void AreasFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what);

/// Replace all content of a surface by points of a frame and triangles.
/// @throws std::overflow_error if a coordinate leaves the range of doubles
void SetSurface(vtkPolyData* surface, const conformal::Points& points,
  const conformal::Triangles& triangles, const conformal::CoordinateFrame& frame);

/// Replace the polygons of a surface by triangles.
void SetTriangles(vtkPolyData* surface, const conformal::Triangles& triangles);

/// Replace the points of a surface by points of a frame, as doubles.
/// @throws std::overflow_error if a coordinate leaves the range of doubles
void SetPoints(
  vtkPolyData* surface, const conformal::Points& points, const conformal::CoordinateFrame& frame);
}

#endif

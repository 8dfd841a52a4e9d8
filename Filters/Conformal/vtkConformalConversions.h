// Conversions between VTK and the numerical core.
#ifndef vtkConformalConversions_h
#define vtkConformalConversions_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Run.h"             // for Run
#include "Base/Types.h"           // for Points, Triangles, PointView

#include "vtkSmartPointer.h" // for Held

#include <exception>  // for MessageOf's argument
#include <functional> // for RunCore's argument, GhostTest
#include <string>     // for MessageOf
#include <vector>     // for the arguments of FrameOf, AddNumbers

class vtkAlgorithm;
class vtkCellArray;
class vtkDataArray;
class vtkFieldData;
class vtkObject;
class vtkPoints;
class vtkPointSet;
class vtkPolyData;

namespace glue
{
/// Name of the point array that carries a map to the sphere: 3 doubles, unit length.
inline const char* SpherePositionName()
{
  return "SpherePosition";
}

/// What a run reads of a data object, for as long as it runs: a shallow copy, which keeps its
/// arrays when an observer of the progress empties the object or gives it others. Null for null.
///
/// Outputs are likewise made apart from what observers can reach, and handed over when they are
/// whole.
template <typename Data>
vtkSmartPointer<Data> Held(Data* data)
{
  vtkSmartPointer<Data> held;
  if (data)
  {
    held.TakeReference(data->NewInstance());
    held->ShallowCopy(data);
  }
  return held;
}

/// On the threads of vtkSMPTools; nobody watches.
conformal::Run SMPRun();

/// Reports to the filter's progress observers; stops when the filter is asked to abort.
conformal::Progress ProgressOf(vtkAlgorithm* self);

/// On these threads, with this progress.
conformal::Run RunOf(vtkAlgorithm* self);

/// What an exception of the core says to the user.
std::string MessageOf(const std::exception& error);

/// Run the core. What it throws becomes an error of the object, and false.
bool ReportErrors(vtkObject* self, const std::function<void()>& core);

/// In RequestData, all of it: check the inputs (vtkInputChecks.h) and run the core. What either
/// throws becomes an error of the filter and 0; an abort asked for by the user is no error. In both
/// cases the outputs are emptied, so that no partial result looks whole. The result is what
/// RequestData should return.
int RunCore(vtkAlgorithm* self, const std::function<void()>& core);

/// The same without a look at the inputs, for requests before RequestData.
int RunRequest(vtkAlgorithm* self, const std::function<void()>& request);

/// Warn of an input that is empty. Of several processes only the first has to say so: on the others
/// it is normal, since the first gets the whole surface.
void WarnOfEmptyInput(vtkObject* self, const char* message);

/// The frame of all points of these data sets; null pointers do not count. Data of one space have
/// one frame.
/// @param[in] reduce  adds up over the processes, where they hold parts of the points
conformal::CoordinateFrame FrameOf(
  const std::vector<vtkPointSet*>& data, const conformal::Reduce& reduce = {});

/// Coordinates in a frame, #P by 3 (empty for a null pointer).
conformal::Points ToPoints(vtkPoints* points, const conformal::CoordinateFrame& frame);

/// The coordinates in a frame, where they lie, or else in the given copy, which must outlive the
/// view.
conformal::PointView ViewPoints(
  vtkPoints* points, const conformal::CoordinateFrame& frame, conformal::Points& copy);

/// The numbers of an array with one component, likewise.
conformal::NumberView ViewNumbers(vtkDataArray* array, std::vector<double>& copy);

/// Whether to leave a point out because it is a ghost, hidden or of another piece; empty where
/// there are no ghosts.
std::function<bool(conformal::Index)> GhostTest(vtkPointSet* input);

/// The vectors of an array of 3 components where they lie, or else in the given copy, which must
/// outlive the view.
/// @throws std::invalid_argument if the array is missing or not of 3 components; what names it
conformal::PointView ViewVectors(vtkDataArray* array, const char* what, conformal::Points& copy,
  const conformal::CoordinateFrame& frame = {});

/// A named point array of 3 components as doubles; false if there is none of that shape.
bool ToVectors(vtkDataArray* array, conformal::Points& vectors);

/// A surface's map to the sphere, normalized to unit length.
/// @throws std::invalid_argument if the point array is missing, is not of 3 components, or holds
///   a vector that is zero or not finite
conformal::Points ToSpherePositions(vtkPolyData* surface);

/// The vectors of the point array "SpherePosition" as they are; false if there is none.
/// @throws std::invalid_argument if it has not 3 components
bool FindSpherePositions(vtkPolyData* surface, conformal::Points& positions);

/// Add a point array of 3 doubles.
/// @throws std::overflow_error if one is not finite, as do the functions below
void AddVectors(vtkFieldData* data, const char* name, const conformal::Points& vectors);

/// Add an array of 1 double for each point or cell.
void AddNumbers(vtkFieldData* data, const char* name, const std::vector<double>& values);

/// Add an array of 1 double for each point or cell, lengths in a frame.
void AddLengths(vtkFieldData* data, const char* name, std::vector<double> lengths,
  const conformal::CoordinateFrame& frame);

/// Add an array of one number.
void AddNumber(vtkFieldData* data, const char* name, double value);
void AddNumber(vtkFieldData* data, const char* name, long long value);

/// Add an array of one tuple of doubles.
void AddTuple(vtkFieldData* data, const char* name, const double* values, int components);

/// Lengths and coordinates, or areas, in place, from a frame to the user's unit.
/// @param[in] size  how many numbers
/// @param[in] what  names them
/// @throws std::overflow_error if they leave the range of doubles, areas also if they become too
///   small for it
void LengthsFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what);
void AreasFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what);

/// Points of a frame and triangles, replacing what the surface held.
/// @throws std::overflow_error as SetPoints
void SetSurface(vtkPolyData* surface, const conformal::Points& points,
  const conformal::Triangles& triangles, const conformal::CoordinateFrame& frame);

/// Triangles instead of the polygons a surface had.
void SetTriangles(vtkPolyData* surface, const conformal::Triangles& triangles);

/// Replace a surface's points by doubles, from a frame.
/// @throws std::overflow_error if they leave the range of doubles
void SetPoints(
  vtkPolyData* surface, const conformal::Points& points, const conformal::CoordinateFrame& frame);
}

#endif

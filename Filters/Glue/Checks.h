// What every filter and every writer checks before it reads its inputs.
#ifndef GlueChecks_h
#define GlueChecks_h

#include <string> // for what the data are

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace glue
{
/// The data on every connection of every input port, by RequireConsistentData. For RequestData;
/// before that the inputs may be those of an earlier run.
/// @throws std::invalid_argument that names the port, what does not fit, and what to do
void RequireConsistentInputs(vtkAlgorithm* self);

/// Points, cells and arrays agree with each other, so that an id of a point or cell is one of a
/// tuple too:
/// - each array of point data and of cell data, of whatever type, has a tuple for each of them;
/// - ghost arrays are of unsigned char and have 1 component, active normals and points have 3;
/// - cells of a vtkPolyData have valid offsets. The ids in them are not checked, since filters
///   of points read no cells; see RequireCellIds.
/// Of composite data each block that is there is looked at; other data objects that are no
/// vtkDataSet, and null, pass. Costs a look at each array and offset.
/// @param[in] what  what the data are to the user, for the message
/// @throws std::invalid_argument that says what does not fit, and what to do
void RequireConsistentData(vtkDataObject* data, const std::string& what);

/// Cells name only points that are there. For what reads them or passes them on.
/// @throws std::invalid_argument that names the first cell that does not
void RequireCellIds(vtkPolyData* surface);
}

#endif

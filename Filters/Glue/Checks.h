// Checks of every filter and every writer before it reads its inputs.
#ifndef GlueChecks_h
#define GlueChecks_h

#include <string> // for descriptions of data

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace glue
{
/// Check the data on every connection of every input port by RequireConsistentData(). Call it in
/// RequestData; in earlier requests, inputs may be those of a previous run.
/// @throws std::invalid_argument with the port, the inconsistency, and what to do
void RequireConsistentInputs(vtkAlgorithm* self);

/// Check that points, cells and arrays are consistent, so that the id of a point or cell is a valid
/// tuple id, too:
/// - Every array of point data and cell data, of any type, has one tuple for each point or cell.
/// - Ghost arrays are of unsigned char with 1 component; active normals and points have 3.
/// - Cells of a vtkPolyData have valid offsets. The ids in cells are not checked, since filters of
///   points read no cells; see RequireCellIds().
///
/// Every non-null block of composite data is checked. Other data objects that are no vtkDataSet,
/// and null, pass. The cost is one access to each array and offset.
/// @param[in] what  description of the data for the user, used in the message
/// @throws std::invalid_argument with the inconsistency, and what to do
void RequireConsistentData(vtkDataObject* data, const std::string& what);

/// Check that cells contain valid point ids only. Call it before cells are read or passed on.
/// @throws std::invalid_argument with the first invalid cell
void RequireCellIds(vtkPolyData* surface);
}

#endif

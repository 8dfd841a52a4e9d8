// Check the inputs of filters and writers. Every filter and writer calls these checks before it
// reads inputs.
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
/// @throws std::invalid_argument if data are inconsistent; the message contains the port, the
///   inconsistency, and what to do
void RequireConsistentInputs(vtkAlgorithm* self);

/// Check that points, cells and arrays are consistent, so that ids of points and cells are valid
/// ids of tuples:
/// - Every array of point data and cell data, of any type, has one tuple for each point or cell.
/// - Ghost arrays are of type unsigned char with 1 component. Active normals and points have 3
///   components.
/// - Cells of a vtkPolyData have valid offsets. The point ids in cells are not checked, since
///   filters of points read no cells; RequireCellIds() checks them.
///
/// In composite data, every block that is not null is checked. Null passes the check, and so do
/// other data objects that are no vtkDataSet. The cost is one access to each array and offset.
/// @param[in] what  description of the data for the user, used in the message
/// @throws std::invalid_argument if data are inconsistent; the message contains the reason, and
///   what to do
void RequireConsistentData(vtkDataObject* data, const std::string& what);

/// Check that cells contain valid point ids only. Call it before cells are read or passed on.
/// @throws std::invalid_argument if a cell is invalid; the message contains the first invalid cell
void RequireCellIds(vtkPolyData* surface);
}

#endif

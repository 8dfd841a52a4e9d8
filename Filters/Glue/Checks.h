// Check the inputs of filters and writers. Every filter and writer must call these checks before
// reading its inputs.
#ifndef GlueChecks_h
#define GlueChecks_h

#include <string> // for descriptions of data

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace glue
{
/// Check the data on every connection of every input port by RequireConsistentData(). Call this
/// function in RequestData. In the requests that precede RequestData, the inputs can still contain
/// data of the previous execution.
/// @throws std::invalid_argument if data are inconsistent. The message contains the port, the
///   inconsistency, and how to correct the data.
void RequireConsistentInputs(vtkAlgorithm* self);

/// Check that points, cells and arrays are consistent, so that array tuples can be accessed by
/// point and cell ids:
/// - Every array of point data has one tuple for each point. Every array of cell data has one tuple
///   for each cell.
/// - Ghost arrays are of type unsigned char with 1 component. Active normals and points have 3
///   components.
/// - The cells of a vtkPolyData have valid offsets. The point ids in cells are not checked, since
///   many filters read only points. RequireCellIds() checks the point ids.
///
/// In composite data, every block is checked. Null pointers, and data objects other than vtkDataSet
/// and composite data, pass the check. The cost is one access to each array and each offset.
/// @param[in] what  description of the data in the error message
/// @throws std::invalid_argument if data are inconsistent. The message contains the inconsistency,
///   and how to correct the data.
void RequireConsistentData(vtkDataObject* data, const std::string& what);

/// Check that cells contain only valid point ids. Call this function before cells are read or
/// copied to an output.
/// @throws std::invalid_argument if a cell contains an invalid point id. The message contains the
///   first invalid cell.
void RequireCellIds(vtkPolyData* surface);
}

#endif

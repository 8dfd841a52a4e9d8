// Read several surfaces with maps to the sphere from the inputs of a filter.
#ifndef GlueMappedSurfaces_h
#define GlueMappedSurfaces_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Run.h"             // for Run
#include "Mesh/Mesh.h"            // for MappedMesh

#include "vtkSmartPointer.h" // for surfaces that are held
#include "vtkType.h"         // for times

#include <cstddef> // for std::size_t
#include <string>  // for names
#include <vector>  // for surfaces

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkMultiBlockDataSet;
class vtkObject;
class vtkPolyData;

namespace glue
{
/// Set up an input port to accept vtkPolyData and composite data.
void AcceptSurfaces(vtkInformation* portInformation);

/// Surfaces of an input port. The name of a surface is the name of its block, or "".
struct Surfaces
{
  std::vector<vtkSmartPointer<vtkPolyData>> Held; ///< shallow copies by Held()
  std::vector<std::string> Names;
  /// Modification time of each surface, unique for each state of the data.
  std::vector<vtkMTimeType> Times;

  std::vector<vtkPolyData*> pointers() const;
  double numberOfPoints() const; ///< total over all surfaces
};

/// Set a block of the output, and name it as its source surface.
void SetNamedBlock(
  vtkMultiBlockDataSet* blocks, const Surfaces& surfaces, std::size_t number, vtkPolyData* block);

/// Append all surfaces on all connections of a port. Blocks keep their order; empty blocks are
/// skipped.
/// @throws std::invalid_argument if a block is no vtkPolyData
void AddSurfaces(vtkInformationVector* inputs, Surfaces& surfaces);

/// Return whether there is no surface, or a surface without points. Issue a warning in both cases.
bool HasEmpty(vtkObject* self, const Surfaces& surfaces);

/// Convert the surfaces and their maps to meshes in a common frame.
/// @throws std::invalid_argument if a surface has no triangles, no map, or a point that is not
///   finite; the message contains the number of the surface
/// @throws std::length_error if the total number of points exceeds the range of int
std::vector<conformal::MappedMesh> ToMappedMeshes(
  const Surfaces& surfaces, conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif

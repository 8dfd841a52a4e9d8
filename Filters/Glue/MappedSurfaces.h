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
/// Accept vtkPolyData and composite data on a port.
void AcceptSurfaces(vtkInformation* portInformation);

/// Surfaces with the names of their blocks, or "".
struct Surfaces
{
  std::vector<vtkSmartPointer<vtkPolyData>> Held; ///< shallow copies by Held()
  std::vector<std::string> Names;
  std::vector<vtkMTimeType> Times; ///< modification times, unique for each state of the data

  std::vector<vtkPolyData*> pointers() const;
  double numberOfPoints() const; ///< over all surfaces
};

/// Set a block of the output, with the name of its source surface.
void SetNamedBlock(
  vtkMultiBlockDataSet* blocks, const Surfaces& surfaces, std::size_t number, vtkPolyData* block);

/// Append all surfaces on all connections of a port, blocks in their order; empty blocks are
/// skipped.
/// @throws std::invalid_argument if a block is no vtkPolyData
void AddSurfaces(vtkInformationVector* inputs, Surfaces& surfaces);

/// Return whether there is no surface, or one without points, and warn of it.
bool HasEmpty(vtkObject* self, const Surfaces& surfaces);

/// Convert the surfaces and their maps to meshes in a common frame.
/// @throws std::invalid_argument with the number of the surface, if it has no triangles, no map, or
///   a point that is not finite
/// @throws std::length_error if the total number of points exceeds the range of int
std::vector<conformal::MappedMesh> ToMappedMeshes(
  const Surfaces& surfaces, conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif

// Several surfaces with maps to the sphere, from the inputs of a filter.
#ifndef GlueMappedSurfaces_h
#define GlueMappedSurfaces_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Run.h"             // for Run
#include "Mesh/Mesh.h"            // for MappedMesh

#include "vtkSmartPointer.h" // for surfaces that are held
#include "vtkType.h"         // for times

#include <string> // for names
#include <vector> // for surfaces

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkPolyData;

namespace glue
{
/// A port takes a vtkPolyData or composite data of them.
void AcceptSurfaces(vtkInformation* portInformation);

/// Surfaces, and what they are called: by their block, or "".
struct Surfaces
{
  std::vector<vtkSmartPointer<vtkPolyData>> Held; ///< as by Held()
  std::vector<std::string> Names;
  std::vector<vtkMTimeType> Times; ///< when they were modified; no two states have the same

  std::vector<vtkPolyData*> pointers() const;
  double numberOfPoints() const; ///< of all of them
};

/// All surfaces on all connections of a port, blocks one by one in their order; blocks that are not
/// there are left out.
/// @throws std::invalid_argument if a block is no vtkPolyData
void AddSurfaces(vtkInformationVector* inputs, Surfaces& surfaces);

/// The surfaces in a frame of all of them, with their maps.
/// @throws std::invalid_argument that names the surface by its number if it has no triangles, no
///   map, or a point that is not finite
/// @throws std::length_error if they have more points together than fit into an int
std::vector<conformal::MappedMesh> ToMappedMeshes(
  const Surfaces& surfaces, conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif

// Read several surfaces with maps to the sphere from an input port of a filter.
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
/// Set up an input port to accept vtkPolyData and composite data of vtkPolyData.
void AcceptSurfaces(vtkInformation* portInformation);

/// Surfaces of an input port.
struct Surfaces
{
  /// Shallow copies of the surfaces, made by glue::Held() of Glue/Run.h. The copies keep their
  /// arrays even if an observer (a callback for VTK events) changes the input.
  std::vector<vtkSmartPointer<vtkPolyData>> Held;
  /// For each surface, the name of its block in composite data; "" if the surface is not a block,
  /// or the block has no name.
  std::vector<std::string> Names;
  /// Modification time of each surface. The time changes whenever the data change.
  std::vector<vtkMTimeType> Times;

  std::vector<vtkPolyData*> pointers() const;
  double numberOfPoints() const; ///< total over all surfaces
};

/// Set a block of the output, and give it the name of the surface from which the block was
/// computed.
/// @param[in] number  index of the block, and of the surface in `surfaces`
void SetNamedBlock(
  vtkMultiBlockDataSet* blocks, const Surfaces& surfaces, std::size_t number, vtkPolyData* block);

/// Return the time steps of a port with a single input that has at least two of them. Otherwise,
/// return no times.
std::vector<double> TimeStepsOf(vtkInformationVector* inputs);

/// Return the times of separate inputs or blocks: multiples of the interval, beginning at 0.
std::vector<double> CountedTimes(std::size_t count, double interval = 1.0);

/// Set the time steps of an output in the pipeline information.
/// @param[in] times  at least one, in ascending order
void SetTimeSteps(vtkInformation* outputInformation, const std::vector<double>& times);

/// What AddSurfaces() does with blocks of composite data that are null pointers.
enum class MissingBlocks
{
  LeftOut,
  Empty ///< appended as empty surfaces, so that later blocks keep their numbers
};

/// Append the surfaces of all connections of a port. From composite data, append all blocks in
/// sequence.
/// @throws std::invalid_argument if a data object or block is not a vtkPolyData
void AddSurfaces(
  vtkInformationVector* inputs, Surfaces& surfaces, MissingBlocks missing = MissingBlocks::LeftOut);

/// Test whether there are no surfaces, or some surface has no points. If the result is true, issue
/// a warning.
bool HasEmpty(vtkObject* self, const Surfaces& surfaces);

/// Convert the surfaces and their maps to meshes in a common coordinate frame. Coordinates in the
/// frame are divided by the unit of the frame.
/// @param[out] frame  the common frame
/// @throws std::invalid_argument if a surface has no triangles, no map to the sphere, or a point
///   that is not finite. The message contains the number of the surface.
/// @throws std::length_error if the total number of points exceeds the range of int
std::vector<conformal::MappedMesh> ToMappedMeshes(
  const Surfaces& surfaces, conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif

// Adapt vtkMultiProcessController to the numerical core, which runs on several processes.
#ifndef GlueProcesses_h
#define GlueProcesses_h

#include "Base/CoordinateFrame.h" // for ToSharedMesh's argument
#include "Base/Reduce.h"          // for Reduce
#include "Base/Run.h"             // for Run
#include "Glue/ProcessSignals.h"
#include "Mesh/Mesh.h" // for MappedMesh

#include <functional> // for RunCore's argument
#include <string>     // for error messages

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

namespace glue
{
/// Processes that run a filter together. Each process has a part of the points. Usually there is a
/// single process, or no controller.
///
/// An error or an abort of one process stops all of them. Before each sum over all processes, they
/// exchange their states. No process therefore waits for one that has stopped. A process that stops
/// between sums signals this to the others, which join the exchange at their next progress report.
/// Observers are also called while processes wait for each other. Without MPI there are no signals,
/// and all processes continue to the next sum.
class Processes
{
public:
  explicit Processes(vtkAlgorithm* self = nullptr, vtkMultiProcessController* controller = nullptr);
  Processes(const Processes&) = delete;
  void operator=(const Processes&) = delete;

  int rank() const { return this->Rank; }
  int size() const { return this->Size; }
  bool isFirst() const { return this->Rank == 0; }

  /// Return an object that sums over all processes. It must not outlive this object.
  conformal::Reduce reduce();

  /// Return the lowest rank on which the condition holds, or -1 if there is none.
  int firstWith(bool condition);

  /// Return the text of one rank on all ranks.
  std::string textOf(int rank, const std::string& text);

  /// Return a run like that of RunOf(), which also stops when another process stops.
  conformal::Run run();

  /// Exchange the states of all processes. If several processes have errors, the error of the
  /// lowest rank is reported.
  /// @param[in] error  error message of this process, or null
  /// @throws SharedError if a process has an error
  /// @throws conformal::Aborted if a process was aborted
  void agree(const std::string* error = nullptr);

  /// Signal the other processes to call agree().
  void call();

private:
  std::string meet();

  vtkAlgorithm* Self;
  vtkMultiProcessController* Controller;
  int Rank = 0;
  int Size = 1;
  bool StopWanted = false;
  ProcessSignals Signals;
};

/// Implement RequestData on several processes: call `core` on all of them, and return the same
/// status on all. RunCore() in Run.h is the function for a single process.
int RunCore(vtkAlgorithm* self, vtkMultiProcessController* controller,
  const std::function<void(Processes&)>& core);

/// Implement RequestUpdateExtent for several processes: each process requests its own piece of all
/// inputs, for any requested piece of the output.
void RequestOwnPieces(
  vtkAlgorithm* self, vtkMultiProcessController* controller, vtkInformationVector** inputs);

/// Copy a mesh that one rank has to all ranks. The mesh is empty on the other ranks.
conformal::MappedMesh GatherMesh(const conformal::Reduce& reduce, const conformal::MappedMesh& own);

/// Return the same mesh with a map to the sphere on all ranks, converted from the surface of the
/// first rank that has points. The frame must be equal on all ranks.
conformal::MappedMesh ToSharedMesh(vtkAlgorithm* self, vtkPolyData* mesh,
  const conformal::CoordinateFrame& frame, Processes& processes);

/// Distribute a surface that all ranks have. If `inPieces` is false, rank 0 keeps the surface, and
/// the other ranks keep its arrays without values. If it is true, each rank keeps a contiguous
/// range of triangles with their points, and gets global ids.
void KeepOwnShare(vtkPolyData* surface, bool inPieces, const Processes& processes);
}

#endif

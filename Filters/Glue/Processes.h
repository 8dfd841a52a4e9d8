// Adapt vtkMultiProcessController to the processes of the core.
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
/// Processes that run a filter together, each on its part of the points. A single process, or no
/// controller, is the usual case.
///
/// An error or an abort of one process stops all of them. Before each sum, processes exchange their
/// states, so that none waits for another that has stopped. A process that stops earlier signals
/// this to the others, which join the exchange at their next progress report. Observers are also
/// called while processes wait for each other. Without MPI there are no signals, and all processes
/// continue to the next sum.
class Processes
{
public:
  explicit Processes(vtkAlgorithm* self = nullptr, vtkMultiProcessController* controller = nullptr);
  Processes(const Processes&) = delete;
  void operator=(const Processes&) = delete;

  int rank() const { return this->Rank; }
  int size() const { return this->Size; }
  bool isFirst() const { return this->Rank == 0; }

  /// Return the sum over all processes. Must not outlive this object.
  conformal::Reduce reduce();

  /// Return the first rank on which the condition holds; -1 for none.
  int firstWith(bool condition);

  /// Return the text of one rank on all ranks.
  std::string textOf(int rank, const std::string& text);

  /// Return a run as RunOf() does that also stops when another process stops.
  conformal::Run run();

  /// Exchange the states of all processes. Of several errors, that of the lowest rank is reported.
  /// @param[in] error  error of this process, or null
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

/// Run the core on all processes together; all return one status. See RunCore() in Run.h for a
/// single process.
int RunCore(vtkAlgorithm* self, vtkMultiProcessController* controller,
  const std::function<void(Processes&)>& core);

/// Implement RequestUpdateExtent for several processes: each requests its own piece of all inputs,
/// whatever piece of the output is requested.
void RequestOwnPieces(
  vtkAlgorithm* self, vtkMultiProcessController* controller, vtkInformationVector** inputs);

/// Gather the rows of all ranks on each rank, for a mesh that one rank has.
conformal::MappedMesh GatherMesh(const conformal::Reduce& reduce, const conformal::MappedMesh& own);

/// Convert a mesh with a map to the sphere, on all ranks, from the first rank that has points of
/// it. The frame must be equal on all ranks.
conformal::MappedMesh ToSharedMesh(vtkAlgorithm* self, vtkPolyData* mesh,
  const conformal::CoordinateFrame& frame, Processes& processes);

/// Distribute a surface that all ranks have. By default, rank 0 keeps it, and the others keep its
/// empty arrays. In pieces, each rank keeps a contiguous range of triangles with their points, and
/// global ids.
void KeepOwnShare(vtkPolyData* surface, bool inPieces, const Processes& processes);
}

#endif

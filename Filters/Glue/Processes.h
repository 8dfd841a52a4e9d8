// From vtkMultiProcessController to the processes of the core.
#ifndef GlueProcesses_h
#define GlueProcesses_h

#include "Base/CoordinateFrame.h" // for ToSharedMesh's argument
#include "Base/Reduce.h"          // for Reduce
#include "Base/Run.h"             // for Run
#include "Glue/ProcessSignals.h"
#include "Mesh/Mesh.h" // for MappedMesh

#include <functional> // for RunCore's argument
#include <string>     // for what went wrong

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

namespace glue
{
/// The processes that run a filter together, each on its part of the points. One process, or no
/// controller, is the ordinary case.
///
/// What stops one of them, an error or a request to abort, stops all of them: before they add up
/// they exchange their states, so none waits for one that has left. Who stops
/// before signals it to the others, which are busy and join the exchange at once when
/// they look, whenever they report progress. While they wait for each other their observers are
/// called, too. Without MPI there are no signals, and all go on to the next sum.
class Processes
{
public:
  explicit Processes(vtkAlgorithm* self = nullptr, vtkMultiProcessController* controller = nullptr);
  Processes(const Processes&) = delete;
  void operator=(const Processes&) = delete;

  int rank() const { return this->Rank; }
  int size() const { return this->Size; }
  bool isFirst() const { return this->Rank == 0; }

  /// How they add up. Must not outlive this.
  conformal::Reduce reduce();

  /// The first process where the condition holds; -1 for none.
  int firstWith(bool condition);

  /// The text of one process, on all of them.
  std::string textOf(int rank, const std::string& text);

  /// As RunOf; also stops when another process does.
  conformal::Run run();

  /// Exchange the state of all processes. An error of several is reported from the first of them.
  /// @param[in] error  what went wrong on this process, null for nothing
  /// @throws SharedError if something went wrong
  /// @throws conformal::Aborted if one was asked to abort
  void agree(const std::string* error = nullptr);

  /// Have the others come and agree.
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

/// Run the core on all processes together; all return the same. See RunCore for one.
int RunCore(vtkAlgorithm* self, vtkMultiProcessController* controller,
  const std::function<void(Processes&)>& core);

/// In RequestUpdateExtent: of several processes, each asks all inputs for its own piece, whatever
/// piece of the output it is asked for.
void RequestOwnPieces(
  vtkAlgorithm* self, vtkMultiProcessController* controller, vtkInformationVector** inputs);

/// The rows of all processes, on each of them; for a mesh that one of them has.
conformal::MappedMesh GatherMesh(const conformal::Reduce& reduce, const conformal::MappedMesh& own);

/// A mesh with a map to the sphere, on all processes, from the first one that has points of it, in
/// a frame that all have alike.
conformal::MappedMesh ToSharedMesh(vtkAlgorithm* self, vtkPolyData* mesh,
  const conformal::CoordinateFrame& frame, Processes& processes);

/// Of a surface that all processes have alike: the first one keeps it, the others its empty
/// arrays. Or, in pieces, each keeps a run of its triangles with their points, and global ids.
void KeepOwnShare(vtkPolyData* surface, bool inPieces, const Processes& processes);
}

#endif

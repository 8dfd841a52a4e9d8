// Run the numerical core (Filters/Numerics) on several processes, by a vtkMultiProcessController.
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
class vtkObject;
class vtkPolyData;

namespace glue
{
/// Processes that run a filter together. Each process has a part of the points. Usually there is a
/// single process, or no controller.
///
/// The processes communicate by sums over all processes (Base/Reduce.h). If one process has an
/// error or is aborted, all processes stop. Before each sum, the processes exchange their states:
/// running, aborted or failed. Therefore, no process waits for another process that has stopped.
///
/// A process that stops between two sums sends a signal to the other processes (ProcessSignals.h).
/// Each of the other processes then exchanges states at its next progress report. While processes
/// wait for each other, progress observers are called. Without MPI, there are no signals. The other
/// processes then stop only at the next sum.
class Processes
{
public:
  /// @param[in] self        filter that the processes run
  /// @param[in] controller  controller of the processes, or null for a single process
  explicit Processes(vtkAlgorithm* self = nullptr, vtkMultiProcessController* controller = nullptr);
  Processes(const Processes&) = delete;
  void operator=(const Processes&) = delete;

  /// Return the number of this process, counted from 0.
  int rank() const { return this->Rank; }
  /// Return the number of processes.
  int size() const { return this->Size; }
  bool isFirst() const { return this->Rank == 0; }

  /// Return an object that computes sums over all processes. The returned object must not outlive
  /// this Processes object.
  conformal::Reduce reduce();

  /// Return the lowest rank (process number) on which the condition is true, or -1 if it is false
  /// on all ranks.
  int firstWith(bool condition);

  /// Send the text of one rank to all ranks, and return this text on all ranks. The texts of other
  /// ranks are ignored.
  std::string textOf(int rank, const std::string& text);

  /// Return an execution context (threads and progress callback) like that of RunOf() in
  /// Glue/Run.h. In addition, the computation stops when another process stops.
  conformal::Run run();

  /// Exchange the states of all processes. If several processes have errors, the error of the
  /// lowest rank is reported.
  /// @param[in] error  error message of this process, or null
  /// @throws std::runtime_error if a process has an error
  /// @throws conformal::Aborted if a process was aborted
  void agree(const std::string* error = nullptr);

  /// Signal the other processes to stop the computation. A process that receives the signal stops
  /// and calls agree(). Without MPI, this function does nothing.
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

/// Implement RequestData of a filter on several processes. Call `core` on all processes, and return
/// the same status on all processes. The function RunCore() in Glue/Run.h is for a single process.
int RunCore(vtkAlgorithm* self, vtkMultiProcessController* controller,
  const std::function<void(Processes&)>& core);

/// Warn on the first of several processes that an input is empty on all of them. The function
/// WarnOfEmptyInput() in Glue/Run.h is for a filter that runs on each process by itself.
void WarnOfEmptyInput(vtkObject* self, const Processes& processes, const char* message);

/// Implement RequestUpdateExtent of a filter on several processes. Each process requests its own
/// piece of all inputs, whichever piece of the output is requested.
void RequestOwnPieces(
  vtkAlgorithm* self, vtkMultiProcessController* controller, vtkInformationVector** inputs);

/// Send the mesh of one rank to all ranks, and return this mesh on all ranks.
/// @param[in] own  mesh on the rank that has it; empty on all other ranks
conformal::MappedMesh GatherMesh(const conformal::Reduce& reduce, const conformal::MappedMesh& own);

/// Return on all ranks the mesh of the first rank whose surface has points. The mesh includes the
/// map of the surface to the sphere. The coordinate frame (unit of the coordinates) must be equal
/// on all ranks.
conformal::MappedMesh ToSharedMesh(vtkAlgorithm* self, vtkPolyData* mesh,
  const conformal::CoordinateFrame& frame, Processes& processes);

/// Keep on each rank only a share of a surface that is complete on all ranks.
/// @param[in] inPieces  whether each rank keeps a part of the surface. If true, each rank keeps a
///   contiguous range of triangles with their points, and global ids are added. If false, rank 0
///   keeps the whole surface. The other ranks then keep only the arrays, without values.
void KeepOwnShare(vtkPolyData* surface, bool inPieces, const Processes& processes);
}

#endif

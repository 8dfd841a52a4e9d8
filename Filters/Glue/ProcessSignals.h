// Signal all processes that run a filter together to stop. Signals are sent and received without
// blocking a process.
#ifndef GlueProcessSignals_h
#define GlueProcessSignals_h

#include <functional> // for work while waiting
#include <memory>     // for std::unique_ptr

class vtkMultiProcessController;

namespace glue
{
/// Signals by which a process informs all other processes that they must stop. The other processes
/// can be computing or waiting. Signals require MPI, since only MPI can test for a message without
/// blocking. In three cases, available() returns false: the controller does not use MPI, there is a
/// single process, or VTK is built without MPI. If available() returns false, do not call any other
/// function.
class ProcessSignals
{
public:
  explicit ProcessSignals(vtkMultiProcessController* controller);
  ~ProcessSignals();
  ProcessSignals(const ProcessSignals&) = delete;
  void operator=(const ProcessSignals&) = delete;

  /// Return whether signals can be sent.
  bool available() const { return this->Link != nullptr; }

  /// Signal all other processes to stop, unless a stop was already signaled. Return immediately.
  void askToStop();

  /// Return whether another process signaled to stop. The function returns immediately. Between two
  /// tests for messages, at least 5 milliseconds pass. Frequent calls therefore cost little.
  bool heardStop();

  /// Wait until all processes have called this function. While waiting, call `idle` repeatedly. The
  /// function `idle` must not throw exceptions.
  void meet(const std::function<void()>& idle);

  /// Remove all signals to stop, including messages that are not yet received. After a process
  /// signaled to stop, all processes must call this function at the same point of the program.
  void settle();

private:
  struct Messages;
  std::unique_ptr<Messages> Link;
};
}

#endif

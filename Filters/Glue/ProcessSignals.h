// Send non-blocking messages between the processes of a filter.
#ifndef GlueProcessSignals_h
#define GlueProcessSignals_h

#include <functional> // for work while waiting
#include <memory>     // for std::unique_ptr

class vtkMultiProcessController;

namespace glue
{
/// Signals by which a process informs the others that it stops, while they compute or wait. Only
/// MPI can test for a message without blocking. With other controllers, and if VTK is built without
/// MPI, available() is false and no other function may be called.
class ProcessSignals
{
public:
  explicit ProcessSignals(vtkMultiProcessController* controller);
  ~ProcessSignals();
  ProcessSignals(const ProcessSignals&) = delete;
  void operator=(const ProcessSignals&) = delete;

  bool available() const { return this->Link != nullptr; }

  /// Signal all other processes to stop, unless a process already did. Return immediately.
  void askToStop();

  /// Return immediately whether another process signaled to stop. Calls are cheap, since messages
  /// are tested only every few milliseconds.
  bool heardStop();

  /// Wait until all processes have called this function. Meanwhile, call `idle` repeatedly, which
  /// must not throw.
  void meet(const std::function<void()>& idle);

  /// Clear all signals to stop. After a signal, all processes must call this function at the same
  /// point of the program.
  void settle();

private:
  struct Messages;
  std::unique_ptr<Messages> Link;
};
}

#endif

// Non-blocking messages between the processes of a filter.
#ifndef GlueProcessSignals_h
#define GlueProcessSignals_h

#include <functional> // for work while waiting
#include <memory>     // for std::unique_ptr

class vtkMultiProcessController;

namespace glue
{
/// Signal to the other processes, which are busy or waiting, that this one stops. Only MPI can test
/// for a message without blocking. With other controllers, and if VTK is built without MPI, signals
/// are unavailable and must not be used.
class ProcessSignals
{
public:
  explicit ProcessSignals(vtkMultiProcessController* controller);
  ~ProcessSignals();
  ProcessSignals(const ProcessSignals&) = delete;
  void operator=(const ProcessSignals&) = delete;

  bool available() const { return this->Link != nullptr; }

  /// Signal all other processes to stop, unless one already did. Returns immediately.
  void askToStop();

  /// Return whether another process signaled to stop. Returns immediately; tests for messages every
  /// few milliseconds only, so it is cheap.
  bool heardStop();

  /// Wait until all processes have called this; `idle` is called repeatedly while waiting and must
  /// not throw.
  void meet(const std::function<void()>& idle);

  /// Clear all signals to stop. After a signal, all processes must call this at one point of the
  /// program.
  void settle();

private:
  struct Messages;
  std::unique_ptr<Messages> Link;
};
}

#endif

// Non-blocking messages between the processes of a filter.
#ifndef GlueProcessSignals_h
#define GlueProcessSignals_h

#include <functional> // for what is done while waiting
#include <memory>     // for std::unique_ptr

class vtkMultiProcessController;

namespace glue
{
/// Tells the other processes, which are busy or waiting, that this one has to stop. Only MPI can
/// look for a message without waiting for one: with other controllers, and where VTK is built
/// without MPI, signals are not available and must not be used.
class ProcessSignals
{
public:
  explicit ProcessSignals(vtkMultiProcessController* controller);
  ~ProcessSignals();
  ProcessSignals(const ProcessSignals&) = delete;
  void operator=(const ProcessSignals&) = delete;

  bool available() const { return this->Link != nullptr; }

  /// Ask all others to stop, unless one did already. Returns at once.
  void askToStop();

  /// Whether another one asked to stop. Returns at once, and costs little: looks every few
  /// milliseconds.
  bool heardStop();

  /// Wait until all have come here; idle is called again and again meanwhile and must not throw.
  void meet(const std::function<void()>& idle);

  /// Forget who asked to stop. Called by all, at the same place, if one of them did.
  void settle();

private:
  struct Messages;
  std::unique_ptr<Messages> Link;
};
}

#endif

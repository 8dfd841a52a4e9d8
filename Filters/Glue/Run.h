/// Execution of the core in a filter: threads, progress, errors, and inputs that stay as they were.
#ifndef GlueRun_h
#define GlueRun_h

#include "Base/Run.h" // for Run

#include "vtkSmartPointer.h" // for Held

#include <exception>  // for MessageOf's argument
#include <functional> // for RunCore's argument
#include <string>     // for MessageOf

class vtkAlgorithm;
class vtkObject;
class vtkPointSet;

namespace glue
{
/// Return a shallow copy of a data object, or null for null. The copy keeps its arrays while a run
/// reads them, also when a progress observer empties the object or replaces its arrays.
///
/// Outputs are built in objects that observers cannot reach, and passed on when they are complete.
template <typename Data>
vtkSmartPointer<Data> Held(Data* data)
{
  vtkSmartPointer<Data> held;
  if (data)
  {
    held.TakeReference(data->NewInstance());
    held->ShallowCopy(data);
  }
  return held;
}

/// Return a run on the threads of vtkSMPTools, without progress.
conformal::Run SMPRun();

/// Return a progress callback that invokes the filter's progress events and stops the run when the
/// filter's abort flag is set.
conformal::Progress ProgressOf(vtkAlgorithm* self);

/// Return a run on the threads of vtkSMPTools with the progress of a filter.
conformal::Run RunOf(vtkAlgorithm* self);

/// Return the text of an exception of the core for an error message.
std::string MessageOf(const std::exception& error);

/// Call `core`. Report an exception as an error of the object and return false.
bool ReportErrors(vtkObject* self, const std::function<void()>& core);

/// Implement RequestData: check the inputs (Checks.h), then call `core`. Report an exception as an
/// error of the filter; an abort is not an error. After either, empty the outputs, so that no
/// partial result looks complete.
/// @return 0 after an error, otherwise 1: the return value of RequestData
int RunCore(vtkAlgorithm* self, const std::function<void()>& core);

/// Implement a request before RequestData: call `request` as RunCore() does, without the check of
/// the inputs.
int RunRequest(vtkAlgorithm* self, const std::function<void()>& request);

/// Warn of an empty input, on the first of several processes. An empty input is normal on the other
/// processes, since the first process gets the complete surface.
void WarnOfEmptyInput(vtkObject* self, const char* message);

/// Return whether an input has no points, and warn of it as WarnOfEmptyInput() does.
bool IsEmptyInput(vtkObject* self, vtkPointSet* input, const char* message);
}

#endif

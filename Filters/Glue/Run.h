/// Run the numerical core in a filter: with threads, progress, reports of errors, and inputs that
/// stay unchanged.
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
/// reads them, even if a progress observer empties the object or replaces its arrays.
///
/// Outputs are built in objects that observers cannot access, and are copied to the output when
/// they are complete.
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

/// Return an execution context (conformal::Run) with the threads of vtkSMPTools and without
/// progress.
conformal::Run SMPRun();

/// Return a progress callback that invokes the filter's progress events and stops the run when the
/// filter's abort flag is set.
conformal::Progress ProgressOf(vtkAlgorithm* self);

/// Return an execution context (conformal::Run) with the threads of vtkSMPTools and the progress of
/// a filter.
conformal::Run RunOf(vtkAlgorithm* self);

/// Return the text of an error message for an exception of the core.
std::string MessageOf(const std::exception& error);

/// Call `core`. Report an exception as an error of the object and return false.
bool ReportErrors(vtkObject* self, const std::function<void()>& core);

/// Implement RequestData: check the inputs (Checks.h), then call `core`. Report an exception as an
/// error of the filter; an abort is not an error. After an error or an abort, empty the outputs, so
/// that no partial result looks complete.
/// @return 0 after an error, otherwise 1: the value that RequestData must return
int RunCore(vtkAlgorithm* self, const std::function<void()>& core);

/// Implement a request that precedes RequestData. Call `request` like RunCore() calls `core`, but
/// do not check the inputs.
int RunRequest(vtkAlgorithm* self, const std::function<void()>& request);

/// Warn of an empty input. Of several processes, only the first warns: it gets the complete
/// surface, and an empty input is normal on the others.
void WarnOfEmptyInput(vtkObject* self, const char* message);

/// Return whether an input has no points. If so, call WarnOfEmptyInput().
bool IsEmptyInput(vtkObject* self, vtkPointSet* input, const char* message);
}

#endif

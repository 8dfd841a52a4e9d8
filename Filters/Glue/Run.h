/// Run the numerical core (Filters/Numerics) in a filter. The functions below provide threads,
/// progress reports and error reports. One function, Held(), protects inputs against changes during
/// a run (an execution of the filter).
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
/// Return a shallow copy of a data object, or null for null. During a run, a progress observer (a
/// callback for VTK events) can empty the object or replace its arrays. The copy keeps the original
/// arrays.
///
/// Observers can also change the output of the filter. Therefore, build results in local objects,
/// and copy complete results to the output.
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

/// Return an execution context (conformal::Run) with the threads of vtkSMPTools. The context
/// reports no progress.
conformal::Run SMPRun();

/// Return a progress callback of a filter. The callback invokes progress events of the filter. If
/// the abort flag of the filter is set, the callback stops the run.
conformal::Progress ProgressOf(vtkAlgorithm* self);

/// Return an execution context (conformal::Run) with the threads of vtkSMPTools and the progress
/// callback of a filter.
conformal::Run RunOf(vtkAlgorithm* self);

/// Return the text of the error message for an exception.
std::string MessageOf(const std::exception& error);

/// Call `core`. If `core` throws an exception, report the exception as an error of `self` and
/// return false.
bool ReportErrors(vtkObject* self, const std::function<void()>& core);

/// Implement RequestData of a filter. Check the inputs (Checks.h), then call `core`. If `core`
/// throws an exception, report the exception as an error of the filter. An abort is not reported as
/// an error. After an error or an abort, empty the outputs, so that no partial result is used as a
/// complete one.
/// @return the value that RequestData must return: 0 after an error, otherwise 1
int RunCore(vtkAlgorithm* self, const std::function<void()>& core);

/// Implement a request that precedes RequestData, such as RequestInformation. Call `request`, and
/// handle exceptions like RunCore(). The inputs are not checked.
/// @return the value that the request must return: 0 after an error, otherwise 1
int RunRequest(vtkAlgorithm* self, const std::function<void()>& request);

/// Warn that an input is empty. If there are several processes, only the first process issues the
/// warning. The first process usually has the complete surface. On other processes, an empty input
/// is normal.
void WarnOfEmptyInput(vtkObject* self, const char* message);

/// Return whether an input has no points. If it has no points, call WarnOfEmptyInput().
bool IsEmptyInput(vtkObject* self, vtkPointSet* input, const char* message);
}

#endif

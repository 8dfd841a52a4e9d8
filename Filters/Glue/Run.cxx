#include "Glue/Run.h"

#include "Glue/Checks.h"
#include "Glue/Compatibility.h"
#include "Glue/FailedRequests.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"
#include "vtkObject.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <new>

namespace
{
void EmptyOutputs(vtkAlgorithm* self)
{
  for (int port = 0; port < self->GetNumberOfOutputPorts(); ++port)
  {
    if (vtkDataObject* output = self->GetOutputDataObject(port))
    {
      output->Initialize();
    }
  }
}
}

namespace glue
{
//------------------------------------------------------------------------------
conformal::Run SMPRun()
{
  // An exception that leaves a thread of the backend STDThread ends the program. Exceptions are
  // therefore kept, and the one of the lowest index is thrown again by the calling thread.
  const conformal::ParallelFor threads =
    [](conformal::Index count, const std::function<void(conformal::Index)>& body)
  {
    std::mutex mutex;
    std::exception_ptr error;
    vtkIdType indexOfError = count;
    vtkSMPTools::For(0, count, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          try
          {
            body(i);
          }
          catch (...)
          {
            const std::lock_guard<std::mutex> lock(mutex);
            if (i < indexOfError)
            {
              indexOfError = i;
              error = std::current_exception();
            }
          }
        }
      });
    if (error)
    {
      std::rethrow_exception(error);
    }
  };
  return { threads };
}

//------------------------------------------------------------------------------
conformal::Progress ProgressOf(vtkAlgorithm* self)
{
  // Observers may render and may abort. Call them after each visible step of progress. During slow
  // runs, also call them at intervals: 50 ms, or a thousandth of the elapsed time if this is
  // longer. The intervals limit the number of calls.
  constexpr double minimumStep = 0.002;
  using Clock = std::chrono::steady_clock;
  struct State
  {
    Clock::time_point Start = Clock::now(), Last = Start;
    double Reached = 0.0, Next = 0.0;
  };
  // All copies of the callback share this state.
  const auto state = std::make_shared<State>();
  return [=](double reached)
  {
    const Clock::time_point now = Clock::now();
    const Clock::duration longest =
      std::max<Clock::duration>(std::chrono::milliseconds(50), (now - state->Start) / 1000);
    if (reached >= state->Next || reached == 1.0 || now - state->Last >= longest)
    {
      state->Reached = std::max(state->Reached, reached);
      state->Next = state->Reached + minimumStep;
      state->Last = now;
      self->UpdateProgress(state->Reached);
    }
    return !glue::IsAbortWanted(self);
  };
}

//------------------------------------------------------------------------------
conformal::Run RunOf(vtkAlgorithm* self)
{
  return SMPRun().watchedBy(ProgressOf(self));
}

//------------------------------------------------------------------------------
std::string MessageOf(const std::exception& error)
{
  return dynamic_cast<const std::bad_alloc*>(&error) ? "out of memory" : error.what();
}

//------------------------------------------------------------------------------
bool ReportErrors(vtkObject* self, const std::function<void()>& core)
{
  try
  {
    core();
    return true;
  }
  catch (const std::exception& e)
  {
    vtkErrorWithObjectMacro(self, << MessageOf(e));
  }
  return false;
}

//------------------------------------------------------------------------------
int RunCore(vtkAlgorithm* self, const std::function<void()>& core)
{
  return RunRequest(self,
    [&]()
    {
      glue::RequireConsistentInputs(self);
      core();
      RunOf(self).report(1.0); // last check for an abort
    });
}

//------------------------------------------------------------------------------
int RunRequest(vtkAlgorithm* self, const std::function<void()>& request)
{
  bool whole = true;
  const bool good = ReportErrors(self,
    [&]()
    {
      try
      {
        request();
      }
      catch (const conformal::Aborted&)
      {
        whole = false;
      }
    });
  if (!good || !whole)
  {
    EmptyOutputs(self);
  }
  return good ? 1 : FailedRequest(self);
}

//------------------------------------------------------------------------------
void WarnOfEmptyInput(vtkObject* self, const char* message)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (!processes || processes->GetLocalProcessId() == 0)
  {
    vtkWarningWithObjectMacro(self, << message);
  }
}

//------------------------------------------------------------------------------
bool IsEmptyInput(vtkObject* self, vtkPointSet* input, const char* message)
{
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  if (isEmpty)
  {
    WarnOfEmptyInput(self, message);
  }
  return isEmpty;
}
}

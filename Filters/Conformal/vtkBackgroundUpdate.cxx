#include "vtkBackgroundUpdate.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <atomic>
#include <exception>
#include <initializer_list>
#include <system_error>
#include <thread>
#include <vector>

vtkStandardNewMacro(vtkBackgroundUpdate);

namespace
{
int SizeOf(const std::vector<std::string>& texts)
{
  return static_cast<int>(texts.size());
}

std::string TextOf(const std::vector<std::string>& texts, int index)
{
  return index >= 0 && index < SizeOf(texts) ? texts[static_cast<size_t>(index)] : std::string();
}
}

struct vtkBackgroundUpdate::State
{
  // Observer on the new thread. Other threads read only the atomic members while the update runs.
  class Listener : public vtkCommand
  {
  public:
    static Listener* New() { return new Listener; }

    void Execute(vtkObject* caller, unsigned long event, void* data) override
    {
      if (event == vtkCommand::ProgressEvent)
      {
        this->Progress = *static_cast<double*>(data);
        // The executive clears this flag at the start of an update, so that Abort() must not set
        // it.
        if (this->IsAborted)
        {
          static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
        }
      }
      else
      {
        const char* text = static_cast<const char*>(data);
        auto& texts = event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings;
        texts.emplace_back(text ? text : "");
      }
    }

    std::atomic<double> Progress{ 0.0 };
    std::atomic<bool> IsAborted{ false };
    std::atomic<bool> IsRunning{ false };
    std::vector<std::string> Errors, Warnings;
  };

  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkSmartPointer<vtkExecutive> Executive;
  vtkSmartPointer<Listener> Heard = vtkSmartPointer<Listener>::New();
  std::thread Thread;

  void Observe()
  {
    this->Algorithm->AddObserver(vtkCommand::ProgressEvent, this->Heard);
    const std::initializer_list<vtkObject*> sources = { this->Algorithm, this->Executive };
    for (vtkObject* source : sources)
    {
      source->AddObserver(vtkCommand::ErrorEvent, this->Heard);
      source->AddObserver(vtkCommand::WarningEvent, this->Heard);
    }
  }

  void End()
  {
    if (this->Thread.joinable())
    {
      this->Thread.join();
    }
    if (this->Algorithm)
    {
      this->Algorithm->RemoveObserver(this->Heard);
      this->Executive->RemoveObserver(this->Heard);
      this->Algorithm = nullptr;
      this->Executive = nullptr;
    }
  }
};

//------------------------------------------------------------------------------
vtkBackgroundUpdate::vtkBackgroundUpdate()
  : Current(new State)
{
}

//------------------------------------------------------------------------------
vtkBackgroundUpdate::~vtkBackgroundUpdate()
{
  this->Abort();
  this->Wait();
}

//------------------------------------------------------------------------------
void vtkBackgroundUpdate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsRunning: " << (this->IsRunning() ? "true" : "false") << "\n";
  os << indent << "Progress: " << this->GetProgress() << "\n";
}

//------------------------------------------------------------------------------
bool vtkBackgroundUpdate::Start(vtkAlgorithm* algorithm)
{
  if (!algorithm || this->IsRunning())
  {
    vtkErrorMacro(<< (algorithm ? "the earlier update still runs; call Wait() first"
                                : "there is no algorithm to update"));
    return false;
  }
  this->Wait();
  this->Current.reset(new State);
  State& state = *this->Current;
  state.Algorithm = algorithm;
  state.Executive = algorithm->GetExecutive();
  state.Observe();
  if (algorithm->GetNumberOfOutputPorts() == 0)
  {
    algorithm->Modified(); // a writer writes anew, even if its input did not change
  }
  state.Heard->IsRunning = true;
  // The raw pointers are valid until End(), which joins the thread.
  const auto update = [algorithm, heard = state.Heard.Get()]()
  {
    try
    {
      algorithm->Update();
    }
    catch (const std::exception& error) // such as std::bad_alloc from a filter of VTK
    {
      heard->Errors.emplace_back(error.what());
    }
    heard->IsRunning = false;
  };
  try
  {
    state.Thread = std::thread(update);
  }
  catch (const std::system_error&) // no thread is available
  {
    update();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkBackgroundUpdate::IsRunning() const
{
  return this->Current->Heard->IsRunning;
}

//------------------------------------------------------------------------------
void vtkBackgroundUpdate::Abort()
{
  this->Current->Heard->IsAborted = true;
}

//------------------------------------------------------------------------------
void vtkBackgroundUpdate::Wait()
{
  this->Current->End();
}

//------------------------------------------------------------------------------
double vtkBackgroundUpdate::GetProgress() const
{
  return this->Current->Heard->Progress;
}

//------------------------------------------------------------------------------
int vtkBackgroundUpdate::GetNumberOfErrors() const
{
  return SizeOf(this->Current->Heard->Errors);
}

//------------------------------------------------------------------------------
std::string vtkBackgroundUpdate::GetError(int index) const
{
  return TextOf(this->Current->Heard->Errors, index);
}

//------------------------------------------------------------------------------
int vtkBackgroundUpdate::GetNumberOfWarnings() const
{
  return SizeOf(this->Current->Heard->Warnings);
}

//------------------------------------------------------------------------------
std::string vtkBackgroundUpdate::GetWarning(int index) const
{
  return TextOf(this->Current->Heard->Warnings, index);
}

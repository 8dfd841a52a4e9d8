#include "Glue/FailedRequests.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"

#include <string>

namespace
{
// Observer of one error of the pipeline.
class NextError : public vtkCommand
{
public:
  static NextError* New() { return new NextError; }

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const auto* text = static_cast<const char*>(data);
    caller->RemoveObserver(this);
    if (text && std::string(text).find(" returned failure for request: ") == std::string::npos)
    {
      vtkOutputWindowDisplayErrorText(text);
    }
  }
};
}

namespace glue
{
//------------------------------------------------------------------------------
int FailedRequest(vtkAlgorithm* self)
{
  vtkExecutive* executive = self->GetExecutive();
  if (executive && !executive->HasObserver(vtkCommand::ErrorEvent))
  {
    const vtkNew<NextError> observer;
    executive->AddObserver(vtkCommand::ErrorEvent, observer);
  }
  return 0;
}
}

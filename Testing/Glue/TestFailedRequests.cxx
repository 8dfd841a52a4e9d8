#include "Glue/FailedRequests.h"
#include "Glue/Run.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace
{
/// Source whose request fails after a message.
class Failing : public vtkPolyDataAlgorithm
{
public:
  static Failing* New();
  vtkTypeMacro(Failing, vtkPolyDataAlgorithm);

protected:
  Failing() { this->SetNumberOfInputPorts(0); }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    return glue::RunRequest(this, []() { throw std::invalid_argument("no luck"); });
  }
};
vtkStandardNewMacro(Failing);

/// Source that calls FailedRequest(), but whose pipeline then has another error.
class Contradicting : public vtkPolyDataAlgorithm
{
public:
  static Contradicting* New();
  vtkTypeMacro(Contradicting, vtkPolyDataAlgorithm);

protected:
  Contradicting() { this->SetNumberOfInputPorts(0); }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    glue::FailedRequest(this);
    vtkErrorWithObjectMacro(this->GetExecutive(), "another matter");
    return 1;
  }
};
vtkStandardNewMacro(Contradicting);

/// Texts that are printed while the object exists.
class Printed
{
public:
  Printed() { vtkOutputWindow::SetInstance(this->Window); }
  ~Printed() { vtkOutputWindow::SetInstance(this->Before); }
  int count(const std::string& text) const
  {
    int found = 0;
    const std::string all = this->Window->GetOutput();
    for (std::size_t at = all.find(text); at != all.npos; at = all.find(text, at + 1))
    {
      ++found;
    }
    return found;
  }

private:
  vtkSmartPointer<vtkOutputWindow> Before = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> Window;
};
}

TEST(FailedRequests, AreReportedOnceInEachUpdate)
{
  const Printed printed;
  const vtkNew<Failing> failing;
  for (int update = 1; update <= 3; ++update)
  {
    failing->Modified();
    failing->Update();
    EXPECT_EQ(printed.count("no luck"), update);
  }
  EXPECT_EQ(printed.count("returned failure"), 0);
  EXPECT_FALSE(failing->GetExecutive()->HasObserver(vtkCommand::ErrorEvent));
}

TEST(FailedRequests, DoNotHideOtherErrors)
{
  const Printed printed;
  const vtkNew<Contradicting> contradicting;
  contradicting->Update();
  EXPECT_EQ(printed.count("another matter"), 1);
}

TEST(FailedRequests, AreReportedToObserversOfThePipeline)
{
  const Printed printed;
  const vtkNew<Failing> failing;
  int heard = 0;
  const vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&heard);
  listener->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  failing->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, listener);
  failing->Update();
  failing->Modified();
  failing->Update();
  EXPECT_EQ(heard, 2);
}

// Check what all filters have in common: arrays, updates, messages, and aborted runs.
#ifndef FilterContract_h
#define FilterContract_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

namespace contract
{
/// Expect an array with a name, type, number of components and number of tuples. All numbers must
/// be finite.
/// @param[in] dataType  type of VTK, or -1 for any type
inline void ExpectArray(
  vtkFieldData* data, const char* name, int dataType, int components, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(name);
  ASSERT_NE(array, nullptr) << name;
  if (dataType >= 0)
  {
    EXPECT_EQ(array->GetDataType(), dataType) << name;
  }
  EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
  ASSERT_EQ(array->GetNumberOfTuples(), tuples) << name;
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      ASSERT_TRUE(std::isfinite(array->GetComponent(i, c))) << name << " " << i;
    }
  }
}

/// Expect a point array "SpherePosition", with 3 doubles of unit length for each point.
inline void ExpectSpherePosition(vtkPolyData* surface)
{
  ExpectArray(
    surface->GetPointData(), "SpherePosition", VTK_DOUBLE, 3, surface->GetNumberOfPoints());
  vtkDataArray* array = surface->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* n = array->GetTuple3(i);
    ASSERT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0, 1e-12);
  }
}

/// Expect that Update() runs the filter only after a change. The function modify() must cause a
/// further run.
template <typename Modify>
void ExpectRunsOnlyWhenModified(vtkAlgorithm* filter, Modify modify)
{
  filter->Update();
  const vtkMTimeType first = filter->GetOutputDataObject(0)->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetMTime(), first);
  modify();
  filter->Update();
  EXPECT_GT(filter->GetOutputDataObject(0)->GetMTime(), first);
}

/// Expect that PrintSelf() prints a property.
inline void ExpectPrints(vtkObject* object, const std::string& property)
{
  std::ostringstream text;
  object->Print(text);
  EXPECT_NE(text.str().find(property + ":"), std::string::npos) << property;
}

/// Expect that an aborted run of a filter has an empty output and no message. The next run must be
/// complete.
inline void ExpectStopsWhenAsked(vtkAlgorithm* filter)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.3);
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Modified();
  filter->Update();
  EXPECT_FALSE(observer->GetError() || observer->GetWarning());
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_GT(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
}

/// Record of the errors and warnings of a filter and of its executive.
class Observed
{
public:
  explicit Observed(vtkAlgorithm* filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Executive);
  }
  bool Error() const { return this->Observer->GetError(); }
  bool ExecutiveError() const { return this->Executive->GetError(); }
  bool Warning() const { return this->Observer->GetWarning(); }
  std::string ErrorMessage() const { return this->Observer->GetErrorMessage(); }
  std::string WarningMessage() const { return this->Observer->GetWarningMessage(); }
  void Clear() { this->Observer->Clear(); }

  /// Expect an error whose message contains a text.
  void ExpectError(const std::string& text) const
  {
    EXPECT_TRUE(this->Error());
    EXPECT_NE(this->ErrorMessage().find(text), std::string::npos) << this->ErrorMessage();
  }
  /// Expect no error, and a warning whose message contains a text. If the text is empty, expect no
  /// warning.
  void ExpectWarning(const std::string& text) const
  {
    EXPECT_FALSE(this->Error()) << this->ErrorMessage();
    EXPECT_EQ(this->Warning(), !text.empty());
    EXPECT_TRUE(text.empty() || this->WarningMessage().find(text) != std::string::npos)
      << this->WarningMessage();
  }

private:
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> Executive;
};

/// Test fixture with a filter, and with the messages of its last run.
template <typename Class>
class FilterTest : public testing::Test
{
protected:
  void Run()
  {
    this->Seen.Clear();
    this->Filter->Modified();
    this->Filter->Update();
  }

  vtkNew<Class> Filter;
  Observed Seen{ this->Filter };
};
}

#endif

// What every filter owes its users, said once.
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
/// A named array with so many components and tuples, all finite. Pass dataType -1 for any type.
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

/// A point array "SpherePosition": 3 doubles of unit length, one for each of the points.
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

/// Update() runs once until something changes; modify() must make it run again.
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

/// PrintSelf names the property.
inline void ExpectPrints(vtkObject* object, const std::string& property)
{
  std::ostringstream text;
  object->Print(text);
  EXPECT_NE(text.str().find(property + ":"), std::string::npos) << property;
}

/// Asked to stop on the way, the filter leaves nothing and reports nothing.
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

/// Counts errors and warnings of a filter and of its executive, and keeps their texts.
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

  /// There was an error with this text.
  void ExpectError(const std::string& text) const
  {
    EXPECT_TRUE(this->Error());
    EXPECT_NE(this->ErrorMessage().find(text), std::string::npos) << this->ErrorMessage();
  }
  /// No error, and a warning with this text, or none if it is empty.
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

/// A filter, run as often as asked, and what it says of the last run.
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

// Test filters whose input is many surfaces with maps to the sphere.
#ifndef ManySurfaces_h
#define ManySurfaces_h

#include "FilterContract.h"

#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace contract
{
inline vtkPolyData* BlockOf(vtkMultiBlockDataSetAlgorithm* filter, unsigned int i)
{
  return vtkPolyData::SafeDownCast(filter->GetOutput()->GetBlock(i));
}

/// Test fixture with a filter and its input, a data set with a surface in each block. Output port 1
/// of the filter is the mean of the surfaces.
template <typename Class>
class OfManySurfaces : public FilterTest<Class>
{
protected:
  OfManySurfaces() { this->Filter->SetInputDataObject(this->Blocks); }

  void Add(vtkPolyData* surface)
  {
    this->Blocks->SetBlock(static_cast<unsigned int>(this->Surfaces.size()), surface);
    this->Surfaces.emplace_back(surface);
  }

  vtkPolyData* Mean() { return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1)); }

  void ExpectRefused(const std::string& why)
  {
    this->Run();
    this->Seen.ExpectError(why);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Mean()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Mean()->GetPointData()->GetNumberOfArrays(), 0);
  }

  /// Expect that the number of threads does not change the points of the mean. If the name of an
  /// array is given, the values of this array must not change either.
  void ExpectThreadsChangeNoBit(const char* array = nullptr)
  {
    vtkNew<vtkPolyData> alone;
    vtkSMPTools::Initialize(1);
    this->Run();
    alone->DeepCopy(this->Mean());
    vtkSMPTools::Initialize(2);
    this->Run();
    vtkPolyData* both = this->Mean();
    ASSERT_GT(both->GetNumberOfPoints(), 0);
    ASSERT_EQ(both->GetNumberOfPoints(), alone->GetNumberOfPoints());
    for (vtkIdType i = 0; i < both->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      both->GetPoint(i, p);
      alone->GetPoint(i, q);
      ASSERT_EQ(vtkMath::Distance2BetweenPoints(p, q), 0.0);
      for (int c = 0; array && c < 3; ++c)
      {
        ASSERT_EQ(both->GetPointData()->GetArray(array)->GetComponent(i, c),
          alone->GetPointData()->GetArray(array)->GetComponent(i, c));
      }
    }
    vtkSMPTools::Initialize();
  }

  std::vector<vtkSmartPointer<vtkPolyData>> Surfaces;
  vtkNew<vtkMultiBlockDataSet> Blocks;
};
}

#endif

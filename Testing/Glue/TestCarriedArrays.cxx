#include "Glue/CarriedArrays.h"

#include "MeshFixtures.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{
// Add an array with the same value at all points.
template <typename Array>
void addConstant(vtkPolyData* surface, const char* name, double value, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  for (int c = 0; c < components; ++c)
  {
    array->FillComponent(c, value);
  }
  surface->GetPointData()->AddArray(array);
}

// Carry the arrays of two surfaces to one point, halfway between their first points.
vtkNew<vtkPointData> carriedHalfway(vtkPolyData* first, vtkPolyData* second)
{
  conformal::ResampleWeights weights;
  weights.add({ { 0, 0.25 }, { static_cast<int>(first->GetNumberOfPoints()), 0.75 } });
  vtkNew<vtkPointData> carried;
  glue::CarryPointArrays(first, { first, second }, weights, carried);
  return carried;
}
}

TEST(CarriedArrays, HaveATypeForTheValuesOfAllSurfaces)
{
  vtkNew<vtkPolyData> first = fixtures::Ellipsoid(2), second = fixtures::Ellipsoid(2);
  addConstant<vtkUnsignedCharArray>(first, "Intensity", 100.0);
  addConstant<vtkDoubleArray>(second, "Intensity", 1000.0);
  addConstant<vtkUnsignedCharArray>(first, "Label", 3.0);
  addConstant<vtkIntArray>(second, "Label", 300.0);
  addConstant<vtkUnsignedCharArray>(first, "Color", 255.0, 3);
  addConstant<vtkIntArray>(second, "Color", 1000.0, 3);
  addConstant<vtkFloatArray>(first, "Height", 1.0);
  addConstant<vtkFloatArray>(second, "Height", 2.0);
  for (const bool isSwapped : { false, true })
  {
    vtkNew<vtkPointData> carried =
      isSwapped ? carriedHalfway(second, first) : carriedHalfway(first, second);
    const auto at = [&](const char* name) { return carried->GetArray(name)->GetComponent(0, 0); };
    EXPECT_EQ(at("Intensity"), isSwapped ? 325.0 : 775.0);
    EXPECT_EQ(at("Label"), isSwapped ? 3.0 : 300.0);
    EXPECT_EQ(at("Color"), isSwapped ? 441.25 : 813.75);
    EXPECT_EQ(carried->GetArray("Label")->GetDataType(), VTK_LONG_LONG);
    EXPECT_EQ(carried->GetArray("Height")->GetDataType(), VTK_FLOAT);
  }
}

TEST(CarriedArrays, AreNotPlacesOrIds)
{
  vtkNew<vtkPolyData> surface = fixtures::Ellipsoid(2);
  addConstant<vtkFloatArray>(surface, "Height", 1.0);
  for (const char* name : { "TexturePosition", "TargetBarycentric", "Longitude", "DiskPosition" })
  {
    addConstant<vtkDoubleArray>(surface, name, 1.0, 3);
  }
  for (const char* name : { "TargetPointIds", "TargetCellId", "OriginalPointIds" })
  {
    addConstant<vtkIntArray>(surface, name, 1.0);
  }
  vtkNew<vtkPointData> carried = carriedHalfway(surface, surface);
  ASSERT_EQ(carried->GetNumberOfArrays(), 1);
  EXPECT_EQ(carried->GetArray(0)->GetName(), std::string("Height"));
}

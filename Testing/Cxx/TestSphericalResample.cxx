#include "vtkSphericalResample.h"

#include "FilterContract.h"
#include "MeshFixtures.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

using fixtures::Ellipsoid;

namespace
{
vtkDataArray* MapOf(vtkPolyData* surface)
{
  return surface->GetPointData()->GetArray("SpherePosition");
}

/// An array whose values are functions of the place on the sphere.
template <typename Array>
vtkNew<Array> OfPlaces(
  vtkPolyData* surface, const char* name, const std::function<double(const double*)>& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    array->InsertNextTuple1(value(MapOf(surface)->GetTuple3(i)));
  }
  surface->GetPointData()->AddArray(array);
  return array;
}

double Height(const double* n)
{
  return n[2];
}

double Half(const double* n)
{
  return n[0] > 0.0 ? 40.0 : 7.0;
}

class SphericalResample : public testing::Test
{
protected:
  SphericalResample()
  {
    this->Filter->SetInputData(this->Target);
    this->Filter->SetSourceData(this->Source);
  }

  vtkPolyData* Run()
  {
    this->Seen.Clear();
    this->Filter->Modified();
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  vtkDataArray* Carried(const char* name)
  {
    vtkDataArray* array = this->Run()->GetPointData()->GetArray(name);
    EXPECT_FALSE(this->Seen.Error()) << this->Seen.ErrorMessage();
    return array;
  }

  void ExpectRefused(const std::string& why)
  {
    vtkPolyData* output = this->Run();
    this->Seen.ExpectError(why);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
  }

  vtkNew<vtkPolyData> Source = Ellipsoid(20), Target = Ellipsoid(9);
  vtkNew<vtkSphericalResample> Filter;
  contract::Observed Seen{ this->Filter };
};
}

TEST_F(SphericalResample, CarriesNumbersByBothMethods)
{
  EXPECT_EQ(this->Filter->GetMethod(), vtkSphericalResample::AREA_ADAPTIVE);
  EXPECT_EQ(this->Filter->GetMaskArrayName(), "");
  OfPlaces<vtkFloatArray>(this->Source, "Height", Height);
  for (const int method :
    { vtkSphericalResample::BARYCENTRIC, vtkSphericalResample::AREA_ADAPTIVE })
  {
    this->Filter->SetMethod(method);
    vtkDataArray* carried = this->Carried("Height");
    contract::ExpectArray(this->Filter->GetOutput()->GetPointData(), "Height", VTK_FLOAT, 1, 812);
    for (vtkIdType i = 0; i < 812; ++i)
    {
      ASSERT_NEAR(carried->GetTuple1(i), MapOf(this->Target)->GetComponent(i, 2), 0.01);
    }
  }
  EXPECT_EQ(this->Filter->GetOutput()->GetPoints(), this->Target->GetPoints());
  EXPECT_EQ(this->Filter->GetOutput()->GetPolys(), this->Target->GetPolys());
  EXPECT_FALSE(this->Seen.Warning());
}

TEST_F(SphericalResample, OntoTheSameMapEverythingStays)
{
  const vtkNew<vtkPolyData> same = Ellipsoid(20);
  for (vtkIdType i = 0; i < same->GetNumberOfPoints(); ++i)
  {
    double p[3];
    same->GetPoint(i, p);
    same->GetPoints()->SetPoint(i, p[1], 5.0 * p[0], p[2]); // of another shape
  }
  this->Filter->SetInputData(same);
  const auto height = OfPlaces<vtkDoubleArray>(this->Source, "Height", Height);
  vtkDataArray* carried = this->Carried("Height");
  for (vtkIdType i = 0; i < same->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(carried->GetTuple1(i), height->GetValue(i), 1e-7);
  }
}

TEST_F(SphericalResample, LabelsAreNeverMixed)
{
  OfPlaces<vtkIntArray>(this->Source, "Parcels", Half);
  const auto large = OfPlaces<vtkLongLongArray>(this->Source, "Large", Half);
  const long long odd = (1LL << 60) + 1;
  for (vtkIdType i = 0; i < large->GetNumberOfTuples(); ++i)
  {
    large->SetValue(i, large->GetValue(i) == 7 ? 7 : odd);
  }
  vtkDataArray* parcels = this->Carried("Parcels");
  auto* exact =
    vtkLongLongArray::SafeDownCast(this->Filter->GetOutput()->GetPointData()->GetArray("Large"));
  ASSERT_NE(exact, nullptr);
  vtkIdType right = 0;
  for (vtkIdType i = 0; i < parcels->GetNumberOfTuples(); ++i)
  {
    const double label = parcels->GetTuple1(i);
    ASSERT_TRUE(label == 7.0 || label == 40.0) << label;
    EXPECT_EQ(exact->GetValue(i), label == 7.0 ? 7 : odd);
    const double x = MapOf(this->Target)->GetComponent(i, 0);
    right += std::abs(x) > 0.1 ? label == Half(&x) : 1;
  }
  EXPECT_EQ(right, parcels->GetNumberOfTuples());
}

TEST_F(SphericalResample, ColorsAreMixedAndRounded)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < this->Source->GetNumberOfPoints(); ++i)
  {
    const double z = MapOf(this->Source)->GetComponent(i, 2);
    colors->InsertNextTuple3(255.0, 100.0 * (z + 1.0), 3.0);
  }
  this->Source->GetPointData()->SetScalars(colors);
  vtkDataArray* carried = this->Carried("Colors");
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetScalars(), carried);
  contract::ExpectArray(
    this->Filter->GetOutput()->GetPointData(), "Colors", VTK_UNSIGNED_CHAR, 3, 812);
  for (vtkIdType i = 0; i < 812; ++i)
  {
    ASSERT_EQ(carried->GetComponent(i, 0), 255.0);
    ASSERT_NEAR(
      carried->GetComponent(i, 1), 100.0 * (MapOf(this->Target)->GetComponent(i, 2) + 1.0), 3.0);
    ASSERT_EQ(carried->GetComponent(i, 2), 3.0);
  }
}

// Spheres in files have a radius of 100 and are rounded to floats.
TEST_F(SphericalResample, SpheresOfRadius100InFloatsAreMaps)
{
  OfPlaces<vtkDoubleArray>(this->Source, "Height", Height);
  vtkNew<vtkDoubleArray> expected;
  expected->DeepCopy(this->Carried("Height"));
  for (vtkPolyData* surface : { this->Source.Get(), this->Target.Get() })
  {
    vtkNew<vtkFloatArray> rounded;
    rounded->SetName("SpherePosition");
    rounded->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* n = MapOf(surface)->GetTuple3(i);
      rounded->InsertNextTuple3(100.0 * n[0], 100.0 * n[1], 100.0 * n[2]);
    }
    surface->GetPointData()->AddArray(rounded);
  }
  vtkDataArray* carried = this->Carried("Height");
  for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(carried->GetTuple1(i), expected->GetValue(i), 1e-5);
  }
}

TEST_F(SphericalResample, PointsOnASphereAreTheirOwnMap)
{
  this->Filter->SetMethodToBarycentric();
  OfPlaces<vtkDoubleArray>(this->Source, "Height", Height);
  vtkNew<vtkDoubleArray> expected;
  expected->DeepCopy(this->Carried("Height"));
  for (vtkPolyData* surface : { this->Source.Get(), this->Target.Get() })
  {
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* n = MapOf(surface)->GetTuple3(i);
      surface->GetPoints()->SetPoint(i, 100.0 * n[0], 100.0 * n[1], 100.0 * n[2]);
    }
    surface->GetPointData()->RemoveArray("SpherePosition");
    surface->Modified();
  }
  vtkDataArray* carried = this->Carried("Height");
  for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(carried->GetTuple1(i), expected->GetValue(i), 1e-6);
  }
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("SpherePosition"), nullptr);
}

TEST_F(SphericalResample, MaskedPointsDoNotCount)
{
  OfPlaces<vtkDoubleArray>(
    this->Source, "Values", [](const double* n) { return n[0] > 0.0 ? 1.0 : 1000.0; });
  OfPlaces<vtkUnsignedCharArray>(
    this->Source, "Cortex", [](const double* n) { return n[0] > 0.0; });
  this->Filter->SetMaskArrayName("Cortex");
  vtkDataArray* values = this->Carried("Values");
  vtkPointData* data = this->Filter->GetOutput()->GetPointData();
  contract::ExpectArray(data, "ResampleMask", VTK_UNSIGNED_CHAR, 1, 812);
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < 812; ++i)
  {
    const bool isInside = data->GetArray("ResampleMask")->GetTuple1(i) == 1.0;
    inside += isInside;
    ASSERT_EQ(values->GetTuple1(i), isInside ? 1.0 : 0.0);
  }
  EXPECT_NEAR(static_cast<double>(inside) / 812.0, 0.5, 0.1);
}

TEST_F(SphericalResample, WhatSaysWherePointsAreIsNotCarried)
{
  OfPlaces<vtkDoubleArray>(this->Source, "Height", Height);
  OfPlaces<vtkDoubleArray>(this->Target, "Height", [](const double*) { return 99.0; });
  OfPlaces<vtkDoubleArray>(this->Target, "Own", [](const double*) { return 5.0; });
  vtkNew<vtkStringArray> words;
  words->SetName("Words");
  words->SetNumberOfValues(this->Source->GetNumberOfPoints());
  this->Source->GetPointData()->AddArray(words);
  vtkPointData* data = this->Run()->GetPointData();
  EXPECT_EQ(data->GetArray("SpherePosition"), MapOf(this->Target));
  EXPECT_EQ(data->GetNormals(), this->Target->GetPointData()->GetNormals());
  EXPECT_EQ(data->GetArray("Own")->GetTuple1(3), 5.0);
  EXPECT_LT(data->GetArray("Height")->GetTuple1(3), 2.0);
  EXPECT_EQ(data->GetAbstractArray("Words"), nullptr);
  EXPECT_EQ(this->Target->GetPointData()->GetArray("Height")->GetTuple1(3), 99.0);
}

TEST_F(SphericalResample, NumbersThatAreNotFiniteDoNotCount)
{
  const double NaN = std::numeric_limits<double>::quiet_NaN();
  const auto array =
    OfPlaces<vtkDoubleArray>(this->Source, "Values", [](const double*) { return 3.0; });
  array->SetValue(5, NaN);
  array->SetValue(77, HUGE_VAL);
  vtkDataArray* carried = this->Carried("Values");
  EXPECT_FALSE(this->Seen.Warning());
  for (vtkIdType i = 0; i < 812; ++i)
  {
    ASSERT_EQ(carried->GetTuple1(i), 3.0);
  }
  array->Fill(NaN);
  carried = this->Carried("Values");
  this->Seen.ExpectWarning("812 values of point arrays are 0");
  EXPECT_EQ(carried->GetTuple1(0), 0.0);
}

TEST_F(SphericalResample, ThreadsChangeNoBit)
{
  OfPlaces<vtkDoubleArray>(this->Source, "Height", Height);
  vtkSMPTools::Initialize(1);
  vtkNew<vtkDoubleArray> alone;
  alone->DeepCopy(this->Carried("Height"));
  vtkSMPTools::Initialize(2);
  vtkDataArray* both = this->Carried("Height");
  for (vtkIdType i = 0; i < alone->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(both->GetTuple1(i), alone->GetValue(i));
  }
  vtkSMPTools::Initialize();
}

TEST_F(SphericalResample, RunsOnlyWhenModifiedAndPrints)
{
  OfPlaces<vtkDoubleArray>(this->Source, "Height", Height);
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetMethodToBarycentric(); });
  contract::ExpectPrints(this->Filter, "Method");
  contract::ExpectPrints(this->Filter, "MaskArrayName");
  this->Filter->SetMethod(9);
  EXPECT_EQ(this->Filter->GetMethod(), vtkSphericalResample::AREA_ADAPTIVE);
}

TEST_F(SphericalResample, StopsWhenAsked)
{
  OfPlaces<vtkDoubleArray>(this->Source, "Height", Height);
  contract::ExpectStopsWhenAsked(this->Filter);
}

TEST_F(SphericalResample, FoldsAreToldOf)
{
  const double* n = MapOf(this->Source)->GetTuple3(1234);
  MapOf(this->Source)->SetTuple3(1234, n[0] + 0.1, n[1] - 0.1, n[2]);
  this->Run();
  this->Seen.ExpectWarning("triangles of the source's map to the sphere are folded");
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(SphericalResample, EmptyInputsGiveAWarningAndNothing)
{
  this->Filter->SetSourceData(vtkNew<vtkPolyData>());
  EXPECT_EQ(this->Run()->GetNumberOfPoints(), 0);
  this->Seen.ExpectWarning("the source is empty; the output is empty");
  this->Filter->SetInputData(vtkNew<vtkPolyData>());
  EXPECT_EQ(this->Run()->GetNumberOfPoints(), 0);
  this->Seen.ExpectWarning("the target is empty; the output is empty");
}

TEST_F(SphericalResample, SurfacesWithoutAMapAreRefused)
{
  this->Source->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused("the source has no point array SpherePosition, and its points do not lie on "
                      "a sphere around the origin");
  this->Filter->SetSourceData(this->Target);
  MapOf(this->Target)->SetTuple3(9, 0.0, 0.0, 0.0);
  this->ExpectRefused("zero or not finite");
}

TEST_F(SphericalResample, SurfacesMustBeFiniteAndHaveTriangles)
{
  this->Target->SetPolys(vtkNew<vtkCellArray>());
  this->ExpectRefused("the target has no triangles; set Method to BARYCENTRIC");
  this->Filter->SetMethodToBarycentric();
  EXPECT_EQ(this->Run()->GetNumberOfPoints(), 812);
  EXPECT_FALSE(this->Seen.Error());
  this->Source->GetPoints()->SetPoint(3, 0.0, HUGE_VAL, 0.0);
  this->ExpectRefused("some points of the source are not finite");
  this->Source->SetPolys(vtkNew<vtkCellArray>());
  this->Source->GetPoints()->SetPoint(3, 0.0, 1.0, 0.0);
  this->ExpectRefused("the source has no triangles");
}

TEST_F(SphericalResample, MapsMustCoverTheSphere)
{
  for (vtkIdType i = 0; i < this->Source->GetNumberOfPoints(); ++i)
  {
    const double* n = MapOf(this->Source)->GetTuple3(i);
    MapOf(this->Source)->SetTuple3(i, n[0], n[1], std::abs(n[2]));
  }
  this->ExpectRefused("the map to the sphere of the source covers the sphere 0 times");
}

TEST_F(SphericalResample, MasksThatAreNotThereAreRefused)
{
  this->Filter->SetMaskArrayName("Cortex");
  this->ExpectRefused("the source has no point array \"Cortex\" of 1 component");
  this->Filter->SetMaskArrayName("SpherePosition");
  this->ExpectRefused("the source has no point array \"SpherePosition\" of 1 component");
}

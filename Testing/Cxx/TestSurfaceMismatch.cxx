#include "vtkSurfaceMismatch.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkCellArray.h"
#include "vtkCellLocator.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkPoints.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <limits>

namespace
{
const char* const Figures[] = { "MeanSquarePointToSurface", "MeanSquarePointToVertex",
  "MeanSquareSurfaceToPoint", "HausdorffDistance", "WebFraction", "LengthUnit" };

class SurfaceMismatch : public testing::Test
{
protected:
  // A coarse ellipsoid as a model of a fine sphere.
  void SetUp() override
  {
    vtkNew<vtkTransform> stretch;
    stretch->Scale(1.0, 1.1, 0.95);
    stretch->Translate(0.02, 0.0, 0.01);
    vtkNew<vtkTransformPolyDataFilter> ellipsoid;
    ellipsoid->SetTransform(stretch);
    vtkNew<vtkGeodesicSphereSource> coarse, fine;
    coarse->SetFrequency(6);
    fine->SetFrequency(15);
    fine->Update();
    ellipsoid->SetInputConnection(coarse->GetOutputPort());
    ellipsoid->Update();
    this->Model->DeepCopy(ellipsoid->GetOutput());
    this->Reference->DeepCopy(fine->GetOutput());
    this->Filter->SetInputData(this->Model);
    this->Filter->SetReferenceData(this->Reference);
    this->Filter->SetNumberOfSamples(2000);
  }
  double Figure(const char* name)
  {
    vtkDataArray* array = this->Filter->GetOutput()->GetFieldData()->GetArray(name);
    return array ? array->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
  }

  vtkNew<vtkPolyData> Model;
  vtkNew<vtkPolyData> Reference;
  vtkNew<vtkSurfaceMismatch> Filter;
};

// An independent oracle.
double DistanceTo(vtkCellLocator* locator, const double x[3])
{
  double foot[3], square = 0.0;
  vtkIdType cell = 0;
  int part = 0;
  vtkNew<vtkGenericCell> buffer;
  locator->FindClosestPoint(x, foot, buffer, cell, part, square);
  return std::sqrt(square);
}
}

TEST_F(SurfaceMismatch, WritesTheContractsArrays)
{
  this->Filter->Update();
  for (const char* name : Figures)
  {
    contract::ExpectArray(this->Filter->GetOutput()->GetFieldData(), name, VTK_DOUBLE, 1, 1);
  }
  for (int port : { 0, 1 })
  {
    vtkPolyData* output = this->Filter->GetOutput(port);
    contract::ExpectArray(
      output->GetPointData(), "Distance", VTK_DOUBLE, 1, output->GetNumberOfPoints());
    contract::ExpectSpherePosition(output);
  }
  EXPECT_EQ(this->Filter->GetOutput(0)->GetPoints(), this->Model->GetPoints());
  EXPECT_EQ(this->Filter->GetOutput(1)->GetPoints(), this->Reference->GetPoints());
}

TEST_F(SurfaceMismatch, LeavesTheInputsAlone)
{
  this->Filter->Update();
  for (vtkPolyData* input : { this->Model.Get(), this->Reference.Get() })
  {
    EXPECT_EQ(input->GetPointData()->GetArray("Distance"), nullptr);
    EXPECT_EQ(input->GetFieldData()->GetNumberOfArrays(), 0);
  }
}

TEST_F(SurfaceMismatch, AgreesWithVtksLocator)
{
  this->Filter->SetLengthUnitToNone();
  this->Filter->Update();
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(this->Model);
  locator->BuildLocator();
  vtkDataArray* distances = this->Filter->GetOutput(1)->GetPointData()->GetArray("Distance");
  double sum = 0.0;
  for (vtkIdType i = 0; i < this->Reference->GetNumberOfPoints(); ++i)
  {
    const double expected = DistanceTo(locator, this->Reference->GetPoint(i));
    ASSERT_NEAR(distances->GetTuple1(i), expected, 1e-12);
    sum += expected * expected;
  }
  EXPECT_NEAR(
    this->Figure("MeanSquarePointToSurface"), sum / this->Reference->GetNumberOfPoints(), 1e-14);
  EXPECT_EQ(this->Figure("LengthUnit"), 1.0);
}

TEST_F(SurfaceMismatch, DistancesAreInUnitsOfTheInputWhateverTheUnit)
{
  this->Filter->SetLengthUnitToNone();
  this->Filter->Update();
  const double plain =
    this->Filter->GetOutput(0)->GetPointData()->GetArray("Distance")->GetTuple1(3);
  const double square = this->Figure("MeanSquarePointToSurface");
  this->Filter->SetLengthUnitToHalfDiagonal();
  this->Filter->Update();
  const double unit = this->Figure("LengthUnit");
  EXPECT_NEAR(unit, std::sqrt(3.0), 0.02);
  EXPECT_NEAR(
    this->Filter->GetOutput(0)->GetPointData()->GetArray("Distance")->GetTuple1(3), plain, 1e-14);
  EXPECT_NEAR(this->Figure("MeanSquarePointToSurface") * unit * unit, square, 1e-15);
}

TEST_F(SurfaceMismatch, ReadsPackedAndOtherPoints)
{
  this->Filter->Update();
  const double expected = this->Figure("MeanSquarePointToSurface");
  vtkNew<vtkPoints> integers;
  integers->SetDataType(VTK_SHORT);
  integers->SetNumberOfPoints(this->Reference->GetNumberOfPoints());
  for (vtkIdType i = 0; i < integers->GetNumberOfPoints(); ++i)
  {
    double x[3];
    this->Reference->GetPoint(i, x);
    integers->SetPoint(i, std::round(3e4 * x[0]), std::round(3e4 * x[1]), std::round(3e4 * x[2]));
  }
  this->Reference->SetPoints(integers);
  vtkNew<vtkTransform> scale;
  scale->Scale(3e4, 3e4, 3e4);
  vtkNew<vtkTransformPolyDataFilter> large;
  large->SetTransform(scale);
  large->SetInputData(this->Model);
  this->Filter->SetInputConnection(large->GetOutputPort());
  this->Filter->Update();
  EXPECT_NEAR(this->Figure("MeanSquarePointToSurface") / expected, 1.0, 1e-3);
}

TEST_F(SurfaceMismatch, TakesACloudForAReference)
{
  this->Reference->SetPolys(nullptr);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_FALSE(observed.Error());
  contract::ExpectArray(this->Filter->GetOutput(0)->GetPointData(), "Distance", VTK_DOUBLE, 1,
    this->Model->GetNumberOfPoints());
}

TEST_F(SurfaceMismatch, WarnsOfEmptyInputs)
{
  contract::Observed observed(this->Filter);
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetReferenceData(nothing);
  this->Filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_NE(observed.WarningMessage().find("the reference is empty"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

TEST_F(SurfaceMismatch, RefusesAModelWithoutTriangles)
{
  contract::Observed observed(this->Filter);
  this->Model->SetPolys(nullptr);
  this->Filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("the model has no triangles"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

TEST_F(SurfaceMismatch, RefusesCoordinatesThatAreNotFinite)
{
  contract::Observed observed(this->Filter);
  this->Reference->GetPoints()->SetPoint(7, 0, std::numeric_limits<double>::infinity(), 0);
  this->Filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("1 of 2252 points of the reference are not finite"),
    std::string::npos);
}

TEST_F(SurfaceMismatch, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetNumberOfSamples(100); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetRandomSeed(5); });
  for (const char* property : { "LengthUnit", "NumberOfSamples", "RandomSeed" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
}

#include "vtkSurfaceHarmonics.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkSurfaceHarmonicsSource.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTransform.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
/// The ellipsoid, bent so that no two of its ends are alike, with a number at each point.
vtkSmartPointer<vtkPolyData> Pear(int frequency = 20)
{
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(fixtures::Ellipsoid(frequency));
  vtkNew<vtkDoubleArray> numbers, pairs;
  numbers->SetName("Number");
  pairs->SetName("Pair");
  pairs->SetNumberOfComponents(2);
  vtkDataArray* sphere = surface->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3], n[3];
    surface->GetPoint(i, p);
    sphere->GetTuple(i, n);
    p[0] += 0.5 * n[0] * n[0];
    p[1] += 0.3 * n[0] * n[1] * n[1];
    surface->GetPoints()->SetPoint(i, p);
    numbers->InsertNextValue(7.0 + n[2]);
    pairs->InsertNextTuple2(n[0], 5.0);
  }
  surface->GetPointData()->AddArray(numbers);
  surface->GetPointData()->AddArray(pairs);
  return surface;
}

/// The same, turned and moved, its map turned otherwise.
vtkSmartPointer<vtkPolyData> Turned(vtkPolyData* surface)
{
  const auto turned = vtkSmartPointer<vtkPolyData>::New();
  turned->DeepCopy(surface);
  vtkNew<vtkTransform> inSpace, onSphere;
  inSpace->Translate(3.0, -2.0, 8.0);
  inSpace->RotateWXYZ(130.0, 1.0, 0.2, 0.7);
  onSphere->RotateWXYZ(75.0, -0.3, 1.0, 0.4);
  vtkDataArray* sphere = turned->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < turned->GetNumberOfPoints(); ++i)
  {
    double p[3];
    turned->GetPoint(i, p);
    inSpace->TransformPoint(p, p);
    turned->GetPoints()->SetPoint(i, p);
    sphere->GetTuple(i, p);
    onSphere->TransformPoint(p, p);
    sphere->SetTuple(i, p);
  }
  return turned;
}

double ValueOf(vtkTable* table, int degree, int order, const char* column)
{
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetValueByName(row, "Degree").ToInt() == degree &&
      table->GetValueByName(row, "Order").ToInt() == order)
    {
      return table->GetValueByName(row, column).ToDouble();
    }
  }
  ADD_FAILURE() << degree << " " << order;
  return 0.0;
}

/// Largest difference of numbers in two tables.
double Difference(vtkTable* a, vtkTable* b)
{
  double largest = 0.0;
  EXPECT_EQ(a->GetNumberOfRows(), b->GetNumberOfRows());
  for (vtkIdType row = 0; row < a->GetNumberOfRows(); ++row)
  {
    for (const char* column : { "X", "Y", "Z" })
    {
      largest = std::max(largest,
        std::abs(
          a->GetValueByName(row, column).ToDouble() - b->GetValueByName(row, column).ToDouble()));
    }
  }
  return largest;
}

double FieldValue(vtkDataObject* data, const char* name, vtkIdType i = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(i, 0) : std::numeric_limits<double>::quiet_NaN();
}

class SurfaceHarmonics : public contract::FilterTest<vtkSurfaceHarmonics>
{
protected:
  SurfaceHarmonics()
  {
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetDegree(8);
  }

  void ExpectRefused(const std::string& why)
  {
    this->Run();
    this->Seen.ExpectError(why);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(this->Filter->GetCoefficients()->GetNumberOfColumns(), 0);
  }

  vtkSmartPointer<vtkPolyData> Surface = Pear();
};
}

TEST_F(SurfaceHarmonics, EllipsoidHasItsCoefficients)
{
  this->Filter->SetInputData(fixtures::Ellipsoid(20));
  this->Run();
  EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning());
  vtkTable* table = this->Filter->GetCoefficients();
  ASSERT_EQ(table->GetNumberOfRows(), 81);
  const double zero = std::sqrt(4.0 * vtkMath::Pi()), one = std::sqrt(4.0 * vtkMath::Pi() / 3.0);
  for (vtkIdType row = 0; row < 81; ++row)
  {
    const int l = table->GetValueByName(row, "Degree").ToInt();
    const int m = table->GetValueByName(row, "Order").ToInt();
    EXPECT_EQ(l * l + l + m, row);
    EXPECT_NEAR(table->GetValueByName(row, "X").ToDouble(),
      row == 0 ? 10.0 * zero : (l == 1 && m == 1 ? 3.0 * one : 0.0), 1e-12);
    EXPECT_NEAR(
      table->GetValueByName(row, "Y").ToDouble(), l == 1 && m == -1 ? 2.0 * one : 0.0, 1e-12);
    EXPECT_NEAR(table->GetValueByName(row, "Z").ToDouble(), l == 1 && m == 0 ? one : 0.0, 1e-12);
  }
  vtkPolyData* output = this->Filter->GetOutput();
  contract::ExpectArray(output->GetFieldData(), "HarmonicPower", VTK_DOUBLE, 1, 9);
  contract::ExpectArray(output->GetFieldData(), "ShapeSpectrum", VTK_DOUBLE, 1, 9);
  EXPECT_NEAR(FieldValue(output, "HarmonicPower", 0), 100.0, 1e-11);
  EXPECT_NEAR(FieldValue(output, "HarmonicPower", 1), 14.0 / 3.0, 1e-12);
  EXPECT_EQ(FieldValue(output, "ShapeSpectrum", 0), 0.0);
  EXPECT_EQ(FieldValue(output, "ShapeSpectrum", 1), 1.0);
  EXPECT_LT(FieldValue(output, "ShapeSpectrum", 2), 1e-12);
  EXPECT_LT(FieldValue(output, "RootMeanSquareDistance"), 1e-12);
}

TEST_F(SurfaceHarmonics, InputIsRebuiltOnItsMesh)
{
  vtkNew<vtkPolyData> before;
  before->DeepCopy(this->Surface);
  this->Filter->AddPointArray("Number");
  this->Filter->AddPointArray("Pair");
  this->Run();
  vtkPolyData* output = this->Filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), before->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfPolys(), before->GetNumberOfPolys());
  contract::ExpectSpherePosition(output);
  EXPECT_EQ(output->GetPointData()->GetNormals(), nullptr);
  contract::ExpectArray(
    output->GetPointData(), "Number", VTK_DOUBLE, 1, before->GetNumberOfPoints());
  contract::ExpectArray(output->GetPointData(), "Pair", VTK_DOUBLE, 2, before->GetNumberOfPoints());
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    before->GetPoint(i, p);
    output->GetPoint(i, q);
    ASSERT_NEAR(vtkMath::Distance2BetweenPoints(p, q), 0.0, 1e-24);
    ASSERT_NEAR(output->GetPointData()->GetArray("Number")->GetTuple1(i),
      before->GetPointData()->GetArray("Number")->GetTuple1(i), 1e-12);
    ASSERT_NEAR(output->GetPointData()->GetArray("Pair")->GetComponent(i, 1), 5.0, 1e-12);
    this->Surface->GetPoint(i, q);
    ASSERT_EQ(vtkMath::Distance2BetweenPoints(p, q), 0.0);
  }
  vtkTable* table = this->Filter->GetCoefficients();
  EXPECT_EQ(table->GetNumberOfColumns(), 8);
  EXPECT_NEAR(ValueOf(table, 0, 0, "Pair_1"), 5.0 * std::sqrt(4.0 * vtkMath::Pi()), 1e-12);
  EXPECT_NEAR(ValueOf(table, 1, 0, "Number"), std::sqrt(4.0 * vtkMath::Pi() / 3.0), 1e-12);
  EXPECT_NEAR(FieldValue(output, "HarmonicPower_Number", 0), 49.0, 1e-11);
  EXPECT_NEAR(FieldValue(output, "HarmonicPower_Pair", 0), 25.0, 1e-11);
}

TEST_F(SurfaceHarmonics, NormalsOfTheInputAreRemoved)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(this->Surface);
  normals->SplittingOff();
  normals->ComputeCellNormalsOn();
  normals->Update();
  ASSERT_NE(normals->GetOutput()->GetCellData()->GetNormals(), nullptr);
  this->Filter->SetInputData(normals->GetOutput());
  this->Run();
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(this->Filter->GetOutput()->GetCellData()->GetNormals(), nullptr);
  EXPECT_NE(normals->GetOutput()->GetCellData()->GetNormals(), nullptr);
}

TEST_F(SurfaceHarmonics, LowDegreesAreLessThanAll)
{
  this->Run();
  vtkNew<vtkTable> all;
  all->DeepCopy(this->Filter->GetCoefficients());
  this->Filter->SetReconstructionDegree(1);
  this->Run();
  EXPECT_EQ(Difference(all, this->Filter->GetCoefficients()), 0.0);
  // What degree 1 leaves out of the pear is at most that much, and not nothing.
  EXPECT_GT(FieldValue(this->Filter->GetOutput(), "RootMeanSquareDistance"), 0.05);
  EXPECT_LT(FieldValue(this->Filter->GetOutput(), "RootMeanSquareDistance"), 0.5);
  this->Filter->SetReconstructionDegree(0);
  this->Run();
  double bounds[6];
  this->Filter->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[1] - bounds[0], 0.0, 1e-13); // a point
}

TEST_F(SurfaceHarmonics, GeodesicSphereIsWhatTheSourceMakes)
{
  this->Filter->SetMeshTypeToGeodesic();
  this->Filter->SetFrequency(9);
  this->Filter->AddPointArray("Number");
  this->Run();
  vtkNew<vtkSurfaceHarmonicsSource> source;
  source->SetInputConnection(this->Filter->GetOutputPort(1));
  source->SetFrequency(9);
  source->Update();
  vtkPolyData* made = source->GetOutput();
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 812);
  ASSERT_EQ(made->GetNumberOfPoints(), 812);
  for (vtkIdType i = 0; i < 812; ++i)
  {
    double p[3], q[3];
    this->Filter->GetOutput()->GetPoint(i, p);
    made->GetPoint(i, q);
    ASSERT_NEAR(vtkMath::Distance2BetweenPoints(p, q), 0.0, 1e-24);
    ASSERT_NEAR(made->GetPointData()->GetArray("Number")->GetTuple1(i),
      this->Filter->GetOutput()->GetPointData()->GetArray("Number")->GetTuple1(i), 1e-12);
  }
  EXPECT_LT(FieldValue(this->Filter->GetOutput(), "RootMeanSquareDistance"), 1e-12);
}

TEST_F(SurfaceHarmonics, SpectrumDoesNotDependOnRotations)
{
  this->Run();
  std::vector<double> power, spectrum;
  for (vtkIdType l = 0; l <= 8; ++l)
  {
    power.push_back(FieldValue(this->Filter->GetOutput(), "HarmonicPower", l));
    spectrum.push_back(FieldValue(this->Filter->GetOutput(), "ShapeSpectrum", l));
  }
  this->Filter->SetInputData(Turned(this->Surface));
  this->Run();
  for (vtkIdType l = 1; l <= 8; ++l)
  {
    EXPECT_NEAR(FieldValue(this->Filter->GetOutput(), "HarmonicPower", l), power[l], 1e-10);
    EXPECT_NEAR(FieldValue(this->Filter->GetOutput(), "ShapeSpectrum", l), spectrum[l], 1e-10);
  }
  EXPECT_GT(spectrum[2], 0.01);
}

TEST_F(SurfaceHarmonics, AlignedSurfacesAreTheSame)
{
  this->Filter->SetAlignmentToMapAndSurface();
  this->Run();
  vtkNew<vtkTable> first;
  first->DeepCopy(this->Filter->GetCoefficients());
  vtkNew<vtkPolyData> there;
  there->DeepCopy(this->Filter->GetOutput());
  EXPECT_NEAR(ValueOf(first, 0, 0, "X"), 0.0, 1e-12);
  EXPECT_GT(ValueOf(first, 1, 1, "X"), ValueOf(first, 1, -1, "Y"));
  EXPECT_GT(ValueOf(first, 1, -1, "Y"), ValueOf(first, 1, 0, "Z"));
  EXPECT_NEAR(ValueOf(first, 1, 1, "Z"), 0.0, 1e-12);
  this->Filter->SetInputData(Turned(this->Surface));
  this->Run();
  EXPECT_LT(Difference(first, this->Filter->GetCoefficients()), 1e-10);
  for (vtkIdType i = 0; i < there->GetNumberOfPoints(); i += 7)
  {
    double p[3], q[3];
    there->GetPoint(i, p);
    this->Filter->GetOutput()->GetPoint(i, q);
    EXPECT_NEAR(vtkMath::Distance2BetweenPoints(p, q), 0.0, 1e-20);
    there->GetPointData()->GetArray("SpherePosition")->GetTuple(i, p);
    this->Filter->GetOutput()->GetPointData()->GetArray("SpherePosition")->GetTuple(i, q);
    EXPECT_NEAR(vtkMath::Distance2BetweenPoints(p, q), 0.0, 1e-20);
  }
  contract::ExpectArray(this->Filter->GetOutput()->GetFieldData(), "MapRotation", VTK_DOUBLE, 9, 1);
  contract::ExpectArray(
    this->Filter->GetOutput()->GetFieldData(), "SurfaceRotation", VTK_DOUBLE, 9, 1);
  contract::ExpectArray(
    this->Filter->GetOutput()->GetFieldData(), "SurfaceCenter", VTK_DOUBLE, 3, 1);
}

// The harmonics of what is written are those that are written.
TEST_F(SurfaceHarmonics, AlignedOutputHasTheAlignedCoefficients)
{
  for (const int alignment : { vtkSurfaceHarmonics::MAP, vtkSurfaceHarmonics::MAP_AND_SURFACE })
  {
    this->Filter->SetInputData(Turned(this->Surface));
    this->Filter->SetAlignment(alignment);
    this->Run();
    vtkNew<vtkSurfaceHarmonics> again;
    again->SetInputConnection(this->Filter->GetOutputPort());
    again->SetDegree(8);
    again->Update();
    EXPECT_LT(Difference(this->Filter->GetCoefficients(), again->GetCoefficients()), 1e-11);
  }
}

TEST_F(SurfaceHarmonics, ReferenceDecidesWhereAxesPoint)
{
  this->Run();
  vtkNew<vtkTable> reference;
  reference->DeepCopy(this->Filter->GetCoefficients());
  this->Filter->SetReferenceData(reference);
  this->Filter->SetAlignmentToMapAndSurface();
  this->Filter->SetInputData(Turned(this->Surface));
  this->Run();
  EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning());
  const double center[] = { ValueOf(reference, 0, 0, "X"), ValueOf(reference, 0, 0, "Y"),
    ValueOf(reference, 0, 0, "Z") };
  for (int c = 0; c < 3; ++c)
  {
    reference->GetColumnByName(c == 0 ? "X" : c == 1 ? "Y" : "Z");
    vtkDoubleArray::SafeDownCast(reference->GetColumn(2 + c))->SetValue(0, 0.0);
  }
  EXPECT_GT(center[0], 1.0);
  EXPECT_LT(Difference(reference, this->Filter->GetCoefficients()), 1e-10);
}

TEST_F(SurfaceHarmonics, ThreadsChangeNoBit)
{
  this->Filter->SetAlignmentToMapAndSurface();
  vtkSMPTools::Initialize(1);
  this->Run();
  vtkNew<vtkTable> alone;
  alone->DeepCopy(this->Filter->GetCoefficients());
  vtkSMPTools::Initialize(2);
  this->Run();
  EXPECT_EQ(Difference(alone, this->Filter->GetCoefficients()), 0.0);
  vtkSMPTools::Initialize();
}

TEST_F(SurfaceHarmonics, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetDegree(3); });
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->AddPointArray("Number"); });
  EXPECT_EQ(this->Filter->GetNumberOfPointArrays(), 1);
  this->Filter->AddPointArray("Number");
  EXPECT_EQ(this->Filter->GetNumberOfPointArrays(), 1);
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->RemoveAllPointArrays(); });
  for (const char* property : { "Degree", "ReconstructionDegree", "MeshType", "Frequency",
         "Alignment", "NumberOfPointArrays" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
  this->Filter->SetDegree(1000);
  EXPECT_EQ(this->Filter->GetDegree(), 256);
}

TEST_F(SurfaceHarmonics, StopsWhenAsked)
{
  contract::ExpectStopsWhenAsked(this->Filter);
}

// Half the number of points that degree 24 has unknowns: places inside the triangles count.
TEST_F(SurfaceHarmonics, MoreHarmonicsThanPointsAreDefined)
{
  this->Filter->SetInputData(Pear(5));
  this->Filter->SetDegree(24);
  this->Run();
  EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning());
  EXPECT_LT(FieldValue(this->Filter->GetOutput(), "RootMeanSquareDistance"), 0.1);
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(SurfaceHarmonics, EmptyInputGivesAWarningAndNothing)
{
  this->Filter->SetInputData(vtkNew<vtkPolyData>());
  this->Run();
  this->Seen.ExpectWarning("the surface is empty");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetCoefficients()->GetNumberOfColumns(), 0);
}

TEST_F(SurfaceHarmonics, SurfacesWithoutAUsableMapAreRefused)
{
  vtkDataArray* sphere = this->Surface->GetPointData()->GetArray("SpherePosition");
  const double opposite[] = { -sphere->GetComponent(99, 0), -sphere->GetComponent(99, 1),
    -sphere->GetComponent(99, 2) };
  sphere->SetTuple(99, opposite);
  this->ExpectRefused("folded triangles, but must cover it once without folds");
  sphere->SetTuple3(99, 0.0, 0.0, 0.0);
  this->ExpectRefused("1 of 4002 vectors of SpherePosition are zero or not finite");
  this->Surface->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused("the surface has no point array SpherePosition");
}

TEST_F(SurfaceHarmonics, BadSurfacesAreRefused)
{
  this->Surface->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->ExpectRefused("some points of the surface are not finite");
  this->Surface->DeepCopy(Pear());
  fixtures::ChangePolygons(this->Surface, [](vtkIdType i, vtkIdList*) { return i != 7; });
  this->ExpectRefused(
    "the surface is open, or its triangles are not oriented consistently, at 3 edges");
  fixtures::ChangePolygons(this->Surface, [](vtkIdType, vtkIdList*) { return false; });
  this->ExpectRefused("the surface has no triangles");
  this->Surface->DeepCopy(Pear());
  for (vtkIdType i = 0; i < this->Surface->GetNumberOfPoints(); ++i)
  {
    this->Surface->GetPoints()->SetPoint(i, 1.0, 2.0, 3.0);
  }
  this->ExpectRefused("the surface has no area");
}

TEST_F(SurfaceHarmonics, BadArraysAreRefused)
{
  this->Filter->AddPointArray("Missing");
  this->ExpectRefused("the surface has no point array \"Missing\" of numbers");
  this->Filter->RemoveAllPointArrays();
  vtkNew<vtkDoubleArray> order;
  order->SetName("Order");
  order->SetNumberOfTuples(this->Surface->GetNumberOfPoints());
  order->FillValue(1.0);
  this->Surface->GetPointData()->AddArray(order);
  this->Filter->AddPointArray("Order");
  this->ExpectRefused("the point array \"Order\" has the name of the map or of a column");
  this->Filter->RemoveAllPointArrays();
  this->Filter->AddPointArray("SpherePosition");
  this->ExpectRefused("the point array \"SpherePosition\" has the name of the map");
  this->Filter->RemoveAllPointArrays();
  vtkNew<vtkDoubleArray> vectors, column;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(2);
  column->SetName("v_1");
  for (vtkDoubleArray* array : { vectors.Get(), column.Get() })
  {
    array->SetNumberOfTuples(this->Surface->GetNumberOfPoints());
    array->Fill(1.0);
    this->Surface->GetPointData()->AddArray(array);
    this->Filter->AddPointArray(array->GetName());
  }
  this->ExpectRefused("the point array \"v_1\" has the name of the map or of a column");
  this->Filter->RemoveAllPointArrays();
  this->Filter->AddPointArray("Number");
  this->Surface->GetPointData()->GetArray("Number")->SetTuple1(
    5, std::numeric_limits<double>::infinity());
  this->ExpectRefused("the point array \"Number\" has values that are not finite");
  this->Surface->GetPointData()->GetArray("Number")->Fill(1.7e308);
  this->ExpectRefused("are too large for their harmonics");
}

TEST_F(SurfaceHarmonics, BadReferencesAreRefused)
{
  vtkNew<vtkTable> reference;
  this->Filter->SetReferenceData(reference);
  this->Filter->SetAlignmentToMap();
  this->ExpectRefused("the table of coefficients has no column \"Degree\"");
}

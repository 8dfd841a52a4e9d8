#include "vtkSurfaceHarmonicsSource.h"

#include "FilterContract.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>
#include <string>

namespace
{
/// A sphere of radius 2 around (5, 0, 0), its rows from the last to the first, and a height.
class SurfaceHarmonicsSource : public testing::Test
{
protected:
  SurfaceHarmonicsSource()
  {
    const double zero = std::sqrt(4.0 * vtkMath::Pi()), one = std::sqrt(4.0 * vtkMath::Pi() / 3.0);
    vtkNew<vtkStringArray> remarks;
    remarks->SetName("Remark");
    remarks->SetNumberOfValues(4);
    vtkNew<vtkDoubleArray> degrees; // of any type
    degrees->SetName("Degree");
    vtkNew<vtkIntArray> orders;
    orders->SetName("Order");
    this->Table->AddColumn(remarks);
    const char* names[] = { "X", "Y", "Z", "Height" };
    const double values[4][4] = { { 2.0 * one, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 * one, one },
      { 0.0, 2.0 * one, 0.0, 0.0 }, { 5.0 * zero, 0.0, 0.0, 0.0 } };
    for (const int degree : { 1, 1, 1, 0 })
    {
      degrees->InsertNextValue(degree);
    }
    for (const int order : { 1, 0, -1, 0 })
    {
      orders->InsertNextValue(order);
    }
    this->Table->AddColumn(degrees);
    this->Table->AddColumn(orders);
    for (int c = 0; c < 4; ++c)
    {
      vtkNew<vtkDoubleArray> column;
      column->SetName(names[c]);
      for (const auto& row : values)
      {
        column->InsertNextValue(row[c]);
      }
      this->Table->AddColumn(column);
    }
    this->Source->SetInputData(this->Table);
    this->Source->SetFrequency(7);
  }

  void Run()
  {
    this->Seen.Clear();
    this->Source->Modified();
    this->Source->Update();
  }

  void ExpectRefused(const std::string& why)
  {
    this->Run();
    this->Seen.ExpectError(why);
    EXPECT_EQ(this->Source->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkDataArray* Column(const char* name)
  {
    return vtkDataArray::SafeDownCast(this->Table->GetColumnByName(name));
  }

  vtkNew<vtkTable> Table;
  vtkNew<vtkSurfaceHarmonicsSource> Source;
  contract::Observed Seen{ this->Source };
};
}

TEST_F(SurfaceHarmonicsSource, SphereIsASphere)
{
  this->Run();
  EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning());
  vtkPolyData* made = this->Source->GetOutput();
  ASSERT_EQ(made->GetNumberOfPoints(), 492);
  EXPECT_EQ(made->GetNumberOfPolys(), 980);
  contract::ExpectSpherePosition(made);
  contract::ExpectArray(made->GetPointData(), "Height", VTK_DOUBLE, 1, 492);
  EXPECT_EQ(made->GetPointData()->GetArray("Remark"), nullptr);
  for (vtkIdType i = 0; i < 492; ++i)
  {
    const double* n = made->GetPointData()->GetArray("SpherePosition")->GetTuple3(i);
    const double* p = made->GetPoint(i);
    EXPECT_NEAR(p[0], 5.0 + 2.0 * n[0], 1e-14);
    EXPECT_NEAR(p[1], 2.0 * n[1], 1e-14);
    EXPECT_NEAR(p[2], 2.0 * n[2], 1e-14);
    EXPECT_NEAR(made->GetPointData()->GetArray("Height")->GetTuple1(i), n[2], 1e-15);
  }
}

TEST_F(SurfaceHarmonicsSource, DegreesAreCutOff)
{
  this->Source->SetReconstructionDegree(0);
  this->Run();
  double bounds[6];
  this->Source->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], 5.0, 1e-14);
  EXPECT_NEAR(bounds[1], 5.0, 1e-14);
}

TEST_F(SurfaceHarmonicsSource, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Source, [&]() { this->Source->SetFrequency(5); });
  contract::ExpectPrints(this->Source, "Frequency");
  contract::ExpectPrints(this->Source, "ReconstructionDegree");
}

TEST_F(SurfaceHarmonicsSource, StopsWhenAsked)
{
  this->Source->SetFrequency(40);
  contract::ExpectStopsWhenAsked(this->Source);
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(SurfaceHarmonicsSource, EmptyTableGivesAWarningAndNothing)
{
  this->Source->SetInputData(vtkNew<vtkTable>());
  this->Run();
  this->Seen.ExpectWarning("the table of coefficients is empty");
  EXPECT_EQ(this->Source->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(SurfaceHarmonicsSource, MissingColumnsAreNamed)
{
  this->Table->RemoveColumnByName("Y");
  this->ExpectRefused("the table of coefficients has no column \"Y\" of numbers");
}

TEST_F(SurfaceHarmonicsSource, ColumnsOfOtherLengthsAreRefused)
{
  this->Column("Height")->SetNumberOfTuples(3);
  this->ExpectRefused("the column \"Height\" has 3 values for 4 rows");
  this->Column("Height")->SetNumberOfTuples(4);
  for (const char* name : { "Degree", "Order", "X", "Z" })
  {
    this->Column(name)->SetNumberOfTuples(5);
    this->ExpectRefused("the column \"" + std::string(name) + "\" has 5 values for 4 rows");
    this->Column(name)->SetNumberOfTuples(4);
  }
}

TEST_F(SurfaceHarmonicsSource, RowsThatAreNoHarmonicsAreRefused)
{
  this->Column("Order")->SetTuple1(1, 2);
  this->ExpectRefused("a row of degree 1.000000 and order 2.000000");
  this->Column("Order")->SetTuple1(1, 1);
  this->ExpectRefused("two rows of degree 1 and order 1");
  this->Column("Degree")->SetTuple1(1, std::numeric_limits<double>::quiet_NaN());
  this->ExpectRefused("a row of degree nan");
  for (const char* name : { "Degree", "Order", "X", "Y", "Z", "Height" })
  {
    this->Column(name)->SetNumberOfTuples(3);
  }
  this->ExpectRefused("there are 3 coefficients, but those of all degrees up to L are (L + 1)^2");
}

TEST_F(SurfaceHarmonicsSource, NumbersThatAreNotFiniteAreRefused)
{
  this->Column("Z")->SetTuple1(2, std::numeric_limits<double>::infinity());
  this->ExpectRefused("the column \"Z\" is not finite in row 2");
}

TEST_F(SurfaceHarmonicsSource, DegreesTooHighForMemoryAreRefused)
{
  for (const char* name : { "Degree", "Order", "X", "Y", "Z", "Height" })
  {
    this->Column(name)->SetNumberOfTuples(1026 * 1026);
  }
  this->ExpectRefused("the coefficients have degree 1025, but the highest is 1024");
}

TEST_F(SurfaceHarmonicsSource, NumbersAtTheEndOfTheirRangeGiveAnErrorOrAreRight)
{
  for (const double scale : { 1e-300, 1e300 })
  {
    this->Column("X")->SetTuple1(3, 0.0);
    for (const char* name : { "X", "Y", "Z" })
    {
      for (vtkIdType i = 0; i < 3; ++i)
      {
        this->Column(name)->SetTuple1(i, this->Column(name)->GetTuple1(i) * scale);
      }
    }
    this->Run();
    EXPECT_FALSE(this->Seen.Error());
    EXPECT_NEAR(this->Source->GetOutput()->GetBounds()[5] / scale, 2.0, 1e-10);
    for (const char* name : { "X", "Y", "Z" })
    {
      for (vtkIdType i = 0; i < 3; ++i)
      {
        this->Column(name)->SetTuple1(i, this->Column(name)->GetTuple1(i) / scale);
      }
    }
  }
  this->Column("X")->Fill(1.7e308);
  this->ExpectRefused("would leave the range");
}

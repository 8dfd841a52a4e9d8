#include "vtkGenusZeroHull.h"

#include "FilterContract.h"
#include "vtkConformalPLYReader.h"
#include "vtkGenusZeroCheck.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMassProperties.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace
{
const char* const Counts[] = { "AffineRank", "Method", "NormalsUsed", "NumberOfInsideNodes",
  "SolidEulerNumber", "NumberOfCutNodes", "Leaks", "NumberOfPointsOutside",
  "NumberOfPointsInside" };
const char* const Lengths[] = { "KernelWidth", "GridSpacing", "HoleWidth", "HoleDepth" };
constexpr double Pi = 3.14159265358979323846;

// A sphere's points, evenly spread.
void AddSphere(vtkPoints* points, vtkIdType size, double radius, double x, double least = -1.0)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / size;
    const double turn = 2.399963229728653 * i, r = std::sqrt(1.0 - z * z);
    if (z > least)
    {
      points->InsertNextPoint(
        x + radius * r * std::cos(turn), radius * r * std::sin(turn), radius * z);
    }
  }
}

void AddTorus(vtkPoints* points, double radius, double tube, double x = 0.0)
{
  for (int i = 0; i < 300; ++i)
  {
    for (int k = 0; k < 100; ++k)
    {
      const double u = 2.0 * Pi * i / 300, v = 2.0 * Pi * k / 100;
      const double r = radius + tube * std::cos(v);
      points->InsertNextPoint(x + r * std::cos(u), r * std::sin(u), tube * std::sin(v));
    }
  }
}

// The filter's warnings, each without where it comes from.
std::vector<std::string> WarningsOf(vtkGenusZeroHull* filter, vtkPointSet* cloud)
{
  std::vector<std::string> warnings;
  vtkNew<vtkCallbackCommand> collect;
  collect->SetClientData(&warnings);
  collect->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* text)
    {
      const std::string message = static_cast<const char*>(text);
      const std::size_t start = message.find("): ") + 3;
      static_cast<std::vector<std::string>*>(client)->push_back(
        message.substr(start, message.find_last_not_of('\n') + 1 - start));
    });
  const unsigned long warning = filter->AddObserver(vtkCommand::WarningEvent, collect);
  const unsigned long error = filter->AddObserver(vtkCommand::ErrorEvent, collect);
  filter->SetInputData(cloud);
  filter->Update();
  filter->RemoveObserver(warning);
  filter->RemoveObserver(error);
  return warnings;
}

class GenusZeroHull : public testing::Test
{
protected:
  // A sphere's points, of radius 2 around (5, 0, 0).
  void SetUp() override
  {
    vtkNew<vtkGeodesicSphereSource> sphere;
    sphere->SetFrequency(36);
    sphere->Update();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < sphere->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const double* n = sphere->GetOutput()->GetPoint(i);
      points->InsertNextPoint(5.0 + 2.0 * n[0], 2.0 * n[1], 2.0 * n[2]);
    }
    this->Cloud->SetPoints(points);
    this->Filter->SetInputData(this->Cloud);
    this->Filter->SetSpacing(0.05);
  }
  double Figure(const char* name)
  {
    vtkDataArray* array = this->Filter->GetOutput()->GetFieldData()->GetArray(name);
    return array ? array->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
  }
  bool IsGenusZero()
  {
    vtkNew<vtkGenusZeroCheck> check;
    check->SetInputConnection(this->Filter->GetOutputPort());
    check->Update();
    vtkFieldData* data = check->GetOutput()->GetFieldData();
    return data->GetArray("IsGenusZero")->GetTuple1(0) == 1 &&
      data->GetArray("NumberOfInconsistentEdges")->GetTuple1(0) == 0 &&
      data->GetArray("IsInsideOut")->GetTuple1(0) == 0;
  }
  void ExpectEmpty()
  {
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  }

  vtkNew<vtkPolyData> Cloud;
  vtkNew<vtkGenusZeroHull> Filter;
};
}

TEST_F(GenusZeroHull, WritesTheContractsArrays)
{
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  vtkFieldData* data = this->Filter->GetOutput()->GetFieldData();
  for (const char* name : Counts)
  {
    contract::ExpectArray(data, name, VTK_ID_TYPE, 1, 1);
  }
  for (const char* name : Lengths)
  {
    contract::ExpectArray(data, name, VTK_DOUBLE, 1, 1);
  }
  EXPECT_EQ(this->Filter->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_TRUE(this->IsGenusZero());
}

TEST_F(GenusZeroHull, KnowsASphere)
{
  this->Filter->Update();
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(this->Filter->GetOutputPort());
  EXPECT_NEAR(mass->GetVolume(), 4.0 / 3.0 * Pi * std::pow(2.1, 3), 0.5);
  double center[3];
  this->Filter->GetOutput()->GetCenter(center);
  EXPECT_NEAR(center[0], 5.0, 0.01);
  EXPECT_NEAR(center[1], 0.0, 0.01);
  EXPECT_NEAR(this->Figure("GridSpacing"), 0.1, 1e-6);
  EXPECT_EQ(this->Figure("AffineRank"), 3);
  EXPECT_EQ(this->Figure("SolidEulerNumber"), 1);
  EXPECT_EQ(this->Figure("NumberOfCutNodes"), 0);
  EXPECT_EQ(this->Figure("NumberOfPointsOutside"), 0);
  EXPECT_EQ(this->Figure("Leaks"), 0);
  EXPECT_NEAR(this->Figure("NumberOfInsideNodes") * 1e-3, 4.0 / 3.0 * Pi * std::pow(1.9, 3), 0.5);
}

// Lengths are those of the coordinates: of a hole in the sphere, its rim's radius and the sphere's.
TEST_F(GenusZeroHull, MeasuresHolesInTheInputsUnit)
{
  vtkNew<vtkPoints> kept;
  const double rim = 0.8;
  for (vtkIdType i = 0; i < this->Cloud->GetNumberOfPoints(); ++i)
  {
    const double* x = this->Cloud->GetPoint(i);
    if (!(x[2] > 0.0 && std::hypot(x[0] - 5.0, x[1]) < rim))
    {
      kept->InsertNextPoint(x);
    }
  }
  this->Cloud->SetPoints(kept);
  this->Filter->Update();
  EXPECT_NEAR(this->Figure("HoleWidth"), rim, 0.1);
  EXPECT_NEAR(this->Figure("HoleDepth"), 2.0, 0.1);
  EXPECT_TRUE(this->IsGenusZero());
}

TEST_F(GenusZeroHull, WarnsOfALeak)
{
  vtkNew<vtkPoints> kept;
  for (vtkIdType i = 0; i < this->Cloud->GetNumberOfPoints(); ++i)
  {
    const double* x = this->Cloud->GetPoint(i);
    if (x[2] < 1.2)
    {
      kept->InsertNextPoint(x);
    }
  }
  this->Cloud->SetPoints(kept);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_NE(observed.WarningMessage().find("nearly as wide"), std::string::npos);
  EXPECT_EQ(this->Figure("Leaks"), 1);
  EXPECT_TRUE(this->IsGenusZero());
  // Told to be content with less, it sees no leak.
  observed.Clear();
  this->Filter->SetPersistence(1.15);
  this->Filter->Update();
  EXPECT_FALSE(observed.Warning());
  EXPECT_EQ(this->Figure("Leaks"), 0);
}

// What the hull leaves out or opens, its user hears of, in figures, once each.
TEST_F(GenusZeroHull, WarnsOfWhatIsLeftOutOrCut)
{
  const auto expect = [&](vtkPoints* points, const std::string& warning)
  {
    this->Cloud->SetPoints(points);
    for (const double spacing : { 0.016, 0.03, 0.05 })
    {
      SCOPED_TRACE(spacing);
      this->Filter->SetSpacing(spacing);
      const std::vector<std::string> warnings = WarningsOf(this->Filter, this->Cloud);
      ASSERT_EQ(warnings.size(), warning.empty() ? 0u : 1u) << testing::PrintToString(warnings);
      EXPECT_TRUE(warning.empty() || warnings[0].find(warning) != std::string::npos) << warnings[0];
      EXPECT_TRUE(this->IsGenusZero());
    }
  };
  vtkNew<vtkPoints> sphere, two, within, half, torus, thin, chain, few;
  AddSphere(sphere, 20000, 1.0, 0.0);
  expect(sphere, "");
  AddSphere(two, 10000, 1.0, 0.0);
  AddSphere(two, 10000, 1.0, 4.0);
  expect(two, "10000 of 20000 points lie apart from the object and are left out");
  AddSphere(within, 20000, 1.0, 0.0);
  AddSphere(within, 5000, 0.5, 0.1);
  expect(within, "5000 of 25000 points lie inside the hull, apart from its surface");
  EXPECT_EQ(this->Figure("NumberOfPointsInside"), 5000);
  AddSphere(half, 20000, 1.0, 0.0, 0.0);
  expect(half, "the points enclose nothing");
  AddTorus(torus, 1.0, 0.4);
  expect(torus, "had handles, which were cut open; the cuts are ");
  AddTorus(thin, 1.0, 0.15);
  expect(thin, "had handles, which were cut open; the cuts are ");
  for (const double x : { 0.0, 2.3 }) // a tube of it has next to nothing inside
  {
    AddTorus(chain, 1.0, 0.35, x);
  }
  expect(chain, "had handles, which were cut open; the cuts are ");
  // A few outliers are not worth a word; their number is among the figures.
  AddSphere(few, 20000, 1.0, 0.0);
  AddSphere(few, 50, 0.2, 1.3);
  expect(few, "");
}

// Handles of the object are kept without a warning, and those that are too thin are cut.
TEST_F(GenusZeroHull, KeepsHandles)
{
  vtkNew<vtkPoints> torus;
  AddTorus(torus, 1.0, 0.35);
  this->Cloud->SetPoints(torus);
  this->Filter->SetSpacing(0.03);
  this->Filter->SetGenusToAsFound();
  EXPECT_TRUE(WarningsOf(this->Filter, this->Cloud).empty());
  EXPECT_EQ(this->Figure("NumberOfHandles"), 1);
  EXPECT_FALSE(this->IsGenusZero());
  // The tube is 0.7 wide, and the grid spacing is 0.03 times the largest radius of 1.35.
  this->Filter->SetHandleWidth(20.0);
  this->Filter->Update();
  EXPECT_EQ(this->Figure("NumberOfHandles"), 0);
  EXPECT_TRUE(this->IsGenusZero());
  this->Filter->SetHandleWidth(std::numeric_limits<double>::quiet_NaN());
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  observed.ExpectError("the width of handles must be in [0.000000, 1000.000000]");
}

// Real scans, closed and of genus zero, with limbs that touch and folds that nearly do.
TEST_F(GenusZeroHull, SaysNothingOfCleanScans)
{
  for (const char* name : { "igea-closed", "stanford-bunny-closed", "armadillo", "spot", "cortex" })
  {
    SCOPED_TRACE(name);
    const std::string path = std::string(CONFORMALSOM_SCAN_DIR) + "/" + name + ".ply";
    if (!std::filesystem::exists(path))
    {
      GTEST_SKIP() << path << " is missing";
    }
    vtkNew<vtkConformalPLYReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    for (const double spacing : { 0.016, 0.03, 0.05 })
    {
      this->Filter->SetSpacing(spacing);
      EXPECT_EQ(WarningsOf(this->Filter, reader->GetOutput()), std::vector<std::string>());
    }
  }
}

TEST_F(GenusZeroHull, PropertiesChangeTheResult)
{
  this->Filter->SetSmoothingPasses(0);
  this->Filter->Update();
  double bounds[6], wider[6];
  this->Filter->GetOutput()->GetBounds(bounds);
  this->Filter->SetOffset(3.0);
  this->Filter->Update();
  this->Filter->GetOutput()->GetBounds(wider);
  EXPECT_NEAR(wider[1] - bounds[1], 0.2, 0.03);
  const vtkIdType points = this->Filter->GetOutput()->GetNumberOfPoints();
  this->Filter->SetSpacing(0.1);
  this->Filter->Update();
  EXPECT_LT(2 * this->Filter->GetOutput()->GetNumberOfPoints(), points);
}

TEST_F(GenusZeroHull, LeavesTheInputAlone)
{
  vtkNew<vtkPolyData> before;
  before->DeepCopy(this->Cloud);
  this->Filter->Update();
  EXPECT_EQ(this->Cloud->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(
    std::memcmp(before->GetPoints()->GetVoidPointer(0), this->Cloud->GetPoints()->GetVoidPointer(0),
      3 * sizeof(double) * before->GetNumberOfPoints()),
    0);
}

TEST_F(GenusZeroHull, GivesTheSameBitsOnAnyThreads)
{
  vtkNew<vtkPolyData> expected;
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::Initialize(threads);
    this->Filter->Modified();
    this->Filter->Update();
    vtkPolyData* output = this->Filter->GetOutput();
    if (threads == 1)
    {
      expected->DeepCopy(output);
    }
    ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
    EXPECT_EQ(
      std::memcmp(expected->GetPoints()->GetVoidPointer(0), output->GetPoints()->GetVoidPointer(0),
        3 * sizeof(double) * expected->GetNumberOfPoints()),
      0);
  }
  vtkSMPTools::Initialize(0);
}

TEST_F(GenusZeroHull, ScalesWithTheCloud)
{
  this->Filter->Update();
  vtkNew<vtkPolyData> small;
  small->DeepCopy(this->Filter->GetOutput());
  const double factor = std::ldexp(1.0, 90); // 1e27
  for (vtkIdType i = 0; i < this->Cloud->GetNumberOfPoints(); ++i)
  {
    double x[3];
    this->Cloud->GetPoint(i, x);
    this->Cloud->GetPoints()->SetPoint(i, factor * x[0], factor * x[1], factor * x[2]);
  }
  this->Cloud->GetPoints()->Modified();
  this->Filter->Update();
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), small->GetNumberOfPoints());
  for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(this->Filter->GetOutput()->GetPoint(i)[axis], factor * small->GetPoint(i)[axis]);
    }
  }
}

TEST_F(GenusZeroHull, TakesAnyPointSet)
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(static_cast<int>(this->Cloud->GetNumberOfPoints()), 1, 1);
  grid->SetPoints(this->Cloud->GetPoints());
  this->Filter->Update();
  const vtkIdType points = this->Filter->GetOutput()->GetNumberOfPoints();
  this->Filter->SetInputData(grid);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), points);
}

TEST_F(GenusZeroHull, SkipsGhostPointsAndThoseNotFinite)
{
  this->Filter->Update();
  const vtkIdType expected = this->Filter->GetOutput()->GetNumberOfPoints();
  const vtkIdType size = this->Cloud->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(size + 3);
  ghosts->Fill(0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Cloud->GetPoints()->InsertNextPoint(100.0, 0.0, 0.0);
  this->Cloud->GetPoints()->InsertNextPoint(0.0, nan, 0.0);
  this->Cloud->GetPoints()->InsertNextPoint(-1.0 / 0.0, 0.0, 0.0);
  ghosts->SetValue(size, vtkDataSetAttributes::DUPLICATEPOINT);
  this->Cloud->GetPointData()->AddArray(ghosts);
  this->Cloud->Modified();
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_NE(
    observed.WarningMessage().find("2 points are not finite and left out"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), expected);
}

TEST_F(GenusZeroHull, LeavesOutPointsFarFromAllOthers)
{
  for (const int method :
    { vtkGenusZeroHull::DISTANCE, vtkGenusZeroHull::WINDING_NUMBERS, vtkGenusZeroHull::AUTOMATIC })
  {
    SCOPED_TRACE(method);
    vtkNew<vtkGenusZeroHull> clean;
    clean->SetInputData(this->Cloud);
    clean->SetSpacing(0.05);
    clean->SetMethod(method);
    clean->Update();
    this->Filter->SetMethod(method);
    vtkPoints* points = clean->GetOutput()->GetPoints();
    for (const double distance : { 1e2, 1e4, 1e15, 1e200 })
    {
      vtkNew<vtkPolyData> dirty;
      dirty->DeepCopy(this->Cloud);
      for (int i = 0; i < 3; ++i)
      {
        dirty->GetPoints()->InsertNextPoint(distance, (i - 1) * distance, 0.0);
      }
      const std::vector<std::string> warnings = WarningsOf(this->Filter, dirty);
      ASSERT_EQ(warnings.size(), 1U);
      EXPECT_NE(warnings[0].find("3 of 12965 points lie far from all others"), std::string::npos)
        << warnings[0];
      EXPECT_EQ(this->Figure("NumberOfPointsOutside"), 3);
      vtkPoints* own = this->Filter->GetOutput()->GetPoints();
      ASSERT_EQ(own->GetNumberOfPoints(), points->GetNumberOfPoints());
      EXPECT_EQ(std::memcmp(own->GetVoidPointer(0), points->GetVoidPointer(0),
                  3 * sizeof(double) * own->GetNumberOfPoints()),
        0);
    }
  }
}

TEST_F(GenusZeroHull, WarnsOfNoPoints)
{
  contract::Observed observed(this->Filter);
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetInputData(nothing);
  this->Filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_NE(observed.WarningMessage().find("there are no points to wrap"), std::string::npos);
  this->ExpectEmpty();
}

TEST_F(GenusZeroHull, WarnsOfFlatClouds)
{
  contract::Observed observed(this->Filter);
  for (const int rank : { 2, 1, 0 })
  {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 400; ++i)
    {
      points->InsertNextPoint(rank > 0 ? i % 20 : 7.0, rank > 1 ? i / 20 : 7.0, 0.0);
    }
    this->Cloud->SetPoints(points);
    observed.Clear();
    this->Filter->Update();
    EXPECT_FALSE(observed.Error());
    EXPECT_NE(observed.WarningMessage().find(
                std::array<const char*, 3>{ "all equal", "collinear", "coplanar" }[rank]),
      std::string::npos);
    EXPECT_EQ(this->Figure("AffineRank"), rank);
    EXPECT_EQ(this->Figure("NumberOfInsideNodes"), 0);
    EXPECT_EQ(this->Figure("NumberOfPointsOutside"), 0);
    EXPECT_TRUE(this->IsGenusZero());
  }
}

TEST_F(GenusZeroHull, RefusesParametersThatAreNoNumbers)
{
  contract::Observed observed(this->Filter);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Filter->SetSpacing(nan);
  this->Filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("grid's spacing"), std::string::npos);
  this->ExpectEmpty();
  this->Filter->SetSpacing(0.1);
  this->Filter->SetOffset(nan);
  observed.Clear();
  this->Filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("offset"), std::string::npos);
  this->Filter->SetOffset(1.0);
  this->Filter->SetPersistence(nan);
  observed.Clear();
  this->Filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("persistence"), std::string::npos);
  // Out of range is clamped.
  this->Filter->SetPersistence(0.0);
  EXPECT_EQ(this->Filter->GetPersistence(), 1.1);
}

TEST_F(GenusZeroHull, AbortLeavesNothingAndSaysNothing)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.3);
    });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  this->ExpectEmpty();
}

TEST_F(GenusZeroHull, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetSpacing(0.08); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetOffset(1.5); });
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetMethodToWindingNumbers(); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetPersistence(2.0); });
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetSmoothingPasses(5); });
  for (const char* property : { "Method", "Spacing", "Offset", "Persistence", "Genus",
         "HandleWidth", "SmoothingPasses", "DistributeOutput", "Controller" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
}

// Half of the data is missing above a height; the distance leaks there or closes it flat.
TEST_F(GenusZeroHull, ClosesALargeHoleByWindingNumbers)
{
  vtkNew<vtkPoints> points;
  AddSphere(points, 5000, 2.0, 5.0, -0.5);
  this->Cloud->SetPoints(points);
  this->Filter->SetMethodToWindingNumbers();
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  EXPECT_EQ(this->Figure("Method"), vtkGenusZeroHull::WINDING_NUMBERS);
  EXPECT_EQ(this->Figure("NormalsUsed"), 0);
  EXPECT_GT(this->Figure("KernelWidth"), 0.0);
  EXPECT_EQ(this->Figure("NumberOfPointsOutside"), 0);
  EXPECT_TRUE(this->IsGenusZero());
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(this->Filter->GetOutputPort());
  // A flat lid would leave 0.84 of the ball.
  EXPECT_NEAR(mass->GetVolume() / (4.0 / 3.0 * Pi * 8.0), 0.97, 0.06);
}

// Given by an array or by triangles, outward or inward.
TEST_F(GenusZeroHull, UsesTheNormalsOfTheInput)
{
  vtkNew<vtkGeodesicSphereSource> sphere;
  sphere->SetFrequency(36);
  sphere->Update();
  const vtkSmartPointer<vtkPoints> places = this->Cloud->GetPoints();
  for (const double sign : { 1.0, -1.0 })
  {
    for (const bool triangles : { false, true })
    {
      this->Cloud->Initialize();
      this->Cloud->SetPoints(places);
      if (triangles)
      {
        vtkNew<vtkCellArray> polygons;
        vtkCellArray* all = sphere->GetOutput()->GetPolys();
        for (vtkIdType i = 0; i < all->GetNumberOfCells(); ++i)
        {
          vtkNew<vtkIdList> ids;
          all->GetCellAtId(i, ids);
          if (sign < 0.0)
          {
            const vtkIdType first = ids->GetId(0);
            ids->SetId(0, ids->GetId(1));
            ids->SetId(1, first);
          }
          polygons->InsertNextCell(ids);
        }
        this->Cloud->SetPolys(polygons);
      }
      else
      {
        vtkNew<vtkFloatArray> normals;
        normals->SetNumberOfComponents(3);
        for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
        {
          const double* n = sphere->GetOutput()->GetPoint(i);
          normals->InsertNextTuple3(sign * n[0], sign * n[1], sign * n[2]);
        }
        this->Cloud->GetPointData()->SetNormals(normals);
      }
      this->Filter->SetMethodToWindingNumbers();
      contract::Observed observed(this->Filter);
      this->Filter->Update();
      EXPECT_FALSE(observed.Error() || observed.Warning());
      EXPECT_EQ(this->Figure("NormalsUsed"), 1);
      vtkNew<vtkMassProperties> mass;
      mass->SetInputConnection(this->Filter->GetOutputPort());
      EXPECT_NEAR(mass->GetVolume() / (4.0 / 3.0 * Pi * 8.0), 1.0, 0.01);
    }
  }
}

TEST_F(GenusZeroHull, WarnsOfNormalsThatDisagree)
{
  vtkPoints* places = this->Cloud->GetPoints();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    const double* x = places->GetPoint(i);
    const double sign = i * 2654435761U % 256 < 128 ? 1.0 : -1.0;
    normals->InsertNextTuple3(sign * (x[0] - 5.0), sign * x[1], sign * x[2]);
  }
  this->Cloud->GetPointData()->SetNormals(normals);
  contract::Observed observed(this->Filter);
  this->Filter->Update(); // by the distance they do not matter
  EXPECT_FALSE(observed.Warning());
  this->Filter->SetMethodToWindingNumbers();
  this->Filter->Update();
  EXPECT_NE(
    observed.WarningMessage().find("contradict each other about the inside"), std::string::npos);
  EXPECT_EQ(this->Figure("NormalsUsed"), 0);
  EXPECT_EQ(this->Figure("Method"), vtkGenusZeroHull::WINDING_NUMBERS);
  EXPECT_TRUE(this->IsGenusZero());
}

// Where winding numbers cannot tell, the hull is the other one, to the bit.
TEST_F(GenusZeroHull, TakesTheDistanceForFlatAndSmallClouds)
{
  for (const int size : { 400, 12 })
  {
    vtkNew<vtkPoints> points;
    if (size == 12)
    {
      AddSphere(points, 12, 1.0, 0.0);
    }
    for (int i = 0; i < 400 && size == 400; ++i)
    {
      points->InsertNextPoint(i % 20, i / 20, 0.0);
    }
    this->Cloud->SetPoints(points);
    this->Filter->SetMethodToDistance();
    this->Filter->Update();
    vtkNew<vtkPolyData> expected;
    expected->DeepCopy(this->Filter->GetOutput());
    this->Filter->SetMethodToWindingNumbers();
    this->Filter->Update();
    EXPECT_EQ(this->Figure("Method"), vtkGenusZeroHull::DISTANCE);
    ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), expected->GetNumberOfPoints());
    for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_EQ(this->Filter->GetOutput()->GetPoint(i)[c], expected->GetPoint(i)[c]);
      }
    }
  }
}

TEST_F(GenusZeroHull, RefusesCellsWithoutPointsOnlyWhereItReadsThem)
{
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 1 << 20 });
  this->Cloud->SetPolys(polygons);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_FALSE(observed.Error());
  this->Filter->SetMethodToWindingNumbers();
  this->Filter->Update();
  EXPECT_TRUE(observed.Error());
  this->ExpectEmpty();
}

TEST_F(GenusZeroHull, ByWindingNumbersIsTheSameOnAnyThreads)
{
  this->Filter->SetMethodToWindingNumbers();
  this->Filter->Update();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Filter->GetOutput());
  vtkSMPTools::LocalScope(vtkSMPTools::Config(1, "Sequential", false),
    [&]()
    {
      this->Filter->Modified();
      this->Filter->Update();
    });
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(
    std::memcmp(this->Filter->GetOutput()->GetPoints()->GetVoidPointer(0),
      expected->GetPoints()->GetVoidPointer(0), 3 * sizeof(double) * expected->GetNumberOfPoints()),
    0);
}

#include "vtkGenusZeroRepair.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkGenusZeroCheck.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkGlobalConformalMap.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkReverseSense.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <string>

namespace
{
const char* const Counts[] = { "IsGenusZero", "EulerNumber", "NumberOfHandlesCut",
  "NumberOfTunnelsFilled", "NumberOfBoundariesFilled", "NumberOfBoundariesLeft",
  "NumberOfPartsRemoved", "NumberOfTrianglesRemoved", "NumberOfPointsMerged",
  "NumberOfTrianglesTurned", "NumberOfTrianglesDropped", "NumberOfEdgesSeparated",
  "NumberOfPointsSeparated", "NumberOfTrianglesAdded" };

double Figure(vtkGenusZeroRepair* filter, const char* name)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetTuple1(0) : -1.0;
}

std::string Words(vtkGenusZeroRepair* filter)
{
  auto* lines = vtkStringArray::SafeDownCast(
    filter->GetOutput()->GetFieldData()->GetAbstractArray("RepairReport"));
  EXPECT_NE(lines, nullptr);
  std::string all;
  for (vtkIdType i = 0; lines && i < lines->GetNumberOfValues(); ++i)
  {
    all += lines->GetValue(i) + "\n";
  }
  return all;
}

// By another class of its own.
void ExpectGenusZero(vtkPolyData* surface)
{
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputData(surface);
  check->Update();
  vtkFieldData* data = check->GetOutput()->GetFieldData();
  EXPECT_EQ(data->GetArray("IsGenusZero")->GetTuple1(0), 1);
  EXPECT_EQ(data->GetArray("EulerNumber")->GetTuple1(0), 2);
  EXPECT_EQ(data->GetArray("NumberOfInconsistentEdges")->GetTuple1(0), 0);
  EXPECT_EQ(data->GetArray("NumberOfIsolatedPoints")->GetTuple1(0), 0);
  EXPECT_EQ(data->GetArray("IsInsideOut")->GetTuple1(0), 0);
}

// Cells with an original have its points' coordinates, to the bit.
// @return how many there are
vtkIdType ExpectUntouched(vtkPolyData* before, vtkPolyData* after)
{
  vtkDataArray* cells = after->GetCellData()->GetArray("OriginalCellIds");
  vtkIdType count = 0;
  vtkNew<vtkIdList> ids, originals;
  for (vtkIdType i = 0; i < after->GetNumberOfCells(); ++i)
  {
    const auto original = static_cast<vtkIdType>(cells->GetTuple1(i));
    if (original < 0)
    {
      continue;
    }
    ++count;
    after->GetCellPoints(i, ids);
    before->GetCellPoints(original, originals);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      double p[3], q[3];
      after->GetPoint(ids->GetId(k), p);
      before->GetPoint(originals->GetId(k), q);
      EXPECT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]);
    }
  }
  return count;
}

vtkNew<vtkPolyData> Scaled(double size, double x)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(5);
  vtkNew<vtkTransform> transform;
  transform->Translate(x, 0.0, 0.0);
  transform->Scale(size, size, size);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputConnection(source->GetOutputPort());
  moved->SetTransform(transform);
  moved->Update();
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(moved->GetOutput());
  return surface;
}

vtkNew<vtkPolyData> Appended(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(a);
  append->AddInputData(b);
  append->Update();
  vtkNew<vtkPolyData> both;
  both->ShallowCopy(append->GetOutput());
  return both;
}

void AddScalars(vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Heights");
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("Labels");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double z = surface->GetPoint(i)[2];
    heights->InsertNextValue(z);
    labels->InsertNextValue(z > 0.0 ? 200 : 100);
  }
  surface->GetPointData()->SetScalars(heights);
  surface->GetPointData()->AddArray(labels);
}
}

TEST(GenusZeroRepair, WritesTheContractsArrays)
{
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  filter->SetInputData(fixtures::SphereWithHandles(2));
  filter->Update();
  observed.ExpectWarning("");
  vtkPolyData* output = filter->GetOutput();
  for (const char* name : Counts)
  {
    contract::ExpectArray(output->GetFieldData(), name, VTK_ID_TYPE, 1, 1);
  }
  contract::ExpectArray(output->GetFieldData(), "RemovedAreaFraction", VTK_DOUBLE, 1, 1);
  contract::ExpectArray(output->GetFieldData(), "UntouchedFraction", VTK_DOUBLE, 1, 1);
  contract::ExpectArray(
    output->GetCellData(), "OriginalCellIds", VTK_ID_TYPE, 1, output->GetNumberOfCells());
  contract::ExpectArray(
    output->GetPointData(), "OriginalPointIds", VTK_ID_TYPE, 1, output->GetNumberOfPoints());
  auto* loops = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(loops->GetNumberOfLines(), 2);
  for (const char* name : { "LoopLength", "LoopAreaFraction" })
  {
    contract::ExpectArray(loops->GetCellData(), name, VTK_DOUBLE, 1, 2);
  }
  contract::ExpectArray(loops->GetCellData(), "LoopType", VTK_ID_TYPE, 1, 2);
  EXPECT_EQ(Words(filter),
    "2 handles were cut through\n" + std::to_string(int(Figure(filter, "NumberOfTrianglesAdded"))) +
      " triangles were added\nthe result is a closed surface of genus zero\n");
}

// The promise: closed and of genus zero, with at least 99 % of the triangles as they were, and
// ready to be mapped.
TEST(GenusZeroRepair, RepairsSpheresWithHandles)
{
  for (const int count : { 1, 5, 50 })
  {
    SCOPED_TRACE(count);
    const auto surface = fixtures::SphereWithHandles(count, 60);
    vtkNew<vtkGenusZeroRepair> filter;
    filter->SetInputData(surface);
    filter->Update();
    ExpectGenusZero(filter->GetOutput());
    EXPECT_EQ(Figure(filter, "NumberOfHandlesCut"), count);
    EXPECT_EQ(Figure(filter, "UntouchedFraction"), 1.0);
    EXPECT_EQ(ExpectUntouched(surface, filter->GetOutput()), surface->GetNumberOfCells());
    EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfLines(), count);
  }
}

TEST(GenusZeroRepair, CanBeMappedThen)
{
  vtkNew<vtkGenusZeroRepair> filter;
  filter->SetInputData(fixtures::SphereWithHandles(5));
  vtkNew<vtkGlobalConformalMap> map;
  contract::Observed observed(map);
  map->SetInputConnection(filter->GetOutputPort());
  map->Update();
  observed.ExpectWarning("");
  contract::ExpectSpherePosition(map->GetOutput());
  EXPECT_EQ(
    map->GetOutput()->GetFieldData()->GetArray("NumberOfFlippedTriangles")->GetTuple1(0), 0);
}

// Each loop is closed, and as long as its points are apart.
TEST(GenusZeroRepair, DrawsLoops)
{
  vtkNew<vtkGenusZeroRepair> filter;
  const auto surface = fixtures::SphereWithHandles(3);
  fixtures::ChangePolygons(surface, [](vtkIdType i, vtkIdList*) { return i != 100; });
  filter->SetInputData(surface);
  filter->Update();
  auto* loops = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(loops->GetNumberOfLines(), 4);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < 4; ++i)
  {
    loops->GetCellPoints(i, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    EXPECT_EQ(ids->GetId(0), ids->GetId(size - 1));
    double length = 0.0;
    for (vtkIdType k = 1; k < size; ++k)
    {
      double p[3], q[3];
      loops->GetPoint(ids->GetId(k - 1), p);
      loops->GetPoint(ids->GetId(k), q);
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    EXPECT_NEAR(loops->GetCellData()->GetArray("LoopLength")->GetTuple1(i), length, 1e-12 * length);
    EXPECT_EQ(loops->GetCellData()->GetArray("LoopType")->GetTuple1(i),
      i == 0 ? vtkGenusZeroRepair::FILLED_HOLE : vtkGenusZeroRepair::CUT_HANDLE);
  }
}

TEST(GenusZeroRepair, PassesWhatNeedsNoRepair)
{
  const auto surface = fixtures::Ellipsoid();
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  filter->SetInputData(surface);
  filter->Update();
  observed.ExpectWarning("");
  EXPECT_EQ(filter->GetOutput()->GetPoints(), surface->GetPoints());
  contract::ExpectSpherePosition(filter->GetOutput());
  EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfLines(), 0);
  EXPECT_EQ(surface->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_FALSE(surface->GetCellData()->HasArray("OriginalCellIds"));
  EXPECT_EQ(Words(filter), "the result is a closed surface of genus zero\n");
}

TEST(GenusZeroRepair, CarriesPointArrays)
{
  const auto surface = fixtures::SphereWithHandles(2);
  fixtures::ChangePolygons(surface, [](vtkIdType i, vtkIdList*) { return i < 100 || i > 140; });
  AddScalars(surface);
  vtkNew<vtkGenusZeroRepair> filter;
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  auto* heights = vtkDoubleArray::SafeDownCast(output->GetPointData()->GetScalars());
  ASSERT_NE(heights, nullptr);
  auto* labels = vtkUnsignedCharArray::SafeDownCast(output->GetPointData()->GetArray("Labels"));
  ASSERT_NE(labels, nullptr);
  vtkDataArray* originals = output->GetPointData()->GetArray("OriginalPointIds");
  vtkIdType added = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto original = static_cast<vtkIdType>(originals->GetTuple1(i));
    const double z = output->GetPoint(i)[2];
    if (original >= 0)
    {
      EXPECT_EQ(heights->GetValue(i), surface->GetPoint(original)[2]);
      EXPECT_EQ(heights->GetValue(i), z);
    }
    else
    {
      ++added;
      EXPECT_NEAR(heights->GetValue(i), z, 0.1);
      EXPECT_TRUE(labels->GetValue(i) == 100 || labels->GetValue(i) == 200);
    }
  }
  EXPECT_GT(added, 2);
}

TEST(GenusZeroRepair, LeavesOtherPartsOutWithAWarning)
{
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  filter->SetInputData(Appended(Scaled(0.1, 5.0), Scaled(1.0, 0.0)));
  filter->Update();
  observed.ExpectWarning("1 parts other than the largest were left out, with 0.990");
  ExpectGenusZero(filter->GetOutput());
  EXPECT_EQ(Figure(filter, "NumberOfPartsRemoved"), 1);
  EXPECT_EQ(Figure(filter, "NumberOfTrianglesRemoved"), 500);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 500);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(0), 500);
}

// Both poles of the sphere are one point, and the other one is unused: the number of points is that
// of the result.
TEST(GenusZeroRepair, SeparatesPointsWithAWarning)
{
  const auto surface = Scaled(1.0, 0.0);
  const vtkIdType unused = 11;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    surface->GetCellPoints(i, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      ids->SetId(k, ids->GetId(k) == unused ? 0 : ids->GetId(k));
    }
    triangles->InsertNextCell(ids);
  }
  surface->SetPolys(triangles);
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  filter->SetInputData(surface);
  filter->Update();
  observed.ExpectWarning("1 points were duplicated");
  ExpectGenusZero(filter->GetOutput());
  EXPECT_EQ(Figure(filter, "NumberOfPointsSeparated"), 1);
  EXPECT_EQ(Words(filter),
    "1 points were duplicated, since their triangles do not form one fan\n"
    "the result is a closed surface of genus zero\n");
  vtkDataArray* originals = filter->GetOutput()->GetPointData()->GetArray("OriginalPointIds");
  EXPECT_EQ(originals->GetTuple1(1), 0);
  EXPECT_EQ(originals->GetTuple1(unused), unused - 1);
}

TEST(GenusZeroRepair, KeepsTheLargestPartBesideHugeUnusedPoints)
{
  for (const double fill : { 0.0, 1e100, std::numeric_limits<double>::max() })
  {
    const auto surface = Appended(Scaled(0.1, 5.0), Scaled(1.0, 0.0));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->DeepCopy(surface->GetPoints());
    points->InsertNextPoint(fill, 0.0, 0.0);
    surface->SetPoints(points);
    surface->GetPointData()->Initialize();
    vtkNew<vtkGenusZeroRepair> filter;
    contract::Observed observed(filter);
    filter->SetInputData(surface);
    filter->Update();
    EXPECT_NEAR(Figure(filter, "RemovedAreaFraction"), 0.0099, 1e-4);
    EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(0), 500);
    ExpectGenusZero(filter->GetOutput());
  }
}

// Half a sphere: its hole has half of its area.
TEST(GenusZeroRepair, FillsHolesUpToASize)
{
  const auto surface = fixtures::Ellipsoid(10);
  double bounds[6];
  surface->GetBounds(bounds);
  fixtures::ChangePolygons(
    surface, [&](vtkIdType, vtkIdList* ids) { return surface->GetPoint(ids->GetId(0))[2] < 0.0; });
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  filter->SetInputData(surface);
  filter->Update();
  observed.ExpectWarning("1 holes were left open");
  EXPECT_EQ(Figure(filter, "IsGenusZero"), 0);
  EXPECT_EQ(Figure(filter, "EulerNumber"), 1);
  EXPECT_EQ(Figure(filter, "NumberOfBoundariesLeft"), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), surface->GetNumberOfCells());
  EXPECT_NE(Words(filter).find("1 holes were left open"), std::string::npos);

  observed.Clear();
  filter->SetMaximumHoleArea(0.9);
  filter->Update();
  observed.ExpectWarning("");
  ExpectGenusZero(filter->GetOutput());
  EXPECT_EQ(Figure(filter, "NumberOfBoundariesFilled"), 1);
  EXPECT_EQ(ExpectUntouched(surface, filter->GetOutput()), surface->GetNumberOfCells());
}

TEST(GenusZeroRepair, MergesQuadsOfASoup)
{
  vtkNew<vtkCubeSource> cube; // its squares have corners of their own
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  filter->SetInputConnection(cube->GetOutputPort());
  filter->Update();
  observed.ExpectWarning("");
  ExpectGenusZero(filter->GetOutput());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 8);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 12);
  EXPECT_EQ(Figure(filter, "NumberOfPointsMerged"), 16);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(11), 5);
}

TEST(GenusZeroRepair, OrientsOutward)
{
  const auto surface = fixtures::Ellipsoid();
  fixtures::TurnOverEvery(3, surface);
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  vtkNew<vtkGenusZeroRepair> filter;
  filter->SetInputConnection(reverse->GetOutputPort());
  filter->Update();
  ExpectGenusZero(filter->GetOutput());
  EXPECT_EQ(Figure(filter, "NumberOfTrianglesTurned"), 213); // all 320 but every third
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray("SpherePosition"));
}

TEST(GenusZeroRepair, SaysWhatItCannotRepair)
{
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  vtkNew<vtkPolyData> surface;
  filter->SetInputData(surface);
  filter->Update();
  observed.ExpectWarning("the surface is empty");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  observed.Clear();
  surface->SetPoints(fixtures::Ellipsoid()->GetPoints());
  filter->Update();
  observed.ExpectError("the surface has no triangles");

  observed.Clear();
  const auto broken = fixtures::Ellipsoid();
  broken->GetPoints()->SetPoint(3, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  filter->SetInputData(broken);
  filter->Update();
  observed.ExpectError("1 of 162 points of the surface are not finite");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  observed.Clear();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> band; // of Moebius
  for (int i = 0; i < 6; ++i)
  {
    const double t = vtkMath::Pi() * i / 3.0;
    for (const double w : { -0.3, 0.3 })
    {
      points->InsertNextPoint((1.0 + w * std::cos(t / 2)) * std::cos(t),
        (1.0 + w * std::cos(t / 2)) * std::sin(t), w * std::sin(t / 2));
    }
    const bool last = i == 5;
    band->InsertNextCell({ 2 * i, 2 * i + 1, last ? 0 : 2 * i + 3, last ? 1 : 2 * i + 2 });
  }
  vtkNew<vtkPolyData> moebius;
  moebius->SetPoints(points);
  moebius->SetPolys(band);
  filter->SetInputData(moebius);
  filter->Update();
  observed.ExpectError("the surface is not orientable");
}

TEST(GenusZeroRepair, GivesTheSameBitsOnAnyThreads)
{
  vtkNew<vtkPolyData> results[2];
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkGenusZeroRepair> filter;
    filter->SetInputData(fixtures::SphereWithHandles(8));
    filter->Update();
    results[threads / 4]->ShallowCopy(filter->GetOutput());
  }
  vtkSMPTools::Initialize(0);
  ASSERT_EQ(results[0]->GetNumberOfPoints(), results[1]->GetNumberOfPoints());
  for (vtkIdType i = 0; i < results[0]->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    results[0]->GetPoint(i, p);
    results[1]->GetPoint(i, q);
    ASSERT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]);
  }
  ASSERT_EQ(results[0]->GetNumberOfCells(), results[1]->GetNumberOfCells());
  vtkNew<vtkIdList> ids, others;
  for (vtkIdType i = 0; i < results[0]->GetNumberOfCells(); ++i)
  {
    results[0]->GetCellPoints(i, ids);
    results[1]->GetCellPoints(i, others);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      ASSERT_EQ(ids->GetId(k), others->GetId(k));
    }
  }
}

TEST(GenusZeroRepair, AbortLeavesNothing)
{
  vtkNew<vtkGenusZeroRepair> filter;
  filter->SetInputData(fixtures::SphereWithHandles(5));
  contract::ExpectStopsWhenAsked(filter);
}

TEST(GenusZeroRepair, RunsOnlyWhenModifiedAndPrints)
{
  vtkNew<vtkGenusZeroRepair> filter;
  filter->SetInputData(fixtures::Ellipsoid());
  contract::ExpectRunsOnlyWhenModified(filter, [&]() { filter->SetMaximumHoleArea(0.5); });
  contract::ExpectPrints(filter, "MaximumHoleArea");
}

// Two balls of radius 1 whose centers have distance 0.97, like the lobes in a model of a comet.
TEST(GenusZeroRepair, JoinsOverlappingParts)
{
  vtkNew<vtkGenusZeroRepair> filter;
  contract::Observed observed(filter);
  filter->SetInputData(Appended(Scaled(1.0, 0.97), Scaled(1.0, 0.0)));
  filter->Update();
  observed.ExpectWarning("");
  ExpectGenusZero(filter->GetOutput());
  EXPECT_EQ(Figure(filter, "NumberOfPartsJoined"), 1);
  EXPECT_EQ(Figure(filter, "NumberOfPartsRemoved"), 0);
  EXPECT_NE(
    Words(filter).find("1 parts that overlap others were joined with them"), std::string::npos);
  vtkDataArray* ids = filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    EXPECT_GE(ids->GetTuple1(i), 0);
  }
}

#include "vtkConformalSOM.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalPLYReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCleanPolyData.h"
#include "vtkCompositeDataSet.h"
#include "vtkConformalDistortion.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGenusZeroCheck.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{
// An ellipsoid's surface, evenly enough, at a place of its own.
vtkSmartPointer<vtkPolyData> MakeCloud(vtkIdType size, int type = VTK_DOUBLE)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (vtkIdType i = 0; i < size; ++i)
  {
    double n[3], length = 0.0;
    do
    {
      for (double& x : n)
      {
        x = random->GetNextRangeValue(-1.0, 1.0);
      }
      length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    } while (length < 0.1 || length > 1.0);
    points->InsertNextPoint(5.0 + 3.0 * n[0] / length, 2.0 * n[1] / length, n[2] / length);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  return cloud;
}

// Small and quick; what the tests show does not depend on size.
vtkSmartPointer<vtkConformalSOM> MakeFilter(vtkPointSet* input)
{
  auto filter = vtkSmartPointer<vtkConformalSOM>::New();
  filter->SetInputDataObject(input);
  filter->SetNumberOfNeurons(362);
  filter->SetNumberOfEpochs(20);
  filter->SetSamplesPerEpoch(500);
  return filter;
}

void ExpectMesh(vtkConformalSOM* filter)
{
  const int neurons = filter->GetNumberOfNeurons();
  vtkPolyData* mesh = filter->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), neurons);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * neurons - 4);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  contract::ExpectSpherePosition(mesh);
  double bounds[6];
  mesh->GetBounds(bounds);
  for (double bound : bounds)
  {
    EXPECT_TRUE(std::isfinite(bound));
  }
}

void ExpectEmpty(vtkConformalSOM* filter)
{
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows(), 0);
}

double Figure(vtkConformalSOM* filter, const char* name)
{
  return filter->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
}

void ExpectSamePoints(vtkConformalSOM* a, vtkConformalSOM* b)
{
  vtkPoints *own = a->GetOutput()->GetPoints(), *other = b->GetOutput()->GetPoints();
  ASSERT_EQ(own->GetNumberOfPoints(), other->GetNumberOfPoints());
  EXPECT_EQ(std::memcmp(own->GetVoidPointer(0), other->GetVoidPointer(0),
              3 * sizeof(double) * own->GetNumberOfPoints()),
    0);
}

// The polygons, each with points of its own.
void MakeSoup(vtkPolyData* surface, vtkPolyData* soup)
{
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, ids);
    polygons->InsertNextCell(ids->GetNumberOfIds());
    for (const vtkIdType id : *ids)
    {
      polygons->InsertCellPoint(points->InsertNextPoint(surface->GetPoint(id)));
    }
  }
  soup->SetPoints(points);
  soup->SetPolys(polygons);
}

void AddPriorities(vtkPolyData* cloud, const std::function<double(vtkIdType)>& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Priority");
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(value(i));
  }
  cloud->GetPointData()->AddArray(array);
}
}

TEST(ConformalSOM, WritesTheContractsArraysInBothModes)
{
  auto cloud = MakeCloud(3000);
  for (int mode : { vtkConformalSOM::ONLINE, vtkConformalSOM::BATCH })
  {
    auto filter = MakeFilter(cloud);
    filter->SetTrainingMode(mode);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error() || observed.Warning());
    ExpectMesh(filter);
    contract::ExpectArray(
      filter->GetOutput()->GetPointData(), "QuantizationError", VTK_DOUBLE, 1, 362);
    contract::ExpectArray(filter->GetOutput()->GetPointData(), "Supported", VTK_DOUBLE, 1, 362);
    if (mode == vtkConformalSOM::BATCH) // After few epochs, the mesh is far from some points.
    {
      EXPECT_GT(filter->GetOutput()->GetPointData()->GetArray("Supported")->GetRange()[0], 0.9);
    }
    contract::ExpectArray(filter->GetOutput()->GetFieldData(), "AffineRank", -1, 1, 1);
    EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("AffineRank")->GetTuple1(0), 3.0);
    contract::ExpectArray(
      filter->GetOutput()->GetFieldData(), "UnsupportedFraction", VTK_DOUBLE, 1, 1);
    for (const char* fraction : { "UncoveredFraction", "InvertedFraction", "FoldedFraction",
           "AreaRatio", "NoiseLevel", "EffectiveDegreesOfFreedom", "VertexShift" })
    {
      contract::ExpectArray(filter->GetOutput()->GetFieldData(), fraction, VTK_DOUBLE, 1, 1);
    }
    for (const char* count : { "StartedFromHull", "HullMethod", "NormalsUsed", "NumberOfStarts" })
    {
      contract::ExpectArray(filter->GetOutput()->GetFieldData(), count, -1, 1, 1);
    }

    vtkTable* history = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
    ASSERT_NE(history, nullptr);
    EXPECT_GE(history->GetNumberOfRows(), 10);
    for (const char* column :
      { "Frequency", "NeighborhoodRadius", "LearningRate", "MeanSquareError", "MeanDisplacement" })
    {
      contract::ExpectArray(
        history->GetRowData(), column, VTK_DOUBLE, 1, history->GetNumberOfRows());
    }
  }
}

TEST(ConformalSOM, AnAdaptiveMeshHasTheNeuronsWanted)
{
  auto filter = MakeFilter(MakeCloud(3000));
  filter->SetMeshTypeToAdaptive();
  filter->SetNumberOfNeurons(345);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  vtkPolyData* mesh = filter->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 345);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * 345 - 4);
  contract::ExpectSpherePosition(mesh);
  contract::ExpectArray(mesh->GetPointData(), "QuantizationError", VTK_DOUBLE, 1, 345);
  EXPECT_EQ(mesh->GetFieldData()->GetArray("StartedFromHull")->GetTuple1(0), 1.0);
  EXPECT_GT(mesh->GetFieldData()->GetArray("VertexShift")->GetTuple1(0), 0.0);

  filter->SetTrainingModeToOnline();
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("Batch"), std::string::npos);
  ExpectEmpty(filter);
}

// The stages are those of the search: levels of the sphere, then the fit, each as the options
// state, and the last one is the output.
TEST(ConformalSOM, StagesEndWithTheOutput)
{
  auto filter = MakeFilter(MakeCloud(3000));
  auto* stages = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(2));
  filter->Update();
  EXPECT_EQ(stages->GetNumberOfBlocks(), 0U);
  filter->GenerateStagesOn();
  const auto namesFor = [&](int mode, int type, int shape)
  {
    filter->SetTrainingMode(mode);
    filter->SetMeshType(type);
    filter->SetStartingShape(shape);
    filter->Update();
    std::vector<std::string> names;
    for (unsigned int i = 0; i < stages->GetNumberOfBlocks(); ++i)
    {
      names.emplace_back(stages->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
      auto* surface = vtkPolyData::SafeDownCast(stages->GetBlock(i));
      EXPECT_EQ(surface->GetNumberOfPolys(), 2 * surface->GetNumberOfPoints() - 4) << names.back();
      EXPECT_EQ(surface->GetFieldData()->GetArray("StartNumber")->GetTuple1(0), 1.0);
    }
    auto* kept = vtkPolyData::SafeDownCast(stages->GetBlock(stages->GetNumberOfBlocks() - 1));
    vtkPolyData* output = filter->GetOutput();
    EXPECT_EQ(kept->GetNumberOfPoints(), output->GetNumberOfPoints());
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double a[3], b[3];
      kept->GetPoint(i, a);
      output->GetPoint(i, b);
      EXPECT_EQ(vtkMath::Distance2BetweenPoints(a, b), 0.0) << i;
    }
    return names;
  };
  using F = vtkConformalSOM;
  using Names = std::vector<std::string>;
  EXPECT_EQ(
    namesFor(F::ONLINE, F::GEODESIC, F::SPHERE), (Names{ "1 sphere: start", "1 sphere: kept" }));
  EXPECT_EQ(namesFor(F::BATCH, F::GEODESIC, F::SPHERE),
    (Names{ "1 sphere: level 6", "1 sphere: fit", "1 sphere: kept" }));
  EXPECT_EQ(namesFor(F::BATCH, F::ADAPTIVE, F::SPHERE),
    (Names{ "1 sphere: level 4", "1 sphere: start", "1 sphere: remeshed", "1 sphere: turn 1",
      "1 sphere: fit", "1 sphere: kept" }));
  EXPECT_EQ(namesFor(F::BATCH, F::ADAPTIVE, F::HULL),
    (Names{ "1 hull: start", "1 hull: remeshed", "1 hull: turn 1", "1 hull: turn 2",
      "1 hull: turn 3", "1 hull: fit", "1 hull: kept" }));
}

TEST(ConformalSOM, StartsFromTheMeshOnPortOne)
{
  auto cloud = MakeCloud(5000);
  vtkNew<vtkGeodesicSphereSource> sphere;
  sphere->SetFrequency(9);
  vtkNew<vtkTransform> transform;
  transform->Translate(5.0, 0.0, 0.0);
  transform->Scale(3.0, 2.0, 1.0);
  vtkNew<vtkTransformPolyDataFilter> start;
  start->SetTransform(transform);
  start->SetInputConnection(sphere->GetOutputPort());
  auto filter = MakeFilter(cloud);
  filter->SetStartConnection(start->GetOutputPort());
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  ExpectMesh(filter);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("StartedFromHull")->GetTuple1(0), 0.0);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("StartedFromMesh")->GetTuple1(0), 1.0);
  filter->SetMeshTypeToGeodesic();
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("set MeshType to Adaptive"), std::string::npos);
  filter->SetMeshTypeToAutomatic();

  vtkNew<vtkPolyData> unmapped;
  start->Update();
  unmapped->CopyStructure(start->GetOutput());
  filter->SetStartData(unmapped);
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("SpherePosition"), std::string::npos);
  ExpectEmpty(filter);
}

TEST(ConformalSOM, StartsFromItsOwnPolygonsWhereTheyAreClosed)
{
  const vtkNew<vtkPolyData> closed = fixtures::Ellipsoid(12);
  const auto learned = [&](vtkPolyData* input, int start, bool fromMesh)
  {
    auto filter = MakeFilter(input);
    filter->SetStartingShape(start);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error() || observed.Warning());
    EXPECT_EQ(Figure(filter, "StartedFromMesh"), fromMesh);
    return filter;
  };
  learned(closed, vtkConformalSOM::SPHERE, false);
  auto automatic = learned(closed, vtkConformalSOM::AUTOMATIC, true);
  ExpectSamePoints(automatic, learned(closed, vtkConformalSOM::MESH, true));
  // Inside out, it is the same surface.
  const vtkNew<vtkPolyData> reversed = fixtures::Ellipsoid(12);
  fixtures::TurnOverEvery(1, reversed);
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputData(learned(reversed, vtkConformalSOM::AUTOMATIC, true)->GetOutput());
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsInsideOut")->GetTuple1(0), 0.0);

  // Open, or not all of the points: as the points alone.
  vtkNew<vtkPolyData> cloud, open, more;
  cloud->SetPoints(closed->GetPoints());
  open->DeepCopy(closed);
  fixtures::ChangePolygons(open, [](vtkIdType i, vtkIdList*) { return i > 0; });
  auto alone = learned(cloud, vtkConformalSOM::AUTOMATIC, false);
  ExpectSamePoints(alone, learned(open, vtkConformalSOM::AUTOMATIC, false));
  more->DeepCopy(closed);
  more->GetPointData()->Initialize();
  more->GetPoints()->InsertNextPoint(closed->GetPoint(0));
  learned(more, vtkConformalSOM::AUTOMATIC, false);
}

// Edges are thirty times as long as those of the learned mesh, and eight corners are too few to
// evaluate it.
TEST(ConformalSOM, LearnsFromCoarsePolygons)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(4.0);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(box->GetOutputPort());
  clean->Update();
  auto filter = MakeFilter(clean->GetOutput());
  filter->SetNumberOfNeurons(1000);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning()) << observed.WarningMessage();
  EXPECT_EQ(Figure(filter, "StartedFromMesh"), 1.0);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(filter->GetOutput());
  EXPECT_NEAR(mass->GetVolume(), 4.0, 0.1);
}

TEST(ConformalSOM, FewPointsGiveAWarning)
{
  vtkNew<vtkPolyData> cloud;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i % 2, i / 2 % 2, i / 4); // NOLINT(bugprone-integer-division)
  }
  cloud->SetPoints(points);
  auto filter = MakeFilter(cloud);
  contract::Observed observed(filter);
  filter->Update();
  observed.ExpectWarning("the input has 8 points, which are too few for the object's details");
}

TEST(ConformalSOM, SaysThatNoGroundIsFound)
{
  auto filter = MakeFilter(MakeCloud(49)); // One more is required.
  filter->SetRemoveGroundToOn();
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_EQ(Figure(filter, "NumberOfGroundPoints"), 0.0);
  EXPECT_NE(observed.WarningMessage().find("no ground is found"), std::string::npos)
    << observed.WarningMessage();
}

TEST(ConformalSOM, SaysThatClosedScansHaveNoBorder)
{
  auto filter = MakeFilter(MakeCloud(1000));
  filter->SetBorderToOpen();
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_NE(observed.WarningMessage().find("Border OPEN has no effect"), std::string::npos)
    << observed.WarningMessage();
}

// As STL files have it: each triangle with points of its own.
TEST(ConformalSOM, StartsFromAPolygonSoup)
{
  const vtkNew<vtkPolyData> closed = fixtures::Ellipsoid(12);
  fixtures::TurnOverEvery(3, closed);
  vtkNew<vtkPolyData> soup;
  MakeSoup(closed, soup);
  auto filter = MakeFilter(soup);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  EXPECT_EQ(Figure(filter, "StartedFromMesh"), 1.0);
  vtkNew<vtkMassProperties> mass, expected;
  mass->SetInputData(filter->GetOutput());
  expected->SetInputData(fixtures::Ellipsoid(12));
  EXPECT_NEAR(mass->GetVolume(), expected->GetVolume(), 0.01 * expected->GetVolume());
}

// Cells that are no surface of the points: the result is that of the points alone, to the bit.
TEST(ConformalSOM, CellsMayBeDecoration)
{
  auto cloud = MakeCloud(3000);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const double* x = cloud->GetPoint(i);
    normals->InsertNextTuple3((x[0] - 5.0) / 9.0, x[1] / 4.0, x[2]);
  }
  cloud->GetPointData()->SetNormals(normals);
  using Cells = std::vector<std::vector<vtkIdType>>;
  Cells verts, line(1), few = { { 0, 1, 2 }, { 7, 8, 9, 10 } }, repeated,
                        missing = { { 0, 1, 3000 } };
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    verts.push_back({ i });
    line[0].push_back(i);
    repeated.push_back({ i, i, i });
  }
  const auto withCells = [&](const Cells& cells, void (vtkPolyData::*set)(vtkCellArray*))
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(cloud);
    vtkNew<vtkCellArray> array;
    for (const std::vector<vtkIdType>& ids : cells)
    {
      array->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    (data->*set)(array);
    return data;
  };
  for (const int hull : { vtkConformalSOM::AUTOMATIC, vtkConformalSOM::HULL })
  {
    const auto learned = [&](vtkPolyData* input)
    {
      auto filter = MakeFilter(input);
      filter->SetStartingShape(hull);
      contract::Observed observed(filter);
      filter->Update();
      EXPECT_FALSE(observed.Error() || observed.Warning()) << observed.WarningMessage();
      EXPECT_EQ(Figure(filter, "StartedFromMesh"), 0.0);
      return filter;
    };
    auto alone = learned(cloud);
    ExpectSamePoints(alone, learned(withCells(verts, &vtkPolyData::SetVerts)));
    ExpectSamePoints(alone, learned(withCells(line, &vtkPolyData::SetLines)));
    ExpectSamePoints(alone, learned(withCells(few, &vtkPolyData::SetPolys)));
    ExpectSamePoints(alone, learned(withCells(repeated, &vtkPolyData::SetStrips)));
    ExpectSamePoints(alone, learned(withCells(missing, &vtkPolyData::SetPolys)));
  }
}

// Of a surface that is open, of genus one, or has unused points, and however its triangles are
// turned: they tell what is outside, before a normals array does, unless they do not agree.
TEST(ConformalSOM, TrianglesOrientThePoints)
{
  const auto hulled = [](vtkPolyData* input)
  {
    auto filter = MakeFilter(input);
    filter->SetStartingShapeToHull();
    filter->SetHullMethodToWindingNumbers();
    filter->SetMeshTypeToAdaptive();
    filter->SetNumberOfNeurons(642);
    filter->Update();
    EXPECT_EQ(Figure(filter, "StartedFromMesh"), 0.0);
    return filter;
  };
  const auto volume = [](vtkAlgorithm* filter)
  {
    vtkNew<vtkMassProperties> mass;
    mass->SetInputConnection(filter->GetOutputPort());
    return mass->GetVolume();
  };
  const vtkNew<vtkPolyData> closed = fixtures::Ellipsoid(16);
  vtkNew<vtkMassProperties> whole;
  whole->SetInputData(closed);
  vtkNew<vtkPolyData> open, turned, unused;
  open->DeepCopy(closed);
  fixtures::ChangePolygons(open, [](vtkIdType i, vtkIdList*) { return i % 100 > 0; });
  turned->DeepCopy(open);
  fixtures::TurnOverEvery(3, turned);
  unused->DeepCopy(closed);
  unused->GetPointData()->Initialize();
  unused->GetPoints()->InsertNextPoint(closed->GetPoint(0));
  for (vtkPolyData* input : { open.Get(), turned.Get(), unused.Get() })
  {
    // Normals that say nothing stand behind the triangles.
    vtkNew<vtkFloatArray> nonsense;
    nonsense->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      nonsense->InsertNextTuple3(0.0, 0.0, 1.0);
    }
    input->GetPointData()->SetNormals(nonsense);
    auto filter = hulled(input);
    EXPECT_EQ(Figure(filter, "NormalsUsed"), 1.0);
    EXPECT_NEAR(volume(filter), whole->GetVolume(), 0.05 * whole->GetVolume());
  }
  // Without a common edge nobody can turn them: the points tell by themselves.
  fixtures::TurnOverEvery(2, open);
  vtkNew<vtkPolyData> soup;
  MakeSoup(open, soup);
  auto filter = hulled(soup);
  EXPECT_EQ(Figure(filter, "NormalsUsed"), 0.0);
  EXPECT_NEAR(volume(filter), whole->GetVolume(), 0.05 * whole->GetVolume());
}

// Its triangles are no surface to start from.
TEST(ConformalSOM, ATorusIsLearnedFromItsPoints)
{
  constexpr int around = 60, across = 40;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * vtkMath::Pi() * i / around, v = 2.0 * vtkMath::Pi() * j / across;
      const double r = 1.0 + 0.4 * std::cos(v);
      points->InsertNextPoint(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
      const int right = (i + 1) % around, up = (j + 1) % across;
      polygons->InsertNextCell(
        { i * across + j, right * across + j, right * across + up, i * across + up });
    }
  }
  vtkNew<vtkPolyData> torus;
  torus->SetPoints(points);
  torus->SetPolys(polygons);
  auto filter = MakeFilter(torus);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(Figure(filter, "StartedFromMesh"), 0.0);
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputConnection(filter->GetOutputPort());
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("EulerNumber")->GetTuple1(0), 2.0);
  EXPECT_EQ(Figure(filter, "NumberOfHandles"), 0.0);
  // With its handle, the surface has no map to the sphere, and all other arrays.
  filter->SetGenusToAsFound();
  filter->SetNumberOfNeurons(1500);
  observed.Clear();
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("EulerNumber")->GetTuple1(0), 0.0);
  EXPECT_EQ(Figure(filter, "NumberOfHandles"), 1.0);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_FALSE(output->GetPointData()->HasArray("SpherePosition"));
  EXPECT_FALSE(output->GetFieldData()->HasArray("MeanQuasiConformalError"));
  for (const char* name : { "Supported", "StandardError", "QuantizationError" })
  {
    contract::ExpectArray(output->GetPointData(), name, VTK_DOUBLE, 1, output->GetNumberOfPoints());
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 1.0, p[2]), 0.4, 0.02);
  }
}

TEST(ConformalSOM, LearnsNoHandlesFromTheSphere)
{
  vtkNew<vtkPolyData> cloud;
  cloud->DeepCopy(fixtures::Ellipsoid(6));
  const auto expectError = [&](const std::function<void(vtkConformalSOM*)>& set)
  {
    auto filter = MakeFilter(cloud);
    filter->SetGenusToAsFound();
    set(filter);
    contract::Observed observed(filter);
    filter->Update();
    observed.ExpectError(
      "a mesh that is learned from the sphere has no handles; set Genus to Zero");
  };
  expectError([](vtkConformalSOM* filter) { filter->SetMeshTypeToGeodesic(); });
  expectError([](vtkConformalSOM* filter) { filter->SetTrainingModeToOnline(); });
  expectError([](vtkConformalSOM* filter) { filter->SetStartingShapeToSphere(); });
}

TEST(ConformalSOM, SaysWhyItCannotStartFromThePolygons)
{
  const auto expectError = [](vtkPolyData* input, const std::string& why)
  {
    auto filter = MakeFilter(input);
    filter->SetStartingShapeToMesh();
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_NE(observed.ErrorMessage().find(why), std::string::npos) << observed.ErrorMessage();
    ExpectEmpty(filter);
  };
  expectError(MakeCloud(1000), "no polygons");
  const vtkNew<vtkPolyData> open = fixtures::Ellipsoid(8);
  fixtures::ChangePolygons(open, [](vtkIdType i, vtkIdList*) { return i > 0; });
  expectError(open, "must be closed");
}

TEST(ConformalSOM, LearnsTheEllipsoidWhereItLies)
{
  auto cloud = MakeCloud(20000);
  auto filter = MakeFilter(cloud);
  filter->SetNumberOfNeurons(1442);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    EXPECT_NEAR(std::hypot((x[0] - 5.0) / 3.0, x[1] / 2.0, x[2]), 1.0, 0.03);
  }
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputConnection(filter->GetOutputPort());
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsGenusZero")->GetTuple1(0), 1.0);
}

TEST(ConformalSOM, TakesFloatsStructuredPointsAndCells)
{
  auto doubles = MakeCloud(2000), floats = MakeCloud(2000, VTK_FLOAT);
  auto a = MakeFilter(doubles), b = MakeFilter(floats);
  a->Update();
  b->Update();
  for (vtkIdType i = 0; i < a->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double x[3], y[3];
    a->GetOutput()->GetPoint(i, x);
    b->GetOutput()->GetPoint(i, y);
    EXPECT_NEAR(x[0], y[0], 1e-3);
  }
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(20, 100, 1);
  grid->SetPoints(doubles->GetPoints());
  auto c = MakeFilter(grid);
  c->Update();
  EXPECT_EQ(std::memcmp(c->GetOutput()->GetPoints()->GetVoidPointer(0),
              a->GetOutput()->GetPoints()->GetVoidPointer(0), 362 * 3 * sizeof(double)),
    0);
}

TEST(ConformalSOM, LeavesItsInputAlone)
{
  auto cloud = MakeCloud(500);
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(cloud);
  const vtkMTimeType before = cloud->GetMTime();
  auto filter = MakeFilter(cloud);
  filter->Update();
  EXPECT_EQ(cloud->GetMTime(), before);
  for (vtkIdType i = 0; i < 500; ++i)
  {
    EXPECT_EQ(cloud->GetPoint(i)[0], copy->GetPoint(i)[0]);
  }
  EXPECT_EQ(cloud->GetPointData()->GetNumberOfArrays(), 0);
}

TEST(ConformalSOM, RunsOnlyWhenModifiedAndPrints)
{
  auto cloud = MakeCloud(200);
  auto filter = MakeFilter(cloud);
  contract::ExpectRunsOnlyWhenModified(filter, [&]() { filter->SetRandomSeed(4); });
  contract::ExpectRunsOnlyWhenModified(filter, [&]() { filter->SetTrainingModeToOnline(); });
  for (const char* property : { "MeshType", "NumberOfNeurons", "TrainingMode", "PriorityArrayName",
         "RandomSeed", "ReferencePoint", "NumberOfEpochs", "SamplesPerEpoch", "OnlineConstants",
         "FitIterations", "Smoothness", "StartingShape", "HullMethod", "GenerateStages",
         "DistributeOutput", "Controller" })
  {
    contract::ExpectPrints(filter, property);
  }
}

TEST(ConformalSOM, AGeodesicMeshHasTheNearestNumberOfNeurons)
{
  vtkNew<vtkConformalSOM> filter;
  EXPECT_EQ(filter->GetNumberOfNeurons(), 0); // automatic
  filter->SetNumberOfNeurons(240);            // between 162 and 252
  auto cloud = MakeCloud(500);
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 240);
  filter->SetMeshTypeToGeodesic();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 252);
  filter->SetMeshTypeToAutomatic();
  filter->SetTrainingModeToOnline();
  filter->SetNumberOfEpochs(1);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 252);
}

TEST(ConformalSOM, SameBitsOnAnyBackendAndNumberOfThreads)
{
  auto cloud = MakeCloud(20000);
  vtkNew<vtkPoints> first;
  first->SetDataTypeToDouble();
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
    for (int threads : { 1, 2, 5 })
    {
      auto filter = MakeFilter(cloud);
      vtkSMPTools::LocalScope(
        vtkSMPTools::Config(threads, backend, false), [&]() { filter->Update(); });
      vtkPoints* points = filter->GetOutput()->GetPoints();
      if (first->GetNumberOfPoints() == 0)
      {
        first->DeepCopy(points);
      }
      EXPECT_EQ(std::memcmp(first->GetVoidPointer(0), points->GetVoidPointer(0),
                  points->GetNumberOfPoints() * 3 * sizeof(double)),
        0)
        << backend << " " << threads;
    }
  }
}

// Rows "CSM" of the policy on bad input -----------------------------------------------------

TEST(ConformalSOM, NoPointsGiveAWarningAndAnEmptyMesh)
{
  vtkNew<vtkPolyData> nothing;
  auto filter = MakeFilter(nothing);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_FALSE(observed.Error());
  ExpectEmpty(filter);
}

TEST(ConformalSOM, FlatCloudsGiveAWarningAndAFiniteMesh)
{
  struct Case
  {
    vtkIdType Size;
    std::function<void(vtkIdType, double*)> Place;
    int Rank;
  };
  const auto equal = [](vtkIdType, double* x) { x[0] = x[1] = x[2] = 3.0; };
  const auto line = [](vtkIdType i, double* x) { x[0] = x[1] = x[2] = static_cast<double>(i); };
  const auto plane = [](vtkIdType i, double* x)
  {
    x[0] = std::cos(static_cast<double>(i));
    x[1] = 1e6 * std::sin(static_cast<double>(i));
    x[2] = 4.0;
  };
  for (const Case& c : { Case{ 1, line, 0 }, Case{ 2, line, 1 }, Case{ 3, plane, 2 },
         Case{ 100, equal, 0 }, Case{ 100, line, 1 }, Case{ 100, plane, 1 } })
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < c.Size; ++i)
    {
      double x[3];
      c.Place(i, x);
      points->InsertNextPoint(x);
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    auto filter = MakeFilter(cloud);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error());
    ExpectMesh(filter);
    const int rank =
      static_cast<int>(filter->GetOutput()->GetFieldData()->GetArray("AffineRank")->GetTuple1(0));
    EXPECT_NE(observed.WarningMessage().find(
                std::array<const char*, 3>{ "all equal", "collinear", "coplanar" }[rank]),
      std::string::npos);
    EXPECT_EQ(observed.WarningMessage().find("neurons"), std::string::npos)
      << observed.WarningMessage();
    EXPECT_LE(rank, 2);
    EXPECT_EQ(filter->GetOutput()->GetLength() > 0.0, rank > 0);
  }
}

// Forty times as long as thick: a conformal map of it has no room in double precision.
TEST(ConformalSOM, MapsWhatIsTooLongForAConformalMapWithAWarning)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 4000; ++i)
  {
    const double angle = 2.399963 * i, z = -1.0 + 2.0 * i / 3999.0;
    const double radius = 0.025 * std::sqrt(1.0 - std::pow(z, 20));
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  auto filter = MakeFilter(cloud);
  filter->SetMeshTypeToAdaptive();
  filter->SetNumberOfNeurons(1500);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  contract::ExpectSpherePosition(filter->GetOutput());
  vtkNew<vtkConformalDistortion> distortion;
  distortion->SetInputData(filter->GetOutput());
  distortion->Update();
  vtkFieldData* figures = distortion->GetOutput()->GetFieldData();
  EXPECT_EQ(figures->GetArray("NumberOfFlippedTriangles")->GetTuple1(0), 0.0);
  std::ostringstream error;
  error << "error is "
        << filter->GetOutput()->GetFieldData()->GetArray("MeanQuasiConformalError")->GetTuple1(0);
  EXPECT_NE(observed.WarningMessage().find(error.str()), std::string::npos)
    << observed.WarningMessage();
}

TEST(ConformalSOM, PointsThatAreNotFiniteAreDroppedAndCounted)
{
  auto clean = MakeCloud(1000);
  auto dirty = MakeCloud(1000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  dirty->GetPoints()->InsertNextPoint(nan, 0, 0);
  dirty->GetPoints()->InsertNextPoint(0, std::numeric_limits<double>::infinity(), 0);
  auto a = MakeFilter(clean), b = MakeFilter(dirty);
  contract::Observed observed(b);
  a->Update();
  b->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_NE(observed.WarningMessage().find("2 points are not finite"), std::string::npos);
  for (vtkIdType i = 0; i < a->GetOutput()->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(a->GetOutput()->GetPoint(i)[2], b->GetOutput()->GetPoint(i)[2]);
  }

  vtkNew<vtkPolyData> allBad;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(nan, nan, nan);
  allBad->SetPoints(points);
  auto c = MakeFilter(allBad);
  contract::Observed none(c);
  c->Update();
  EXPECT_TRUE(none.Warning());
  EXPECT_FALSE(none.Error());
  ExpectEmpty(c);
}

// Outliers at any distance change no bit of the mesh; a frame around them would leave nothing of
// it.
TEST(ConformalSOM, PointsFarFromAllOthersAreLeftOutAndCounted)
{
  for (const int meshType : { vtkConformalSOM::GEODESIC, vtkConformalSOM::ADAPTIVE })
  {
    auto clean = MakeFilter(MakeCloud(1000));
    clean->SetMeshType(meshType);
    clean->Update();
    for (const double distance : { 30.0, 900.0, 3e4, 3e9, 3e15, 3e200 })
    {
      SCOPED_TRACE(std::to_string(meshType) + " " + std::to_string(distance));
      auto cloud = MakeCloud(1000);
      cloud->GetPoints()->InsertNextPoint(distance, 0.0, 0.0);
      cloud->GetPoints()->InsertNextPoint(0.1 * distance, -distance, 0.3 * distance);
      auto filter = MakeFilter(cloud);
      filter->SetMeshType(meshType);
      contract::Observed observed(filter);
      filter->Update();
      observed.ExpectWarning("2 of 1002 points lie far from all others and are left out");
      ExpectSamePoints(clean, filter);
    }
  }
}

// As exporters write pixels without a point, in a cloud that lies far from there.
TEST(ConformalSOM, ManyPointsAtTheOriginAreLeftOut)
{
  auto clean = MakeCloud(1000), dirty = MakeCloud(1000);
  for (vtkPolyData* cloud : { clean.Get(), dirty.Get() })
  {
    for (vtkIdType i = 0; i < 1000; ++i)
    {
      double x[3];
      cloud->GetPoint(i, x);
      cloud->GetPoints()->SetPoint(i, x[0] + 5e5, x[1] + 5e6, x[2]);
    }
  }
  for (int i = 0; i < 400; ++i)
  {
    dirty->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  }
  auto a = MakeFilter(clean), b = MakeFilter(dirty);
  contract::Observed observed(b);
  a->Update();
  b->Update();
  observed.ExpectWarning("400 of 1400 points lie far from all others");
  ExpectSamePoints(a, b);
}

// A vertex of the input's own polygons is no outlier.
TEST(ConformalSOM, FarVerticesOfPolygonsAreKept)
{
  const vtkNew<vtkPolyData> surface = fixtures::Ellipsoid(20);
  surface->GetPoints()->SetPoint(7, 300.0, 0.0, 0.0);
  auto filter = MakeFilter(surface);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_EQ(observed.WarningMessage().find("far from all others"), std::string::npos);
  EXPECT_FALSE(observed.Error());
}

// Real scans, closed and of genus zero, with limbs that bend back to the body.
TEST(ConformalSOM, OneLayerOfAShellIsLearned)
{
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(8000);
  const double outer[3] = { 5.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < 8000; ++i)
  {
    double x[3];
    cloud->GetPoint(i, x);
    for (int k = 0; k < 3; ++k)
    {
      x[k] = outer[k] + 0.7 * (x[k] - outer[k]);
    }
    cloud->GetPoints()->InsertNextPoint(x);
  }
  double volumes[3] = { 0.0, 0.0, 0.0 };
  for (const int side : { vtkConformalSOM::OUTER_SIDE, vtkConformalSOM::INNER_SIDE })
  {
    auto filter = vtkSmartPointer<vtkConformalSOM>::New();
    filter->SetInputDataObject(cloud);
    filter->SetNumberOfNeurons(1000);
    filter->SetSide(side);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_NE(observed.WarningMessage().find(side == vtkConformalSOM::OUTER_SIDE
                  ? "8000 of 16000 points are left out as the inner layer"
                  : "8000 of 16000 points are left out as the outer layer"),
      std::string::npos)
      << observed.WarningMessage();
    EXPECT_EQ(
      filter->GetOutput()->GetFieldData()->GetArray("NumberOfOtherLayerPoints")->GetTuple1(0),
      8000);
    vtkNew<vtkMassProperties> mass;
    mass->SetInputConnection(filter->GetOutputPort());
    volumes[side] = mass->GetVolume();
  }
  const double volume = 4.0 / 3.0 * vtkMath::Pi() * 3.0 * 2.0 * 1.0;
  EXPECT_NEAR(volumes[vtkConformalSOM::OUTER_SIDE], volume, 0.01 * volume);
  EXPECT_NEAR(volumes[vtkConformalSOM::INNER_SIDE], 0.343 * volume, 0.01 * volume);
}

TEST(ConformalSOM, SaysNothingOfCleanScans)
{
  for (const char* name : { "spot", "armadillo" })
  {
    const std::string path = std::string(CONFORMALSOM_SCAN_DIR) + "/" + name + ".ply";
    if (!std::filesystem::exists(path))
    {
      GTEST_SKIP() << path << " is missing";
    }
    vtkNew<vtkConformalPLYReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    SCOPED_TRACE(name);
    auto filter = MakeFilter(reader->GetOutput());
    filter->SetStartingShapeToHull();
    filter->SetNumberOfNeurons(5762);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error() || observed.Warning()) << observed.WarningMessage();
  }
}

TEST(ConformalSOM, AnyUnitAndPlaceWill)
{
  auto cloud = MakeCloud(1000);
  auto reference = MakeFilter(cloud);
  reference->Update();
  for (double unit : { 1e-30, 1e30 })
  {
    vtkNew<vtkPolyData> scaled;
    scaled->DeepCopy(cloud);
    for (vtkIdType i = 0; i < 1000; ++i)
    {
      double x[3];
      cloud->GetPoint(i, x);
      scaled->GetPoints()->SetPoint(i, unit * x[0], unit * x[1], unit * x[2]);
    }
    auto filter = MakeFilter(scaled);
    filter->Update();
    ExpectMesh(filter);
    double x[3], y[3];
    reference->GetOutput()->GetPoint(17, x);
    filter->GetOutput()->GetPoint(17, y);
    EXPECT_NEAR(y[0] / unit, x[0], 1e-6);
  }
}

TEST(ConformalSOM, ScannerPositionsThatCannotBeUsedAreErrors)
{
  auto cloud = MakeCloud(300);
  const auto refused = [&](vtkFieldData* data, int components, int tuples)
  {
    vtkNew<vtkDoubleArray> positions;
    positions->SetName("ScannerPosition");
    positions->SetNumberOfComponents(components);
    positions->SetNumberOfTuples(tuples);
    positions->Fill(9.0);
    data->AddArray(positions);
    auto filter = MakeFilter(cloud);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_EQ(observed.Error(), components != 3 || (tuples != 1 && tuples != 300));
    if (observed.Error())
    {
      EXPECT_NE(observed.ErrorMessage().find("ScannerPosition"), std::string::npos);
      ExpectEmpty(filter);
    }
    data->RemoveArray("ScannerPosition");
  };
  refused(cloud->GetPointData(), 1, 300);
  refused(cloud->GetPointData(), 3, 299);
  refused(cloud->GetPointData(), 3, 300);
  refused(cloud->GetFieldData(), 2, 1);
  refused(cloud->GetFieldData(), 3, 2);
  refused(cloud->GetFieldData(), 3, 1);
}

TEST(ConformalSOM, PriorityArraysThatCannotBeUsedAreErrors)
{
  auto cloud = MakeCloud(300);
  const auto refused = [&](vtkPolyData* input, const char* name)
  {
    auto filter = MakeFilter(input);
    filter->SetPriorityArrayName(name);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_TRUE(observed.Error());
    EXPECT_NE(observed.ErrorMessage().find(name), std::string::npos);
    ExpectEmpty(filter);
  };
  refused(cloud, "missing");
  vtkNew<vtkDoubleArray> wrong;
  wrong->SetName("short");
  wrong->SetNumberOfTuples(299);
  wrong->Fill(1.0);
  cloud->GetPointData()->AddArray(wrong);
  refused(cloud, "short");
  cloud->GetPointData()->RemoveArray("short");
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(300);
  vectors->Fill(1.0);
  cloud->GetPointData()->AddArray(vectors);
  refused(cloud, "vectors");
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfTuples(300);
  cloud->GetPointData()->AddArray(words);
  refused(cloud, "words");
  AddPriorities(cloud, [](vtkIdType i) { return i % 2 ? 0.0 : -1.0; });
  refused(cloud, "Priority");
}

TEST(ConformalSOM, AnEmptyNameMeansEqualPriority)
{
  auto named = MakeFilter(MakeCloud(1000)), unnamed = MakeFilter(MakeCloud(1000));
  named->SetPriorityArrayName("");
  contract::Observed observed(named);
  named->Update();
  unnamed->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(named->GetOutput()->GetPoint(9)[1], unnamed->GetOutput()->GetPoint(9)[1]);
}

TEST(ConformalSOM, BadPrioritiesCountAsZeroWithAWarning)
{
  auto cloud = MakeCloud(1000), clean = MakeCloud(1000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  AddPriorities(cloud, [&](vtkIdType i) { return i % 10 == 0 ? nan : i % 10 == 1 ? -2.0 : 1.0; });
  AddPriorities(clean, [&](vtkIdType i) { return i % 10 < 2 ? 0.0 : 1.0; });
  auto a = MakeFilter(cloud), b = MakeFilter(clean);
  a->SetPriorityArrayName("Priority");
  b->SetPriorityArrayName("Priority");
  contract::Observed observed(a);
  a->Update();
  b->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_NE(observed.WarningMessage().find("200 priorities"), std::string::npos);
  EXPECT_EQ(a->GetOutput()->GetPoint(9)[1], b->GetOutput()->GetPoint(9)[1]);
}

namespace
{
// Add a color, red on one side and blue on the other, a number and a label of the side.
void AddPatterns(vtkPolyData* cloud)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> numbers;
  numbers->SetName("Height");
  vtkNew<vtkIntArray> labels;
  labels->SetName("Side");
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const double* x = cloud->GetPoint(i);
    const bool isRed = x[0] > 5.0;
    colors->InsertNextTuple3(isRed ? 200.0 : 10.0, 50.0, isRed ? 10.0 : 200.0);
    numbers->InsertNextValue(static_cast<float>(1000.0 + x[2]));
    labels->InsertNextValue(isRed ? 7 : -3);
  }
  cloud->GetPointData()->AddArray(colors);
  cloud->GetPointData()->AddArray(numbers);
  cloud->GetPointData()->AddArray(labels);
}

vtkSmartPointer<vtkConformalSOM> MakePatternFilter(vtkPolyData* cloud, bool online)
{
  auto filter = MakeFilter(cloud);
  filter->SetTrainingMode(online ? vtkConformalSOM::ONLINE : vtkConformalSOM::BATCH);
  filter->SetNumberOfEpochs(80);
  filter->SetSamplesPerEpoch(2500);
  filter->AddPatternArray("RGB", 0.3);
  filter->AddPatternArray("Height", 0.3);
  filter->AddPatternArray("Side", 0.3);
  return filter;
}
}

TEST(ConformalSOM, LearnsPatternArraysInBothModes)
{
  auto cloud = MakeCloud(3000);
  AddPatterns(cloud);
  for (const bool online : { false, true })
  {
    auto filter = MakePatternFilter(cloud, online);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
    ExpectMesh(filter);
    vtkPolyData* mesh = filter->GetOutput();
    contract::ExpectArray(
      mesh->GetPointData(), "RGB", VTK_UNSIGNED_CHAR, 3, mesh->GetNumberOfPoints());
    contract::ExpectArray(mesh->GetPointData(), "Height", VTK_FLOAT, 1, mesh->GetNumberOfPoints());
    contract::ExpectArray(mesh->GetPointData(), "Side", VTK_INT, 1, mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* x = mesh->GetPoint(i);
      const double label = mesh->GetPointData()->GetArray("Side")->GetTuple1(i);
      EXPECT_TRUE(label == 7.0 || label == -3.0);
      EXPECT_NEAR(
        mesh->GetPointData()->GetArray("Height")->GetTuple1(i), 1000.0 + x[2], online ? 0.4 : 0.05);
      double color[3];
      mesh->GetPointData()->GetArray("RGB")->GetTuple(i, color);
      EXPECT_EQ(color[1], 50.0);
      if (std::abs(x[0] - 5.0) > (online ? 1.2 : 0.8))
      {
        EXPECT_EQ(label, x[0] > 5.0 ? 7.0 : -3.0);
        EXPECT_NEAR(color[0], x[0] > 5.0 ? 200.0 : 10.0, online ? 60.0 : 12.0);
      }
    }
  }
}

// Edges follow the step of the colors, on both types of meshes; the shape stays.
TEST(ConformalSOM, BatchMeshesFollowStepsOfPatternArrays)
{
  auto cloud = MakeCloud(5000);
  AddPatterns(cloud);
  for (const int type : { vtkConformalSOM::GEODESIC, vtkConformalSOM::ADAPTIVE })
  {
    const auto learned = [&](bool withPatterns)
    {
      auto filter = MakeFilter(cloud);
      filter->SetMeshType(type);
      if (withPatterns)
      {
        filter->AddPatternArray("RGB", 0.2);
      }
      filter->Update();
      ExpectMesh(filter);
      return filter;
    };
    // Mean width of the triangles across the plane x = 5, where the color changes
    const auto width = [](vtkPolyData* mesh)
    {
      double sum = 0.0;
      int count = 0;
      for (vtkIdType r = 0; r < mesh->GetNumberOfCells(); ++r)
      {
        double bounds[6];
        mesh->GetCellBounds(r, bounds);
        if (bounds[0] < 5.0 && bounds[1] > 5.0)
        {
          sum += bounds[1] - bounds[0];
          ++count;
        }
      }
      return sum / count;
    };
    auto plain = learned(false), filter = learned(true);
    EXPECT_LT(width(filter->GetOutput()), 0.75 * width(plain->GetOutput()));
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const double* x = filter->GetOutput()->GetPoint(i);
      const double square = (x[0] - 5.0) * (x[0] - 5.0) / 9.0 + x[1] * x[1] / 4.0 + x[2] * x[2];
      EXPECT_NEAR(square, 1.0, 0.1);
    }
    if (type == vtkConformalSOM::ADAPTIVE)
    {
      EXPECT_LT(Figure(filter, "MeanQuasiConformalError"), 1.2);
    }
    EXPECT_EQ(filter->GetNumberOfPatternArrays(), 1);
    filter->RemoveAllPatternArrays();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("RGB"), nullptr);
    ExpectSamePoints(plain, filter);
  }
}

TEST(ConformalSOM, PatternArraysThatCannotBeUsedAreErrors)
{
  auto cloud = MakeCloud(300);
  AddPatterns(cloud);
  const auto refused = [&](const char* name, double weight, const char* message)
  {
    auto filter = MakeFilter(cloud);
    filter->AddPatternArray("Height", 1.0);
    filter->AddPatternArray(name, weight);
    contract::Observed observed(filter);
    filter->Update();
    observed.ExpectError(message);
    ExpectEmpty(filter);
  };
  refused("missing", 1.0, "no point array \"missing\"");
  refused("RGB", 0.0, "weight of the pattern array \"RGB\"");
  refused("RGB", std::numeric_limits<double>::quiet_NaN(), "weight");
  refused("RGB", 1001.0, "weight");
  refused("Height", 1.0, "twice");
  refused("Supported", 1.0, "cannot have the name \"Supported\"");
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfTuples(300);
  cloud->GetPointData()->AddArray(words);
  refused("words", 1.0, "no point array \"words\" with numbers");
  vtkNew<vtkIntArray> ids;
  ids->SetName("ids");
  for (int i = 0; i < 300; ++i)
  {
    ids->InsertNextValue(i);
  }
  cloud->GetPointData()->AddArray(ids);
  refused("ids", 1.0, "more than 64 different");
}

TEST(ConformalSOM, PointsWithPatternValuesThatAreNotFiniteAreLeftOut)
{
  auto cloud = MakeCloud(1000);
  AddPatterns(cloud);
  vtkNew<vtkPolyData> rest;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto* heights = vtkFloatArray::SafeDownCast(cloud->GetPointData()->GetArray("Height"));
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    if (i % 10 == 3)
    {
      heights->SetValue(i, std::numeric_limits<float>::infinity());
      continue;
    }
    points->InsertNextPoint(cloud->GetPoint(i));
  }
  rest->SetPoints(points);
  AddPatterns(rest);
  for (const bool online : { false, true })
  {
    auto a = MakePatternFilter(cloud, online), b = MakePatternFilter(rest, online);
    contract::Observed observed(a);
    a->Update();
    b->Update();
    EXPECT_FALSE(observed.Error());
    observed.ExpectWarning("100 points have a value that is not finite in a pattern array");
    ExpectSamePoints(a, b);
  }
}

TEST(ConformalSOM, GhostPointsAreSkipped)
{
  auto clean = MakeCloud(1000), cloud = MakeCloud(1000);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(1003);
  ghosts->Fill(0);
  for (vtkIdType i = 1000; i < 1003; ++i)
  {
    cloud->GetPoints()->InsertNextPoint(100.0 * static_cast<double>(i), 0, 0);
    ghosts->SetValue(
      i, i == 1000 ? vtkDataSetAttributes::DUPLICATEPOINT : vtkDataSetAttributes::HIDDENPOINT);
  }
  cloud->GetPointData()->AddArray(ghosts);
  auto a = MakeFilter(clean), b = MakeFilter(cloud);
  a->Update();
  b->Update();
  EXPECT_EQ(a->GetOutput()->GetPoint(100)[0], b->GetOutput()->GetPoint(100)[0]);
}

// Files with a point for each corner of a triangle have each vertex about six times.
TEST(ConformalSOM, CopiesOfPointsChangeNothing)
{
  auto cloud = MakeCloud(2000), copies = MakeCloud(2000);
  vtkPoints* points = copies->GetPoints();
  for (int copy = 1; copy < 6; ++copy)
  {
    for (vtkIdType i = 0; i < 2000; i += copy)
    {
      double x[3];
      points->GetPoint(i, x);
      points->InsertNextPoint(x);
    }
  }
  auto plain = MakeFilter(cloud), copied = MakeFilter(copies);
  contract::Observed observed(copied);
  plain->Update();
  copied->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning()) << observed.WarningMessage();
  ExpectSamePoints(plain, copied);
}

TEST(ConformalSOM, OtherDataIsRefusedByThePort)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkConformalSOM> filter;
  filter->SetInputDataObject(image);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_TRUE(observed.ExecutiveError());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ConformalSOM, BadParametersAreErrors)
{
  auto cloud = MakeCloud(100);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const std::function<void(vtkConformalSOM*)>& change)
  {
    auto filter = MakeFilter(cloud);
    change(filter);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_TRUE(observed.Error());
    ExpectEmpty(filter);
  };
  for (const double bad : { 0.0, nan })
  {
    refused([=](auto* f) { f->SetOnlineConstants(bad, 20.0, 0.01, 60.0); });
    refused([=](auto* f) { f->SetOnlineConstants(0.4, bad, 0.01, 60.0); });
    refused([=](auto* f) { f->SetOnlineConstants(0.4, 20.0, 0.01, bad); });
  }
  refused([](auto* f) { f->SetOnlineConstants(0.4, 20.0, 1.0, 60.0); });
  refused([=](auto* f) { f->SetOnlineConstants(0.4, 20.0, nan, 60.0); });
  refused([&](auto* f) { f->SetSmoothness(nan); });
  refused([](auto* f) { f->SetSmoothness(-1.0); });
  const auto geodesic = [](int shape)
  {
    return [=](vtkConformalSOM* f)
    {
      f->SetMeshTypeToGeodesic();
      f->SetStartingShape(shape);
    };
  };
  refused(geodesic(vtkConformalSOM::HULL));
  refused(geodesic(vtkConformalSOM::MESH));

  vtkNew<vtkConformalSOM> filter;
  filter->SetNumberOfNeurons(-1);
  EXPECT_EQ(filter->GetNumberOfNeurons(), 0);
  filter->SetNumberOfNeurons(VTK_INT_MAX);
  EXPECT_EQ(filter->GetNumberOfNeurons(), 10000002);
  filter->SetNumberOfEpochs(-3);
  EXPECT_EQ(filter->GetNumberOfEpochs(), 0);
}

TEST(ConformalSOM, AbortLeavesNothingAndSaysNothing)
{
  auto cloud = MakeCloud(3000);
  for (int mode : { vtkConformalSOM::ONLINE, vtkConformalSOM::BATCH })
  {
    auto filter = MakeFilter(cloud);
    filter->SetTrainingMode(mode);
    vtkNew<vtkCallbackCommand> stop;
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*)
      {
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        algorithm->SetAbortExecute(algorithm->GetProgress() > 0.3);
      });
    filter->AddObserver(vtkCommand::ProgressEvent, stop);
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error() || observed.Warning());
    ExpectEmpty(filter);
  }
}

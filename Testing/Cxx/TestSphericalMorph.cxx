#include "vtkSphericalMorph.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkGenusZeroCheck.h"
#include "vtkSphericalTextureMap.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using fixtures::Ellipsoid;

namespace
{
/// The ellipsoid of another mesh, turned, moved and bent.
vtkNew<vtkPolyData> Other(int frequency, double angle, double bend = 0.0)
{
  auto surface = Ellipsoid(frequency);
  vtkNew<vtkTransform> turn;
  turn->Translate(1.0, 2.0, 3.0);
  turn->RotateWXYZ(angle, 1.0, -2.0, 0.5);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    p[2] += bend * (p[0] - 10.0) * (p[0] - 10.0);
    turn->TransformPoint(p, p);
    surface->GetPoints()->SetPoint(i, p);
  }
  return surface;
}

void AddArray(vtkPolyData* surface, vtkDataArray* array, const char* name, int components,
  const std::vector<double>& values)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  for (int c = 0; c < components; ++c)
  {
    array->FillComponent(c, values[c]);
  }
  surface->GetPointData()->AddArray(array);
}

double LargestDistance(vtkPolyData* a, vtkPolyData* b)
{
  EXPECT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  double largest = a->GetNumberOfPoints() == b->GetNumberOfPoints() ? 0.0 : HUGE_VAL;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints() && largest < HUGE_VAL; ++i)
  {
    double p[3], q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
  }
  return largest;
}

class SphericalMorph : public testing::Test
{
protected:
  SphericalMorph()
  {
    this->Filter->SetInputData(this->Source);
    this->Filter->SetTargetData(this->Target);
    this->Filter->SetNumberOfPoints(1500);
  }

  /// A copy, since the next run makes another one.
  vtkSmartPointer<vtkPolyData> Run()
  {
    this->Seen.Clear();
    this->Filter->Modified();
    this->Filter->Update();
    const auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(this->Filter->GetOutput());
    return copy;
  }

  vtkSmartPointer<vtkPolyData> At(double factor)
  {
    this->Filter->SetMorphFactor(factor);
    auto output = this->Run();
    EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning())
      << this->Seen.ErrorMessage() << this->Seen.WarningMessage();
    return output;
  }

  void ExpectRefused(const std::string& why)
  {
    const auto output = this->Run();
    this->Seen.ExpectError(why);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
  }

  vtkNew<vtkPolyData> Source = Ellipsoid(12), Target = Other(9, 70.0, 0.1);
  vtkNew<vtkSphericalMorph> Filter;
  contract::Observed Seen{ this->Filter };
};

/// Where the ray of a direction meets the triangle whose corners lie at a, b, c on the sphere:
/// their shares, of which the least tells how far inside.
double SharesAt(const double direction[3], const double a[3], const double b[3], const double c[3],
  double shares[3])
{
  shares[0] = vtkMath::Determinant3x3(direction, b, c);
  shares[1] = vtkMath::Determinant3x3(a, direction, c);
  shares[2] = vtkMath::Determinant3x3(a, b, direction);
  const double sum = shares[0] + shares[1] + shares[2];
  if (sum <= 0.0)
  {
    return -1.0; // behind
  }
  for (int k = 0; k < 3; ++k)
  {
    shares[k] /= sum;
  }
  return std::min({ shares[0], shares[1], shares[2] });
}

/// The surface in the directions of a mesh, by a look at all of its triangles.
vtkSmartPointer<vtkPolyData> Sampled(vtkPolyData* surface, vtkPolyData* directions)
{
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(directions);
  vtkDataArray* map = surface->GetPointData()->GetArray("SpherePosition");
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    double direction[3], best = -1.0;
    directions->GetPointData()->GetArray("SpherePosition")->GetTuple(i, direction);
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      surface->GetPolys()->GetCellAtId(cell, ids);
      double corners[3][3], shares[3], position[3] = { 0.0, 0.0, 0.0 };
      for (int k = 0; k < 3; ++k)
      {
        map->GetTuple(ids->GetId(k), corners[k]);
      }
      const double inside = SharesAt(direction, corners[0], corners[1], corners[2], shares);
      if (inside > best)
      {
        best = inside;
        for (int k = 0; k < 3; ++k)
        {
          double corner[3];
          surface->GetPoint(ids->GetId(k), corner);
          for (int c = 0; c < 3; ++c)
          {
            position[c] += shares[k] * corner[c];
          }
        }
        result->GetPoints()->SetPoint(i, position);
      }
    }
  }
  return result;
}
}

TEST_F(SphericalMorph, WritesTheContractsArrays)
{
  vtkNew<vtkSphericalMorph> fresh;
  EXPECT_EQ(fresh->GetMorphFactor(), 0.5);
  EXPECT_EQ(fresh->GetPath(), vtkSphericalMorph::LINEAR);
  EXPECT_FALSE(fresh->GetGenerateTimeSteps());
  const auto output = this->At(0.25);
  contract::ExpectSpherePosition(output);
  contract::ExpectArray(output->GetFieldData(), "MorphWeights", VTK_DOUBLE, 1, 2);
  EXPECT_EQ(output->GetFieldData()->GetArray("MorphWeights")->GetTuple1(0), 0.75);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NEAR(output->GetNumberOfPoints(), 1500, 30);
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputData(output);
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsGenusZero")->GetTuple1(0), 1.0);
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsInsideOut")->GetTuple1(0), 0.0);
  this->Filter->SetMeshTypeToGeodesic();
  this->Filter->SetFrequency(7);
  EXPECT_EQ(this->Run()->GetNumberOfPoints(), 492);
}

TEST_F(SphericalMorph, AtTheEndsItIsEitherSurface)
{
  for (const int path : { vtkSphericalMorph::LINEAR, vtkSphericalMorph::RIGID })
  {
    this->Filter->SetPath(path);
    const auto start = this->At(0.0), end = this->At(1.0);
    EXPECT_LT(LargestDistance(start, Sampled(this->Source, start)), 1e-12);
    EXPECT_LT(LargestDistance(end, Sampled(this->Target, end)), 1e-12);
  }
}

TEST_F(SphericalMorph, SwappedInputsMirror)
{
  this->Filter->SetMeshTypeToGeodesic();
  this->Filter->SetFrequency(12);
  for (const int path : { vtkSphericalMorph::LINEAR, vtkSphericalMorph::RIGID })
  {
    this->Filter->SetPath(path);
    this->Filter->SetInputData(this->Source);
    this->Filter->SetTargetData(this->Target);
    const auto there = this->At(0.3);
    this->Filter->SetInputData(this->Target);
    this->Filter->SetTargetData(this->Source);
    EXPECT_LT(LargestDistance(there, this->At(0.7)), 1e-10);
  }
}

TEST_F(SphericalMorph, ATurnedCopyStaysRigid)
{
  this->Filter->SetTargetData(Other(12, 130.0));
  this->Filter->SetPathToRigid();
  const auto start = this->At(0.0), half = this->At(0.5);
  const auto edge = [](vtkPolyData* surface, vtkIdType cell)
  {
    vtkNew<vtkIdList> ids;
    surface->GetPolys()->GetCellAtId(cell, ids);
    double p[3], q[3];
    surface->GetPoint(ids->GetId(0), p);
    surface->GetPoint(ids->GetId(1), q);
    return std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
  };
  // The whole surface turns, so that straight lines in its frame keep the edges, too.
  this->Filter->SetPathToLinear();
  const auto linear = this->At(0.5);
  for (vtkIdType i = 0; i < start->GetNumberOfPolys(); ++i)
  {
    ASSERT_NEAR(edge(half, i) / edge(start, i), 1.0, 1e-6);
    ASSERT_NEAR(edge(linear, i) / edge(start, i), 1.0, 1e-6);
  }
}

TEST_F(SphericalMorph, ArraysOfAllSurfacesAreBlended)
{
  AddArray(this->Source, vtkNew<vtkDoubleArray>(), "Numbers", 1, { 10.0 });
  AddArray(this->Target, vtkNew<vtkDoubleArray>(), "Numbers", 1, { 20.0 });
  AddArray(this->Source, vtkNew<vtkIntArray>(), "Labels", 1, { 10.0 });
  AddArray(this->Target, vtkNew<vtkIntArray>(), "Labels", 1, { 20.0 });
  AddArray(this->Source, vtkNew<vtkUnsignedCharArray>(), "Colors", 3, { 255.0, 0.0, 100.0 });
  AddArray(this->Target, vtkNew<vtkUnsignedCharArray>(), "Colors", 3, { 0.0, 0.0, 201.0 });
  AddArray(this->Source, vtkNew<vtkDoubleArray>(), "Own", 1, { 1.0 });
  this->Source->GetPointData()->SetActiveScalars("Colors");
  vtkPointData* data = nullptr;
  const auto expect = [&](const char* name, const std::vector<double>& values)
  {
    vtkDataArray* array = data->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    for (std::size_t c = 0; c < values.size(); ++c)
    {
      const int component = static_cast<int>(c);
      EXPECT_NEAR(array->GetComponent(3, component), values[c], 1e-12) << name;
      EXPECT_NEAR(array->GetComponent(900, component), values[c], 1e-12) << name;
    }
  };
  const auto output = this->At(0.25);
  data = output->GetPointData();
  expect("Numbers", { 12.5 });
  expect("Labels", { 10.0 });
  expect("Colors", { 191.0, 0.0, 125.0 });
  EXPECT_EQ(data->GetScalars(), data->GetArray("Colors"));
  EXPECT_EQ(data->GetArray("Own"), nullptr);
  EXPECT_EQ(data->GetNormals(), nullptr);
  const auto later = this->At(0.75);
  data = later->GetPointData();
  expect("Numbers", { 17.5 });
  expect("Labels", { 20.0 });
  // Arrays that do not fit are left out, with a warning that names them.
  AddArray(this->Target, vtkNew<vtkDoubleArray>(), "Numbers", 2, { 20.0, 1.0 });
  const auto without = this->Run();
  this->Seen.ExpectWarning("the point arrays \"Numbers\" were left out");
  EXPECT_EQ(without->GetPointData()->GetArray("Numbers"), nullptr);
  EXPECT_NE(without->GetPointData()->GetArray("Labels"), nullptr);
}

TEST_F(SphericalMorph, BlocksAreSurfacesInTheirOrder)
{
  vtkNew<vtkMultiBlockDataSet> blocks, inner;
  const auto third = Other(10, -40.0, 0.2);
  inner->SetBlock(0, this->Target);
  inner->SetBlock(2, third);
  blocks->SetBlock(0, this->Source);
  blocks->SetBlock(1, inner);
  this->Filter->SetInputDataObject(0, blocks);
  this->Filter->SetInputDataObject(1, nullptr);
  const auto middle = this->At(0.5);
  EXPECT_LT(LargestDistance(middle, Sampled(this->Target, middle)), 1e-12);
  const auto last = this->At(1.0);
  EXPECT_LT(LargestDistance(last, Sampled(third, last)), 1e-12);
  contract::ExpectArray(last->GetFieldData(), "MorphWeights", VTK_DOUBLE, 1, 3);
  // Weights instead of a factor, of any sum.
  for (const double weight : { 2.0, 6.0, 0.0 })
  {
    this->Filter->AddWeight(weight);
  }
  EXPECT_EQ(this->Filter->GetNumberOfWeights(), 3);
  const auto mean = this->Run();
  EXPECT_NEAR(mean->GetFieldData()->GetArray("MorphWeights")->GetTuple1(0), 0.25, 1e-15);
  this->Filter->RemoveAllWeights();
  EXPECT_LT(LargestDistance(mean, this->At(0.375)), 1e-12);
  // A target beside blocks comes last.
  this->Filter->SetTargetData(this->Source);
  const auto back = this->At(1.0);
  EXPECT_LT(LargestDistance(back, Sampled(this->Source, back)), 1e-12);
}

TEST_F(SphericalMorph, IsASourceOfTimeSteps)
{
  const auto quarter = this->At(0.25);
  this->Filter->SetMorphFactor(0.9);
  this->Filter->UpdateInformation();
  vtkInformation* info = this->Filter->GetOutputInformation(0);
  using Executive = vtkStreamingDemandDrivenPipeline;
  EXPECT_FALSE(info->Has(Executive::TIME_STEPS()));
  this->Filter->GenerateTimeStepsOn();
  this->Filter->SetNumberOfTimeSteps(5);
  this->Filter->UpdateInformation();
  ASSERT_EQ(info->Length(Executive::TIME_STEPS()), 5);
  EXPECT_EQ(info->Get(Executive::TIME_STEPS())[1], 0.25);
  EXPECT_EQ(info->Get(Executive::TIME_RANGE())[1], 1.0);
  this->Filter->UpdateTimeStep(0.25);
  EXPECT_EQ(LargestDistance(this->Filter->GetOutput(), quarter), 0.0);
  EXPECT_EQ(
    this->Filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 0.25);
  const vtkMTimeType time = this->Filter->GetOutput()->GetMTime();
  this->Filter->UpdateTimeStep(0.25);
  EXPECT_EQ(this->Filter->GetOutput()->GetMTime(), time);
  this->Filter->UpdateTimeStep(1.0);
  EXPECT_LT(
    LargestDistance(this->Filter->GetOutput(), Sampled(this->Target, this->Filter->GetOutput())),
    1e-12);
  this->Filter->UpdateTimeStep(7.0); // the last there is
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetArray("MorphWeights")->GetTuple1(1), 1.0);
}

// What was kept of a run is not taken for other surfaces.
TEST_F(SphericalMorph, ChangedInputsAreNoticed)
{
  const auto before = this->At(0.0);
  for (vtkIdType i = 0; i < this->Source->GetNumberOfPoints(); ++i)
  {
    double p[3];
    this->Source->GetPoint(i, p);
    this->Source->GetPoints()->SetPoint(i, p[0] + 1.0, p[1], p[2]);
  }
  this->Source->GetPoints()->Modified();
  const auto after = this->At(0.0);
  EXPECT_NEAR(LargestDistance(before, after), 1.0, 1e-12);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, this->Source);
  blocks->SetBlock(1, this->Target);
  this->Filter->SetInputDataObject(0, blocks);
  this->Filter->SetInputDataObject(1, nullptr);
  EXPECT_EQ(LargestDistance(this->At(0.0), after), 0.0);
  this->Source->GetPoints()->SetPoint(0, 10.0, 0.0, 5.0);
  this->Source->GetPoints()->Modified();
  EXPECT_GT(LargestDistance(this->At(0.0), after), 0.1);
  this->Filter->SetNumberOfPoints(2000);
  EXPECT_NEAR(this->At(0.0)->GetNumberOfPoints(), 2000, 40);
}

TEST_F(SphericalMorph, TexturesGoThroughIt)
{
  vtkNew<vtkSphericalTextureMap> map;
  this->Filter->SetPathToRigid();
  map->SetInputConnection(this->Filter->GetOutputPort());
  map->Update();
  contract::ExpectArray(map->GetOutput()->GetPointData(), "Texture Coordinates", -1, 2,
    this->Filter->GetOutput()->GetNumberOfPoints());
}

TEST_F(SphericalMorph, ThreadsChangeNoBit)
{
  for (const int path : { vtkSphericalMorph::LINEAR, vtkSphericalMorph::RIGID })
  {
    this->Filter->SetPath(path);
    vtkSMPTools::Initialize(1);
    this->Target->Modified();
    const auto alone = this->At(0.4);
    vtkSMPTools::Initialize(2);
    this->Target->Modified(); // else the mesh would be the one of before
    EXPECT_EQ(LargestDistance(alone, this->At(0.4)), 0.0);
  }
  vtkSMPTools::Initialize();
}

TEST_F(SphericalMorph, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetMorphFactor(0.1); });
  contract::ExpectRunsOnlyWhenModified(this->Filter,
    [&]()
    {
      this->Filter->AddWeight(1.0);
      this->Filter->AddWeight(2.0);
    });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->RemoveAllWeights(); });
  for (const char* property : { "MorphFactor", "NumberOfWeights", "Path", "MeshType", "Frequency",
         "NumberOfPoints", "GenerateTimeSteps", "NumberOfTimeSteps" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
  this->Filter->SetMorphFactor(7.0);
  EXPECT_EQ(this->Filter->GetMorphFactor(), 1.0);
  this->Filter->SetPath(7);
  EXPECT_EQ(this->Filter->GetPath(), vtkSphericalMorph::RIGID);
}

TEST_F(SphericalMorph, StopsWhenAsked)
{
  this->Filter->SetPathToRigid();
  contract::ExpectStopsWhenAsked(this->Filter);
}

TEST_F(SphericalMorph, LeavesItsInputsAlone)
{
  AddArray(this->Source, vtkNew<vtkDoubleArray>(), "Numbers", 1, { 10.0 });
  const vtkMTimeType source = this->Source->GetMTime(), target = this->Target->GetMTime();
  this->At(0.5);
  EXPECT_EQ(this->Source->GetMTime(), source);
  EXPECT_EQ(this->Target->GetMTime(), target);
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(SphericalMorph, EmptyInputsGiveAWarningAndNothing)
{
  this->Filter->SetTargetData(vtkNew<vtkPolyData>());
  EXPECT_EQ(this->Run()->GetNumberOfPoints(), 0);
  this->Seen.ExpectWarning("a surface is empty; the output is empty");
  this->Filter->SetInputDataObject(0, vtkNew<vtkMultiBlockDataSet>());
  this->Filter->SetInputDataObject(1, nullptr);
  EXPECT_EQ(this->Run()->GetNumberOfPoints(), 0);
  this->Seen.ExpectWarning("a surface is empty; the output is empty");
}

TEST_F(SphericalMorph, OneSurfaceIsTooFew)
{
  this->Filter->SetInputDataObject(1, nullptr);
  this->ExpectRefused("two surfaces or more are needed");
}

TEST_F(SphericalMorph, BadSurfacesAreRefusedByTheirNumber)
{
  this->Target->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused("surface 1: the surface has no point array SpherePosition");
  this->Source->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->Source->GetPoints()->Modified();
  this->ExpectRefused("surface 0: some points of the surface are not finite");
  this->Source->SetPolys(vtkNew<vtkCellArray>());
  this->ExpectRefused("surface 0: the surface has no triangles");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkImageData>());
  this->Filter->SetInputDataObject(0, blocks);
  this->ExpectRefused("a block is a vtkImageData instead of a vtkPolyData");
}

TEST_F(SphericalMorph, BlocksOfBrokenArraysAreRefused)
{
  this->Target->GetPointData()->GetArray("SpherePosition")->SetNumberOfTuples(3);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, this->Source);
  blocks->SetBlock(1, this->Target);
  this->Filter->SetInputDataObject(0, blocks);
  this->ExpectRefused("input port 0, block 1: the point array \"SpherePosition\" has 3 tuples");
}

TEST_F(SphericalMorph, MapsThatMirrorOrFoldAreRefused)
{
  vtkDataArray* map = this->Target->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
  {
    const double* n = map->GetTuple3(i);
    map->SetTuple3(i, -n[0], n[1], n[2]);
  }
  map->Modified();
  this->ExpectRefused("the map to the sphere of surface 1 mirrors it, unlike that of surface 0");
  for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
  {
    const double* n = map->GetTuple3(i);
    map->SetTuple3(i, std::abs(n[0]), n[1], n[2]);
  }
  map->Modified();
  this->ExpectRefused("must cover it once without folds");
}

TEST_F(SphericalMorph, BadWeightsAreRefused)
{
  this->Filter->AddWeight(1.0);
  this->ExpectRefused("there are 1 weights for 2 surfaces");
  this->Filter->AddWeight(-1.0);
  this->ExpectRefused("weights must be finite and at least 0, and not all of them 0");
  this->Filter->RemoveAllWeights();
  this->Filter->AddWeight(0.0);
  this->Filter->AddWeight(0.0);
  this->ExpectRefused("weights must be finite and at least 0, and not all of them 0");
  this->Filter->RemoveAllWeights();
  this->Filter->AddWeight(HUGE_VAL);
  this->Filter->AddWeight(1.0);
  this->ExpectRefused("weights must be finite and at least 0, and not all of them 0");
}

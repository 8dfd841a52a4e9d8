#include "vtkAdaptiveSphere.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGenusZeroCheck.h"
#include "vtkSphericalTextureMap.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

using fixtures::Ellipsoid;

namespace
{
/// Share of the points where a test is true.
double Share(vtkPolyData* sphere, const std::function<bool(const double*)>& test)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sphere->GetPoint(i, p);
    count += test(p);
  }
  return static_cast<double>(count) / static_cast<double>(sphere->GetNumberOfPoints());
}

double MinimumAngle(vtkPolyData* mesh)
{
  double smallest = 180.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    for (int k = 0; k < 3; ++k)
    {
      double o[3], u[3], v[3];
      mesh->GetPoint(ids->GetId(k), o);
      mesh->GetPoint(ids->GetId((k + 1) % 3), u);
      mesh->GetPoint(ids->GetId((k + 2) % 3), v);
      vtkMath::Subtract(u, o, u);
      vtkMath::Subtract(v, o, v);
      smallest =
        std::min(smallest, vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(u, v)));
    }
  }
  return smallest;
}

/// A point array: 9 where x of the sphere is above 0, else 1.
vtkNew<vtkDoubleArray> Ninefold(vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Interest");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* n = surface->GetPointData()->GetArray("SpherePosition")->GetTuple3(i);
    array->InsertNextValue(n[0] > 0.0 ? 9.0 : 1.0);
  }
  return array;
}

/// Gray, with a checkerboard in the right half.
vtkNew<vtkImageData> HalfACheckerboard()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(128, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 128; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        image->SetScalarComponentFromDouble(i, j, 0, c,
          i < 64                  ? 128.0
            : (i / 4 + j / 4) % 2 ? 255.0
                                  : 0.0);
      }
    }
  }
  return image;
}

class AdaptiveSphere : public testing::Test
{
protected:
  AdaptiveSphere() { this->Filter->SetNumberOfPoints(3000); }

  vtkPolyData* Run(vtkPolyData* surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  void ExpectRefused(vtkPolyData* surface, const std::string& why)
  {
    this->Seen.Clear();
    surface->Modified();
    vtkPolyData* output = this->Run(surface);
    this->Seen.ExpectError(why);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetNumberOfCells(), 0);
  }

  /// A sphere as the contract has it, without a word.
  vtkPolyData* ExpectDone(vtkPolyData* surface)
  {
    this->Seen.Clear();
    vtkPolyData* output = this->Run(surface);
    EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning());
    EXPECT_NEAR(output->GetNumberOfPoints(), 3000, 60);
    EXPECT_EQ(output->GetNumberOfPolys(), 2 * output->GetNumberOfPoints() - 4);
    EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
    contract::ExpectSpherePosition(output);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_EQ(output->GetPoint(i)[c],
          output->GetPointData()->GetArray("SpherePosition")->GetComponent(i, c));
      }
    }
    vtkNew<vtkGenusZeroCheck> check;
    check->SetInputData(output);
    check->Update();
    EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsGenusZero")->GetTuple1(0), 1.0);
    EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsInsideOut")->GetTuple1(0), 0.0);
    EXPECT_GE(MinimumAngle(output), 28.0 - 1e-6);
    return output;
  }

  vtkNew<vtkAdaptiveSphere> Filter;
  contract::Observed Seen{ this->Filter };
};
}

TEST_F(AdaptiveSphere, IsASphereWithTheContractsArrays)
{
  vtkNew<vtkAdaptiveSphere> fresh;
  EXPECT_EQ(fresh->GetNumberOfPoints(), 64002);
  EXPECT_EQ(fresh->GetDensity(), vtkAdaptiveSphere::AREA);
  EXPECT_EQ(fresh->GetDensityArrayName(), "");
  vtkPolyData* output = this->ExpectDone(Ellipsoid(10));
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(output->GetCellData()->GetNumberOfArrays(), 0);
}

// The ellipsoid is 3 times as long as it is thick: on the sphere its ends are small.
TEST_F(AdaptiveSphere, AreaIsEvenOverTheSurface)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(20);
  vtkPolyData* sphere = this->ExpectDone(surface);
  vtkNew<vtkCurvedSeamlessSurface> curved;
  curved->SetInputData(surface);
  curved->SetVertexShift(0.0);
  curved->SetSphereData(sphere);
  curved->Update();
  vtkPolyData* even = curved->GetOutput();
  ASSERT_EQ(even->GetNumberOfPoints(), sphere->GetNumberOfPoints());
  double logarithms = 0.0, squares = 0.0;
  for (vtkIdType i = 0; i < even->GetNumberOfPolys(); ++i)
  {
    vtkNew<vtkIdList> ids;
    even->GetPolys()->GetCellAtId(i, ids);
    double a[3], b[3], c[3], n[3];
    even->GetPoint(ids->GetId(0), a);
    even->GetPoint(ids->GetId(1), b);
    even->GetPoint(ids->GetId(2), c);
    vtkMath::Subtract(b, a, b);
    vtkMath::Subtract(c, a, c);
    vtkMath::Cross(b, c, n);
    const double logarithm = std::log(vtkMath::Norm(n));
    logarithms += logarithm;
    squares += logarithm * logarithm;
  }
  const auto size = static_cast<double>(even->GetNumberOfPolys());
  EXPECT_LT(std::sqrt(squares / size - std::pow(logarithms / size, 2)), 0.3);
}

TEST_F(AdaptiveSphere, CurvatureIsDenserWhereTheSurfaceBends)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(20);
  const auto atTheRim = [](const double* p) { return std::abs(p[2]) < 0.3; };
  const double even = Share(this->ExpectDone(surface), atTheRim);
  this->Filter->SetDensityToCurvature();
  EXPECT_GT(Share(this->ExpectDone(surface), atTheRim), 1.2 * even);
}

TEST_F(AdaptiveSphere, ArraysOfPointsAndCellsSayTheSame)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(20);
  const auto isInFront = [](const double* p) { return p[0] > 0.0; };
  surface->GetPointData()->AddArray(Ninefold(surface));
  this->Filter->SetDensityToArray();
  this->Filter->SetDensityArrayName("Interest");
  EXPECT_NEAR(Share(this->ExpectDone(surface), isInFront), 0.9, 0.03);

  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("Cells");
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, ids);
    ofCells->InsertNextValue(
      surface->GetPointData()->GetArray("Interest")->GetTuple1(ids->GetId(0)));
  }
  surface->GetCellData()->AddArray(ofCells);
  this->Filter->SetDensityArrayName("Cells");
  EXPECT_NEAR(Share(this->ExpectDone(surface), isInFront), 0.9, 0.03);
}

TEST_F(AdaptiveSphere, UnitsOfTheArrayDoNotCount)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(10);
  surface->GetPointData()->AddArray(Ninefold(surface));
  this->Filter->SetDensityToArray();
  this->Filter->SetDensityArrayName("Interest");
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->ExpectDone(surface));
  vtkDataArray* array = surface->GetPointData()->GetArray("Interest");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetTuple1(i, array->GetTuple1(i) * 0x1p1000);
  }
  surface->Modified();
  vtkPolyData* output = this->ExpectDone(surface);
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    output->GetPoint(i, p);
    expected->GetPoint(i, q);
    ASSERT_EQ(vtkMath::Distance2BetweenPoints(p, q), 0.0);
  }
}

TEST_F(AdaptiveSphere, ImagesAreFollowedWhereTheyChange)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(10);
  const vtkNew<vtkImageData> image = HalfACheckerboard();
  const auto isRight = [](const double* p) { return p[0] > 0.1; };
  const double even = Share(this->ExpectDone(surface), isRight);
  this->Filter->SetDensityToImage();
  this->Filter->SetImageData(image);
  // Longitude and latitude about (0, 0, 1): the right half of the image is the one of x > 0.
  EXPECT_NEAR(Share(this->ExpectDone(surface), isRight), 0.5 * even + 0.5, 0.1);
  // As a texture map has laid it: turned by half a turn, it is the other half.
  vtkNew<vtkSphericalTextureMap> map;
  map->SetInputData(surface);
  map->SetProjectionToLongitudeLatitude();
  map->SetRotation(180.0);
  map->Update();
  const double* right = map->GetOutput()->GetFieldData()->GetArray("SphereRight")->GetTuple3(0);
  const double axis[3] = { right[0], right[1], right[2] };
  const auto isToTheRight = [&](const double* p) { return vtkMath::Dot(p, axis) > 0.1; };
  EXPECT_GT(Share(this->ExpectDone(map->GetOutput()), isToTheRight), 0.6);
  // A picture of one color has nothing to follow.
  image->GetPointData()->GetScalars()->Fill(7.0);
  image->Modified();
  EXPECT_NEAR(Share(this->ExpectDone(surface), isRight), even, 0.02);
}

TEST_F(AdaptiveSphere, ThreadsChangeNoBit)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(20);
  for (const int density : { vtkAdaptiveSphere::AREA, vtkAdaptiveSphere::CURVATURE })
  {
    this->Filter->SetDensity(density);
    vtkSMPTools::Initialize(1);
    vtkNew<vtkPolyData> alone;
    alone->DeepCopy(this->Run(surface));
    vtkSMPTools::Initialize(2);
    this->Filter->Modified();
    vtkPolyData* both = this->Run(surface);
    ASSERT_EQ(both->GetNumberOfPoints(), alone->GetNumberOfPoints());
    for (vtkIdType i = 0; i < both->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      both->GetPoint(i, p);
      alone->GetPoint(i, q);
      ASSERT_EQ(vtkMath::Distance2BetweenPoints(p, q), 0.0);
    }
  }
  vtkSMPTools::Initialize();
}

TEST_F(AdaptiveSphere, RunsOnlyWhenModifiedAndPrints)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  this->Filter->SetInputData(surface);
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetNumberOfPoints(600); });
  for (const char* property : { "Density", "DensityArrayName", "NumberOfPoints" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
  EXPECT_EQ(surface->GetNumberOfPoints(), 162);
  EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 2); // and normals, as before
  this->Filter->SetNumberOfPoints(1);
  EXPECT_EQ(this->Filter->GetNumberOfPoints(), 500);
}

TEST_F(AdaptiveSphere, StopsWhenAsked)
{
  this->Filter->SetInputData(Ellipsoid(30));
  contract::ExpectStopsWhenAsked(this->Filter);
}

TEST_F(AdaptiveSphere, OfNothingIsNothing)
{
  this->Run(vtkNew<vtkPolyData>());
  this->Seen.ExpectWarning("the surface is empty; the output is empty");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(AdaptiveSphere, BadSurfacesAreRefused)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  surface->GetPoints()->SetPoint(8, 1.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  this->ExpectRefused(surface, "some points of the surface are not finite");
  const vtkNew<vtkPolyData> unmapped = Ellipsoid();
  unmapped->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused(unmapped, "SpherePosition");
  const vtkNew<vtkPolyData> points = Ellipsoid();
  points->SetPolys(vtkNew<vtkCellArray>());
  this->ExpectRefused(points, "the surface has no triangles");
  const vtkNew<vtkPolyData> bowl = Ellipsoid();
  vtkDataArray* map = bowl->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < bowl->GetNumberOfPoints(); ++i)
  {
    const double* n = map->GetTuple3(i);
    map->SetTuple3(i, n[0], n[1], std::abs(n[2]));
  }
  this->ExpectRefused(bowl, "must cover it once without folds");
}

TEST_F(AdaptiveSphere, BadDensitiesAreRefused)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  this->Filter->SetDensityToArray();
  this->ExpectRefused(surface, "the surface has no point or cell array \"\"");
  this->Filter->SetDensityArrayName("SpherePosition");
  this->ExpectRefused(surface, "\"SpherePosition\" has 3 components instead of 1");
  this->Filter->SetDensityArrayName("Interest");
  const vtkNew<vtkDoubleArray> array = Ninefold(surface);
  surface->GetPointData()->AddArray(array);
  array->SetValue(17, -1.0);
  this->ExpectRefused(surface, "\"Interest\" is negative or not finite at 17");
  array->SetValue(17, std::numeric_limits<double>::infinity());
  this->ExpectRefused(surface, "\"Interest\" is negative or not finite at 17");
  array->Fill(0.0);
  this->ExpectRefused(surface, "a density must be above 0 somewhere");
  this->Filter->SetDensityToImage();
  this->ExpectRefused(surface, "needs an image of one slice with point scalars on input port 1");
  this->Filter->SetImageData(vtkNew<vtkImageData>());
  this->ExpectRefused(surface, "needs an image of one slice with point scalars on input port 1");
}

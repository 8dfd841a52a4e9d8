// Make point clouds, divide them among ranks (processes), and compare the results of the ranks with
// those of one process.
#ifndef Clouds_h
#define Clouds_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkConformalSOM.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace clouds
{
inline vtkMultiProcessController* Controller()
{
  return vtkMultiProcessController::GetGlobalController();
}

inline int Rank()
{
  return Controller()->GetLocalProcessId();
}

inline int NumberOfRanks()
{
  return Controller()->GetNumberOfProcesses();
}

/// Return a cloud with `size` points. The function `place` computes each point from two random
/// numbers in [0, 1).
inline vtkSmartPointer<vtkPolyData> Make(
  vtkIdType size, const std::function<void(double, double, double*)>& place)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double u = random->GetNextRangeValue(0.0, 1.0), v = random->GetNextRangeValue(0.0, 1.0);
    double x[3];
    place(u, v, x);
    points->InsertNextPoint(x);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  return cloud;
}

inline vtkSmartPointer<vtkPolyData> Ellipsoid(vtkIdType size)
{
  return Make(size,
    [](double u, double v, double* x)
    {
      const double z = 2.0 * u - 1.0, angle = 2.0 * std::acos(-1.0) * v;
      x[0] = 5.0 + 3.0 * std::sqrt(1.0 - z * z) * std::cos(angle);
      x[1] = 2.0 * std::sqrt(1.0 - z * z) * std::sin(angle);
      x[2] = z;
    });
}

/// Return points on a bent tube with round ends. A mesh that is learned from a sphere spans a
/// spurious membrane between the ends.
inline vtkSmartPointer<vtkPolyData> Horseshoe(vtkIdType size)
{
  constexpr double tube = 0.3;
  const double pi = std::acos(-1.0), arc = 5.0 / 3.0 * pi;
  return Make(size,
    [&](double u, double v, double* x)
    {
      const double along = (arc + 4.0 * tube) * u - 2.0 * tube;
      const double end = std::clamp(along, 0.0, arc);
      const double cap = std::clamp((along - end) / (2.0 * tube), -1.0, 1.0);
      const double radius = tube * std::sqrt(1.0 - cap * cap), around = 2.0 * pi * v;
      const double out = 1.0 + radius * std::cos(around);
      x[0] = out * std::cos(end) - tube * cap * std::sin(end);
      x[1] = out * std::sin(end) + tube * cap * std::cos(end);
      x[2] = radius * std::sin(around);
    });
}

/// Return the points of a cloud with z < 0.5.
inline vtkSmartPointer<vtkPolyData> WithoutTop(vtkPolyData* cloud)
{
  constexpr double top = 0.5;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    if (cloud->GetPoint(i)[2] < top)
    {
      points->InsertNextPoint(cloud->GetPoint(i));
    }
  }
  auto seen = vtkSmartPointer<vtkPolyData>::New();
  seen->SetPoints(points);
  return seen;
}

inline void AddPriorities(vtkPolyData* cloud)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Priority");
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(1.0 + std::abs(cloud->GetPoint(i)[2]));
  }
  cloud->GetPointData()->AddArray(array);
}

/// Add colors of three bytes as active scalars, and an array "Height" of numbers, to the points of
/// a cloud.
inline void AddColors(vtkPolyData* cloud)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double x[3];
    cloud->GetPoint(i, x);
    heights->InsertNextValue(x[0] + x[2] / 3.0);
    colors->InsertNextTuple3(40.0 * (x[0] - std::floor(x[0])), 30.0 * std::abs(x[1]), i % 251);
  }
  cloud->GetPointData()->SetScalars(colors);
  cloud->GetPointData()->AddArray(heights);
}

/// Return the mesh that a single process learns from a cloud.
inline vtkSmartPointer<vtkPolyData> Learned(vtkPolyData* cloud)
{
  vtkNew<vtkConformalSOM> network;
  network->SetController(nullptr);
  network->SetInputData(cloud);
  network->SetNumberOfNeurons(642);
  network->SetStartingShapeToSphere();
  network->Update();
  return network->GetOutput();
}

/// Return the corners of all triangles of a mesh: three separate points for each triangle.
inline vtkSmartPointer<vtkPolyData> Soup(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, corners);
    for (const vtkIdType id : *corners)
    {
      points->InsertNextPoint(mesh->GetPoint(id));
    }
  }
  auto soup = vtkSmartPointer<vtkPolyData>::New();
  soup->SetPoints(points);
  return soup;
}

/// Add triangles to the points of Soup(). Each three consecutive points become a triangle.
inline void AddSoupTriangles(vtkPolyData* points)
{
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); i += 3)
  {
    triangles->InsertNextCell({ i, i + 1, i + 2 });
  }
  points->SetPolys(triangles);
}

/// Return the end index of the part of each rank, for equal parts.
inline std::vector<vtkIdType> EvenCuts(vtkIdType size)
{
  std::vector<vtkIdType> ends;
  for (vtkIdType rank = 1; rank <= NumberOfRanks(); ++rank)
  {
    ends.push_back(size * rank / NumberOfRanks());
  }
  return ends;
}

/// Return the end index of the part of each rank, for unequal parts. The first rank has no points,
/// and the second rank has the first third. Further ranks but the last have no points.
inline std::vector<vtkIdType> UnevenCuts(vtkIdType size)
{
  std::vector<vtkIdType> ends(NumberOfRanks(), size / 3);
  ends.front() = NumberOfRanks() > 1 ? 0 : size;
  ends.back() = size;
  return ends;
}

/// Return the part of this rank. If the part has no points, it also has no arrays, as the output of
/// a reader.
inline vtkSmartPointer<vtkPolyData> OwnPart(vtkPolyData* cloud, const std::vector<vtkIdType>& ends)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  const vtkIdType begin = Rank() == 0 ? 0 : ends[Rank() - 1], end = ends[Rank()];
  if (begin == end)
  {
    return part;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  part->GetPointData()->CopyAllocate(cloud->GetPointData());
  for (vtkIdType i = begin; i < end; ++i)
  {
    part->GetPointData()->CopyData(
      cloud->GetPointData(), i, points->InsertNextPoint(cloud->GetPoint(i)));
  }
  part->SetPoints(points);
  if (vtkDataArray* scalars = cloud->GetPointData()->GetScalars())
  {
    part->GetPointData()->SetActiveScalars(scalars->GetName());
  }
  return part;
}

/// Expect that an array equals a part of a larger array, from the tuple `begin` on.
inline void ExpectSameBitsFrom(vtkDataArray* part, vtkDataArray* whole, vtkIdType begin)
{
  ASSERT_NE(part, nullptr);
  ASSERT_NE(whole, nullptr);
  ASSERT_EQ(part->GetNumberOfComponents(), whole->GetNumberOfComponents());
  ASSERT_LE(begin + part->GetNumberOfTuples(), whole->GetNumberOfTuples());
  for (vtkIdType i = 0; i < part->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < part->GetNumberOfComponents(); ++c)
    {
      ASSERT_EQ(part->GetComponent(i, c), whole->GetComponent(begin + i, c)) << i;
    }
  }
}

/// Expect at least `count` numbers in field data. Each number must equal the expected number of the
/// same name.
inline void ExpectSameFigures(vtkFieldData* figures, vtkFieldData* expected, int count)
{
  EXPECT_GE(figures->GetNumberOfArrays(), count);
  for (int i = 0; i < figures->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = figures->GetArray(i);
    ASSERT_NE(expected->GetArray(array->GetName()), nullptr);
    EXPECT_EQ(expected->GetArray(array->GetName())->GetTuple1(0), array->GetTuple1(0))
      << array->GetName();
  }
}

inline void ExpectSameBits(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_NE(a, nullptr);
  ASSERT_NE(b, nullptr);
  ASSERT_EQ(a->GetDataType(), b->GetDataType());
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
              a->GetNumberOfValues() * a->GetDataTypeSize()),
    0);
}

/// Expect that the first rank has the expected surface. Other ranks must have the arrays of the
/// surface, without values.
inline void ExpectOnFirstRank(vtkPolyData* surface, vtkPolyData* expected)
{
  ASSERT_GT(expected->GetNumberOfPoints(), 0);
  vtkPointData* data = expected->GetPointData();
  ASSERT_EQ(surface->GetPointData()->GetNumberOfArrays(), data->GetNumberOfArrays());
  if (Rank() > 0)
  {
    EXPECT_EQ(surface->GetNumberOfPoints(), 0);
    EXPECT_EQ(surface->GetNumberOfCells(), 0);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      EXPECT_EQ(surface->GetPointData()->GetArray(data->GetArrayName(i))->GetNumberOfTuples(), 0);
    }
    return;
  }
  ExpectSameBits(surface->GetPoints()->GetData(), expected->GetPoints()->GetData());
  ExpectSameBits(
    surface->GetPolys()->GetConnectivityArray(), expected->GetPolys()->GetConnectivityArray());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    ExpectSameBits(surface->GetPointData()->GetArray(data->GetArrayName(i)), data->GetArray(i));
  }
}

/// Expect that each rank has a piece of the expected surface. Together, the pieces must contain
/// each triangle exactly once.
inline void ExpectInPieces(vtkPolyData* piece, vtkPolyData* expected)
{
  auto* pointIds = vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetGlobalIds());
  auto* cellIds = vtkIdTypeArray::SafeDownCast(piece->GetCellData()->GetGlobalIds());
  ASSERT_NE(pointIds, nullptr);
  ASSERT_NE(cellIds, nullptr);
  const vtkIdType size = piece->GetNumberOfPolys(), whole = expected->GetNumberOfPolys();
  ASSERT_EQ(cellIds->GetNumberOfTuples(), size);
  ASSERT_EQ(pointIds->GetNumberOfTuples(), piece->GetNumberOfPoints());
  EXPECT_NEAR(static_cast<double>(size), static_cast<double>(whole) / NumberOfRanks(), 1.0);
  std::vector<int> own(whole, 0), all(whole, 0);
  vtkNew<vtkIdList> corners, wholeCorners;
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    own[cellIds->GetValue(cell)] = 1;
    piece->GetPolys()->GetCellAtId(cell, corners);
    expected->GetPolys()->GetCellAtId(cellIds->GetValue(cell), wholeCorners);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(pointIds->GetValue(corners->GetId(k)), wholeCorners->GetId(k));
    }
  }
  Controller()->AllReduce(own.data(), all.data(), whole, vtkCommunicator::SUM_OP);
  EXPECT_EQ(all, std::vector<int>(whole, 1));
  vtkPointData* data = expected->GetPointData();
  for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
  {
    double x[3], y[3];
    piece->GetPoint(i, x);
    expected->GetPoint(pointIds->GetValue(i), y);
    ASSERT_TRUE(std::equal(x, x + 3, y));
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = piece->GetPointData()->GetArray(data->GetArrayName(a));
      ASSERT_NE(array, nullptr);
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        ASSERT_EQ(
          array->GetComponent(i, c), data->GetArray(a)->GetComponent(pointIds->GetValue(i), c));
      }
    }
  }
}
}

#endif

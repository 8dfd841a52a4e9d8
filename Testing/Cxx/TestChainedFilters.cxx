// What filters owe the filters before them: no array that describes an earlier map remains after
// the map has changed, labels remain labels, and cell arrays belong to their cells.
#include "vtkBodyMap.h"
#include "vtkBodyMapImage.h"
#include "vtkConformalDistortion.h"
#include "vtkGlobalConformalMap.h"
#include "vtkSphericalAlignment.h"
#include "vtkSphericalRegistration.h"
#include "vtkSphericalTextureImage.h"
#include "vtkSphericalTextureMap.h"

#include "FilterContract.h"
#include "MeshFixtures.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <functional>
#include <map>
#include <set>
#include <string>

namespace
{
using SurfacePointer = vtkSmartPointer<vtkPolyData>;

SurfacePointer OutputOf(vtkPolyDataAlgorithm* filter)
{
  filter->Update();
  SurfacePointer output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

// Return a surface after filters that describe its map: registration, longitudes, a picture, and
// distortions.
SurfacePointer Described()
{
  vtkNew<vtkSphericalRegistration> registered;
  registered->SetInputData(fixtures::Head(8, 0.3));
  registered->SetFixedData(fixtures::Head(7, 0.0));
  registered->SetFrequency(8);
  vtkNew<vtkBodyMap> body;
  body->SetInputConnection(registered->GetOutputPort());
  vtkNew<vtkSphericalTextureMap> texture;
  texture->SetInputConnection(body->GetOutputPort());
  texture->SetAreaBalance(0.5);
  vtkNew<vtkConformalDistortion> distortion;
  distortion->SetInputConnection(texture->GetOutputPort());
  SurfacePointer surface = OutputOf(distortion);
  // vtkBodyMap is a new map. Its output has no targets, so set some.
  vtkNew<vtkIntArray> ids;
  ids->SetName("TargetPointIds");
  ids->SetNumberOfComponents(3);
  ids->SetNumberOfTuples(surface->GetNumberOfPoints());
  ids->Fill(0);
  surface->GetPointData()->AddArray(ids);
  return surface;
}

// Return a surface with two labels, 1 where y is negative and 9 elsewhere.
SurfacePointer Labeled()
{
  SurfacePointer surface = vtkSmartPointer<vtkPolyData>::New();
  surface->ShallowCopy(fixtures::Ellipsoid(6));
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    labels->InsertNextValue(surface->GetPoint(i)[1] < 0.0 ? 1 : 9);
  }
  surface->GetPointData()->AddArray(labels);
  return surface;
}

std::set<double> ValuesOf(vtkDataArray* array)
{
  std::set<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.insert(array->GetComponent(i, 0));
  }
  return values;
}

void ExpectNoTraceOfAnEarlierMap(vtkPolyData* surface)
{
  EXPECT_EQ(surface->GetPointData()->GetArray("TexturePosition"), nullptr);
  EXPECT_EQ(surface->GetFieldData()->GetArray("TextureAreaBalance"), nullptr);
  EXPECT_NE(surface->GetPointData()->GetTCoords(), nullptr);
  vtkNew<vtkSphericalTextureImage> image;
  image->SetInputData(surface);
  image->SetArrayName("Height");
  const contract::Observed seen(image);
  image->Update();
  seen.ExpectError("no field data SpherePole of vtkSphericalTextureMap");
}
}

TEST(ChainedFilters, AMapRemovesWhatDescribesAnEarlierOne)
{
  const SurfacePointer described = Described();
  const vtkNew<vtkPolyData> head = fixtures::Head(7, 0.0);
  vtkNew<vtkGlobalConformalMap> mapped;
  mapped->SetInputData(described);
  vtkNew<vtkSphericalRegistration> registered;
  registered->SetInputData(described);
  registered->SetFixedData(head);
  registered->SetFrequency(8);
  vtkNew<vtkSphericalAlignment> aligned;
  aligned->SetInputData(described);
  aligned->SetReferenceData(head);
  vtkNew<vtkBodyMap> body;
  body->SetInputData(described);
  body->SetRotationAxis(1.0, 0.0, 0.0);
  for (vtkPolyDataAlgorithm* filter :
    std::initializer_list<vtkPolyDataAlgorithm*>{ mapped, registered, aligned, body })
  {
    SCOPED_TRACE(filter->GetClassName());
    const SurfacePointer output = OutputOf(filter);
    ASSERT_GT(output->GetNumberOfPoints(), 0);
    ExpectNoTraceOfAnEarlierMap(output);
    vtkDataArray* ids = output->GetPointData()->GetArray("TargetPointIds");
    EXPECT_EQ(ids != nullptr, filter == registered.Get());
    EXPECT_TRUE(!ids || ValuesOf(ids).size() > 1);
    EXPECT_EQ(output->GetPointData()->GetArray("Longitude") != nullptr, filter == body.Get());
    const bool keepsAngles = filter == aligned.Get() || filter == body.Get();
    EXPECT_EQ(output->GetCellData()->GetArray("QuasiConformalError") != nullptr, keepsAngles);
    EXPECT_EQ(
      output->GetFieldData()->GetArray("MaximumQuasiConformalError") != nullptr, keepsAngles);
    EXPECT_EQ(output->GetFieldData()->GetArray("SphereDegree") != nullptr, keepsAngles);
    EXPECT_EQ(output->GetFieldData()->GetArray("AreaDistortionDeviation") != nullptr,
      filter == aligned.Get()); // a rotation
    EXPECT_EQ(
      output->GetCellData()->GetArray("AreaDistortion") != nullptr, filter == aligned.Get());
  }
}

TEST(ChainedFilters, LabelsAreNotAveraged)
{
  const std::set<double> labels = { 1.0, 9.0 };
  const SurfacePointer surface = Labeled();
  vtkNew<vtkSphericalTextureMap> texture;
  texture->SetInputData(surface);
  texture->SplitSeamOn();
  texture->Update();
  ASSERT_GT(texture->GetOutput()->GetNumberOfPoints(), surface->GetNumberOfPoints());
  EXPECT_EQ(ValuesOf(texture->GetOutput()->GetPointData()->GetArray("Label")), labels);

  vtkNew<vtkSphericalTextureImage> image;
  image->SetInputConnection(texture->GetOutputPort());
  image->SetArrayName("Label");
  image->SetImageSize(64, 64);
  image->Update();
  EXPECT_EQ(ValuesOf(image->GetOutput()->GetPointData()->GetScalars()), labels);

  vtkNew<vtkBodyMapImage> map;
  map->SetInputData(surface);
  map->SetArrayName("Label");
  map->SetImageSize(64, 32);
  map->Update();
  EXPECT_EQ(ValuesOf(map->GetOutput()->GetPointData()->GetScalars()), labels);
}

TEST(ChainedFilters, CellArraysStayWithTheirTrianglesWhenPointsAreMerged)
{
  const vtkNew<vtkPolyData> closed = fixtures::Ellipsoid(4);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  // Each triangle has its own points. The first one occurs as a needle, too, which is dropped.
  for (vtkIdType cell = -1; cell < closed->GetNumberOfCells(); ++cell)
  {
    closed->GetCellPoints(std::max<vtkIdType>(cell, 0), ids);
    triangles->InsertNextCell(3);
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType corner = cell < 0 && k == 2 ? 1 : k;
      triangles->InsertCellPoint(points->InsertNextPoint(closed->GetPoint(ids->GetId(corner))));
    }
    numbers->InsertNextValue(static_cast<int>(cell));
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(points);
  soup->SetPolys(triangles);
  soup->GetCellData()->AddArray(numbers);

  vtkNew<vtkGlobalConformalMap> map;
  map->SetInputData(soup);
  const contract::Observed seen(map);
  map->Update();
  seen.ExpectWarning("points of open edges were merged");
  vtkPolyData* output = map->GetOutput();
  ASSERT_EQ(output->GetNumberOfCells(), closed->GetNumberOfCells());
  vtkDataArray* kept = output->GetCellData()->GetArray("Number");
  ASSERT_NE(kept, nullptr);
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(kept->GetComponent(cell, 0), static_cast<double>(cell));
  }
}

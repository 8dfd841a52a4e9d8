#include "vtkGeodesicSphereSource.h"

#include "FilterContract.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkPointData.h"

TEST(GeodesicSphereSource, WritesTheContractsArrays)
{
  vtkNew<vtkGeodesicSphereSource> source;
  EXPECT_EQ(source->GetFrequency(), 36);
  source->SetFrequency(7);
  source->Update();
  vtkPolyData* sphere = source->GetOutput();
  EXPECT_EQ(sphere->GetNumberOfPoints(), 10 * 49 + 2);
  EXPECT_EQ(sphere->GetNumberOfPolys(), 20 * 49);
  EXPECT_EQ(sphere->GetPoints()->GetDataType(), VTK_DOUBLE);
  contract::ExpectSpherePosition(sphere);
  contract::ExpectArray(
    sphere->GetPointData(), "Normals", VTK_DOUBLE, 3, sphere->GetNumberOfPoints());
  EXPECT_NE(sphere->GetPointData()->GetNormals(), nullptr);
}

TEST(GeodesicSphereSource, EnclosesTheSpheresVolume)
{
  vtkNew<vtkGeodesicSphereSource> source;
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(source->GetOutputPort());
  mass->Update();
  const double ball = 4.0 / 3.0 * vtkMath::Pi();
  EXPECT_LT(mass->GetVolume(), ball);
  EXPECT_GT(mass->GetVolume(), 0.999 * ball);
}

TEST(GeodesicSphereSource, HasNoOpenEdges)
{
  vtkNew<vtkGeodesicSphereSource> source;
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(source->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
}

TEST(GeodesicSphereSource, ClampsItsFrequency)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(0);
  EXPECT_EQ(source->GetFrequency(), 1);
  source->SetFrequency(2000);
  EXPECT_EQ(source->GetFrequency(), 1000);
}

TEST(GeodesicSphereSource, RunsOnlyWhenModifiedAndPrints)
{
  vtkNew<vtkGeodesicSphereSource> source;
  contract::ExpectRunsOnlyWhenModified(source, [&]() { source->SetFrequency(3); });
  contract::ExpectPrints(source, "Frequency");
}

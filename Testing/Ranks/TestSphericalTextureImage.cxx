#include "vtkSphericalTextureImage.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

#include "vtkGeodesicSphereSource.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"
#include "vtkSphericalTextureMap.h"

namespace
{
vtkSmartPointer<vtkPolyData> Ball(int frequency)
{
  vtkNew<vtkGeodesicSphereSource> sphere;
  sphere->SetFrequency(frequency);
  sphere->Update();
  return sphere->GetOutput();
}

// A ball with its texture coordinates.
vtkSmartPointer<vtkPolyData> Painted()
{
  vtkNew<vtkSphericalTextureMap> map;
  map->SetInputData(Ball(8));
  map->Update();
  return map->GetOutput();
}

// Colored points of a ball, and no triangles.
vtkSmartPointer<vtkPolyData> Cloud()
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(Ball(17)->GetPoints());
  clouds::AddColors(cloud);
  return cloud;
}

vtkSmartPointer<vtkSphericalTextureImage> MakeFilter(
  vtkPolyData* surface, vtkPolyData* source, const char* name = "")
{
  auto filter = vtkSmartPointer<vtkSphericalTextureImage>::New();
  filter->SetInputData(surface);
  filter->SetSourceData(source);
  filter->SetArrayName(name);
  filter->SetImageSize(640, 480); // more pixels than are sent at a time
  return filter;
}

void ExpectSameAsAlone(
  vtkPolyData* source, const std::vector<vtkIdType>& ends, bool isSurface, const char* name)
{
  auto surface = Painted();
  auto alone = MakeFilter(surface, source, name);
  alone->SetController(nullptr);
  alone->Update();
  auto part = clouds::OwnPart(source, ends);
  if (isSurface)
  {
    clouds::AddSoupTriangles(part);
  }
  const vtkNew<vtkPolyData> nothing;
  for (const int threads : { 1, 2 })
  {
    auto filter = MakeFilter(
      clouds::Rank() == 0 ? surface.Get() : static_cast<vtkPolyData*>(nothing), part, name);
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads, "STDThread", false), [&]() { filter->Update(); });
    filter->Update(); // runs on none of them again, or would wait for others
    vtkPointData *image = filter->GetOutput()->GetPointData(),
                 *expected = alone->GetOutput()->GetPointData();
    clouds::ExpectSameBits(image->GetScalars(), expected->GetScalars());
    EXPECT_STREQ(image->GetScalars()->GetName(), expected->GetScalars()->GetName());
    clouds::ExpectSameBits(image->GetArray("OutsideSurface"), expected->GetArray("OutsideSurface"));
  }
}
}

TEST(SphericalTextureImage, TakesTheClosestPointOfAllRanks)
{
  auto cloud = Cloud();
  const vtkIdType size = cloud->GetNumberOfPoints();
  for (const char* name : { "", "Height" })
  {
    ExpectSameAsAlone(cloud, clouds::EvenCuts(size), false, name);
    ExpectSameAsAlone(cloud, clouds::UnevenCuts(size), false, name);
  }
}

TEST(SphericalTextureImage, TakesTheClosestTriangleOfAllRanks)
{
  auto source = clouds::Soup(Ball(5));
  clouds::AddColors(source);
  clouds::AddSoupTriangles(source);
  std::vector<vtkIdType> ends = clouds::UnevenCuts(source->GetNumberOfPolys());
  for (vtkIdType& end : ends)
  {
    end *= 3;
  }
  ExpectSameAsAlone(source, ends, true, "Height");
}

TEST(SphericalTextureImage, FitsTheSizeOfTheImageToThePointsOfAllRanks)
{
  auto cloud = Cloud();
  auto alone = MakeFilter(Painted(), cloud);
  alone->SetController(nullptr);
  alone->FitImageSize(2.0);
  const vtkNew<vtkPolyData> nothing;
  auto filter = MakeFilter(clouds::Rank() == 0 ? Painted().Get() : nothing.Get(),
    clouds::OwnPart(cloud, clouds::EvenCuts(cloud->GetNumberOfPoints())));
  filter->FitImageSize(2.0);
  EXPECT_GT(filter->GetImageSize()[1], 16);
  EXPECT_EQ(filter->GetImageSize()[0], alone->GetImageSize()[0]);
  EXPECT_EQ(filter->GetImageSize()[1], alone->GetImageSize()[1]);
}

TEST(SphericalTextureImage, SizesThatDifferAreAnErrorOfAll)
{
  auto cloud = Cloud();
  auto filter =
    MakeFilter(Painted(), clouds::OwnPart(cloud, clouds::EvenCuts(cloud->GetNumberOfPoints())));
  filter->SetImageSize(64 + clouds::Rank(), 32);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_EQ(
    observed.ErrorMessage().find("ImageSize differs between processes") != std::string::npos,
    clouds::NumberOfRanks() > 1)
    << observed.ErrorMessage();
}

TEST(SphericalTextureImage, AnArrayMissingOnOneRankIsAnErrorOfAll)
{
  auto cloud = Cloud();
  auto part = clouds::OwnPart(cloud, clouds::EvenCuts(cloud->GetNumberOfPoints()));
  if (clouds::Rank() + 1 == clouds::NumberOfRanks())
  {
    part->GetPointData()->RemoveArray("Height");
  }
  auto filter = MakeFilter(Painted(), part, "Height");
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("no point array Height to bake"), std::string::npos)
    << observed.ErrorMessage();

  const vtkNew<vtkPolyData> nothing;
  auto empty = MakeFilter(Painted(), nothing);
  contract::Observed seen(empty);
  empty->Update();
  EXPECT_TRUE(seen.Error());
}

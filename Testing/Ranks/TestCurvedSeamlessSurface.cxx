#include "vtkCurvedSeamlessSurface.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

#include "vtkCurvedSeamlessMap.h"
#include "vtkSMPTools.h"

namespace
{
constexpr vtkIdType Size = 6001;

vtkSmartPointer<vtkCurvedSeamlessSurface> MakeFilter(vtkPolyData* mesh, vtkPolyData* cloud)
{
  auto filter = vtkSmartPointer<vtkCurvedSeamlessSurface>::New();
  filter->SetInputData(mesh);
  filter->SetCloudData(cloud);
  filter->SetDomeHeightToFitted();
  filter->SetFrequency(16);
  return filter;
}

// The whole surface, by the map alone.
vtkSmartPointer<vtkDoubleArray> Evaluated(vtkCurvedSeamlessSurface* filter, vtkPolyData* sphere)
{
  auto positions = vtkSmartPointer<vtkDoubleArray>::New();
  EXPECT_TRUE(
    filter->GetMap()->ToSurface(sphere->GetPointData()->GetArray("SpherePosition"), positions));
  return positions;
}
}

TEST(CurvedSeamlessSurface, IsFittedToTheCloudOfAllRanks)
{
  auto cloud = clouds::Ellipsoid(Size);
  for (vtkIdType i = 0; i < Size; i += 1000)
  {
    cloud->GetPoints()->SetPoint(i, 5.0, 4.0, 0.001 * static_cast<double>(i)); // outliers
  }
  auto mesh = clouds::Learned(cloud);
  auto alone = MakeFilter(mesh, cloud);
  alone->SetController(nullptr);
  alone->Update();
  const vtkNew<vtkPolyData> nothing;
  for (const int threads : { 1, 2 })
  {
    auto filter = MakeFilter(clouds::Rank() == 0 ? mesh.Get() : static_cast<vtkPolyData*>(nothing),
      clouds::OwnPart(cloud, threads == 1 ? clouds::EvenCuts(Size) : clouds::UnevenCuts(Size)));
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads, "STDThread", false), [&]() { filter->Update(); });
    clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
    clouds::ExpectSameBits(
      Evaluated(filter, alone->GetOutput()), Evaluated(alone, alone->GetOutput()));
  }

  // And it matters: the cloud of the first rank alone gives another surface.
  if (clouds::NumberOfRanks() > 1)
  {
    auto other = MakeFilter(mesh, clouds::OwnPart(cloud, clouds::EvenCuts(Size)));
    other->SetController(nullptr);
    other->Update();
    EXPECT_NE(std::memcmp(other->GetOutput()->GetPoints()->GetVoidPointer(0),
                alone->GetOutput()->GetPoints()->GetVoidPointer(0),
                3 * sizeof(double) * alone->GetOutput()->GetNumberOfPoints()),
      0);
  }
}

TEST(CurvedSeamlessSurface, TheCloudMayBeConnectedOnOneRankOnly)
{
  auto cloud = clouds::Ellipsoid(Size);
  auto mesh = clouds::Learned(cloud);
  auto alone = MakeFilter(mesh, cloud);
  alone->SetController(nullptr);
  alone->Update();
  const vtkNew<vtkPolyData> nothing;
  const bool isLast = clouds::Rank() + 1 == clouds::NumberOfRanks();
  auto filter = MakeFilter(clouds::Rank() == 0 ? mesh.Get() : static_cast<vtkPolyData*>(nothing),
    isLast ? cloud.Get() : nullptr);
  filter->Update();
  clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
}

TEST(CurvedSeamlessSurface, CarriesSupportOnOnAnyNumberOfRanks)
{
  auto cloud = clouds::Ellipsoid(Size);
  auto mesh = clouds::Learned(cloud);
  vtkDataArray* support = mesh->GetPointData()->GetArray("Supported");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    support->SetComponent(i, 0, mesh->GetPoint(i)[2] < 0.3 ? 1.0 : 0.0);
  }
  auto alone = MakeFilter(mesh, cloud);
  alone->SetController(nullptr);
  alone->Update();
  double range[2];
  alone->GetOutput()->GetPointData()->GetArray("Supported")->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 1.0);
  const vtkNew<vtkPolyData> nothing;
  const bool isLast = clouds::Rank() + 1 == clouds::NumberOfRanks();
  auto filter = MakeFilter(isLast ? mesh.Get() : static_cast<vtkPolyData*>(nothing),
    clouds::OwnPart(cloud, clouds::EvenCuts(cloud->GetNumberOfPoints())));
  filter->Update();
  // The mesh is on the last rank, and so is the surface.
  vtkDataArray* own = filter->GetOutput()->GetPointData()->GetArray("Supported");
  ASSERT_NE(own, nullptr);
  if (isLast)
  {
    clouds::ExpectSameBits(own, alone->GetOutput()->GetPointData()->GetArray("Supported"));
  }
  else
  {
    EXPECT_EQ(own->GetNumberOfTuples(), 0);
  }
}

TEST(CurvedSeamlessSurface, OtherDomesAreThoseOfEachRank)
{
  auto mesh = clouds::Learned(clouds::Ellipsoid(2000 + 500 * clouds::Rank()));
  auto filter = MakeFilter(mesh, nullptr);
  filter->SetDomeHeightToCurvature();
  if (clouds::Rank() == 0) // the others need not even run
  {
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 10 * 16 * 16 + 2);
  }
}

TEST(CurvedSeamlessSurface, ABadSurfaceIsAnErrorOfAll)
{
  auto cloud = clouds::Ellipsoid(2000);
  const vtkNew<vtkPolyData> nothing;
  const bool hasMesh = clouds::Rank() + 1 == clouds::NumberOfRanks();
  auto filter = MakeFilter(hasMesh ? cloud.Get() : static_cast<vtkPolyData*>(nothing),
    clouds::OwnPart(cloud, clouds::EvenCuts(2000)));
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_TRUE(observed.Error());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  auto empty = MakeFilter(nothing, clouds::OwnPart(cloud, clouds::EvenCuts(2000)));
  contract::Observed seen(empty);
  empty->Update();
  EXPECT_FALSE(seen.Error());
  EXPECT_EQ(seen.Warning(), clouds::Rank() == 0);
}

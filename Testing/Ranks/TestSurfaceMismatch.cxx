#include "vtkSurfaceMismatch.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

#include "vtkSMPTools.h"

namespace
{
constexpr vtkIdType Size = 5001;

vtkSmartPointer<vtkSurfaceMismatch> MakeFilter(vtkPolyData* model, vtkPolyData* reference)
{
  auto filter = vtkSmartPointer<vtkSurfaceMismatch>::New();
  filter->SetInputData(model);
  filter->SetReferenceData(reference);
  filter->SetNumberOfSamples(2000);
  return filter;
}

vtkDataArray* Distances(vtkSurfaceMismatch* filter, int port)
{
  return filter->GetOutput(port)->GetPointData()->GetArray("Distance");
}

vtkIdType FirstOwn(const std::vector<vtkIdType>& ends)
{
  return clouds::Rank() == 0 ? 0 : ends[clouds::Rank() - 1];
}

// The model on one rank, the reference spread.
void ExpectSameAsAlone(vtkPolyData* model, vtkPolyData* reference,
  const std::vector<vtkIdType>& ends, bool isSurface, int unit)
{
  auto alone = MakeFilter(model, reference);
  alone->SetController(nullptr);
  alone->SetLengthUnit(unit);
  alone->Update();
  const vtkNew<vtkPolyData> nothing;
  auto part = clouds::OwnPart(reference, ends);
  if (isSurface)
  {
    clouds::AddSoupTriangles(part);
  }
  const bool hasModel = clouds::Rank() + 1 == clouds::NumberOfRanks();
  for (const int threads : { 1, 2 })
  {
    auto filter = MakeFilter(hasModel ? model : static_cast<vtkPolyData*>(nothing), part);
    filter->SetLengthUnit(unit);
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads, "STDThread", false), [&]() { filter->Update(); });
    clouds::ExpectSameFigures(
      filter->GetOutput()->GetFieldData(), alone->GetOutput()->GetFieldData(), 6);
    ASSERT_EQ(Distances(filter, 0)->GetNumberOfTuples(), hasModel ? model->GetNumberOfPoints() : 0);
    clouds::ExpectSameBitsFrom(Distances(filter, 0), Distances(alone, 0), 0);
    ASSERT_EQ(Distances(filter, 1)->GetNumberOfTuples(), part->GetNumberOfPoints());
    clouds::ExpectSameBitsFrom(Distances(filter, 1), Distances(alone, 1), FirstOwn(ends));
  }
}
}

TEST(SurfaceMismatch, SeesTheCloudOfAllRanks)
{
  auto cloud = clouds::Ellipsoid(Size);
  auto model = clouds::Learned(cloud);
  for (const int unit : { vtkSurfaceMismatch::MAX_RADIUS, vtkSurfaceMismatch::HALF_DIAGONAL })
  {
    ExpectSameAsAlone(model, cloud, clouds::EvenCuts(Size), false, unit);
    ExpectSameAsAlone(model, cloud, clouds::UnevenCuts(Size), false, unit);
  }
}

TEST(SurfaceMismatch, SeesTheTrianglesOfAllRanks)
{
  auto model = clouds::Learned(clouds::Ellipsoid(Size));
  auto reference = clouds::Soup(clouds::Learned(clouds::Ellipsoid(3000)));
  clouds::AddSoupTriangles(reference);
  const vtkIdType triangles = reference->GetNumberOfPolys();
  for (std::vector<vtkIdType> ends : { clouds::EvenCuts(triangles), clouds::UnevenCuts(triangles) })
  {
    for (vtkIdType& end : ends)
    {
      end *= 3;
    }
    ExpectSameAsAlone(model, reference, ends, true, vtkSurfaceMismatch::NONE);
  }
}

TEST(SurfaceMismatch, TakesAModelInPieces)
{
  auto cloud = clouds::Ellipsoid(Size);
  auto model = clouds::Soup(clouds::Learned(cloud));
  clouds::AddSoupTriangles(model);
  auto alone = MakeFilter(model, cloud);
  alone->SetController(nullptr);
  alone->Update();
  std::vector<vtkIdType> ends = clouds::UnevenCuts(model->GetNumberOfPolys());
  for (vtkIdType& end : ends)
  {
    end *= 3;
  }
  auto piece = clouds::OwnPart(model, ends);
  clouds::AddSoupTriangles(piece);
  auto filter = MakeFilter(piece, clouds::OwnPart(cloud, clouds::EvenCuts(Size)));
  filter->Update();
  clouds::ExpectSameFigures(
    filter->GetOutput()->GetFieldData(), alone->GetOutput()->GetFieldData(), 6);
  ASSERT_EQ(Distances(filter, 0)->GetNumberOfTuples(), piece->GetNumberOfPoints());
  clouds::ExpectSameBitsFrom(Distances(filter, 0), Distances(alone, 0), FirstOwn(ends));
}

TEST(SurfaceMismatch, BadPointsOfOneRankAreAnErrorOfAll)
{
  auto cloud = clouds::Ellipsoid(Size);
  cloud->GetPoints()->SetPoint(Size - 1, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  auto filter = MakeFilter(
    clouds::Learned(clouds::Ellipsoid(3000)), clouds::OwnPart(cloud, clouds::EvenCuts(Size)));
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("1 of 5001 points of the reference are not finite"),
    std::string::npos)
    << observed.ErrorMessage();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

TEST(SurfaceMismatch, NothingToMeasureIsSaidOnce)
{
  const vtkNew<vtkPolyData> nothing;
  auto filter = MakeFilter(clouds::Rank() == 0 ? clouds::Learned(clouds::Ellipsoid(1000)).Get()
                                               : static_cast<vtkPolyData*>(nothing),
    nothing);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(observed.Warning(), clouds::Rank() == 0);
}

TEST(SurfaceMismatch, WithoutControllerEachRankMeasuresItsOwn)
{
  auto cloud = clouds::Ellipsoid(1000 + 100 * clouds::Rank());
  auto filter = MakeFilter(clouds::Learned(cloud), cloud);
  filter->SetController(nullptr);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), cloud->GetNumberOfPoints());
  EXPECT_GT(filter->GetOutput()->GetFieldData()->GetArray("HausdorffDistance")->GetTuple1(0), 0.0);
}

#include "vtkSphericalTemplate.h"

#include "ManySurfaces.h"
#include "MeshFixtures.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using contract::BlockOf;

namespace
{
/// A head, longer by its number, turned and moved, its map turned, with marks at some vertices of
/// the icosahedron, which are the first points at any frequency.
vtkSmartPointer<vtkPolyData> Variant(int number, int frequency)
{
  vtkSmartPointer<vtkPolyData> surface = fixtures::Head(frequency, 0.8 * number).Get();
  vtkNew<vtkTransform> turn;
  turn->Translate(10.0 * number, 2.0, 5.0 * number);
  turn->RotateWXYZ(40.0 * number, 1.0, -2.0, 0.5);
  vtkNew<vtkIntArray> marks;
  marks->SetName("Marks");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    p[0] *= 1.0 + 0.1 * number;
    turn->TransformPoint(p, p);
    surface->GetPoints()->SetPoint(i, p);
    marks->InsertNextValue(i == 0 ? 5 : i == 3 ? 2 : i == 7 ? 11 : i == 10 ? 1 : 0);
  }
  surface->GetPointData()->AddArray(marks);
  return surface;
}

class SphericalTemplate : public contract::OfManySurfaces<vtkSphericalTemplate>
{
protected:
  SphericalTemplate()
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Add(Variant(i, 10 + i));
    }
    this->Blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "second");
    this->Filter->SetFrequency(8);
    this->Filter->SetMeanFrequency(12);
    this->Filter->SetMaximumNumberOfRounds(1);
    this->Filter->SetLandmarkArrayName("Marks");
  }
};
}

TEST_F(SphericalTemplate, WritesTheContractsArrays)
{
  this->Run();
  this->Seen.ExpectWarning("");
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfBlocks(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkPolyData* block = BlockOf(this->Filter, i);
    EXPECT_EQ(block->GetPoints(), this->Surfaces[i]->GetPoints());
    EXPECT_EQ(block->GetPolys(), this->Surfaces[i]->GetPolys());
    EXPECT_NE(block->GetPointData()->GetArray("Height"), nullptr);
    contract::ExpectSpherePosition(block);
    contract::ExpectArray(block->GetFieldData(), "RegistrationStretch", VTK_DOUBLE, 1, 1);
    contract::ExpectArray(block->GetFieldData(), "FeatureAgreement", VTK_DOUBLE, 2, 1);
    EXPECT_LT(block->GetFieldData()->GetArray("LandmarkError")->GetTuple1(0), 1e-6);
    EXPECT_EQ(block->GetFieldData()->GetArray("NumberOfFolds")->GetTuple1(0), 0.0);
  }
  EXPECT_STREQ(
    this->Filter->GetOutput()->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()), "second");
  vtkPolyData* mean = this->Filter->GetMeanSurface();
  EXPECT_NEAR(mean->GetNumberOfPoints(), 10 * 12 * 12 + 2, 0.02 * (10 * 12 * 12 + 2));
  contract::ExpectSpherePosition(mean);
  contract::ExpectArray(mean->GetFieldData(), "TemplateChange", VTK_DOUBLE, 1, 1);
  // The head of middle length.
  contract::ExpectArray(mean->GetFieldData(), "TemplateStart", VTK_ID_TYPE, 1, 1);
  EXPECT_EQ(mean->GetFieldData()->GetArray("TemplateStart")->GetTuple1(0), 1.0);
  // The input is left alone.
  EXPECT_EQ(this->Surfaces[0]->GetFieldData()->GetNumberOfArrays(), 0);
}

// Where a point lies on the sphere is where points of equal directions of the other heads lie.
TEST_F(SphericalTemplate, SurfacesCorrespond)
{
  this->Filter->SetLandmarkArrayName("");
  const auto surface = Variant(2, 10); // with the first one's directions
  this->Blocks->SetBlock(2, surface);
  this->Run();
  vtkDataArray* first = BlockOf(this->Filter, 0)->GetPointData()->GetArray("SpherePosition");
  vtkDataArray* last = BlockOf(this->Filter, 2)->GetPointData()->GetArray("SpherePosition");
  double sum = 0.0;
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    double p[3], q[3];
    first->GetTuple(i, p);
    last->GetTuple(i, q);
    sum += std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
  }
  EXPECT_LT(
    vtkMath::DegreesFromRadians(sum / static_cast<double>(first->GetNumberOfTuples())), 4.0);
}

TEST_F(SphericalTemplate, ConnectionsAreSurfacesTooAndOneIsItsOwnTemplate)
{
  vtkNew<vtkSphericalTemplate> filter;
  filter->SetMeanFrequency(9);
  filter->AddInputDataObject(this->Surfaces[1]);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfBlocks(), 1u);
  EXPECT_NEAR(filter->GetMeanSurface()->GetNumberOfPoints(), 812, 0.02 * 812);
  EXPECT_EQ(filter->GetMeanSurface()->GetFieldData()->GetArray("TemplateChange"), nullptr);
  vtkDataArray* before = this->Surfaces[1]->GetPointData()->GetArray("SpherePosition");
  vtkDataArray* after = BlockOf(filter, 0)->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(before->GetComponent(i, c), after->GetComponent(i, c), 1e-7);
    }
  }
}

TEST_F(SphericalTemplate, ArraysAgree)
{
  this->Filter->AddFeature("Height", 1.0);
  EXPECT_EQ(this->Filter->GetNumberOfFeatures(), 1);
  this->Filter->SetMaximumNumberOfRounds(0);
  this->Filter->SetAlignmentToSimilarity();
  this->Run();
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_GT(
      BlockOf(this->Filter, i)->GetFieldData()->GetArray("FeatureAgreement")->GetComponent(0, 1),
      0.97);
  }
}

TEST_F(SphericalTemplate, ThreadsChangeNoBit)
{
  this->ExpectThreadsChangeNoBit();
}

TEST_F(SphericalTemplate, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetTolerance(0.5); });
  for (const char* property : { "MaximumNumberOfRounds", "Tolerance", "Alignment", "MeanFrequency",
         "ShapeWeight", "StretchWeight", "Frequency", "LandmarkArrayName" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
  this->Filter->SetAlignment(9);
  EXPECT_EQ(this->Filter->GetAlignment(), vtkSphericalTemplate::SIMILARITY);
}

TEST_F(SphericalTemplate, StopsWhenAsked)
{
  contract::ExpectStopsWhenAsked(this->Filter);
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(SphericalTemplate, EmptyBlocksStayEmpty)
{
  this->Blocks->SetBlock(0, vtkNew<vtkPolyData>());
  this->Run();
  this->Seen.ExpectWarning("1 of 3 surfaces are empty; their blocks stay empty");
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(BlockOf(this->Filter, 0)->GetNumberOfPoints(), 0);
  EXPECT_NE(BlockOf(this->Filter, 2)->GetFieldData()->GetArray("RegistrationStretch"), nullptr);
  // Of two equally far from their mean, the first one.
  EXPECT_EQ(
    this->Filter->GetMeanSurface()->GetFieldData()->GetArray("TemplateStart")->GetTuple1(0), 1.0);
  this->Filter->SetInputDataObject(vtkNew<vtkMultiBlockDataSet>());
  this->Run();
  this->Seen.ExpectWarning("all surfaces are empty; the output is empty");
  EXPECT_EQ(this->Filter->GetMeanSurface()->GetNumberOfPoints(), 0);
}

TEST_F(SphericalTemplate, BadSurfacesAreNamed)
{
  this->Surfaces[2]->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused("surface 2: the surface has no point array SpherePosition");
  this->Surfaces[1]->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->ExpectRefused("surface 1 (\"second\"): ");
  this->Surfaces[0]->GetPointData()->GetArray("Height")->SetNumberOfTuples(3);
  this->ExpectRefused("input port 0, block 0: the point array \"Height\" has 3 tuples");
  this->Blocks->SetBlock(1, vtkNew<vtkImageData>());
  this->Surfaces[0]->GetPointData()->RemoveArray("Height");
  this->ExpectRefused("a block is a vtkImageData instead of a vtkPolyData");
}

TEST_F(SphericalTemplate, MapsThatFoldAreNamed)
{
  vtkDataArray* map = this->Surfaces[1]->GetPointData()->GetArray("SpherePosition");
  map->SetTuple3(
    30, -map->GetComponent(30, 0), -map->GetComponent(30, 1), -map->GetComponent(30, 2));
  this->ExpectRefused("the map to the sphere of surface 1 (\"second\") covers it");
}

TEST_F(SphericalTemplate, OpenSurfacesAreNamed)
{
  fixtures::ChangePolygons(this->Surfaces[2], [](vtkIdType i, vtkIdList*) { return i != 7; });
  this->ExpectRefused("surface 2: ");
}

TEST_F(SphericalTemplate, LandmarksThatDoNotFitAreNamed)
{
  vtkDataArray* marks = this->Surfaces[1]->GetPointData()->GetArray("Marks");
  marks->SetTuple1(50, 2);
  this->ExpectRefused(
    "surface 1 (\"second\"): two points have the landmark 2; the second is point 50");
  marks->SetTuple1(50, 77);
  this->ExpectRefused("surface 1 (\"second\"): it has the landmark 77, but");
  marks->SetTuple1(50, 0);
  marks->SetTuple1(0, 0);
  this->ExpectRefused("surface 1 (\"second\"): it has no landmark 5");
  this->Filter->SetLandmarkArrayName("Nothing");
  this->ExpectRefused("surface 0: there is no point array \"Nothing\" of 1 component");
  this->Filter->SetLandmarkArrayName("");
  this->Filter->AddFeature("Nothing", 1.0);
  this->ExpectRefused("surface 0: every surface must have the feature \"Nothing\"");
  this->Filter->RemoveAllFeatures();
  this->Filter->AddFeature("Height", -1.0);
  this->ExpectRefused("must be finite and at least 0");
}

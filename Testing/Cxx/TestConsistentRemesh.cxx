#include "vtkConsistentRemesh.h"

#include "ManySurfaces.h"
#include "MeshFixtures.h"
#include "vtkGenusZeroCheck.h"
#include "vtkSurfaceMismatch.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using contract::BlockOf;
using fixtures::Ellipsoid;

namespace
{
/// The ellipsoid, longer by one number and bent by another, turned and moved.
vtkSmartPointer<vtkPolyData> Variant(int number, int frequency)
{
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(Ellipsoid(frequency));
  const double longer = 1.0 + 0.2 * std::sin(1.7 * number + 0.3),
               bent = 0.1 * std::sin(2.9 * number + 0.3);
  vtkNew<vtkTransform> turn;
  turn->Translate(number, 2.0, 0.5 * number);
  turn->RotateWXYZ(40.0 * number, 1.0, -2.0, 0.5);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    p[0] = longer * (p[0] - 10.0);
    p[1] += bent * p[0] * p[0];
    turn->TransformPoint(p, p);
    surface->GetPoints()->SetPoint(i, p);
    numbers->InsertNextValue(number);
  }
  surface->GetPointData()->AddArray(numbers);
  return surface;
}

class ConsistentRemesh : public contract::OfManySurfaces<vtkConsistentRemesh>
{
protected:
  ConsistentRemesh()
  {
    for (int i = 0; i < 10; ++i)
    {
      this->Add(Variant(i, 20 + i % 3));
    }
    this->Blocks->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "fourth");
    this->Filter->SetNumberOfPoints(2000);
  }
};
}

TEST_F(ConsistentRemesh, BlocksShareTheirPolygonsToTheBit)
{
  this->Run();
  EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning());
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfBlocks(), 10u);
  vtkCellArray* first = BlockOf(this->Filter, 0)->GetPolys();
  const vtkIdType size = BlockOf(this->Filter, 0)->GetNumberOfPoints();
  EXPECT_NEAR(size, 2000, 40);
  for (unsigned int i = 0; i < 10; ++i)
  {
    vtkPolyData* block = BlockOf(this->Filter, i);
    ASSERT_EQ(block->GetNumberOfPoints(), size);
    ASSERT_EQ(block->GetNumberOfPolys(), first->GetNumberOfCells());
    for (vtkIdType k = 0; k < first->GetNumberOfConnectivityIds(); ++k)
    {
      ASSERT_EQ(block->GetPolys()->GetConnectivityArray()->GetComponent(k, 0),
        first->GetConnectivityArray()->GetComponent(k, 0));
    }
    contract::ExpectSpherePosition(block);
    contract::ExpectArray(block->GetPointData(), "Number", VTK_DOUBLE, 1, size);
    EXPECT_EQ(block->GetPointData()->GetArray("Number")->GetTuple1(7), i);
    contract::ExpectArray(block->GetFieldData(), "MeanSquarePointToSurface", VTK_DOUBLE, 1, 1);
    contract::ExpectArray(block->GetFieldData(), "ShapeScores", VTK_DOUBLE, 9, 1);
    vtkNew<vtkGenusZeroCheck> check;
    check->SetInputData(block);
    check->Update();
    EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsGenusZero")->GetTuple1(0), 1.0);
    EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("IsInsideOut")->GetTuple1(0), 0.0);
  }
  EXPECT_STREQ(
    this->Filter->GetOutput()->GetMetaData(3u)->Get(vtkCompositeDataSet::NAME()), "fourth");
}

TEST_F(ConsistentRemesh, BlocksLieOnTheirSurfaces)
{
  this->Filter->AlignBlocksOff();
  this->Run();
  for (unsigned int i = 0; i < 10; i += 3)
  {
    vtkNew<vtkSurfaceMismatch> mismatch;
    mismatch->SetInputData(0, BlockOf(this->Filter, i));
    mismatch->SetInputData(1, this->Surfaces[i]);
    mismatch->Update();
    const double p2s =
      mismatch->GetOutput()->GetFieldData()->GetArray("MeanSquarePointToSurface")->GetTuple1(0);
    EXPECT_LT(p2s, 1e-5);
    EXPECT_NEAR(
      BlockOf(this->Filter, i)->GetFieldData()->GetArray("MeanSquarePointToSurface")->GetTuple1(0),
      p2s, 1e-12);
  }
}

TEST_F(ConsistentRemesh, TwoHiddenModesExplainTheShapes)
{
  this->Run();
  vtkPolyData* mean = this->Filter->GetMeanSurface();
  contract::ExpectSpherePosition(mean);
  contract::ExpectArray(mean->GetFieldData(), "ExplainedVariance", VTK_DOUBLE, 1, 9);
  vtkDataArray* explained = mean->GetFieldData()->GetArray("ExplainedVariance");
  EXPECT_GE(explained->GetTuple1(0) + explained->GetTuple1(1), 0.99);
  contract::ExpectArray(
    mean->GetPointData(), "ShapeMode1", VTK_DOUBLE, 3, mean->GetNumberOfPoints());
  EXPECT_EQ(mean->GetPointData()->GetVectors(), mean->GetPointData()->GetArray("ShapeMode1"));
  EXPECT_NE(mean->GetPointData()->GetArray("ShapeMode9"), nullptr);
  EXPECT_NEAR(mean->GetPointData()->GetArray("Number")->GetTuple1(11), 4.5, 1e-12);
  // The mean and all modes by their scores are the block.
  for (const unsigned int s : { 0u, 6u })
  {
    vtkPolyData* block = BlockOf(this->Filter, s);
    const auto rebuilt = [&](vtkIdType i, double p[3])
    {
      mean->GetPoint(i, p);
      for (int k = 0; k < 9; ++k)
      {
        const double* mode = mean->GetPointData()
                               ->GetArray(("ShapeMode" + std::to_string(k + 1)).c_str())
                               ->GetTuple3(i);
        const double score = block->GetFieldData()->GetArray("ShapeScores")->GetComponent(0, k);
        for (int c = 0; c < 3; ++c)
        {
          p[c] += score * mode[c];
        }
      }
    };
    for (vtkIdType i = 0; i < mean->GetNumberOfPoints(); ++i)
    {
      double p[3];
      rebuilt(i, p);
      ASSERT_NEAR(vtkMath::Distance2BetweenPoints(p, block->GetPoint(i)), 0.0, 1e-18);
    }
  }
}

TEST_F(ConsistentRemesh, AlignedBlocksAreMovedAndScaledOnlyAsAllowed)
{
  // Lengths of edges of a block, relative to the block that keeps the coordinates of its surface.
  const auto lengths = [&](unsigned int s)
  {
    std::vector<double> result;
    for (vtkIdType i = 1; i < BlockOf(this->Filter, s)->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      BlockOf(this->Filter, s)->GetPoint(i - 1, p);
      BlockOf(this->Filter, s)->GetPoint(i, q);
      result.push_back(std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
    }
    return result;
  };
  this->Filter->AlignBlocksOff();
  this->Run();
  const std::vector<double> kept = lengths(7);
  this->Filter->AlignBlocksOn();
  this->Run();
  const std::vector<double> rigid = lengths(7);
  this->Filter->SetAlignmentToSimilarity();
  this->Run();
  const std::vector<double> scaled = lengths(7);
  const double scale = scaled.front() / kept.front();
  EXPECT_GT(std::abs(scale - 1.0), 1e-3);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    ASSERT_NEAR(rigid[i], kept[i], 1e-9);
    ASSERT_NEAR(scaled[i], scale * kept[i], 1e-9);
  }
}

TEST_F(ConsistentRemesh, FewerModesAndOtherAlignments)
{
  this->Filter->SetNumberOfModes(2);
  this->Run();
  EXPECT_NE(this->Filter->GetMeanSurface()->GetPointData()->GetArray("ShapeMode2"), nullptr);
  EXPECT_EQ(this->Filter->GetMeanSurface()->GetPointData()->GetArray("ShapeMode3"), nullptr);
  this->Filter->SetNumberOfModes(0);
  this->Run();
  EXPECT_EQ(this->Filter->GetMeanSurface()->GetFieldData()->GetArray("ExplainedVariance"), nullptr);
  EXPECT_EQ(BlockOf(this->Filter, 1)->GetFieldData()->GetArray("ShapeScores"), nullptr);
  // Unaligned, the mean is that of the points.
  this->Filter->SetAlignmentToNone();
  this->Run();
  double sum = 0.0;
  for (unsigned int i = 0; i < 10; ++i)
  {
    sum += BlockOf(this->Filter, i)->GetPoint(33)[0];
  }
  EXPECT_NEAR(this->Filter->GetMeanSurface()->GetPoint(33)[0], 0.1 * sum, 1e-12);
}

TEST_F(ConsistentRemesh, ConnectionsAreSurfacesToo)
{
  vtkNew<vtkConsistentRemesh> filter;
  filter->SetMeshTypeToGeodesic();
  filter->SetFrequency(7);
  filter->AddInputDataObject(this->Surfaces[0]);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfBlocks(), 1u);
  EXPECT_EQ(filter->GetMeanSurface()->GetNumberOfPoints(), 492);
  EXPECT_EQ(filter->GetMeanSurface()->GetFieldData()->GetArray("ExplainedVariance"), nullptr);
  filter->AddInputDataObject(this->Surfaces[1]);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfBlocks(), 2u);
  contract::ExpectArray(
    filter->GetMeanSurface()->GetFieldData(), "ExplainedVariance", VTK_DOUBLE, 1, 1);
}

TEST_F(ConsistentRemesh, ThreadsChangeNoBit)
{
  this->ExpectThreadsChangeNoBit("ShapeMode1");
}

TEST_F(ConsistentRemesh, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetNumberOfModes(3); });
  for (const char* property :
    { "MeshType", "Frequency", "NumberOfPoints", "Alignment", "AlignBlocks", "NumberOfModes" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
  this->Filter->SetAlignment(9);
  EXPECT_EQ(this->Filter->GetAlignment(), vtkConsistentRemesh::SIMILARITY);
}

TEST_F(ConsistentRemesh, StopsWhenAsked)
{
  contract::ExpectStopsWhenAsked(this->Filter);
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(ConsistentRemesh, EmptyInputsGiveAWarningAndNothing)
{
  this->Blocks->SetBlock(4, vtkNew<vtkPolyData>());
  this->Run();
  this->Seen.ExpectWarning("a surface is empty; the output is empty");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(ConsistentRemesh, BadSurfacesAreRefusedByTheirNumber)
{
  this->Surfaces[6]->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused("surface 6: the surface has no point array SpherePosition");
  this->Surfaces[4]->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->ExpectRefused("surface 4: some points of the surface are not finite");
  this->Surfaces[2]->GetPointData()->GetArray("Number")->SetNumberOfTuples(3);
  this->ExpectRefused("input port 0, block 2: the point array \"Number\" has 3 tuples");
}

TEST_F(ConsistentRemesh, OpenSurfacesAreRefused)
{
  fixtures::ChangePolygons(this->Surfaces[5], [](vtkIdType i, vtkIdList*) { return i != 7; });
  this->ExpectRefused("surface 5 is open, or its triangles are not oriented consistently, at 3 "
                      "edges, but must be closed");
}

TEST_F(ConsistentRemesh, ArraysThatDoNotFitAreLeftOutOfTheMean)
{
  vtkNew<vtkUnsignedCharArray> other;
  other->SetName("Number");
  other->SetNumberOfComponents(3);
  other->SetNumberOfTuples(this->Surfaces[8]->GetNumberOfPoints());
  other->FillValue(5);
  this->Surfaces[8]->GetPointData()->AddArray(other);
  this->Run();
  this->Seen.ExpectWarning("the point arrays \"Number\" were left out");
  EXPECT_EQ(this->Filter->GetMeanSurface()->GetPointData()->GetArray("Number"), nullptr);
  EXPECT_EQ(
    BlockOf(this->Filter, 8)->GetPointData()->GetArray("Number")->GetNumberOfComponents(), 3);
}

#include "vtkDeformationTransfer.h"

#include "FilterContract.h"
#include "MeshFixtures.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataGroupFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{
using Executive = vtkStreamingDemandDrivenPipeline;

// Return the surface bent about the z axis, by an angle that grows along x.
vtkSmartPointer<vtkPolyData> Bent(vtkPolyData* surface, double angle)
{
  auto bent = vtkSmartPointer<vtkPolyData>::New();
  bent->DeepCopy(surface);
  for (vtkIdType i = 0; i < bent->GetNumberOfPoints(); ++i)
  {
    double p[3];
    bent->GetPoint(i, p);
    const double turn = angle * std::tanh(0.1 * p[0]);
    const double x = std::cos(turn) * p[0] - std::sin(turn) * p[1];
    p[1] = std::sin(turn) * p[0] + std::cos(turn) * p[1];
    p[0] = x;
    bent->GetPoints()->SetPoint(i, p);
  }
  return bent;
}

double LargestDistance(vtkPolyData* a, vtkPolyData* b)
{
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

// Source of poses at the times 0, 2 and 5, bent by a tenth of the time. Between these times, it
// offers the nearest pose.
class Poses : public vtkPolyDataAlgorithm
{
public:
  static Poses* New();
  vtkTypeMacro(Poses, vtkPolyDataAlgorithm);
  vtkSmartPointer<vtkPolyData> Rest;

protected:
  Poses() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[3] = { 0.0, 2.0, 5.0 }, range[2] = { 0.0, 5.0 };
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(Executive::TIME_STEPS(), times, 3);
    info->Set(Executive::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    double time =
      info->Has(Executive::UPDATE_TIME_STEP()) ? info->Get(Executive::UPDATE_TIME_STEP()) : 0.0;
    time = time < 1.0 ? 0.0 : time < 3.5 ? 2.0 : 5.0;
    vtkPolyData::GetData(outputs)->ShallowCopy(Bent(this->Rest, 0.1 * time));
    return 1;
  }
};
vtkStandardNewMacro(Poses);

class DeformationTransfer : public testing::Test
{
protected:
  DeformationTransfer()
  {
    this->Filter->SetInputData(this->Target);
    this->Filter->SetSourceData(this->Source);
    this->Filter->SetPoseData(Bent(this->Source, 0.5));
  }

  vtkSmartPointer<vtkPolyData> At(double time)
  {
    this->Filter->UpdateTimeStep(time);
    EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning())
      << this->Seen.ErrorMessage() << this->Seen.WarningMessage();
    const auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(this->Filter->GetOutput());
    return copy;
  }

  void ExpectRefused(const std::string& why)
  {
    this->Seen.Clear();
    this->Filter->Modified();
    this->Filter->Update();
    this->Seen.ExpectError(why);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkPolyData> Source = fixtures::Head(12, 0.0), Target = fixtures::Head(9, 0.0);
  vtkNew<vtkDeformationTransfer> Filter;
  contract::Observed Seen{ this->Filter };
};
}

TEST_F(DeformationTransfer, TheSourceItselfGetsThePose)
{
  this->Filter->SetInputData(this->Source);
  const auto pose = Bent(this->Source, 0.5);
  const auto output = this->At(0.0);
  EXPECT_LT(LargestDistance(output, pose), 1e-10 * pose->GetLength());
  EXPECT_LT(output->GetFieldData()->GetArray("TransferResidual")->GetComponent(0, 0), 1e-10);
}

TEST_F(DeformationTransfer, OutputHasArraysOfTheTarget)
{
  const auto before = vtkSmartPointer<vtkPolyData>::New();
  before->DeepCopy(this->Target);
  const auto output = this->At(0.0);
  EXPECT_EQ(output->GetNumberOfPoints(), this->Target->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfPolys(), this->Target->GetNumberOfPolys());
  contract::ExpectSpherePosition(output);
  contract::ExpectArray(
    output->GetPointData(), "Height", VTK_DOUBLE, 1, output->GetNumberOfPoints());
  contract::ExpectArray(output->GetFieldData(), "TransferResidual", VTK_DOUBLE, 1, 1);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(LargestDistance(before, this->Target), 0.0);
  // Both are the same body, on different meshes.
  EXPECT_LT(LargestDistance(output, Bent(this->Target, 0.5)), 0.1 * output->GetLength());
  EXPECT_GT(LargestDistance(output, this->Target), 0.05 * output->GetLength());
}

TEST_F(DeformationTransfer, PosesHaveTimes)
{
  this->Filter->AddPoseData(Bent(this->Source, 1.0));
  this->Filter->AddPoseData(Bent(this->Source, -1.0));
  this->Filter->SetInputData(this->Source);
  this->Filter->UpdateInformation();
  vtkInformation* info = this->Filter->GetOutputInformation(0);
  ASSERT_EQ(info->Length(Executive::TIME_STEPS()), 3);
  EXPECT_EQ(info->Get(Executive::TIME_STEPS())[2], 2.0);
  const double tolerance = 1e-9 * this->Source->GetLength();
  EXPECT_LT(LargestDistance(this->At(1.0), Bent(this->Source, 1.0)), tolerance);
  EXPECT_LT(LargestDistance(this->At(1.9), Bent(this->Source, 1.0)), tolerance);
  EXPECT_EQ(this->Filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 1.0);
  EXPECT_LT(LargestDistance(this->At(7.0), Bent(this->Source, -1.0)), tolerance);
  EXPECT_LT(LargestDistance(this->At(-7.0), Bent(this->Source, 0.5)), tolerance);
  this->Filter->RemoveAllPoses();
  this->Filter->AddPoseData(Bent(this->Source, 0.2));
  EXPECT_LT(LargestDistance(this->At(0.0), Bent(this->Source, 0.2)), tolerance);
}

TEST_F(DeformationTransfer, BlocksArePoses)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Bent(this->Source, 1.0));
  blocks->SetBlock(1, Bent(this->Source, -1.0));
  this->Filter->SetInputData(this->Source);
  this->Filter->SetPoseData(blocks);
  EXPECT_LT(
    LargestDistance(this->At(1.0), Bent(this->Source, -1.0)), 1e-9 * this->Source->GetLength());
}

TEST_F(DeformationTransfer, MissingBlocksKeepTheirTimes)
{
  this->Filter->SetInputData(this->Source);
  const auto last = Bent(this->Source, 0.5);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, this->Source);
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, last);
  this->Filter->SetPoseData(blocks);
  EXPECT_LT(LargestDistance(this->At(0.0), this->Source), 1e-10 * last->GetLength());
  EXPECT_LT(LargestDistance(this->At(2.0), last), 1e-10 * last->GetLength());
  this->Filter->UpdateTimeStep(1.0);
  this->Seen.ExpectWarning("the pose is empty");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Blocks of a filter that has not run yet cannot be counted before the update.
TEST_F(DeformationTransfer, BlocksThatAreMadeInTheUpdateAreCounted)
{
  vtkNew<vtkMultiBlockDataGroupFilter> group;
  for (const double angle : { 0.0, 0.5, 1.0 })
  {
    group->AddInputDataObject(Bent(this->Source, angle));
  }
  this->Filter->SetPoseConnection(group->GetOutputPort());
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutputInformation(0)->Length(Executive::TIME_STEPS()), 3);
}

TEST_F(DeformationTransfer, TimeStepsOfThePosesAreThoseOfTheOutput)
{
  vtkNew<Poses> poses;
  poses->Rest = this->Source.Get();
  this->Filter->SetInputData(this->Source);
  this->Filter->SetPoseConnection(poses->GetOutputPort());
  this->Filter->UpdateInformation();
  ASSERT_EQ(this->Filter->GetOutputInformation(0)->Length(Executive::TIME_STEPS()), 3);
  const double tolerance = 1e-9 * this->Source->GetLength();
  for (const double time : { 5.0, 0.0, 2.0 })
  {
    EXPECT_LT(LargestDistance(this->At(time), Bent(this->Source, 0.1 * time)), tolerance) << time;
    EXPECT_EQ(
      this->Filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
  }
  EXPECT_LT(LargestDistance(this->At(4.0), Bent(this->Source, 0.2)), tolerance)
    << "between two times, the pose is that of the earlier one";
}

TEST_F(DeformationTransfer, ContactsStay)
{
  vtkNew<vtkUnsignedCharArray> feet;
  feet->SetName("Feet");
  const auto pose = vtkSmartPointer<vtkPolyData>::New();
  pose->DeepCopy(this->Source);
  for (vtkIdType i = 0; i < pose->GetNumberOfPoints(); ++i)
  {
    double p[3];
    pose->GetPoint(i, p);
    p[0] += std::max(0.0, p[2] + 5.0);
    pose->GetPoints()->SetPoint(i, p);
  }
  for (vtkIdType i = 0; i < this->Target->GetNumberOfPoints(); ++i)
  {
    feet->InsertNextValue(this->Target->GetPoint(i)[2] < -9.0 ? 1 : 0);
  }
  this->Target->GetPointData()->AddArray(feet);
  this->Filter->SetPoseData(pose);
  const auto slideOf = [&](vtkPolyData* output)
  {
    double largest = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      output->GetPoint(i, p);
      this->Target->GetPoint(i, q);
      const double slide = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
      largest = std::max(largest, feet->GetValue(i) ? slide : 0.0);
    }
    return largest;
  };
  EXPECT_GT(slideOf(this->At(0.0)), 1e-3);
  this->Filter->SetContactArrayName("Feet");
  EXPECT_LT(slideOf(this->At(0.0)), 1e-10);
  this->Filter->SetContactArrayName("Hands");
  this->ExpectRefused("the target has no point array \"Hands\"");
}

TEST_F(DeformationTransfer, BadInputIsRefused)
{
  const auto pose = Bent(this->Source, 0.5);
  this->Filter->SetPoseData(this->Target);
  this->ExpectRefused("the pose has 812 points, but the source at rest has 1442");
  const auto other = Bent(this->Source, 0.5);
  other->GetPolys()->ReverseCellAtId(3);
  this->Filter->SetPoseData(other);
  this->ExpectRefused("the polygons of the pose are not those of the source at rest");
  const auto broken = Bent(this->Source, 0.5);
  broken->GetPoints()->SetPoint(4, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  this->Filter->SetPoseData(broken);
  this->ExpectRefused("some points of the pose are not finite");
  this->Filter->SetPoseData(pose);
  const auto unmapped = Bent(this->Source, 0.0);
  unmapped->GetPointData()->RemoveArray("SpherePosition");
  this->Filter->SetSourceData(unmapped);
  this->ExpectRefused("the source: ");
  this->Filter->SetSourceData(this->Source);
  this->Filter->SetInputData(unmapped);
  this->ExpectRefused("the target: ");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkImageData>());
  this->Filter->SetInputData(this->Target);
  this->Filter->SetPoseData(blocks);
  this->ExpectRefused("a block is a vtkImageData instead of a vtkPolyData");
}

TEST_F(DeformationTransfer, EmptyInputGivesAWarning)
{
  this->Filter->SetInputData(vtkNew<vtkPolyData>());
  this->Filter->Update();
  this->Seen.ExpectWarning("a surface is empty; the output is empty");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(DeformationTransfer, RunsOnlyWhenModified)
{
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetAlignRotation(false); });
  contract::ExpectPrints(this->Filter, "AlignRotation");
  contract::ExpectPrints(this->Filter, "ContactArrayName");
}

TEST_F(DeformationTransfer, ThreadsChangeNoBit)
{
  vtkSmartPointer<vtkPolyData> outputs[2];
  for (int threads = 1; threads < 3; ++threads)
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkDeformationTransfer> filter;
    filter->SetInputData(this->Target);
    filter->SetSourceData(this->Source);
    filter->SetPoseData(Bent(this->Source, 0.5));
    filter->Update();
    outputs[threads - 1] = filter->GetOutput();
  }
  vtkSMPTools::Initialize();
  ASSERT_GT(outputs[0]->GetNumberOfPoints(), 0);
  EXPECT_EQ(LargestDistance(outputs[0], outputs[1]), 0.0);
}

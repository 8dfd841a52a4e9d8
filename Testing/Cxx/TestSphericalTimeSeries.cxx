#include "vtkSphericalTimeSeries.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{
// A head that grows by a tenth per time.
vtkSmartPointer<vtkPolyData> HeadAt(double time)
{
  vtkSmartPointer<vtkPolyData> surface = fixtures::Head(12, 0.8).Get();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    for (double& c : p)
    {
      c *= std::exp(0.1 * time);
    }
    surface->GetPoints()->SetPoint(i, p);
  }
  return surface;
}

// Source with the time steps 0, 2, 3 and 6. The surface of one of them can be empty.
class Heads : public vtkPolyDataAlgorithm
{
public:
  static Heads* New();
  vtkTypeMacro(Heads, vtkPolyDataAlgorithm);
  int Empty = -1;
  int NumberOfRuns = 0;

protected:
  Heads() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[4] = { 0.0, 2.0, 3.0, 6.0 }, range[2] = { 0.0, 6.0 };
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 4);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    ++this->NumberOfRuns;
    if (time != this->Empty)
    {
      vtkPolyData::GetData(outputs)->ShallowCopy(HeadAt(time));
    }
    vtkPolyData::GetData(outputs)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};
vtkStandardNewMacro(Heads);

// Source of composite data. With time steps 0 and 1, all blocks are the head at this time;
// otherwise, block k is the head at time k.
class HeadBlocks : public vtkMultiBlockDataSetAlgorithm
{
public:
  static HeadBlocks* New();
  vtkTypeMacro(HeadBlocks, vtkMultiBlockDataSetAlgorithm);
  int NumberOfBlocks = 1;
  bool HasTimes = true;

protected:
  HeadBlocks() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[2] = { 0.0, 1.0 };
    vtkInformation* info = outputs->GetInformationObject(0);
    if (this->HasTimes)
    {
      info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 2);
      info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), times, 2);
    }
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    auto* blocks = vtkMultiBlockDataSet::GetData(outputs);
    for (int k = 0; k < this->NumberOfBlocks; ++k)
    {
      blocks->SetBlock(k,
        HeadAt(
          this->HasTimes ? info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()) : k));
    }
    return 1;
  }
};
vtkStandardNewMacro(HeadBlocks);

class SphericalTimeSeries : public contract::FilterTest<vtkSphericalTimeSeries>
{
protected:
  SphericalTimeSeries()
  {
    this->Filter->SetFrequency(8);
    this->Filter->SetNumberOfSweeps(0);
  }

  double MeanOf(const char* name)
  {
    vtkDataArray* array = this->Filter->GetOutput()->GetPointData()->GetArray(name);
    double sum = 0.0;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      sum += array->GetComponent(i, 0) / static_cast<double>(array->GetNumberOfTuples());
    }
    return sum;
  }

  double SizeOfOutput() { return this->Filter->GetOutput()->GetLength(); }
  vtkVariant Entry(vtkIdType row, const char* column)
  {
    return this->Filter->GetTable()->GetValueByName(row, column);
  }
};
}

// Spots on a ball that turns by 5 degrees between two inputs. Its shape does not show the turn.
TEST_F(SphericalTimeSeries, FeaturesShowMotionAlongTheSurface)
{
  const double turn = 5.0 * 3.14159265358979 / 180.0;
  const auto ballAt = [&](double angle)
  {
    vtkNew<vtkGeodesicSphereSource> source;
    source->SetFrequency(16);
    source->Update();
    auto ball = vtkSmartPointer<vtkPolyData>::New();
    ball->ShallowCopy(source->GetOutput());
    vtkNew<vtkDoubleArray> spots;
    spots->SetName("Spots");
    for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
    {
      double p[3];
      ball->GetPoint(i, p);
      const double x = std::cos(angle) * p[0] + std::sin(angle) * p[1],
                   y = std::cos(angle) * p[1] - std::sin(angle) * p[0];
      spots->InsertNextValue(
        std::sin(6.0 * x) * std::sin(5.0 * y) + std::sin(4.0 * p[2] + 3.0 * x));
    }
    ball->GetPointData()->AddArray(spots);
    return ball;
  };
  this->Filter->AddInputData(ballAt(0.0));
  this->Filter->AddInputData(ballAt(turn));
  // Return the mean velocity around the axis by that of the turn, weighted by the distance to it.
  const auto followed = [&]()
  {
    this->Filter->UpdateTimeStep(1.0);
    vtkPolyData* output = this->Filter->GetOutput();
    double moved = 0.0, all = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double p[3], v[3];
      output->GetPoint(i, p);
      output->GetPointData()->GetArray("Velocity")->GetTuple(i, v);
      moved += p[0] * v[1] - p[1] * v[0];
      all += turn * (p[0] * p[0] + p[1] * p[1]);
    }
    return moved / all;
  };
  this->Filter->SetShapeWeight(0.0); // a ball has no shape features
  EXPECT_LT(std::abs(followed()), 0.1);
  this->Filter->AddFeature("Spots", 10.0);
  EXPECT_NEAR(followed(), 0.8, 0.2);
  this->Seen.ExpectWarning("");
  this->Filter->RemoveAllFeatures();
  EXPECT_EQ(this->Filter->GetNumberOfFeatures(), 0);
  EXPECT_LT(std::abs(followed()), 0.1);
  this->Filter->AddFeature("Nothing", 1.0);
  this->Filter->Update();
  this->Seen.ExpectError("Nothing");
}

// A head that grows by a tenth between two inputs, which are 5 seconds apart.
TEST_F(SphericalTimeSeries, RatesAreInTheUnitOfTheTimeInterval)
{
  for (const double time : { 0.0, 1.0, 2.0 })
  {
    this->Filter->AddInputData(HeadAt(time));
  }
  this->Filter->SetTimeInterval(5.0);
  this->Filter->UpdateTimeStep(5.0);
  EXPECT_NEAR(this->SizeOfOutput(), HeadAt(1.0)->GetLength(), 1e-9);
  EXPECT_NEAR(this->MeanOf("AreaRate"), 0.2 / 5.0, 0.004);
  EXPECT_EQ(this->Entry(2, "Time").ToDouble(), 10.0);
  EXPECT_NEAR(this->Entry(1, "RelativeArea").ToDouble(), std::exp(0.2), 1e-9);
  // Growth by a tenth moves points by a tenth of their distance from the origin, times the cosine
  // between position and normal: the volume is a third of the area times the mean of this product.
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(this->Filter->GetOutput());
  EXPECT_NEAR(this->Entry(1, "MeanNormalSpeed").ToDouble() /
      (0.1 / 5.0 * 3.0 * mass->GetVolume() / mass->GetSurfaceArea()),
    1.0, 0.05);
  EXPECT_GT(this->Entry(1, "MeanTangentialSpeed").ToDouble(), 0.0);
}

TEST_F(SphericalTimeSeries, ReadsTimeStepsOnceAndShowsAnyTime)
{
  vtkNew<Heads> heads;
  this->Filter->SetInputConnection(heads->GetOutputPort());
  this->Filter->UpdateTimeStep(3.0);
  this->Seen.ExpectWarning("");
  contract::ExpectSpherePosition(this->Filter->GetOutput());
  EXPECT_EQ(heads->NumberOfRuns, 4);
  EXPECT_NEAR(this->SizeOfOutput(), HeadAt(3.0)->GetLength(), 1e-9);
  EXPECT_NEAR(this->MeanOf("AreaRate"), 0.2, 0.02);
  EXPECT_NEAR(this->MeanOf("ShearRate"), 0.0, 0.02);
  vtkInformation* info = this->Filter->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 4);
  EXPECT_EQ(info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[3], 6.0);

  this->Filter->UpdateTimeStep(2.5);
  EXPECT_EQ(heads->NumberOfRuns, 4);
  EXPECT_NEAR(this->SizeOfOutput() / (0.5 * (HeadAt(2.0)->GetLength() + HeadAt(3.0)->GetLength())),
    1.0, 0.01);
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetArray("IsInterpolated")->GetTuple1(0), 1);
  EXPECT_EQ(this->Filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 2.5);

  ASSERT_EQ(this->Filter->GetTable()->GetNumberOfRows(), 4);
  EXPECT_EQ(this->Entry(0, "State").ToString(), "reference");
  EXPECT_EQ(this->Entry(3, "State").ToString(), "registered");
  EXPECT_NEAR(this->Entry(3, "RelativeArea").ToDouble(), std::exp(1.2), 1e-6);
  EXPECT_NEAR(this->Entry(3, "RelativeVolume").ToDouble(), std::exp(1.8), 1e-6);
}

// Between two time steps, points move straight: velocities are those at the first of only two
// steps.
TEST_F(SphericalTimeSeries, MotionBetweenTimeStepsIsThatOfTheTime)
{
  this->Filter->AddInputData(HeadAt(0.0));
  this->Filter->AddInputData(HeadAt(1.0));
  this->Filter->UpdateTimeStep(0.0);
  const double area = this->MeanOf("AreaRate");
  const auto speed = [&]()
  {
    vtkDataArray* array = this->Filter->GetOutput()->GetPointData()->GetArray("Velocity");
    double sum = 0.0;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      sum += vtkMath::Norm(array->GetTuple3(i));
    }
    return sum;
  };
  const double first = speed();
  for (const double time : { 1e-9, 0.1, 0.5, 0.9 })
  {
    this->Filter->UpdateTimeStep(time);
    EXPECT_NEAR(speed() / first, 1.0, 1e-6) << time;
    EXPECT_NEAR(this->MeanOf("AreaRate") / area, 1.0, 0.15) << time;
  }
}

TEST_F(SphericalTimeSeries, ReadsTimeStepsOfBlocks)
{
  vtkNew<HeadBlocks> heads;
  this->Filter->SetInputConnection(heads->GetOutputPort());
  this->Filter->UpdateTimeStep(1.0);
  this->Seen.ExpectWarning("");
  EXPECT_NEAR(this->SizeOfOutput(), HeadAt(1.0)->GetLength(), 1e-9);
  EXPECT_EQ(this->Filter->GetTable()->GetNumberOfRows(), 2);
  heads->NumberOfBlocks = 2;
  heads->Modified();
  this->Filter->Update();
  this->Seen.ExpectError("must be a single surface at each time, but has 2 at time step 0");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  this->Seen.Clear();
  heads->NumberOfBlocks = 0;
  heads->Modified();
  this->Filter->Update();
  this->Seen.ExpectWarning("all surfaces are empty");
}

// Blocks of a filter that has not run yet cannot be counted before the update.
TEST_F(SphericalTimeSeries, CountsBlocksThatAreMadeInTheUpdate)
{
  vtkNew<HeadBlocks> heads;
  heads->NumberOfBlocks = 3;
  heads->HasTimes = false;
  this->Filter->SetTimeInterval(2.0);
  this->Filter->SetInputConnection(heads->GetOutputPort());
  this->Filter->Update();
  vtkInformation* info = this->Filter->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 3);
  EXPECT_EQ(info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[2], 4.0);
  this->Filter->UpdateTimeStep(4.0);
  EXPECT_NEAR(this->SizeOfOutput(), HeadAt(2.0)->GetLength(), 1e-9);
  this->Seen.ExpectWarning("");
}

// The rows of the table, the last part of the computation, have equal shares of the progress.
TEST_F(SphericalTimeSeries, ReportsEachRowOfTheTable)
{
  for (const double time : { 0.0, 1.0, 2.0, 3.0 })
  {
    this->Filter->AddInputDataObject(HeadAt(time));
  }
  std::vector<double> reports;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&reports);
  keep->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      auto* kept = static_cast<std::vector<double>*>(client);
      const double progress = static_cast<vtkAlgorithm*>(caller)->GetProgress();
      if (kept->empty() || progress > kept->back())
      {
        kept->push_back(progress);
      }
    });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, keep);
  this->Filter->Update();
  const std::size_t size = reports.size();
  ASSERT_GT(size, 5U);
  EXPECT_EQ(reports.back(), 1.0);
  for (std::size_t i = size - 4; i < size; ++i)
  {
    EXPECT_NEAR(reports[i] - reports[i - 1], 1.0 - reports[size - 2], 1e-9);
  }
}

TEST_F(SphericalTimeSeries, RemovesNormalsOfInterpolatedSurfaces)
{
  for (const double time : { 0.0, 1.0 })
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(HeadAt(time));
    normals->SplittingOff();
    normals->ComputeCellNormalsOn();
    normals->Update();
    this->Filter->AddInputDataObject(normals->GetOutput());
  }
  this->Filter->UpdateTimeStep(1.0);
  EXPECT_NE(this->Filter->GetOutput()->GetCellData()->GetNormals(), nullptr);
  this->Filter->UpdateTimeStep(0.5);
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(this->Filter->GetOutput()->GetCellData()->GetNormals(), nullptr);
}

TEST_F(SphericalTimeSeries, SkipsSurfacesThatCannotBeUsed)
{
  vtkNew<Heads> heads;
  heads->Empty = 2;
  this->Filter->SetInputConnection(heads->GetOutputPort());
  this->Filter->UpdateTimeStep(2.0);
  this->Seen.ExpectWarning("time step 1 is skipped and interpolated: the surface is empty");
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetArray("IsInterpolated")->GetTuple1(0), 1);
  EXPECT_EQ(this->Entry(1, "State").ToString(), "skipped");

  this->Filter->SetReferenceStep(1);
  this->Filter->UpdateTimeStep(2.0);
  this->Seen.ExpectError("time step 1, which is ReferenceStep, cannot be used");
  this->Seen.Clear();
  this->Filter->SetReferenceStep(4);
  this->Filter->UpdateTimeStep(2.0);
  this->Seen.ExpectError("ReferenceStep is 4, but there are only 4 time steps");
}

TEST_F(SphericalTimeSeries, SkipsMissingBlocksAtTheirTimes)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, HeadAt(0.0));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, HeadAt(2.0));
  this->Filter->SetInputDataObject(blocks);
  this->Filter->UpdateTimeStep(2.0);
  this->Seen.ExpectWarning("time step 1 is skipped and interpolated: the surface is empty");
  EXPECT_EQ(this->Entry(1, "State").ToString(), "skipped");
  EXPECT_EQ(this->Entry(2, "Time").ToDouble(), 2.0);
}

TEST_F(SphericalTimeSeries, TakesSeparateInputsAndKnowsTheirRegistrations)
{
  for (const double time : { 0.0, 1.0, 2.0 })
  {
    this->Filter->AddInputDataObject(HeadAt(time));
  }
  // Stop after the first registration.
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(caller);
      filter->SetAbortExecute(filter->GetProgress() > 0.6);
    });
  const unsigned long tag = this->Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  this->Filter->RemoveObserver(tag);
  this->Filter->SetAbortExecute(0);
  this->Run();
  this->Seen.ExpectWarning("");
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetTable()->GetNumberOfRows(), 3);
}

TEST_F(SphericalTimeSeries, HasTheSameBitsOnAnyThreads)
{
  const auto mapOf = [&](int threads)
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<Heads> heads;
    vtkNew<vtkSphericalTimeSeries> filter;
    filter->SetFrequency(8);
    filter->SetInputConnection(heads->GetOutputPort());
    filter->UpdateTimeStep(6.0);
    vtkNew<vtkDoubleArray> map;
    map->DeepCopy(filter->GetOutput()->GetPointData()->GetArray("SpherePosition"));
    vtkSMPTools::Initialize();
    return std::vector<double>(map->GetPointer(0), map->GetPointer(0) + map->GetNumberOfValues());
  };
  EXPECT_EQ(mapOf(1), mapOf(4));
}

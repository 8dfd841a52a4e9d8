// vtkBackgroundUpdate runs filters and readers on other threads: results are those of Update(), an
// abort ends the run, and messages are kept.
#include "vtkBackgroundUpdate.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkType.h"

#include <chrono>
#include <string>
#include <thread>

namespace
{
void Sleep()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// A filter that would run for years.
vtkNew<vtkConformalSOM> EndlessNetwork()
{
  vtkNew<vtkConformalSOM> network;
  network->SetInputData(fixtures::Ellipsoid(12));
  network->SetTrainingModeToOnline();
  network->SetNumberOfEpochs(VTK_INT_MAX);
  return network;
}
}

TEST(BackgroundUpdate, TwoAtATimeHaveTheResultOfUpdate)
{
  vtkNew<vtkConformalSOM> first, second, expected;
  vtkNew<vtkBackgroundUpdate> one, two;
  for (vtkConformalSOM* network : { first.Get(), second.Get(), expected.Get() })
  {
    network->SetInputData(fixtures::Ellipsoid(24));
    network->SetNumberOfNeurons(500);
  }
  ASSERT_TRUE(one->Start(first));
  ASSERT_TRUE(two->Start(second));
  while (one->IsRunning() || two->IsRunning())
  {
    EXPECT_GE(one->GetProgress(), 0.0);
    EXPECT_LE(one->GetProgress(), 1.0);
    Sleep();
  }
  one->Wait();
  two->Wait();
  expected->Update();
  ASSERT_GT(expected->GetOutput()->GetNumberOfPoints(), 0);
  for (vtkConformalSOM* network : { first.Get(), second.Get() })
  {
    vtkPolyData* output = network->GetOutput();
    ASSERT_EQ(output->GetNumberOfPoints(), expected->GetOutput()->GetNumberOfPoints());
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_EQ(output->GetPoint(i)[c], expected->GetOutput()->GetPoint(i)[c]);
      }
    }
  }
  EXPECT_EQ(one->GetProgress(), 1.0);
  EXPECT_EQ(one->GetNumberOfErrors(), 0);
  EXPECT_EQ(one->GetNumberOfWarnings(), 0);
}

TEST(BackgroundUpdate, AbortEndsTheRun)
{
  const vtkNew<vtkConformalSOM> network = EndlessNetwork();
  vtkNew<vtkBackgroundUpdate> update;
  ASSERT_TRUE(update->Start(network));
  while (update->GetProgress() == 0.0 && update->IsRunning())
  {
    Sleep();
  }
  EXPECT_TRUE(update->IsRunning());
  update->Abort();
  update->Wait();
  EXPECT_FALSE(update->IsRunning());
  EXPECT_EQ(network->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(update->GetNumberOfErrors(), 0);
}

TEST(BackgroundUpdate, AbortBeforeTheFirstProgressEndsTheRun)
{
  const vtkNew<vtkConformalSOM> network = EndlessNetwork();
  vtkNew<vtkBackgroundUpdate> update;
  ASSERT_TRUE(update->Start(network));
  update->Abort();
  update->Wait();
  EXPECT_EQ(network->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(BackgroundUpdate, DestructorEndsTheRun)
{
  const vtkNew<vtkConformalSOM> network = EndlessNetwork();
  {
    vtkNew<vtkBackgroundUpdate> update;
    ASSERT_TRUE(update->Start(network));
  }
  EXPECT_EQ(network->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_FALSE(network->HasObserver(vtkCommand::ErrorEvent));
}

TEST(BackgroundUpdate, KeepsMessages)
{
  vtkNew<vtkConformalPLYReader> reader;
  reader->SetFileName("there is no such file.ply");
  vtkNew<vtkBackgroundUpdate> update;
  ASSERT_TRUE(update->Start(reader));
  update->Wait();
  ASSERT_GT(update->GetNumberOfErrors(), 0);
  EXPECT_NE(update->GetError(0).find("there is no such file"), std::string::npos);
  EXPECT_EQ(update->GetError(-1), "");
  EXPECT_EQ(update->GetError(1000), "");

  vtkNew<vtkConformalSOM> network;
  vtkNew<vtkPolyData> empty;
  network->SetInputData(empty);
  ASSERT_TRUE(update->Start(network));
  update->Wait();
  EXPECT_EQ(update->GetNumberOfErrors(), 0); // those of the reader are gone
  ASSERT_EQ(update->GetNumberOfWarnings(), 1);
  EXPECT_NE(update->GetWarning(0).find("no points"), std::string::npos);
  EXPECT_EQ(update->GetWarning(1), "");
  EXPECT_FALSE(network->HasObserver(vtkCommand::WarningEvent));
}

TEST(BackgroundUpdate, RefusesASecondRunAndNoAlgorithm)
{
  const vtkNew<vtkConformalSOM> network = EndlessNetwork();
  vtkNew<vtkConformalSOM> other;
  vtkNew<vtkBackgroundUpdate> update;
  vtkNew<vtkTest::ErrorObserver> heard;
  update->AddObserver(vtkCommand::ErrorEvent, heard);
  contract::ExpectPrints(update, "IsRunning");
  EXPECT_FALSE(update->Start(nullptr));
  EXPECT_NE(heard->GetErrorMessage().find("no algorithm"), std::string::npos);
  ASSERT_TRUE(update->Start(network));
  EXPECT_FALSE(update->Start(other));
  EXPECT_NE(heard->GetErrorMessage().find("still runs"), std::string::npos);
  EXPECT_TRUE(update->IsRunning());
}

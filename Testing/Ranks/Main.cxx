// Runs the tests on every process of an MPI job. All must take the same way through them.
#include "vtkCommunicator.h"
#include "vtkMPIController.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  testing::InitGoogleTest(&argc, argv);
  const int own = RUN_ALL_TESTS();
  int failed = 0;
  controller->AllReduce(&own, &failed, 1, vtkCommunicator::MAX_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return failed;
}

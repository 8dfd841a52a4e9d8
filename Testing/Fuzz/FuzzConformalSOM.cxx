#include "vtkConformalSOM.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkConformalSOM> learner;
  const int frequency = 1 + source.below(3);
  learner->SetNumberOfNeurons(10 * frequency * frequency + 2);
  learner->SetTrainingMode(source.below(2));
  learner->SetReferencePoint(source.below(4));
  learner->SetStartingShape(source.below(4));
  learner->SetNumberOfEpochs(source.below(3));
  learner->SetSamplesPerEpoch(1 + source.below(40));
  learner->SetMeshType(source.below(3));
  learner->SetHullMethod(source.below(3));
  learner->SetFitIterations(source.below(3));
  learner->SetGenerateStages(source.flag());
  learner->SetDistributeOutput(source.flag());
  const int odd = source.byte();
  learner->SetPriorityArrayName(odd % 4 == 3 ? "Priority" : nullptr);
  if (odd & 64)
  {
    double constants[4];
    for (double& constant : constants)
    {
      constant = source.number();
    }
    learner->SetOnlineConstants(constants);
  }
  if (odd & 32)
  {
    learner->SetSmoothness(source.number());
  }
  if (odd & 16)
  {
    learner->SetMeshTypeToAdaptive();
    learner->SetNumberOfNeurons(12 + source.below(60));
  }
  learner->SetInputDataObject(0, source.surface());
  if (odd & 128)
  {
    learner->SetInputDataObject(1, source.surface());
  }
  fuzz::run(learner, true);
  return 0;
}

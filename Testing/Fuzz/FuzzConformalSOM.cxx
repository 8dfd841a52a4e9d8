#include "vtkConformalSOM.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkConformalSOM> learner;
  learner->SetFrequency(1 + source.below(3));
  learner->SetTrainingMode(source.below(2));
  learner->SetReferencePoint(source.below(4));
  learner->SetStartingShape(source.below(4));
  learner->SetNumberOfEpochs(source.below(3));
  learner->SetSamplesPerEpoch(1 + source.below(40));
  learner->SetPassesPerLevel(source.below(3));
  learner->SetSamplesPerNeuron(1 + source.below(4));
  learner->SetNumberOfPolishRounds(source.below(3));
  learner->SetGenerateErrorScalars(source.flag());
  learner->SetDistributeOutput(source.flag());
  learner->SetAutomaticPriority(source.flag());
  const int odd = source.byte();
  learner->SetPriorityArrayName(odd % 4 == 3 ? "Priority" : nullptr);
  if (odd & 64)
  {
    learner->SetInitialNeighborhoodRadius(source.number());
    learner->SetNeighborhoodTimeConstant(source.number());
  }
  if (odd & 32)
  {
    learner->SetInitialLearningRate(source.number());
    learner->SetLearningRateTimeConstant(source.number());
    learner->SetSmoothness(source.number());
  }
  if (odd & 16)
  {
    learner->SetLatticeToAdaptive();
    learner->SetNumberOfNeurons(12 + source.below(60));
    learner->SetSphereMap(source.below(3));
    learner->SetAreaBalance(source.number());
  }
  learner->SetInputDataObject(0, source.surface());
  if (odd & 128)
  {
    learner->SetInputDataObject(1, source.surface());
  }
  fuzz::run(learner, true);
  return 0;
}

// Stages of learning as blocks of a data set.
#ifndef GlueLearningStages_h
#define GlueLearningStages_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Learn/LearningStage.h"  // for the stages

#include <vector> // for the stages

class vtkMultiBlockDataSet;

namespace glue
{
/// Set one block for each stage: a vtkPolyData whose block name is "<number of the start> <start>:
/// <stage>", with the quality of the surface as field data "StartNumber", "DefectScore",
/// "UncoveredFraction", "InvertedFraction" and "FoldedFraction".
void SetStages(vtkMultiBlockDataSet* blocks, const std::vector<conformal::LearningStage>& stages,
  const conformal::CoordinateFrame& frame);
}

#endif

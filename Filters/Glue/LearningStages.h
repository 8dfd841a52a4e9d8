// Convert stages of learning to blocks of a data set.
#ifndef GlueLearningStages_h
#define GlueLearningStages_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Learn/LearningStage.h"  // for the stages

#include <vector> // for the stages

class vtkMultiBlockDataSet;

namespace glue
{
/// Set one block for each stage: a vtkPolyData with the stage's surface. The block name is "<number
/// of the start> <start>: <stage>". The quality of the surface is stored as field data
/// "StartNumber", "DefectScore", "UncoveredFraction", "InvertedFraction" and "FoldedFraction".
void SetStages(vtkMultiBlockDataSet* blocks, const std::vector<conformal::LearningStage>& stages,
  const conformal::CoordinateFrame& frame);
}

#endif

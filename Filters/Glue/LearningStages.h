// Convert intermediate surfaces of learning (stages) to blocks of a data set.
#ifndef GlueLearningStages_h
#define GlueLearningStages_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Learn/LearningStage.h"  // for the stages

#include <vector> // for the stages

class vtkMultiBlockDataSet;

namespace glue
{
/// Set one block for each stage: a vtkPolyData with the surface of the stage. The block name is
/// "<number of the start> <start>: <stage>", for example "1 sphere: level 8". Here the start is the
/// surface from which learning began.
///
/// Each block has field data with the quality of the surface: "StartNumber", "DefectScore",
/// "UncoveredFraction", "InvertedFraction" and "FoldedFraction".
/// @param[in] frame  coordinate frame of the stages; points are converted to the user's coordinates
void SetStages(vtkMultiBlockDataSet* blocks, const std::vector<conformal::LearningStage>& stages,
  const conformal::CoordinateFrame& frame);
}

#endif

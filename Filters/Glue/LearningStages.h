// Convert intermediate surfaces of learning (stages) to blocks of a data set. Learning fits a mesh
// to a point cloud, beginning with a start surface.
#ifndef GlueLearningStages_h
#define GlueLearningStages_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Learn/LearningStage.h"  // for the stages

#include <vector> // for the stages

class vtkMultiBlockDataSet;

namespace glue
{
/// Set one block for each stage: a vtkPolyData with the surface of the stage. The block name
/// consists of the number and the name of the start surface, and the name of the stage. An example
/// is "1 sphere: level 8". Here, the first start surface is a sphere. The stage "level 8" trains a
/// mesh that has 8 segments along each edge of an icosahedron.
///
/// Each block has the field data "StartNumber", "DefectScore", "UncoveredFraction",
/// "InvertedFraction" and "FoldedFraction". "StartNumber" is the number of the start surface. The
/// other four numbers describe the quality of the surface, see LearningStage.h.
/// @param[in] frame  coordinate frame of the stages; points are converted to the user's coordinates
void SetStages(vtkMultiBlockDataSet* blocks, const std::vector<conformal::LearningStage>& stages,
  const conformal::CoordinateFrame& frame);
}

#endif

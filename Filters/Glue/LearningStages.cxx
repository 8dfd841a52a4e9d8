#include "Glue/LearningStages.h"

#include "Glue/Arrays.h"

#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <string>

namespace glue
{
void SetStages(vtkMultiBlockDataSet* blocks, const std::vector<conformal::LearningStage>& stages,
  const conformal::CoordinateFrame& frame)
{
  blocks->Initialize();
  for (const conformal::LearningStage& stage : stages)
  {
    const vtkNew<vtkPolyData> surface;
    SetSurface(surface, stage.Surface.Positions, stage.Surface.Triangles, frame);
    vtkFieldData* figures = surface->GetFieldData();
    AddNumber(figures, "StartNumber", static_cast<long long>(stage.StartNumber));
    AddNumber(figures, "DefectScore", stage.DefectScore);
    AddNumber(figures, "UncoveredFraction", stage.Quality.UncoveredFraction);
    AddNumber(figures, "InvertedFraction", stage.Quality.InvertedFraction);
    AddNumber(figures, "FoldedFraction", stage.Quality.FoldedFraction);
    const unsigned int block = blocks->GetNumberOfBlocks();
    blocks->SetBlock(block, surface);
    const std::string name =
      std::to_string(stage.StartNumber) + " " + stage.Start + ": " + stage.Name;
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
}
}

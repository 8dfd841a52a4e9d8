#include "vtkSurfaceHarmonics.h"
#include "vtkSurfaceHarmonicsSource.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkSurfaceHarmonics> harmonics;
  harmonics->SetDegree(source.below(9));
  harmonics->SetReconstructionDegree(source.below(9));
  harmonics->SetMeshType(source.below(2));
  harmonics->SetFrequency(1 + source.below(5));
  harmonics->SetAlignment(source.below(3));
  if (source.flag())
  {
    harmonics->AddPointArray(source.flag() ? "Priority" : "Normals");
  }
  harmonics->SetInputDataObject(0, source.surface());
  fuzz::run(harmonics);

  // Its own table, or one of which a number is another.
  vtkNew<vtkTable> table;
  table->DeepCopy(harmonics->GetOutputDataObject(1));
  if (table->GetNumberOfRows() > 0 && source.flag())
  {
    table->SetValue(source.below(static_cast<int>(table->GetNumberOfRows())),
      source.below(static_cast<int>(table->GetNumberOfColumns())), source.number());
  }
  vtkNew<vtkSurfaceHarmonicsSource> surface;
  surface->SetFrequency(1 + source.below(5));
  surface->SetReconstructionDegree(source.below(9));
  surface->SetInputDataObject(0, table);
  fuzz::run(surface);

  vtkNew<vtkSurfaceHarmonics> alike;
  alike->SetDegree(source.below(5));
  alike->SetAlignment(source.below(3));
  alike->SetInputDataObject(0, source.surface());
  alike->SetInputDataObject(1, table);
  fuzz::run(alike);
  return 0;
}

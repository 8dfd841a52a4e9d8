#include "vtkGIFTIWriter.h"

#include "Files.h"
#include "vtkGIFTIReader.h"

namespace cases
{
Case GIFTIWriter()
{
  using F = vtkGIFTIWriter;
  Case all = CaseOf<F>("vtkGIFTIWriter");
  Mode surface = Writes(".surf.gii", Reading<vtkGIFTIReader>);
  surface.Properties = { Contents<F>([](F* f, int content) { f->SetContent(content); }),
    Texts<F>("AnatomicalStructure",
      { "", "CortexLeft", "</Value>]]>&<!--", std::string(100000, 'x'), "a\nb\x01\xff" },
      [](F* f, const std::string& structure)
      {
        f->SetContentToGeometry();
        f->SetAnatomicalStructure(structure);
      }) };
  const Mode sphere = WritesOther(".sphere.surf.gii", Reading<vtkGIFTIReader>, BadIds | BadMap,
    Set<F>([](F* f) { f->SetContentToSphere(); }));
  const Mode shape =
    WritesOther(".shape.gii", {}, BadIds, Set<F>([](F* f) { f->SetContentToShape(); }));
  all.Modes = { surface, sphere, shape };
  return all;
}
}

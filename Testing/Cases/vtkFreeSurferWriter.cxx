#include "vtkFreeSurferWriter.h"

#include "Files.h"
#include "vtkFreeSurferReader.h"

namespace cases
{
Case FreeSurferWriter()
{
  using F = vtkFreeSurferWriter;
  Case all = CaseOf<F>("vtkFreeSurferWriter");
  const auto content = [](int what) { return Set<F>([=](F* f) { f->SetContent(what); }); };
  Mode surface = Writes(".white", Reading<vtkFreeSurferReader>, BadIds, content(F::SURFACE));
  surface.Properties = { Contents<F>(
    [](F* f, int what)
    {
      f->SetContent(what);
      f->SetArrayName("Curvature");
    }) };
  const Mode sphere =
    WritesOther(".sphere", Reading<vtkFreeSurferReader>, BadIds | BadMap, content(F::SPHERE));
  Mode values = WritesOther(".curv", {}, BadIds, content(F::CURVATURE));
  values.Properties = { Texts<F>("ArrayName",
    { "", "no such array", "SpherePosition", std::string(100000, 'x'), "a\nb" },
    [](F* f, const std::string& name) { f->SetArrayName(name); }) };
  all.Modes = { surface, sphere, values };
  return all;
}
}

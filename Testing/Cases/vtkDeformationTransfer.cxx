#include "vtkDeformationTransfer.h"

#include "FuzzFilter.h"
#include "Motion/DeformationTransfer.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkDeformationTransfer;

std::vector<Mode> Modes()
{
  Mode target = { "target", { Surface(BadPoints | BadIds | BadMap), Good(), Good() } };
  target.IsClosed = true;
  target.Properties = { Switch("AlignRotation", &F::SetAlignRotation),
    Name("ContactArrayName", &F::SetContactArrayName) };
  const Mode source = { "source", { Good(), Surface(BadPoints | BadIds | BadMap), Good() } };
  const Mode pose = { "pose", { Good(), Good(), Surface(BadPoints | BadIds) } };
  return { target, source, pose };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> transfer;
  transfer->SetInputDataObject(0, source.surface());
  transfer->SetInputDataObject(1, source.surface());
  for (int i = 1 + source.below(2); i > 0; --i)
  {
    transfer->AddPoseData(source.surface());
  }
  transfer->SetAlignRotation(source.below(2) == 0);
  fuzz::run(transfer);
}

// Defaults of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::DeformationTransferOptions options;
  vtkNew<vtkDeformationTransfer> filter;
  return { Same("AlignRotation", filter->GetAlignRotation(), options.AlignRotation) };
}
}

Case DeformationTransfer()
{
  Case all = CaseOf<F>("vtkDeformationTransfer");
  all.Modes = Modes();
  all.Scaled = { Scaled<F>("Transfers",
    [](F* f, double scale)
    {
      const SurfacePointer source = BumpyMesh(scale, 7);
      const auto pose = vtkSmartPointer<vtkPolyData>::New();
      pose->DeepCopy(source);
      for (vtkIdType i = 0; i < pose->GetNumberOfPoints(); ++i)
      {
        double p[3];
        pose->GetPoint(i, p);
        pose->GetPoints()->SetPoint(i, 1.5 * p[0], p[1], p[2]);
      }
      f->SetInputData(BumpyMesh(scale, 5));
      f->SetSourceData(source);
      f->SetPoseData(pose);
    }) };
  all.Progress = { { "a head",
    []() -> Maker
    {
      const SurfacePointer target = Head(60), source = Head(80);
      return [=]() -> Algorithm
      {
        const auto filter = vtkSmartPointer<F>::New();
        filter->SetInputData(target);
        filter->SetSourceData(source);
        filter->SetPoseData(source);
        return filter;
      };
    } } };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}

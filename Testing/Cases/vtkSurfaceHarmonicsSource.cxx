#include "vtkSurfaceHarmonicsSource.h"

#include "Properties.h"
#include "Surfaces.h"
#include "vtkSurfaceHarmonics.h"

#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>

namespace cases
{
namespace
{
using F = vtkSurfaceHarmonicsSource;

void Rebuild(F* f, double scale)
{
  vtkNew<vtkSurfaceHarmonics> harmonics;
  harmonics->SetInputData(BumpyMesh(1.0, 9));
  harmonics->SetDegree(6);
  harmonics->Update();
  vtkTable* table = harmonics->GetCoefficients();
  for (const char* name : { "X", "Y", "Z" })
  {
    auto* column = vtkDoubleArray::SafeDownCast(table->GetColumnByName(name));
    for (vtkIdType i = 0; i < column->GetNumberOfValues(); ++i)
    {
      // In steps that leave room for small units.
      column->SetValue(i, scale * std::round(0x1p20 * column->GetValue(i)) * 0x1p-20);
    }
  }
  f->SetInputData(table);
  f->SetFrequency(6);
}
}

Case SurfaceHarmonicsSource()
{
  Case all = CaseOf<F>("vtkSurfaceHarmonicsSource");
  Mode mode = { "", {},
    SetWith<F>(
      [](F* f, vtkPolyData* good)
      {
        vtkNew<vtkSurfaceHarmonics> harmonics;
        harmonics->SetInputData(good);
        harmonics->SetDegree(4);
        f->SetInputConnection(harmonics->GetOutputPort(1));
      }),
    true };
  mode.Properties = { Integer("Frequency", &F::SetFrequency),
    Integer("ReconstructionDegree", &F::SetReconstructionDegree) };
  all.Modes = { mode };
  all.Scaled = { Scaled<F>("Rebuilds", Rebuild) };
  all.Progress = { { "degree 30",
    []() -> Maker
    {
      vtkNew<vtkSurfaceHarmonics> harmonics;
      harmonics->SetInputData(Head(20));
      harmonics->SetDegree(30);
      harmonics->Update();
      const vtkSmartPointer<vtkTable> table = harmonics->GetCoefficients();
      return [=]() -> Algorithm
      {
        const auto source = vtkSmartPointer<F>::New();
        source->SetInputData(table);
        source->SetFrequency(100);
        return source;
      };
    } } };
  return all;
}
}

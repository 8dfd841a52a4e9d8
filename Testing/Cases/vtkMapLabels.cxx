#include "vtkMapLabels.h"

#include "Projections.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
// A map of columns of labels, each four pixels wide.
vtkSmartPointer<vtkImageData> Columns(int width)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, width / 2, 1);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Cells");
  labels->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    labels->SetValue(i, static_cast<int>(i % width / 4));
  }
  image->GetPointData()->SetScalars(labels);
  return image;
}
}

Case MapLabels()
{
  using F = vtkMapLabels;
  Case all = CaseOf<F>("vtkMapLabels");
  Mode labels = { "", { Surface(BadPoints | BadIds | BadMap), Picture("vtkMapLabels labels") } };
  labels.Properties = { Name("ArrayName", &F::SetArrayName),
    Integer("Projection", &F::SetProjection), Number("CentralLongitude", &F::SetCentralLongitude),
    Number("CapsuleAspect", &F::SetCapsuleAspect) };
  labels.WritesAreas = true;
  all.Modes = { labels };
  all.Scaled = { Scaled<F>(
    "MeasuresLabels",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale));
      f->SetLabelsData(Columns(24));
    },
    { { "Area", 2 }, { "Perimeter", 1 }, { "CentroidX", 1 }, { "CentroidY", 1 },
      { "CentroidZ", 1 } },
    1e-7) };
  all.Progress = { Run<F>(
    "columns", []() { return BumpyMesh(1.0, 60); }, [](F* f) { f->SetLabelsData(Columns(400)); }) };
  all.Mirrors = ProjectionMirrors<F>;
  return all;
}
}

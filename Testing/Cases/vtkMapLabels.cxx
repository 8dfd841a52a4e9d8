#include "vtkMapLabels.h"

#include "FuzzFilter.h"
#include "Projections.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

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

// Take the first component of a color picture, as pictures for all classes are. Labels have one.
void TakeFirstComponent(vtkAlgorithm* filter)
{
  auto* picture = vtkImageData::SafeDownCast(filter->GetInputDataObject(1, 0));
  vtkDataArray* colors = picture ? picture->GetPointData()->GetScalars() : nullptr;
  if (!colors || colors->GetNumberOfComponents() != 3)
  {
    return;
  }
  const auto labels = vtkSmartPointer<vtkDataArray>::Take(colors->NewInstance());
  labels->SetName(colors->GetName());
  labels->SetNumberOfTuples(colors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    labels->SetComponent(i, 0, colors->GetComponent(i, 0));
  }
  vtkNew<vtkImageData> gray;
  gray->ShallowCopy(picture);
  gray->GetPointData()->SetScalars(labels);
  filter->SetInputDataObject(1, gray);
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<vtkMapLabels> filter;
  FuzzProjection(filter.Get(), source);
  filter->SetInputDataObject(0, source.surface());
  filter->SetInputDataObject(1, source.picture());
  TakeFirstComponent(filter);
  fuzz::run(filter);
}
}

Case MapLabels()
{
  using F = vtkMapLabels;
  Case all = CaseOf<F>("vtkMapLabels");
  Mode labels = { "", { Surface(BadPoints | BadIds | BadMap), Picture("vtkMapLabels labels") } };
  labels.Set = [](vtkAlgorithm* filter, vtkPolyData*) { TakeFirstComponent(filter); };
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
  all.Fuzz = Fuzz;
  all.Mirrors = ProjectionMirrors<F>;
  return all;
}
}

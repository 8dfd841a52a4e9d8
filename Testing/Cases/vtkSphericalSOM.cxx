#include "vtkSphericalSOM.h"

#include "FuzzFilter.h"
#include "Learn/Batch/SphericalSOM.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <string>

namespace cases
{
namespace
{
using F = vtkSphericalSOM;

// The coordinates of points as columns X, Y and Z.
vtkSmartPointer<vtkTable> TableOf(vtkPolyData* surface)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (int c = 0; c < 3; ++c)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(std::string(1, static_cast<char>('X' + c)).c_str());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      column->InsertNextValue(surface->GetPoint(i)[c]);
    }
    table->AddColumn(column);
  }
  return table;
}
}

namespace
{
std::vector<Mirror> Mirrors()
{
  const conformal::SphericalSOMOptions options;
  vtkNew<F> filter;
  return { Same("NumberOfNeurons", filter->GetNumberOfNeurons(), options.NumberOfNeurons),
    Same("Standardize", filter->GetStandardize(), options.Standardize),
    Same("RandomSeed", static_cast<unsigned int>(filter->GetRandomSeed()), options.RandomSeed) };
}
}

Case SphericalSOM()
{
  Case all = CaseOf<F>("vtkSphericalSOM");
  Mode mode = { "", {}, SetWith<F>([](F* f, vtkPolyData* good) { f->SetInputData(TableOf(good)); }),
    true };
  mode.IsUnitless = true;
  mode.Properties = { Integer("NumberOfNeurons", &F::SetNumberOfNeurons),
    Integer("RandomSeed", &F::SetRandomSeed), Switch("Standardize", &F::SetStandardize),
    Name("LabelColumn", &F::SetLabelColumn), Name("Columns", &F::AddColumn) };
  all.Modes = { mode };
  all.Scaled = { Scaled<F>("LearnsRows",
    [](F* f, double scale)
    {
      f->SetInputData(TableOf(BumpyCloud(scale, 500)));
      f->StandardizeOff();
    },
    { { "Points", 0 }, { "X", 1 }, { "Y", 1 }, { "Z", 1 }, { "UMatrix", 1 },
      { "QuantizationError", 1 } }) };
  all.Progress = { { "many rows",
    []() -> Maker
    {
      const auto table = TableOf(Head(60));
      return [=]() -> Algorithm
      {
        const auto som = vtkSmartPointer<F>::New();
        som->SetInputData(table);
        som->SetNumberOfNeurons(1002);
        return som;
      };
    } } };
  all.Mirrors = Mirrors;
  all.Fuzz = [](fuzz::FilterSource& source)
  {
    vtkNew<F> filter;
    vtkNew<vtkTable> table;
    table->GetRowData()->ShallowCopy(source.surface()->GetPointData());
    filter->SetInputData(table);
    filter->SetStandardize(source.below(2) == 0);
    fuzz::run(filter);
  };
  return all;
}
}

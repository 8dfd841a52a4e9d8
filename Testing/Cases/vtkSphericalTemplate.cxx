#include "vtkSphericalTemplate.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Register/ShapeModes.h"
#include "Register/SphericalTemplate.h"
#include "Surfaces.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalTemplate;

std::vector<Mode> Modes()
{
  // The output has the surfaces' own polygons, as they are oriented.
  Mode whole = { "", { Surface(BadPoints | BadIds | BadMap) },
    SetWith<F>(
      [](F* f, vtkPolyData* good)
      {
        f->AddInputDataObject(good);
        f->SetFrequency(8);
        f->SetMeanFrequency(8);
        f->SetMaximumNumberOfRounds(1);
      }) };
  whole.TakesMore = true;
  whole.IsSlow = true;
  whole.Properties = { Integer("MaximumNumberOfRounds", &F::SetMaximumNumberOfRounds),
    Integer("MeanFrequency", &F::SetMeanFrequency), Integer("Frequency", &F::SetFrequency),
    Number("Tolerance", &F::SetTolerance), Integer("Alignment", &F::SetAlignment),
    Number("ShapeWeight", &F::SetShapeWeight), Number("StretchWeight", &F::SetStretchWeight),
    Name("LandmarkArrayName", &F::SetLandmarkArrayName),
    Values<F, double>(
      "feature", ExtremeValues(), [](F* f, double value) { f->AddFeature("Weights", value); }) };
  Mode single = { "single", { Surface(BadIds | BadMap) } };
  single.ResultOfMap = "SpherePosition";
  single.Properties = { Integer("MaximumNumberOfRounds", &F::SetMaximumNumberOfRounds),
    Integer("MeanFrequency", &F::SetMeanFrequency), Integer("Frequency", &F::SetFrequency) };
  return { whole, single };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> many;
  many->SetFrequency(8);
  many->SetMeanFrequency(8);
  many->SetShapeWeight(0.0);
  many->SetMaximumNumberOfRounds(source.below(3));
  many->SetAlignment(source.below(3));
  many->SetTolerance(source.number());
  for (int i = 1 + source.below(3); i > 0; --i)
  {
    many->AddInputDataObject(0, source.surface());
  }
  fuzz::run(many);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SphericalTemplateOptions options;
  vtkNew<vtkSphericalTemplate> filter;
  using conformal::ShapeAlignment;
  return { Same("MaximumNumberOfRounds", filter->GetMaximumNumberOfRounds(),
             options.MaximumNumberOfRounds),
    Same("Tolerance", filter->GetTolerance(), options.Tolerance),
    Same("Alignment", filter->GetAlignment(), static_cast<int>(options.Alignment)),
    Same("MeanFrequency", filter->GetMeanFrequency(), options.MeanFrequency),
    Same("ShapeWeight", filter->GetShapeWeight(), options.Registration.ShapeWeight),
    Same("StretchWeight", filter->GetStretchWeight(), options.Registration.StretchWeight),
    Same("Frequency", filter->GetFrequency(), options.Registration.Frequency),
    Same("NONE", vtkSphericalTemplate::NONE, static_cast<int>(ShapeAlignment::None)),
    Same("RIGID", vtkSphericalTemplate::RIGID, static_cast<int>(ShapeAlignment::Rigid)),
    Same("SIMILARITY", vtkSphericalTemplate::SIMILARITY,
      static_cast<int>(ShapeAlignment::Similarity)) };
}
}

Case SphericalTemplate()
{
  Case all = CaseOf<F>("vtkSphericalTemplate");
  all.Modes = Modes();
  all.Scaled = { Scaled<F>("FindsATemplate",
    [](F* f, double scale)
    {
      f->AddInputDataObject(BumpyMesh(scale, 7));
      f->AddInputDataObject(BumpyMesh(scale, 5));
      f->SetFrequency(8);
      f->SetMeanFrequency(8);
      f->SetMaximumNumberOfRounds(1);
      f->SetShapeWeight(0.0);
    }) };
  all.Progress = { { "two surfaces",
    []() -> Maker
    {
      const SurfacePointer head = Head(12), coarse = Head(8);
      return [=]() -> Algorithm
      {
        const auto filter = vtkSmartPointer<F>::New();
        for (vtkPolyData* surface : { head.Get(), coarse.Get() })
        {
          filter->AddInputDataObject(surface);
        }
        filter->SetMaximumNumberOfRounds(1);
        filter->SetFrequency(8);
        filter->SetMeanFrequency(8);
        return filter;
      };
    } } };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}

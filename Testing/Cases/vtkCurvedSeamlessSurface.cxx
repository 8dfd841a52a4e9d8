#include "vtkCurvedSeamlessSurface.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Surface/CurvedSeamlessSurface.h"
#include "Surfaces.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkCurvedSeamlessSurface;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

Mode DomeMode(const char* name, const Port& port, int height, int seam)
{
  return { name, { port },
    Set<F>(
      [=](F* f)
      {
        f->SetFrequency(6);
        f->SetDomeHeight(height);
        f->SetSeamMode(seam);
      }),
    true };
}

std::vector<Mode> Modes()
{
  Mode curvature = DomeMode("Curvature", Surface(Reads), F::CURVATURE, F::EDGE_MATCHED);
  curvature.ResultOfMap = "Normals";
  curvature.Properties = { Integer("Frequency", &F::SetFrequency),
    Integer("Sampling", &F::SetSampling), Integer("Subdivisions", &F::SetSubdivisions),
    Integer("SeamMode", &F::SetSeamMode), Integer("DomeHeight", &F::SetDomeHeight),
    Number("VertexShift", &F::SetVertexShift) };
  Mode fitted = { "Fitted",
    { Surface(Reads), Nothing(), Surface(BadPoints, "Fitted to the cloud") },
    Set<F>(
      [](F* f)
      {
        f->SetFrequency(6);
        f->SetDomeHeightToFitted();
        f->SetNumberOfFitRounds(2);
      }),
    true };
  fitted.MixesUnits = true;
  fitted.Properties = { Integer("NumberOfFitRounds", &F::SetNumberOfFitRounds),
    Number("FitSmoothness", &F::SetFitSmoothness), Number("VertexShift", &F::SetVertexShift) };
  const Mode network = { "Network", { Surface(Reads) },
    Set<F>(
      [](F* f)
      {
        f->SetSamplingToNetwork();
        f->SetSubdivisions(2);
      }),
    true };
  const Mode onSphere = { "on the sphere", { Good(), Surface(BadIds) } };
  return { curvature, DomeMode("flat", Variant(Reads), F::NONE, F::EDGE_MATCHED),
    DomeMode("Published", Surface(Reads), F::PUBLISHED, F::PER_TRIANGLE),
    DomeMode("Scaled", Variant(Reads), F::SCALED, F::EDGE_MATCHED),
    DomeMode("Curvature, per triangle", Variant(Reads), F::CURVATURE, F::PER_TRIANGLE), fitted,
    network, onSphere };
}

std::vector<ScaledRun> ScaledRuns()
{
  std::vector<ScaledRun> runs;
  for (int height = F::NONE; height <= F::FITTED; ++height)
  {
    for (const int seam : { F::PER_TRIANGLE, F::EDGE_MATCHED })
    {
      runs.push_back(Scaled<F>("Curves" + std::to_string(height) + std::to_string(seam),
        [=](F* f, double scale)
        {
          f->SetInputData(BumpyMesh(scale));
          f->SetCloudData(BumpyCloud(scale));
          f->SetFrequency(9);
          f->SetDomeHeight(height);
          f->SetSeamMode(seam);
        }));
    }
  }
  runs.push_back(Scaled<F>("CurvesWhereASphereSays",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale));
      const SurfacePointer sphere = BumpyMesh(scale, 4); // seen from the origin, which is inside
      sphere->GetPointData()->Initialize();
      f->SetSphereData(sphere);
    }));
  return runs;
}

std::vector<ProgressRun> ProgressRuns()
{
  const auto mesh = []() { return Head(36); };
  const auto fine = []() { return Head(100); };
  const auto frequency = [](int f) { return [f](F* css) { css->SetFrequency(f); }; };
  std::vector<ProgressRun> runs = { Run<F>("coarse mesh", mesh, frequency(120)),
    Run<F>("fine mesh", fine, frequency(60)),
    Run<F>("EdgeMatched", mesh,
      [](F* css)
      {
        css->SetFrequency(100);
        css->SetSeamModeToEdgeMatched();
      }) };
  for (int height = F::NONE; height <= F::CURVATURE; ++height)
  {
    const auto domes = [height](int f)
    {
      return [=](F* css)
      {
        css->SetFrequency(f);
        css->SetDomeHeight(height);
        css->SetSeamModeToPerTriangle();
      };
    };
    const std::string name = "PerTriangle " + std::to_string(height);
    runs.push_back(Run<F>(name, mesh, domes(150)));
    runs.push_back(Run<F>(name + " of a fine mesh", fine, domes(60)));
  }
  const auto cut = [](int subdivisions)
  {
    return [=](F* css)
    {
      css->SetSamplingToNetwork();
      css->SetSubdivisions(subdivisions);
    };
  };
  runs.push_back(Run<F>("Network", mesh, cut(5)));
  runs.push_back(Run<F>("Network of a fine mesh", fine, cut(1)));
  runs.push_back({ "Fitted",
    []() -> Maker
    {
      const SurfacePointer network = Head(20), cloud = Head(80);
      return [=]() -> Algorithm
      {
        const auto css = vtkSmartPointer<F>::New();
        css->SetInputData(network);
        css->SetFrequency(100);
        css->SetDomeHeightToFitted();
        css->SetCloudData(cloud);
        return css;
      };
    } });
  return runs;
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> surface;
  surface->SetFrequency(1 + source.below(4));
  surface->SetSeamMode(source.below(2));
  surface->SetDomeHeight(source.below(5));
  surface->SetNumberOfFitRounds(source.below(3));
  const int odd = source.byte();
  if (odd & 1)
  {
    surface->SetVertexShift(source.number());
    surface->SetFitSmoothness(source.number());
  }
  surface->SetInputDataObject(0, source.surface());
  if (odd & 2)
  {
    surface->SetInputDataObject(2, source.surface());
  }
  const bool hasSphere = (odd & 12) == 12;
  if (hasSphere)
  {
    surface->SetInputDataObject(1, source.surface());
  }
  fuzz::run(surface, !hasSphere);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::CurvedSeamlessSurfaceOptions options;
  vtkNew<vtkCurvedSeamlessSurface> filter;
  using conformal::DomeHeight;
  using conformal::SeamMode;
  return { Same("SeamMode", filter->GetSeamMode(), static_cast<int>(options.SeamMode)),
    Same("DomeHeight", filter->GetDomeHeight(), static_cast<int>(options.DomeHeight)),
    Same("VertexShift", filter->GetVertexShift(), -1.0),
    Same("NumberOfFitRounds", filter->GetNumberOfFitRounds(), options.Fit.NumberOfFitRounds),
    Same("FitSmoothness", filter->GetFitSmoothness(), options.Fit.FitSmoothness),
    Same("PER_TRIANGLE", vtkCurvedSeamlessSurface::PER_TRIANGLE,
      static_cast<int>(SeamMode::PerTriangle)),
    Same("EDGE_MATCHED", vtkCurvedSeamlessSurface::EDGE_MATCHED,
      static_cast<int>(SeamMode::EdgeMatched)),
    Same("NONE", vtkCurvedSeamlessSurface::NONE, static_cast<int>(DomeHeight::None)),
    Same("PUBLISHED", vtkCurvedSeamlessSurface::PUBLISHED, static_cast<int>(DomeHeight::Published)),
    Same("SCALED", vtkCurvedSeamlessSurface::SCALED, static_cast<int>(DomeHeight::Scaled)),
    Same("CURVATURE", vtkCurvedSeamlessSurface::CURVATURE, static_cast<int>(DomeHeight::Curvature)),
    Same("FITTED", vtkCurvedSeamlessSurface::FITTED, static_cast<int>(DomeHeight::Fitted)) };
}
}

Case CurvedSeamlessSurface()
{
  Case all = CaseOf<F>("vtkCurvedSeamlessSurface");
  all.Modes = Modes();
  all.Scaled = ScaledRuns();
  all.Progress = ProgressRuns();
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}

#include "vtkSphericalMorph.h"

#include "FuzzFilter.h"
#include "Mesh/GeodesicSphere.h"
#include "Properties.h"
#include "Register/ConsistentRemesh.h"
#include "Register/SphericalMorph.h"
#include "Sphere/AdaptiveSphere.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalMorph;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

Setter Morphs(int path, int meshType)
{
  return Set<F>(
    [=](F* f)
    {
      f->SetPath(path);
      f->SetMeshType(meshType);
      f->SetFrequency(6);
      f->SetNumberOfPoints(500);
    });
}

std::vector<Mode> Modes()
{
  Mode linear = { "Linear", { Surface(Reads), Good() }, Morphs(F::LINEAR, F::GEODESIC), true };
  linear.ResultOfMap = "SpherePosition";
  linear.Properties = { Number("MorphFactor", &F::SetMorphFactor), Integer("Path", &F::SetPath),
    Integer("MeshType", &F::SetMeshType), Integer("Frequency", &F::SetFrequency),
    Switch("GenerateTimeSteps", &F::SetGenerateTimeSteps),
    Integer("NumberOfTimeSteps", &F::SetNumberOfTimeSteps),
    Values<F, double>("weight", ExtremeValues(),
      [](F* f, double weight)
      {
        f->AddWeight(weight);
        f->AddWeight(1.0);
      }) };
  Mode adaptive = { "Rigid, Adaptive", { Surface(Reads), Good() }, Morphs(F::RIGID, F::ADAPTIVE),
    true };
  adaptive.Properties = { Integer("NumberOfPoints", &F::SetNumberOfPoints) };
  const Mode target = { "target", { Good(), Surface(Reads) }, Morphs(F::RIGID, F::GEODESIC), true };
  return { linear, adaptive, target };
}

ScaledRun MorphsScaled(const char* name, int path)
{
  return Scaled<F>(name,
    [=](F* f, double scale)
    {
      const SurfacePointer target = BumpyMesh(scale, 5);
      for (vtkIdType i = 0; i < target->GetNumberOfPoints(); ++i)
      {
        double p[3];
        target->GetPoint(i, p);
        target->GetPoints()->SetPoint(i, p[1], p[2], p[0]);
      }
      f->SetInputData(BumpyMesh(scale, 7));
      f->SetTargetData(target);
      f->SetPath(path);
      f->SetMeshTypeToGeodesic();
      f->SetFrequency(6);
    });
}

ProgressRun MorphsOn(const std::string& name, bool isFine, int path, int meshType)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer source = Colored(Head(isFine ? 50 : 30));
      const SurfacePointer target = isFine ? source : Colored(Limbs(30));
      return [=]() -> Algorithm
      {
        const auto morph = vtkSmartPointer<F>::New();
        morph->SetInputData(source);
        morph->SetTargetData(target);
        morph->SetMeshType(meshType);
        morph->SetPath(path);
        morph->SetFrequency(30);
        morph->SetNumberOfPoints(10000);
        return morph;
      };
    } };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> morph;
  morph->SetInputDataObject(0, source.surface());
  morph->SetInputDataObject(1, source.surface());
  morph->SetMorphFactor(source.number());
  morph->SetPath(source.below(2));
  morph->SetMeshType(source.below(2));
  morph->SetFrequency(1 + source.below(4));
  morph->SetNumberOfPoints(500 + 4 * source.byte());
  fuzz::run(morph);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SphericalMorphOptions options;
  const conformal::ConsistentRemeshOptions remesh;
  vtkNew<vtkSphericalMorph> filter;
  using Limits = conformal::AdaptiveSphereLimits;
  using conformal::MorphPath;
  using conformal::RemeshMeshType;
  return { Same("Path", filter->GetPath(), static_cast<int>(options.Path)),
    Same("MeshType", filter->GetMeshType(), static_cast<int>(remesh.MeshType)),
    Same("Frequency", filter->GetFrequency(), remesh.Frequency),
    Same("NumberOfPoints", filter->GetNumberOfPoints(), remesh.NumberOfPoints),
    { "FrequencyMaxValue", filter->GetFrequencyMaxValue() <= conformal::MaximumFrequency },
    Same("NumberOfPointsMinValue", filter->GetNumberOfPointsMinValue(), Limits::MinimumPoints),
    Same("NumberOfPointsMaxValue", filter->GetNumberOfPointsMaxValue(), Limits::MaximumPoints),
    Same("LINEAR", vtkSphericalMorph::LINEAR, static_cast<int>(MorphPath::Linear)),
    Same("RIGID", vtkSphericalMorph::RIGID, static_cast<int>(MorphPath::Rigid)),
    Same("GEODESIC", vtkSphericalMorph::GEODESIC, static_cast<int>(RemeshMeshType::Geodesic)),
    Same("ADAPTIVE", vtkSphericalMorph::ADAPTIVE, static_cast<int>(RemeshMeshType::Adaptive)) };
}
}

Case SphericalMorph()
{
  Case all = CaseOf<F>("vtkSphericalMorph");
  all.Modes = Modes();
  all.Scaled = { MorphsScaled("MorphsStraight", F::LINEAR),
    MorphsScaled("MorphsByTurning", F::RIGID) };
  for (const int path : { F::LINEAR, F::RIGID })
  {
    for (const int meshType : { F::GEODESIC, F::ADAPTIVE })
    {
      const std::string name = std::to_string(path) + std::to_string(meshType);
      all.Progress.push_back(MorphsOn(name, false, path, meshType));
      all.Progress.push_back(MorphsOn(name + ", fine meshes", true, path, meshType));
    }
  }
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}

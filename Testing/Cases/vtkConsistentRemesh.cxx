#include "vtkConsistentRemesh.h"

#include "FuzzFilter.h"
#include "Mesh/GeodesicSphere.h"
#include "Properties.h"
#include "Register/ConsistentRemesh.h"
#include "Register/ShapeModes.h"
#include "Sphere/AdaptiveSphere.h"
#include "Surfaces.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkConsistentRemesh;

Mode MeshTypeMode(const char* name, int meshType)
{
  Mode mode = { name, { Surface(BadPoints | BadIds | BadMap) },
    SetWith<F>(
      [=](F* f, vtkPolyData* good)
      {
        f->AddInputDataObject(good);
        f->SetMeshType(meshType);
        f->SetFrequency(6);
        f->SetNumberOfPoints(500);
      }) };
  mode.TakesMore = true;
  return mode;
}

void Remesh(F* f, double scale)
{
  const SurfacePointer other = BumpyMesh(scale, 5);
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
  {
    double p[3];
    other->GetPoint(i, p);
    other->GetPoints()->SetPoint(i, p[0], p[1], 0.75 * p[2]);
  }
  f->AddInputDataObject(BumpyMesh(scale, 7));
  f->AddInputDataObject(other);
  f->SetMeshTypeToGeodesic();
  f->SetFrequency(6);
}

ProgressRun RemeshesOn(const std::string& name, bool isFine, int meshType)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer fine = Colored(Head(80)), head = Colored(Head(40)),
                           limbs = Colored(Limbs(40));
      const std::vector<SurfacePointer> inputs = isFine
        ? std::vector<SurfacePointer>{ fine, fine }
        : std::vector<SurfacePointer>{ head, limbs };
      return [=]() -> Algorithm
      {
        const auto remesh = vtkSmartPointer<F>::New();
        for (vtkPolyData* input : inputs)
        {
          remesh->AddInputDataObject(input);
        }
        remesh->SetMeshType(meshType);
        return remesh;
      };
    } };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> remesh;
  for (int i = 1 + source.below(3); i > 0; --i)
  {
    remesh->AddInputDataObject(source.surface());
  }
  remesh->SetMeshType(source.below(2));
  remesh->SetFrequency(1 + source.below(4));
  remesh->SetNumberOfPoints(500 + 4 * source.byte());
  remesh->SetAlignment(source.below(3));
  remesh->SetAlignBlocks(source.flag());
  remesh->SetMeanType(source.below(2));
  remesh->SetNumberOfModes(source.below(4));
  fuzz::run(remesh);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::ConsistentRemeshOptions remesh;
  const conformal::ShapeModesOptions options;
  vtkNew<vtkConsistentRemesh> filter;
  using Limits = conformal::AdaptiveSphereLimits;
  using conformal::RemeshMeshType;
  using conformal::ShapeAlignment;
  return { Same("MeshType", filter->GetMeshType(), static_cast<int>(remesh.MeshType)),
    Same("Frequency", filter->GetFrequency(), remesh.Frequency),
    Same("NumberOfPoints", filter->GetNumberOfPoints(), remesh.NumberOfPoints),
    Same("Alignment", filter->GetAlignment(), static_cast<int>(options.Alignment)),
    Same("NumberOfModes", filter->GetNumberOfModes(), options.NumberOfModes),
    { "FrequencyMaxValue", filter->GetFrequencyMaxValue() <= conformal::MaximumFrequency },
    Same("NumberOfPointsMinValue", filter->GetNumberOfPointsMinValue(), Limits::MinimumPoints),
    Same("NumberOfPointsMaxValue", filter->GetNumberOfPointsMaxValue(), Limits::MaximumPoints),
    Same("GEODESIC", vtkConsistentRemesh::GEODESIC, static_cast<int>(RemeshMeshType::Geodesic)),
    Same("ADAPTIVE", vtkConsistentRemesh::ADAPTIVE, static_cast<int>(RemeshMeshType::Adaptive)),
    Same("NONE", vtkConsistentRemesh::NONE, static_cast<int>(ShapeAlignment::None)),
    Same("RIGID", vtkConsistentRemesh::RIGID, static_cast<int>(ShapeAlignment::Rigid)),
    Same("SIMILARITY", vtkConsistentRemesh::SIMILARITY,
      static_cast<int>(ShapeAlignment::Similarity)) };
}
}

Case ConsistentRemesh()
{
  Case all = CaseOf<F>("vtkConsistentRemesh");
  Mode geodesic = MeshTypeMode("Geodesic", F::GEODESIC);
  geodesic.ResultOfMap = "SpherePosition";
  geodesic.Properties = { Integer("MeshType", &F::SetMeshType),
    Integer("Frequency", &F::SetFrequency), Integer("Alignment", &F::SetAlignment),
    Switch("AlignBlocks", &F::SetAlignBlocks), Integer("MeanType", &F::SetMeanType),
    Integer("NumberOfModes", &F::SetNumberOfModes) };
  Mode adaptive = MeshTypeMode("Adaptive", F::ADAPTIVE);
  adaptive.Properties = { Integer("NumberOfPoints", &F::SetNumberOfPoints) };
  all.Modes = { geodesic, adaptive };
  all.Scaled = { Scaled<F>("RemeshesAlike", Remesh, { { "ShapeMode1", 1 } }) };
  for (const int meshType : { F::GEODESIC, F::ADAPTIVE })
  {
    const std::string name = std::to_string(meshType);
    all.Progress.push_back(RemeshesOn(name, false, meshType));
    all.Progress.push_back(RemeshesOn(name + ", fine meshes", true, meshType));
  }
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}

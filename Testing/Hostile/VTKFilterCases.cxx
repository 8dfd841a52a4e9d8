#include "SetUps.h"

#include "vtkButterflySubdivisionFilter.h"
#include "vtkCurvatures.h"
#include "vtkDelaunay3D.h"
#include "vtkHausdorffDistancePointSetFilter.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkMeshQuality.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmoothPolyDataFilter.h"
#include "vtkSurfaceReconstructionFilter.h"
#include "vtkTextureMapToSphere.h"
#include "vtkWindowedSincPolyDataFilter.h"

namespace hostile
{
namespace
{
template <typename Filter>
SetUp Of(const char* name, const std::function<void(Filter*)>& set = {})
{
  return { name, "", false,
    [=](vtkDataObject* input, vtkPolyData*) -> vtkSmartPointer<vtkAlgorithm>
    {
      auto filter = vtkSmartPointer<Filter>::New();
      filter->SetInputDataObject(0, input);
      if (set)
      {
        set(filter);
      }
      return filter;
    },
    BadPoints | BadIds };
}

SetUp Hausdorff(int port, const char* mode)
{
  return { "vtkHausdorffDistancePointSetFilter", mode, false,
    [=](vtkDataObject* input, vtkPolyData* good) -> vtkSmartPointer<vtkAlgorithm>
    {
      auto filter = vtkSmartPointer<vtkHausdorffDistancePointSetFilter>::New();
      filter->SetInputDataObject(port, input);
      filter->SetInputDataObject(1 - port, good);
      filter->SetTargetDistanceMethodToPointToCell();
      return filter;
    },
    BadPoints | BadIds, false, true };
}
}

//------------------------------------------------------------------------------
std::vector<Case> VTKFilterCases()
{
  // Surfaces from points; smooth surfaces; texture coordinates; distances; checks and measures.
  SetUp delaunay = Of<vtkDelaunay3D>("vtkDelaunay3D");
  delaunay.Properties = { Number("Alpha", &vtkDelaunay3D::SetAlpha),
    Number("Tolerance", &vtkDelaunay3D::SetTolerance),
    Number("Offset", &vtkDelaunay3D::SetOffset) };
  SetUp reconstruction = Of<vtkSurfaceReconstructionFilter>("vtkSurfaceReconstructionFilter");
  reconstruction.Properties = { Integer("NeighborhoodSize",
                                  &vtkSurfaceReconstructionFilter::SetNeighborhoodSize),
    Number("SampleSpacing", &vtkSurfaceReconstructionFilter::SetSampleSpacing) };
  SetUp smooth = Of<vtkSmoothPolyDataFilter>("vtkSmoothPolyDataFilter");
  smooth.Properties = { Integer(
                          "NumberOfIterations", &vtkSmoothPolyDataFilter::SetNumberOfIterations),
    Number("RelaxationFactor", &vtkSmoothPolyDataFilter::SetRelaxationFactor),
    Number("Convergence", &vtkSmoothPolyDataFilter::SetConvergence) };
  SetUp sinc = Of<vtkWindowedSincPolyDataFilter>("vtkWindowedSincPolyDataFilter");
  sinc.Properties = { Integer("NumberOfIterations",
                        &vtkWindowedSincPolyDataFilter::SetNumberOfIterations),
    Number("PassBand", &vtkWindowedSincPolyDataFilter::SetPassBand) };
  SetUp texture = Of<vtkTextureMapToSphere>(
    "vtkTextureMapToSphere", [](vtkTextureMapToSphere* f) { f->AutomaticSphereGenerationOff(); });
  texture.Properties = { Vector3("Center", &vtkTextureMapToSphere::SetCenter) };
  SetUp automatic = Of<vtkTextureMapToSphere>("vtkTextureMapToSphere");
  automatic.Mode = "automatic";

  std::vector<Input> inputs = Meshes();
  for (const std::vector<Input>& more : { Arrays(), Scales() })
  {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  std::vector<Case> all;
  for (const SetUp& setUp :
    { delaunay, reconstruction, smooth, sinc,
      Of<vtkLoopSubdivisionFilter>("vtkLoopSubdivisionFilter"),
      Of<vtkButterflySubdivisionFilter>("vtkButterflySubdivisionFilter"), texture, automatic,
      Hausdorff(0, "first"), Hausdorff(1, "second"), Of<vtkPolyDataNormals>("vtkPolyDataNormals"),
      Of<vtkCurvatures>("vtkCurvatures"), Of<vtkMeshQuality>("vtkMeshQuality") })
  {
    AddCases(all, setUp, inputs);
    AddPropertyCases(all, setUp);
  }
  return all;
}
}

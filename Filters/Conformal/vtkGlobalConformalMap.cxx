#include "vtkGlobalConformalMap.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "SphereMap/GlobalConformalMap.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkGlobalConformalMap);

namespace
{
void AddFigures(vtkFieldData* data, const conformal::GlobalConformalMapResult& map)
{
  using glue::AddNumber;
  AddNumber(data, "Energy", map.Energy);
  AddNumber(data, "NumberOfIterations", static_cast<long long>(map.NumberOfIterations));
  AddNumber(data, "Converged", static_cast<long long>(map.Converged));
  AddNumber(data, "NumberOfFlippedTriangles", static_cast<long long>(map.NumberOfFlippedTriangles));
  AddNumber(data, "SphereMapTier", static_cast<long long>(map.Tier));
  AddNumber(data, "NumberOfNegativeStringConstants",
    static_cast<long long>(map.NumberOfNegativeStringConstants));
  AddNumber(data, "NumberOfInfiniteStringConstants",
    static_cast<long long>(map.NumberOfInfiniteStringConstants));
}

void WarnOf(vtkGlobalConformalMap* self, const conformal::GlobalConformalMapResult& map)
{
  const bool published = self->GetMethod() == vtkGlobalConformalMap::GUYAU;
  if (map.NumberOfInfiniteStringConstants > 0)
  {
    vtkWarningWithObjectMacro(
      self, << map.NumberOfInfiniteStringConstants << " edges belong to triangles without area; "
            << (published ? "their string constants are infinite and are left out"
                          : "they are mapped as if they had a small area"));
  }
  if (map.NumberOfFlippedTriangles > 0)
  {
    vtkWarningWithObjectMacro(self, << map.NumberOfFlippedTriangles << " triangles are flipped, "
                                    << map.NumberOfNegativeStringConstants
                                    << " string constants are negative");
  }
  else if (!map.Converged)
  {
    vtkWarningWithObjectMacro(
      self, << "the map has not converged in " << map.NumberOfIterations << " iterations");
  }
}
}

//------------------------------------------------------------------------------
int vtkGlobalConformalMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  conformal::GlobalConformalMapOptions options;
  options.Method = static_cast<conformal::GlobalConformalMethod>(this->Method);
  options.AreaBalance = this->AreaBalance;
  options.MaximumNumberOfIterations = this->MaximumNumberOfIterations;
  options.Tolerance = this->Tolerance;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      // Relative costs of mesh, map and output.
      conformal::Steps steps(glue::RunOf(this), { 0.08, 0.91, 0.01 });
      const auto mesh = glue::ToClosedMesh(this, surface, frame, steps.next());
      const conformal::Mesh outward = glue::Outward(mesh);
      const conformal::GlobalConformalMapResult map =
        conformal::globalConformalMap(outward, options, steps.next());
      steps.next();
      glue::PassClosedMesh(surface, mesh, frame, output);
      glue::AddVectors(output->GetPointData(), glue::SpherePositionName(), map.Positions);
      AddFigures(output->GetFieldData(), map);
      WarnOf(this, map);
    });
}

//------------------------------------------------------------------------------
void vtkGlobalConformalMap::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const methods[] = { "Robust", "GuYau" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << methods[this->Method] << "\n";
  os << indent << "AreaBalance: " << this->AreaBalance << "\n";
  os << indent << "MaximumNumberOfIterations: " << this->MaximumNumberOfIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}

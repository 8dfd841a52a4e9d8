#include "vtkGlobalConformalMap.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "SphereMap/GlobalConformalMap.h"
#include "SphereMap/SheetMap.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <utility>

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

// Map a sheet, and describe the map like that of a closed surface.
conformal::GlobalConformalMapResult MapSheet(const conformal::Mesh& sheet,
  const conformal::GlobalConformalMapOptions& options, const conformal::Run& run)
{
  if (options.Method != conformal::GlobalConformalMethod::Robust || options.AreaBalance > 0.0)
  {
    throw std::invalid_argument("a surface with a border is mapped only by Method ROBUST with "
                                "AreaBalance 0");
  }
  conformal::SheetMapResult map = conformal::mapSheet(sheet, run);
  conformal::GlobalConformalMapResult result;
  result.Positions = std::move(map.Positions);
  result.Tier = map.Repaired ? conformal::GlobalConformalTier::Repaired
                             : conformal::GlobalConformalTier::Harmonic;
  result.Energy = map.Energy;
  result.NumberOfIterations = map.NumberOfSolves;
  result.NumberOfFlippedTriangles = map.NumberOfFlippedTriangles;
  result.Converged = map.NumberOfFlippedTriangles == 0;
  result.NumberOfNegativeStringConstants = map.NumberOfNegativeStringConstants;
  result.NumberOfInfiniteStringConstants = map.NumberOfInfiniteStringConstants;
  return result;
}

void AddDiskPositions(vtkPointData* data, const conformal::Points& spherePositions)
{
  const auto disk = conformal::diskPositions(spherePositions);
  const vtkNew<vtkDoubleArray> array;
  array->SetName("DiskPosition");
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(disk.rows());
  for (conformal::Index i = 0; i < disk.size(); ++i)
  {
    array->SetValue(i, disk.data()[i]);
  }
  data->AddArray(array);
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
      const auto mesh =
        glue::ToClosedMesh(this, surface, frame, steps.next(), glue::Topology::ClosedOrSheet);
      const conformal::Mesh outward = glue::Outward(mesh);
      const conformal::GlobalConformalMapResult map = mesh.NumberOfBorders > 0
        ? MapSheet(outward, options, steps.next())
        : conformal::globalConformalMap(outward, options, steps.next());
      steps.next();
      glue::PassClosedMesh(surface, mesh, frame, output);
      glue::AddVectors(output->GetPointData(), glue::SpherePositionName(), map.Positions);
      if (mesh.NumberOfBorders > 0)
      {
        AddDiskPositions(output->GetPointData(), map.Positions);
      }
      if (mesh.NumberOfBorders > 1)
      {
        vtkWarningMacro(<< "the surface has " << mesh.NumberOfBorders << " borders; the longest is "
                        << "mapped to the circle, and the others are mapped as holes inside");
      }
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

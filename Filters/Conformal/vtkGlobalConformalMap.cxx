#include "vtkGlobalConformalMap.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "SphereMap/GlobalConformalMap.h"
#include "SphereMap/SheetMap.h"
#include "TorusMap/ConformalTorusMap.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkGlobalConformalMap);

namespace
{
const char* const DiskPositionName = "DiskPosition";

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

void RequireRobust(const conformal::GlobalConformalMapOptions& options, const std::string& surface,
  const std::string& otherwise = "")
{
  if (options.Method != conformal::GlobalConformalMethod::Robust || options.AreaBalance > 0.0)
  {
    throw std::invalid_argument(
      surface + " is mapped only by Method ROBUST with AreaBalance 0" + otherwise);
  }
}

// Remove arrays of the input that describe an earlier map of it.
void RemoveOldResults(vtkPolyData* output)
{
  for (const char* name :
    { glue::SpherePositionName(), glue::TorusPositionName(), DiskPositionName })
  {
    output->GetPointData()->RemoveArray(name);
  }
  for (const char* name : { "SphereMapTier", "TorusModulus" })
  {
    output->GetFieldData()->RemoveArray(name);
  }
  glue::RemoveDistortions(output);
}

// Map a sheet, and describe the map like that of a closed surface.
conformal::GlobalConformalMapResult MapSheet(vtkObject* self, const conformal::Mesh& sheet,
  const conformal::GlobalConformalMapOptions& options, const conformal::Run& run)
{
  RequireRobust(options, "a surface with a border",
    "; for a map to the whole sphere, close it by vtkGenusZeroRepair or vtkConformalSOM");
  conformal::SheetMapResult map = conformal::mapSheet(sheet, run);
  if (map.NumberOfEars > 0)
  {
    vtkWarningWithObjectMacro(self, << map.NumberOfEars << " triangles have all three corners on "
                                    << "the border (ears), and thus no area on the sphere; remove "
                                    << "them, or flip or split their inner edges");
  }
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

// Write the map of a surface of genus 1, and warn of its defects.
void AddTorusMap(
  vtkGlobalConformalMap* self, const conformal::ConformalTorusMapResult& map, vtkPolyData* output)
{
  using glue::AddNumber;
  RemoveOldResults(output);
  glue::AddPlanePositions(output->GetPointData(), glue::TorusPositionName(), map.Positions);
  vtkFieldData* data = output->GetFieldData();
  const double modulus[] = { map.Torus.Modulus.real(), map.Torus.Modulus.imag() };
  glue::AddTuple(data, "TorusModulus", modulus, 2);
  AddNumber(data, "Energy", map.Energy);
  AddNumber(data, "NumberOfIterations", static_cast<long long>(map.NumberOfSolves));
  AddNumber(data, "Converged", static_cast<long long>(map.NumberOfFlippedTriangles == 0));
  AddNumber(data, "NumberOfFlippedTriangles", static_cast<long long>(map.NumberOfFlippedTriangles));
  AddNumber(data, "NumberOfNegativeStringConstants",
    static_cast<long long>(map.NumberOfNegativeStringConstants));
  AddNumber(data, "NumberOfInfiniteStringConstants",
    static_cast<long long>(map.NumberOfInfiniteStringConstants));
  AddNumber(data, "MeanQuasiConformalError", map.MeanQuasiConformalError);
  AddNumber(data, "QuasiConformalError95", map.QuasiConformalError95);
  constexpr double farFromConformal = 1.5;
  if (map.NumberOfInfiniteStringConstants > 0)
  {
    vtkWarningWithObjectMacro(self, << map.NumberOfInfiniteStringConstants
                                    << " edges belong to triangles without area; they are mapped "
                                       "as if they had a small area");
  }
  if (map.NumberOfFlippedTriangles > 0)
  {
    vtkWarningWithObjectMacro(self, << map.NumberOfFlippedTriangles << " triangles are flipped on "
                                    << "the torus: parts of the surface are too small on it");
  }
  if (map.MeanQuasiConformalError > farFromConformal)
  {
    vtkWarningWithObjectMacro(self, << "the map to the torus is far from conformal: lengths in a "
                                       "triangle are scaled by factors of mean ratio "
                                    << map.MeanQuasiConformalError
                                    << "; the triangles are too large or too thin");
  }
}

conformal::ConformalTorusMapResult MapTorus(const conformal::Mesh& surface,
  const conformal::GlobalConformalMapOptions& options, const conformal::Run& run)
{
  RequireRobust(options, "a surface of genus 1");
  return conformal::mapToTorus(surface, run);
}

void WarnOf(vtkObject* self, const conformal::GlobalConformalMapResult& map, bool published)
{
  if (map.NumberOfInfiniteStringConstants > 0)
  {
    vtkWarningWithObjectMacro(
      self, << map.NumberOfInfiniteStringConstants << " edges belong to triangles without area; "
            << (published ? "their string constants are infinite and are left out, "
                            "so that Converged is 0"
                          : "they are mapped as if they had a small area"));
  }
  if (map.NumberOfFlippedTriangles > 0)
  {
    vtkWarningWithObjectMacro(self, << map.NumberOfFlippedTriangles << " triangles are flipped, "
                                    << map.NumberOfNegativeStringConstants
                                    << " string constants are negative");
  }
  else if (!map.Converged && map.NumberOfInfiniteStringConstants == 0)
  {
    vtkWarningWithObjectMacro(
      self, << "the map has not converged in " << map.NumberOfIterations << " iterations");
  }
}

// Write the map of a surface of genus zero, or of a sheet, and warn of its defects.
void AddSphereMap(vtkObject* self, const conformal::GlobalConformalMapResult& map,
  conformal::GlobalConformalMethod method, int numberOfBorders, vtkPolyData* output)
{
  RemoveOldResults(output);
  glue::ReplaceSpherePositions(output, map.Positions);
  if (numberOfBorders > 0)
  {
    glue::AddPlanePositions(
      output->GetPointData(), DiskPositionName, conformal::diskPositions(map.Positions));
  }
  if (numberOfBorders > 1)
  {
    vtkWarningWithObjectMacro(self, << "the surface has " << numberOfBorders << " borders; the "
                                    << "longest is mapped to the circle, and the others are mapped "
                                    << "as holes inside");
  }
  AddFigures(output->GetFieldData(), map);
  WarnOf(self, map, method == conformal::GlobalConformalMethod::GuYau);
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
        glue::ToClosedMesh(this, surface, frame, steps.next(), glue::Topology::Mappable);
      const conformal::Mesh outward = glue::Outward(mesh);
      if (mesh.NumberOfHandles > 0)
      {
        const conformal::ConformalTorusMapResult map = MapTorus(outward, options, steps.next());
        steps.next();
        glue::PassClosedMesh(surface, mesh, frame, output);
        AddTorusMap(this, map, output);
        return;
      }
      const conformal::GlobalConformalMapResult map = mesh.NumberOfBorders > 0
        ? MapSheet(this, outward, options, steps.next())
        : conformal::globalConformalMap(outward, options, steps.next());
      steps.next();
      glue::PassClosedMesh(surface, mesh, frame, output);
      AddSphereMap(this, map, options.Method, mesh.NumberOfBorders, output);
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

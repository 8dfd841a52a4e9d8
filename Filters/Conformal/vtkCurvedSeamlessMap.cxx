#include "vtkCurvedSeamlessMap.h"

#include "Base/CoordinateFrame.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/CurvedSurfaces.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Surface/CurvedSeamlessSurface.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCurvedSeamlessMap);

namespace
{
// Resize an array, and return its memory. Return null if there is no array.
double* Sized(vtkDoubleArray* array, int components, conformal::Index tuples)
{
  if (!array)
  {
    return nullptr;
  }
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array->GetPointer(0);
}

// Require that all arrays are distinct, and that none is the array from which they are computed.
void RequireDifferent(vtkDataArray* from, std::initializer_list<vtkDoubleArray*> arrays)
{
  for (auto array = arrays.begin(); array != arrays.end(); ++array)
  {
    if (*array && (*array == from || std::find(arrays.begin(), array, *array) != array))
    {
      throw std::invalid_argument(
        "the same array is passed twice; pass a separate array for each result");
    }
  }
}

void Empty(std::initializer_list<vtkDoubleArray*> arrays)
{
  for (vtkDoubleArray* array : arrays)
  {
    if (array)
    {
      array->SetNumberOfTuples(0);
    }
  }
}

// Fill arrays by a function. After an error, the arrays are empty.
bool FillOrEmpty(vtkObject* self, vtkDataArray* from, std::initializer_list<vtkDoubleArray*> arrays,
  const std::function<void()>& fill)
{
  return glue::ReportErrors(self,
    [&]()
    {
      RequireDifferent(from, arrays);
      Empty(arrays);
      try
      {
        fill();
      }
      catch (...)
      {
        Empty(arrays);
        throw;
      }
    });
}

// Convert the lengths in an array from the frame to the unit of the user. A null array is skipped.
void LengthsFromFrame(
  vtkDoubleArray* array, const conformal::CoordinateFrame& frame, const char* what)
{
  if (array)
  {
    glue::LengthsFromFrame(array->GetPointer(0), array->GetNumberOfValues(), frame, what);
  }
}

void AreasFromFrame(
  vtkDoubleArray* array, const conformal::CoordinateFrame& frame, const char* what)
{
  if (array)
  {
    glue::AreasFromFrame(array->GetPointer(0), array->GetNumberOfValues(), frame, what);
  }
}

conformal::Points UnitDirections(vtkDataArray* directions)
{
  conformal::Points copy;
  return conformal::unitVectors(
    glue::ViewVectors(directions, "directions", copy), "direction", glue::SMPRun());
}
}

//------------------------------------------------------------------------------
vtkCurvedSeamlessMap::vtkCurvedSeamlessMap() = default;
vtkCurvedSeamlessMap::~vtkCurvedSeamlessMap() = default;

//------------------------------------------------------------------------------
const conformal::CurvedSeamlessSurface& vtkCurvedSeamlessMap::Built() const
{
  if (!this->Map)
  {
    throw std::logic_error("there is no map; call Build() first");
  }
  return this->Map->Surface;
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::Take(std::shared_ptr<const glue::BuiltSurface> map)
{
  this->Map = std::move(map);
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::Build(vtkPolyData* surface)
{
  return this->Build(glue::CurvedSeamlessProperties(), surface, nullptr);
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::Build(
  const glue::CurvedSeamlessProperties& properties, vtkPolyData* surface, vtkPointSet* cloud)
{
  return glue::ReportErrors(this,
    [&]()
    {
      this->Map.reset();
      if (!surface || surface->GetNumberOfPoints() == 0)
      {
        throw std::invalid_argument("the surface is empty; there is nothing to build");
      }
      glue::RequireConsistentData(surface, "surface");
      glue::RequireConsistentData(cloud, "cloud");
      glue::Processes alone;
      this->Map = glue::BuildSurface(properties, this, surface, cloud, {}, alone);
    });
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::ToSurface(
  vtkDataArray* directions, vtkDoubleArray* positions, vtkDoubleArray* normals)
{
  return FillOrEmpty(this, directions, { positions, normals },
    [&]()
    {
      const conformal::CurvedSeamlessSurface& surface = this->Built();
      const conformal::Points units = UnitDirections(directions);
      conformal::SurfaceSamples samples;
      samples.Positions = Sized(positions, 3, units.rows());
      samples.Normals = Sized(normals, 3, units.rows());
      conformal::evaluate(surface, units, samples, glue::SMPRun());
      LengthsFromFrame(positions, this->Map->Frame, "positions");
    });
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::Differentiate(vtkDataArray* directions, vtkDoubleArray* derivatives,
  vtkDoubleArray* metrics, vtkDoubleArray* areaElements)
{
  return FillOrEmpty(this, directions, { derivatives, metrics, areaElements },
    [&]()
    {
      const conformal::CurvedSeamlessSurface& surface = this->Built();
      const conformal::Points units = UnitDirections(directions);
      conformal::SurfaceSamples samples;
      samples.Derivatives = Sized(derivatives, 9, units.rows());
      samples.Metrics = Sized(metrics, 9, units.rows());
      samples.AreaElements = Sized(areaElements, 1, units.rows());
      conformal::evaluate(surface, units, samples, glue::SMPRun());
      LengthsFromFrame(derivatives, this->Map->Frame, "derivatives");
      AreasFromFrame(metrics, this->Map->Frame, "metrics");
      AreasFromFrame(areaElements, this->Map->Frame, "area elements");
    });
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::ToSphere(
  vtkDataArray* points, vtkDoubleArray* directions, vtkDoubleArray* closestPoints)
{
  return FillOrEmpty(this, points, { directions, closestPoints },
    [&]()
    {
      if (!directions)
      {
        throw std::invalid_argument("the array for the directions is null");
      }
      const conformal::CurvedSeamlessSurface& surface = this->Built();
      conformal::Points inFrame;
      if (!glue::ToVectors(points, inFrame))
      {
        throw std::invalid_argument("points must be an array of 3 components");
      }
      for (conformal::Index i = 0; i < inFrame.rows(); ++i)
      {
        inFrame.row(i) = this->Map->Frame.toFrameFromAfar(inFrame.row(i));
      }
      conformal::invert(surface, inFrame, Sized(directions, 3, inFrame.rows()),
        Sized(closestPoints, 3, inFrame.rows()), glue::SMPRun());
      LengthsFromFrame(closestPoints, this->Map->Frame, "closest points");
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkCurvedSeamlessMap::GetNumberOfDegeneratePatches()
{
  return this->Map ? this->Map->Surface.numberOfDegeneratePatches() : 0;
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::GetNormalJumps(double jumps[2])
{
  jumps[0] = jumps[1] = 0.0;
  if (this->Map && this->Map->Surface.differentiable())
  {
    const conformal::NormalJumps measured =
      conformal::measureNormalJumps(this->Map->Surface.curvedTriangles(),
        this->Map->Surface.neighborsWithoutCaps(), glue::SMPRun());
    jumps[0] = measured.Mean;
    jumps[1] = measured.Maximum;
  }
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsBuilt: " << (this->IsBuilt() ? "Yes" : "No") << "\n";
}

#include "vtkCurvedSeamlessMap.h"

#include "Case.h"
#include "FuzzFilter.h"
#include "Surfaces.h"
#include "vtkCurvedSeamlessSurface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"

namespace cases
{
namespace
{
// The map is no filter: this one builds it of its input, and asks it both ways. The output has the
// points of the answer, and all arrays of the answer as field data.
class MapProbe : public vtkPolyDataAlgorithm
{
public:
  static MapProbe* New();
  vtkTypeMacro(MapProbe, vtkPolyDataAlgorithm);

  int DomeHeight = -1; // that of the map's own Build()
  SurfacePointer Cloud;
  vtkSmartPointer<vtkDataArray> Directions, Points;
  bool HasAreas = false;
  bool HasLengths = true;

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkPolyData* surface = vtkPolyData::GetData(inputs[0]);
    vtkNew<vtkCurvedSeamlessMap> map;
    vtkNew<vtkCurvedSeamlessSurface> settings;
    settings->SetDomeHeight(this->DomeHeight);
    const bool isBuilt =
      this->DomeHeight < 0 ? map->Build(surface) : settings->BuildMap(surface, this->Cloud, map);
    if (isBuilt != map->IsBuilt())
    {
      vtkErrorMacro(<< "it was built, or was not, but IsBuilt() is " << map->IsBuilt());
    }
    if (map->IsBuilt())
    {
      this->Ask(map, vtkPolyData::GetData(outputs));
    }
    return 1;
  }

private:
  void Ask(vtkCurvedSeamlessMap* map, vtkPolyData* output)
  {
    vtkNew<vtkFieldData> answers;
    const auto array = [&](const char* name)
    {
      vtkNew<vtkDoubleArray> made;
      made->SetName(name);
      answers->AddArray(made);
      return made.Get();
    };
    vtkDoubleArray* positions = array("Positions");
    bool isAnswered = map->ToSurface(this->Directions, positions, array("Normals"));
    if (this->HasLengths)
    {
      isAnswered = isAnswered && map->Differentiate(this->Directions, array("Derivatives")) &&
        map->ToSphere(this->Points ? this->Points.Get() : positions, array("DirectionsOfPoints"),
          array("ClosestPoints"));
    }
    if (this->HasAreas)
    {
      isAnswered = isAnswered &&
        map->Differentiate(this->Directions, nullptr, array("Metrics"), array("AreaElements"));
    }
    if (isAnswered)
    {
      map->GetNormalJumps(array("NormalJumps")->WritePointer(0, 2));
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      points->GetData()->DeepCopy(positions);
      output->SetPoints(points);
      output->GetFieldData()->ShallowCopy(answers);
    }
  }
};
vtkStandardNewMacro(MapProbe);

Mode MapMode(const char* name, int height)
{
  return { name, { Surface(0) },
    SetWith<MapProbe>(
      [=](MapProbe* probe, vtkPolyData* good)
      {
        probe->DomeHeight = height;
        probe->Cloud = good;
        probe->Directions = good->GetPointData()->GetArray("SpherePosition");
        probe->HasAreas = true;
      }) };
}

ScaledRun Evaluates(const char* name, bool hasAreas)
{
  return Scaled<MapProbe>(name,
    [=](MapProbe* probe, double scale)
    {
      probe->SetInputData(BumpyMesh(scale));
      probe->Directions = Sphere(5)->GetPoints()->GetData();
      probe->Points = BumpyCloud(scale)->GetPoints()->GetData();
      probe->HasAreas = hasAreas;
      probe->HasLengths = !hasAreas;
    },
    { { "Positions", 1 }, { "Derivatives", 1 }, { "ClosestPoints", 1 }, { "Metrics", 2 },
      { "AreaElements", 2 } });
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<MapProbe> probe;
  probe->DomeHeight = source.below(6) - 1;
  probe->HasAreas = source.flag();
  probe->HasLengths = source.flag();
  const SurfacePointer surface = source.surface();
  probe->SetInputData(surface);
  probe->Cloud = source.flag() ? surface : source.surface();
  // Directions and points with NaN and of wrong types among them.
  const SurfacePointer other = source.flag() ? surface : source.surface();
  vtkPointData* arrays = other->GetPointData();
  probe->Directions = arrays->GetArray("SpherePosition");
  probe->Points = arrays->GetArray(source.flag() ? "Colors" : "SpherePosition");
  if (probe->Directions && probe->Directions->GetNumberOfTuples() == 0)
  {
    probe->Update(); // of no directions, an answer has no points, which is no error
    return;
  }
  fuzz::run(probe);
}
}

Case CurvedSeamlessMap()
{
  using Surface = vtkCurvedSeamlessSurface;
  Case all = CaseOf<MapProbe>("vtkCurvedSeamlessMap");
  all.IsProbe = true;
  all.Modes = { MapMode("Curvature", Surface::CURVATURE), MapMode("flat", Surface::NONE),
    MapMode("Fitted", Surface::FITTED) };
  all.Scaled = { Evaluates("Positions", false), Evaluates("Areas", true) };
  all.Fuzz = Fuzz;
  return all;
}
}

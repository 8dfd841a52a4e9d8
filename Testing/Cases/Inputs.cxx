#include "Inputs.h"

#include "vtkGeodesicSphereSource.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace cases
{
namespace
{
using Surface = vtkSmartPointer<vtkPolyData>;
using Positions = std::vector<std::array<double, 3>>;
using Polygons = std::vector<std::vector<vtkIdType>>;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double Smallest = std::numeric_limits<double>::denorm_min();

template <typename Array, typename Value>
vtkSmartPointer<Array> Filled(const char* name, int components, vtkIdType tuples, Value value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, static_cast<double>(value(i, c)));
    }
  }
  return array;
}

vtkSmartPointer<vtkDoubleArray> Numbers(const char* name, std::vector<double> values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.data());
  return array;
}

std::array<double, 3> DirectionOf(vtkPolyData* surface, vtkIdType id)
{
  std::array<double, 3> p;
  surface->GetPoint(id, p.data());
  const double largest = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  if (!(largest > 0.0 && std::isfinite(largest)))
  {
    return { 0.0, 0.0, 1.0 };
  }
  for (double& x : p)
  {
    x /= largest;
  }
  const double length = std::hypot(p[0], p[1], p[2]);
  return { p[0] / length, p[1] / length, p[2] / length };
}

// All that filters and writers look for; the map is the direction from the origin.
void Dress(vtkPolyData* surface)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  const auto direction = [&](vtkIdType i, int c) { return DirectionOf(surface, i)[c]; };
  vtkPointData* data = surface->GetPointData();
  data->AddArray(Filled<vtkDoubleArray>("SpherePosition", 3, points, direction));
  data->SetNormals(Filled<vtkFloatArray>("Normals", 3, points, direction));
  data->SetTCoords(Filled<vtkFloatArray>("Texture Coordinates", 2, points,
    [&](vtkIdType i, int c) { return 0.5 + 0.5 * direction(i, c); }));
  data->SetScalars(Filled<vtkUnsignedCharArray>(
    "Colors", 3, points, [&](vtkIdType i, int c) { return 127.0 + 127.0 * direction(i, c); }));
  data->AddArray(Filled<vtkFloatArray>(
    "Curvature", 1, points, [&](vtkIdType i, int) { return direction(i, 2); }));
  data->AddArray(
    Filled<vtkDoubleArray>("Priority", 1, points, [&](vtkIdType i, int) { return 1.0 + i % 3; }));
  surface->GetCellData()->AddArray(Filled<vtkFloatArray>(
    "Heat", 1, surface->GetNumberOfCells(), [](vtkIdType i, int) { return i; }));
  vtkFieldData* field = surface->GetFieldData();
  field->AddArray(Numbers("SpherePole", { 0.0, 0.0, 1.0 }));
  field->AddArray(Numbers("SphereUp", { 0.0, 1.0, 0.0 }));
  field->AddArray(Numbers("SphereRight", { 1.0, 0.0, 0.0 }));
  field->AddArray(Numbers("TextureProjection", { 2.0 }));
  field->AddArray(Numbers("TextureFieldOfView", { 180.0 }));
  field->AddArray(Numbers("TextureScale", { 1.0, 1.0 }));
  field->AddArray(Numbers("TextureMargin", { 0.0 }));
  field->AddArray(Numbers("VertexShift", { 1.0 }));
}

Surface Bare(const Positions& positions, const Polygons& polygons)
{
  auto surface = Surface::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : positions)
  {
    points->InsertNextPoint(p.data());
  }
  surface->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const auto& ids : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  surface->SetPolys(cells);
  return surface;
}

Surface Dressed(const Positions& positions, const Polygons& polygons)
{
  Surface surface = Bare(positions, polygons);
  Dress(surface);
  return surface;
}

Polygons PolygonsOf(vtkPolyData* surface)
{
  Polygons polygons;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, size, ids);
    polygons.emplace_back(ids, ids + size);
  }
  return polygons;
}

Positions PositionsOf(vtkPolyData* surface)
{
  Positions positions(surface->GetNumberOfPoints());
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), positions[i].data());
  }
  return positions;
}

// The ellipsoid after change(positions, polygons).
template <typename Change>
Surface Changed(Change change)
{
  const Surface whole = Ellipsoid();
  Positions positions = PositionsOf(whole);
  Polygons polygons = PolygonsOf(whole);
  change(positions, polygons);
  return Dressed(positions, polygons);
}

// The ellipsoid's points and triangles, and points of no triangle that many times as far away.
Surface WithPointsAway(std::size_t count, double distance)
{
  return Changed(
    [=](Positions& p, Polygons&) {
      p.insert(p.end(), count, { 0.3 * distance, -distance, 0.0 });
    });
}

// The ellipsoid with all its arrays after change(surface), so that only this is wrong.
template <typename Change>
Surface Damaged(Change change)
{
  Surface surface = Ellipsoid();
  change(surface.Get());
  return surface;
}

// A grid of quads, closed in one or both directions.
Surface Tube(int across, int around, bool isTwisted)
{
  const double turn = 8.0 * std::atan(1.0);
  Positions positions;
  Polygons polygons;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double a = turn * i / around;
      if (isTwisted) // a strip that comes back turned over
      {
        const double h = 0.4 * (2.0 * j / (across - 1) - 1.0);
        const double r = 1.0 + h * std::cos(0.5 * a);
        positions.push_back({ r * std::cos(a), r * std::sin(a), h * std::sin(0.5 * a) });
        if (j + 1 < across)
        {
          const bool isLast = i + 1 == around;
          const vtkIdType next = isLast ? across - 1 - j : (i + 1) * across + j;
          const vtkIdType beside = isLast ? across - 2 - j : next + 1;
          polygons.push_back({ i * across + j, next, beside, i * across + j + 1 });
        }
      }
      else
      {
        const double b = turn * j / across;
        const double r = 1.0 + 0.4 * std::cos(b);
        positions.push_back({ r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b) });
        const vtkIdType k = (j + 1) % across, next = (i + 1) % around * across;
        polygons.push_back({ i * across + j, next + j, next + k, i * across + k });
      }
    }
  }
  return Dressed(positions, polygons);
}

Surface Cloud(int points, const std::function<std::array<double, 3>(double, double, double)>& place)
{
  std::mt19937 random(1);
  const auto draw = [&]() { return static_cast<double>(random()) / 4294967296.0; };
  Positions positions;
  for (int i = 0; i < points; ++i)
  {
    const double a = draw(), b = draw(), c = draw();
    positions.push_back(place(a, b, c));
  }
  return Dressed(positions, {});
}

// Triangles between random points.
Surface Soup(int triangles)
{
  std::mt19937 random(2);
  Positions positions;
  Polygons polygons;
  for (int i = 0; i < 40; ++i)
  {
    const auto draw = [&]() { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
    const double a = draw(), b = draw(), c = draw();
    positions.push_back({ a, b, c });
  }
  for (int i = 0; i < triangles; ++i)
  {
    const vtkIdType a = random() % 40, b = random() % 40, c = random() % 40;
    polygons.push_back({ a, b, c });
  }
  return Dressed(positions, polygons);
}

Surface Polygon(int corners, bool isClosed)
{
  const double turn = 8.0 * std::atan(1.0);
  Positions positions;
  std::vector<vtkIdType> there, back;
  for (int i = 0; i < corners; ++i)
  {
    const double a = turn * i / corners, r = 1.0 - 0.3 * (i % 2);
    positions.push_back({ r * std::cos(a), r * std::sin(a), 0.0 });
    there.push_back(i);
    back.push_back(corners - 1 - i);
  }
  return Dressed(positions, isClosed ? Polygons{ there, back } : Polygons{ there });
}

template <typename Type>
Surface OfType()
{
  return Damaged(
    [](vtkPolyData* surface)
    {
      vtkNew<vtkPoints> points;
      vtkNew<Type> values;
      const bool isWhole =
        values->GetDataType() != VTK_FLOAT && values->GetDataType() != VTK_DOUBLE;
      values->SetNumberOfComponents(3);
      values->SetNumberOfTuples(surface->GetNumberOfPoints());
      for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          const double x = surface->GetPoint(i)[c];
          values->SetComponent(i, c, isWhole ? std::round(100.0 * x) : x);
        }
      }
      points->SetData(values);
      surface->SetPoints(points);
    });
}

Surface WithPoint(vtkIdType every, double value)
{
  return Damaged(
    [=](vtkPolyData* surface)
    {
      for (vtkIdType i = 7; i < surface->GetNumberOfPoints(); i += every)
      {
        double p[3];
        surface->GetPoint(i, p);
        p[i % 3] = value;
        surface->GetPoints()->SetPoint(i, p);
      }
    });
}

Surface WithId(vtkIdType id)
{
  return Damaged(
    [=](vtkPolyData* surface)
    {
      Polygons polygons = PolygonsOf(surface);
      polygons[100][1] = id;
      surface->SetPolys(Bare({}, polygons)->GetPolys());
    });
}

Surface Strips()
{
  return Damaged(
    [](vtkPolyData* surface)
    {
      vtkNew<vtkCellArray> strips;
      for (const auto& ids : PolygonsOf(surface))
      {
        strips->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
      }
      surface->SetPolys(nullptr);
      surface->SetStrips(strips);
    });
}

Surface VertsAndLines(bool hasPolygons)
{
  return Damaged(
    [=](vtkPolyData* surface)
    {
      vtkNew<vtkCellArray> verts;
      vtkNew<vtkCellArray> lines;
      for (vtkIdType i = 0; i + 1 < surface->GetNumberOfPoints(); ++i)
      {
        const vtkIdType ids[] = { i, i + 1 };
        verts->InsertNextCell(1, ids);
        lines->InsertNextCell(2, ids);
      }
      surface->SetVerts(verts);
      surface->SetLines(lines);
      if (!hasPolygons)
      {
        surface->SetPolys(nullptr);
      }
      surface->GetCellData()->Initialize();
    });
}

Surface Stretched(double x, double y, double z, double offset = 0.0)
{
  return Changed(
    [=](Positions& positions, Polygons&)
    {
      for (auto& p : positions)
      {
        p = { x * p[0] + offset, y * p[1] + offset, z * p[2] };
      }
    });
}

Surface WithMap(vtkAbstractArray* map)
{
  return Damaged(
    [=](vtkPolyData* surface)
    {
      surface->GetPointData()->RemoveArray("SpherePosition");
      if (map)
      {
        surface->GetPointData()->AddArray(map);
      }
    });
}

// The map with change(direction) instead of each.
template <typename Array, typename Change>
Surface WithMapOf(vtkIdType tuples, int components, Change change)
{
  const Surface whole = Ellipsoid();
  return WithMap(Filled<Array>("SpherePosition", components, tuples,
    [&](vtkIdType i, int c)
    {
      const auto p = DirectionOf(whole, i % whole->GetNumberOfPoints());
      return change(i, std::array<double, 4>{ p[0], p[1], p[2], 0.0 })[c];
    }));
}

vtkSmartPointer<vtkStringArray> Words(const char* name, vtkIdType tuples)
{
  auto words = vtkSmartPointer<vtkStringArray>::New();
  words->SetName(name);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    words->InsertNextValue("word");
  }
  return words;
}

constexpr vtkIdType Count = 162; // points of the ellipsoid
constexpr vtkIdType CellCount = 320;

// Numbers of tuples that do not fit so many points or cells.
std::vector<std::pair<std::string, vtkIdType>> Lengths(vtkIdType count)
{
  return { { "0 tuples", 0 }, { "1 tuple", 1 }, { "n-1 tuples", count - 1 },
    { "n+1 tuples", count + 1 } };
}

// Note that an array has so many tuples for another number of points or cells.
void BreakLength(
  Input& input, bool isOfCells, const std::string& name, vtkIdType tuples, vtkIdType count)
{
  const std::string thing = isOfCells ? "cell" : "point";
  input.Faults |= Inconsistent;
  input.Message = "the " + thing + " array \"" + name + "\" has " + std::to_string(tuples) +
    (tuples == 1 ? " tuple" : " tuples") + " for " + std::to_string(count) + " " + thing + "s";
}

void AddIds(std::vector<Input>& all)
{
  for (const auto& [name, id] : { std::pair("negative id", vtkIdType(-1)), std::pair("id n", Count),
         std::pair("id 2^40", vtkIdType(1) << 40), std::pair("id -2^62", -(vtkIdType(1) << 62)) })
  {
    all.push_back({ name, [id = id]() { return WithId(id); }, BadIds });
    all.back().Message =
      "cell 100 refers to point " + std::to_string(id) + " of " + std::to_string(Count);
  }
}

// One triangle, with these offsets.
void AddOffsets(std::vector<Input>& all)
{
  using Offsets = std::vector<vtkIdType>;
  for (const auto& [name, offsets] :
    { std::pair<const char*, Offsets>("an offset past the ids", { 0, 1000000 }),
      { "falling offsets", { 0, 3, 1 } }, { "a negative offset", { -1000000, 3 } },
      { "no offsets", {} } })
  {
    all.push_back({ name,
      [offsets = offsets]()
      {
        return Damaged(
          [&](vtkPolyData* surface)
          {
            vtkNew<vtkIdTypeArray> places, ids;
            for (const vtkIdType offset : offsets)
            {
              places->InsertNextValue(offset);
            }
            for (const vtkIdType id : { 0, 1, 2 })
            {
              ids->InsertNextValue(id);
            }
            vtkNew<vtkCellArray> polygons;
            polygons->SetData(places, ids);
            surface->SetPolys(polygons);
            surface->GetCellData()->Initialize();
          });
      },
      Inconsistent });
    all.back().Message = "the offsets of the polygons";
  }
}

// Arrays that filters only pass on, and ghosts, that do not fit the points or cells.
void AddUnreadArrays(
  std::vector<Input>& all, const std::function<vtkSmartPointer<vtkDataSet>()>& make)
{
  const vtkSmartPointer<vtkDataSet> whole = make();
  const auto add = [&](bool isOfCells, const char* name, int type)
  {
    const vtkIdType count = isOfCells ? whole->GetNumberOfCells() : whole->GetNumberOfPoints();
    for (const auto& [what, tuples] : Lengths(count))
    {
      all.push_back({ std::string(isOfCells ? "cell array " : "point array ") + name + " " + what,
        [=, tuples = tuples]()
        {
          const vtkSmartPointer<vtkDataSet> broken = make();
          const auto array =
            vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
          array->SetName(name);
          array->SetNumberOfTuples(tuples);
          if (auto* numbers = vtkDataArray::SafeDownCast(array))
          {
            numbers->Fill(0.0);
          }
          broken->GetAttributes(isOfCells ? vtkDataObject::CELL : vtkDataObject::POINT)
            ->AddArray(array);
          return broken;
        } });
      BreakLength(all.back(), isOfCells, name, tuples, count);
    }
  };
  for (const bool isOfCells : { false, true })
  {
    add(isOfCells, "Unrelated", VTK_FLOAT);
    add(isOfCells, "Words", VTK_STRING);
    add(isOfCells, "Bits", VTK_BIT);
    add(isOfCells, vtkDataSetAttributes::GhostArrayName(), VTK_UNSIGNED_CHAR);
  }
  all.push_back({ "ghosts of another type",
    [=]()
    {
      const vtkSmartPointer<vtkDataSet> broken = make();
      const vtkIdType count = broken->GetNumberOfPoints();
      broken->GetPointData()->AddArray(Filled<vtkIntArray>(
        vtkDataSetAttributes::GhostArrayName(), 1, count, [](vtkIdType, int) { return 0; }));
      return broken;
    },
    Inconsistent });
  all.back().Message = "the point array \"vtkGhostType\" is a vtkIntArray of 1 component";
}

void AddMaps(std::vector<Input>& all)
{
  using V = std::array<double, 4>;
  const auto same = [](vtkIdType, V v) { return v; };
  const auto add = [&](const std::string& name, const std::function<Surface()>& make, bool isBad) {
    all.push_back({ "map " + name, [make]() { return make(); }, isBad ? unsigned(BadMap) : 0u });
  };
  add(
    "missing", []() { return WithMap(nullptr); }, true);
  for (const auto& [what, tuples] : Lengths(Count))
  {
    add(
      what, [=, tuples = tuples]() { return WithMapOf<vtkDoubleArray>(tuples, 3, same); }, true);
    BreakLength(all.back(), false, "SpherePosition", tuples, Count);
  }
  add(
    "float n-1", [=]() { return WithMapOf<vtkFloatArray>(Count - 1, 3, same); }, true);
  BreakLength(all.back(), false, "SpherePosition", Count - 1, Count);
  add(
    "1 component", [=]() { return WithMapOf<vtkDoubleArray>(Count, 1, same); }, true);
  add(
    "2 components", [=]() { return WithMapOf<vtkDoubleArray>(Count, 2, same); }, true);
  add(
    "4 components", [=]() { return WithMapOf<vtkDoubleArray>(Count, 4, same); }, true);
  add(
    "float", [=]() { return WithMapOf<vtkFloatArray>(Count, 3, same); }, false);
  const auto times = [](double factor)
  {
    return [factor](vtkIdType, V v) {
      return V{ factor * v[0], factor * v[1], factor * v[2], 0.0 };
    };
  };
  add(
    "int", [=]() { return WithMapOf<vtkIntArray>(Count, 3, times(1000.0)); }, false);
  add(
    "int of zeros", [=]() { return WithMapOf<vtkIntArray>(Count, 3, times(0.0)); }, true);
  add(
    "bits", [=]() { return WithMapOf<vtkBitArray>(Count, 3, times(1.0)); }, false);
  add(
    "all NaN", [=]() { return WithMapOf<vtkDoubleArray>(Count, 3, times(NaN)); }, true);
  add(
    "zeros", [=]() { return WithMapOf<vtkDoubleArray>(Count, 3, times(0.0)); }, true);
  add(
    "tiny", [=]() { return WithMapOf<vtkDoubleArray>(Count, 3, times(1e-300)); }, false);
  add(
    "float tiny", [=]() { return WithMapOf<vtkFloatArray>(Count, 3, times(1e-38)); }, false);
  add(
    "huge", [=]() { return WithMapOf<vtkDoubleArray>(Count, 3, times(1e308)); }, false);
  add(
    "turned inside out", [=]() { return WithMapOf<vtkDoubleArray>(Count, 3, times(-1.0)); }, false);
  for (const auto& [name, value] : { std::pair("NaN", NaN), std::pair("infinity", Infinity) })
  {
    add(
      std::string("one ") + name,
      [value = value]()
      {
        return WithMapOf<vtkDoubleArray>(Count, 3,
          [value](vtkIdType i, V v) {
            return V{ v[0], i == 80 ? value : v[1], v[2], 0.0 };
          });
      },
      true);
  }
  add(
    "one zero",
    []() {
      return WithMapOf<vtkDoubleArray>(
        Count, 3, [](vtkIdType i, V v) { return i == 80 ? V{} : v; });
    },
    true);
  add(
    "all equal",
    []()
    {
      return WithMapOf<vtkDoubleArray>(Count, 3,
        [](vtkIdType, V) {
          return V{ 0.6, 0.0, 0.8, 0.0 };
        });
    },
    false);
  add(
    "folded",
    []()
    {
      return WithMapOf<vtkDoubleArray>(Count, 3,
        [](vtkIdType, V v) {
          return V{ v[0], v[1], std::abs(v[2]), 0.0 };
        });
    },
    false);
  add(
    "on a circle",
    []()
    {
      return WithMapOf<vtkDoubleArray>(Count, 3,
        [](vtkIdType i, V) {
          return V{ std::cos(i), std::sin(i), 0.0, 0.0 };
        });
    },
    false);
  add(
    "shuffled",
    []()
    {
      return WithMapOf<vtkDoubleArray>(Count, 3,
        [](vtkIdType i, V) {
          return V{ std::cos(7.0 * i), std::sin(5.0 * i), std::sin(i), 0.0 };
        });
    },
    false);
  add(
    "strings", []() { return WithMap(Words("SpherePosition", Count)); }, true);
}

void AddPointArrays(std::vector<Input>& all)
{
  struct Attribute
  {
    const char* Name;
    int Components;
    std::function<void(vtkPolyData*, vtkAbstractArray*)> Set;
  };
  const auto scalars = [](vtkPolyData* s, vtkAbstractArray* a)
  {
    s->GetPointData()->RemoveArray("Colors");
    s->GetPointData()->AddArray(a);
    s->GetPointData()->SetActiveScalars("Colors");
  };
  const auto normals = [](vtkPolyData* s, vtkAbstractArray* a)
  {
    s->GetPointData()->AddArray(a);
    s->GetPointData()->SetActiveNormals("Normals");
  };
  const auto coordinates = [](vtkPolyData* s, vtkAbstractArray* a)
  {
    s->GetPointData()->AddArray(a);
    s->GetPointData()->SetActiveTCoords("Texture Coordinates");
  };
  const auto any = [](vtkPolyData* s, vtkAbstractArray* a) { s->GetPointData()->AddArray(a); };
  const auto cell = [](vtkPolyData* s, vtkAbstractArray* a) { s->GetCellData()->AddArray(a); };
  const Attribute attributes[] = { { "Colors", 3, scalars }, { "Normals", 3, normals },
    { "Texture Coordinates", 2, coordinates }, { "Curvature", 1, any }, { "Priority", 1, any },
    { "Heat", 1, cell }, { "vtkGhostType", 1, any }, { "GlobalPointIds", 1, any } };
  for (const Attribute& of : attributes)
  {
    const std::string name = of.Name;
    const vtkIdType count = name == "Heat" ? CellCount : Count;
    const auto add =
      [&](const std::string& what, const std::function<vtkSmartPointer<vtkAbstractArray>()>& make)
    {
      all.push_back({ name + " " + what,
        [make, set = of.Set]() { return Damaged([&](vtkPolyData* s) { set(s, make()); }); } });
    };
    const auto one = [](vtkIdType, int) { return 1.0; };
    for (const auto& [what, tuples] : Lengths(count))
    {
      add(what,
        [=, name = name, components = of.Components,
          tuples = tuples]() -> vtkSmartPointer<vtkAbstractArray>
        {
          if (name == "Colors" || name == "vtkGhostType")
          {
            return Filled<vtkUnsignedCharArray>(name.c_str(), components, tuples, one);
          }
          return Filled<vtkDoubleArray>(name.c_str(), components, tuples, one);
        });
      BreakLength(all.back(), name == "Heat", name, tuples, count);
    }
    add("more components",
      [=, components = of.Components]() -> vtkSmartPointer<vtkAbstractArray>
      { return Filled<vtkDoubleArray>(name.c_str(), components + 2, count, one); });
    add("NaN",
      [=, components = of.Components]() -> vtkSmartPointer<vtkAbstractArray>
      {
        return Filled<vtkDoubleArray>(
          name.c_str(), components, count, [](vtkIdType, int) { return NaN; });
      });
    add("huge",
      [=, components = of.Components]() -> vtkSmartPointer<vtkAbstractArray>
      {
        return Filled<vtkDoubleArray>(name.c_str(), components, count,
          [](vtkIdType i, int) { return i % 2 == 0 ? Largest : -Largest; });
      });
    add("of strings",
      [=]() -> vtkSmartPointer<vtkAbstractArray> { return Words(name.c_str(), count); });
  }
  for (int flag : { 1, 2, 255 }) // duplicate, hidden, all
  {
    all.push_back({ "vtkGhostType all " + std::to_string(flag),
      [flag]()
      {
        return Damaged(
          [&](vtkPolyData* s)
          {
            s->GetPointData()->AddArray(Filled<vtkUnsignedCharArray>(
              "vtkGhostType", 1, Count, [&](vtkIdType, int) { return flag; }));
          });
      } });
  }
  for (double value : { -1.0, 0.0, 1e-320 })
  {
    all.push_back({ "Priority all " + std::to_string(value),
      [value]()
      {
        return Damaged(
          [&](vtkPolyData* s)
          {
            s->GetPointData()->AddArray(
              Filled<vtkDoubleArray>("Priority", 1, Count, [&](vtkIdType, int) { return value; }));
          });
      } });
  }
  all.push_back({ "no arrays",
    []()
    {
      return Damaged(
        [](vtkPolyData* s)
        {
          s->GetPointData()->Initialize();
          s->GetCellData()->Initialize();
          s->GetFieldData()->Initialize();
        });
    },
    BadMap });
  all.push_back({ "arrays without names",
    []()
    {
      return Damaged(
        [](vtkPolyData* s)
        {
          s->GetPointData()->Initialize();
          const auto array =
            Filled<vtkDoubleArray>("", 3, Count, [](vtkIdType i, int c) { return i + c; });
          array->SetName(nullptr);
          s->GetPointData()->SetScalars(array);
        });
    },
    BadMap });
}

void AddFieldArrays(std::vector<Input>& all)
{
  const auto add = [&](const std::string& name, const std::string& what, std::vector<double> values)
  {
    all.push_back({ "field " + name + " " + what,
      [=]()
      {
        return Damaged(
          [&](vtkPolyData* s)
          {
            if (values.empty())
            {
              s->GetFieldData()->RemoveArray(name.c_str());
            }
            else
            {
              s->GetFieldData()->AddArray(Numbers(name.c_str(), values));
            }
          });
      } });
  };
  add("SpherePole", "missing", {});
  add("SpherePole", "zero", { 0.0, 0.0, 0.0 });
  add("SpherePole", "NaN", { NaN, 0.0, 1.0 });
  add("SpherePole", "tiny", { 0.0, 0.0, 1e-320 });
  add("SpherePole", "huge", { Largest, Largest, Largest });
  add("SpherePole", "of 2", { 0.0, 1.0 });
  add("SphereUp", "along the pole", { 0.0, 0.0, 1.0 });
  add("SphereUp", "zero", { 0.0, 0.0, 0.0 });
  add("TextureProjection", "99", { 99.0 });
  add("TextureProjection", "-1", { -1.0 });
  add("TextureProjection", "NaN", { NaN });
  add("TextureFieldOfView", "huge", { 1e300 });
  add("TextureScale", "zero", { 0.0, 0.0 });
  add("TextureScale", "huge", { Largest, Largest });
  add("TextureMargin", "1", { 1.0 });
  add("VertexShift", "of 3", { 1.0, 1.0, 1.0 });
  add("VertexShift", "NaN", { NaN });
  add("VertexShift", "huge", { 1e300 });
  all.push_back({ "field data of strings",
    []()
    {
      return Damaged(
        [](vtkPolyData* s)
        {
          for (const char* name : { "SpherePole", "TextureProjection", "VertexShift" })
          {
            s->GetFieldData()->AddArray(Words(name, 1));
          }
        });
    } });
  all.push_back({ "field data of 0 tuples",
    []()
    {
      return Damaged(
        [](vtkPolyData* s)
        {
          for (int i = 0; i < s->GetFieldData()->GetNumberOfArrays(); ++i)
          {
            s->GetFieldData()->GetArray(i)->SetNumberOfTuples(0);
          }
        });
    } });
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Ellipsoid(double scale, int frequency)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  Positions positions = PositionsOf(source->GetOutput());
  for (auto& p : positions)
  {
    p = { scale * p[0], scale * (2.0 / 3.0 * p[1]), scale * (p[2] / 3.0) };
  }
  // The map is the sphere's own, whatever became of the ellipsoid.
  Surface surface = Dressed(PositionsOf(source->GetOutput()), PolygonsOf(source->GetOutput()));
  surface->SetPoints(Bare(positions, {})->GetPoints());
  return surface;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> SmallPicture()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(0, 15, 0, 15, 0, 0);
  image->GetPointData()->SetScalars(Filled<vtkUnsignedCharArray>(
    "Pixels", 3, 256, [](vtkIdType i, int c) { return i * (c + 1) % 256; }));
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PlacesOnABody()
{
  Surface places = Ellipsoid();
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    places->GetPoints()->SetPoint(
      i, 2.0 * static_cast<double>(i), 80.0 - static_cast<double>(i), 0.0);
  }
  return places;
}

//------------------------------------------------------------------------------
std::vector<Input> Meshes()
{
  const Polygons tetrahedron = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  const Positions corners = { { -1, -1, -1 }, { 1, -1, -1 }, { 0, 1, -1 }, { 0, 0, 1 } };
  std::vector<Input> all = {
    { "ellipsoid", []() { return Ellipsoid(); } },
    { "nothing at all", []() { return Surface::New(); } },
    { "empty", []() { return Dressed({}, {}); } },
    { "no points but triangles",
      []() {
        return Bare({}, { { 0, 1, 2 } });
      },
      BadIds },
    { "null points and triangles",
      []()
      {
        Surface surface = Ellipsoid();
        surface->SetPoints(nullptr);
        return surface;
      },
      BadIds },
    { "one point",
      []() {
        return Dressed({ { 1, 2, 3 } }, {});
      } },
    { "two points",
      []() {
        return Dressed({ { 1, 2, 3 }, { 2, 2, 3 } }, {});
      } },
    { "three points",
      []() {
        return Dressed({ { 1, 2, 3 }, { 2, 2, 3 }, { 1, 4, 3 } }, {});
      } },
    { "one triangle",
      []() {
        return Dressed({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
      } },
    { "two triangles back to back",
      []() {
        return Dressed({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 1 } });
      } },
    { "tetrahedron", [=]() { return Dressed(corners, tetrahedron); } },
    { "two components",
      []()
      {
        return Changed(
          [](Positions& p, Polygons& t)
          {
            const std::size_t points = p.size(), triangles = t.size();
            for (std::size_t i = 0; i < points; ++i)
            {
              p.push_back({ p[i][0] + 5.0, p[i][1], p[i][2] });
            }
            for (std::size_t i = 0; i < triangles; ++i)
            {
              const auto n = static_cast<vtkIdType>(points);
              t.push_back({ t[i][0] + n, t[i][1] + n, t[i][2] + n });
            }
          });
      } },
    { "one hole", []() { return Changed([](Positions&, Polygons& t) { t.pop_back(); }); } },
    { "half", []() { return Changed([](Positions&, Polygons& t) { t.resize(t.size() / 2); }); } },
    { "an edge of three triangles",
      []()
      {
        return Changed(
          [](Positions& p, Polygons& t)
          {
            p.push_back({ 3, 3, 3 });
            t.push_back({ t[0][0], t[0][1], static_cast<vtkIdType>(p.size() - 1) });
          });
      } },
    { "two tetrahedra at a vertex",
      [=]()
      {
        Positions p = corners;
        p.insert(p.end(), { { -1, -1, 3 }, { 1, -1, 3 }, { 0, 1, 3 } });
        Polygons t = tetrahedron;
        t.insert(t.end(), { { 4, 5, 6 }, { 4, 3, 5 }, { 5, 3, 6 }, { 6, 3, 4 } });
        return Dressed(p, t);
      } },
    { "moebius strip", []() { return Tube(4, 20, true); } },
    { "torus", []() { return Tube(8, 16, false); } },
    { "inside out",
      []()
      {
        return Changed(
          [](Positions&, Polygons& t)
          {
            for (auto& ids : t)
            {
              std::swap(ids[0], ids[1]);
            }
          });
      } },
    { "some triangles turned over",
      []()
      {
        return Changed(
          [](Positions&, Polygons& t)
          {
            for (std::size_t i = 0; i < t.size(); i += 3)
            {
              std::swap(t[i][0], t[i][1]);
            }
          });
      } },
    { "each triangle twice",
      []()
      {
        return Changed(
          [](Positions&, Polygons& t) { t.insert(t.end(), t.begin(), t.begin() + 320); });
      } },
    { "one triangle thrice",
      []()
      {
        return Changed(
          [](Positions&, Polygons& t)
          {
            t.push_back(t[3]);
            t.push_back(t[3]);
          });
      } },
    { "triangles of a repeated point",
      []()
      {
        return Changed(
          [](Positions&, Polygons& t)
          {
            t.push_back({ 3, 3, 4 });
            t.push_back({ 5, 5, 5 });
          });
      } },
    { "triangles without area",
      []()
      {
        return Changed(
          [](Positions& p, Polygons&)
          {
            p[20] = p[21];
            p[50] = p[51];
            p[51] = p[52];
          });
      } },
    { "a point 1e3 away", []() { return WithPointsAway(1, 1e3); } },
    { "a point 1e15 away", []() { return WithPointsAway(1, 1e15); } },
    { "a point 1e300 away", []() { return WithPointsAway(1, 1e300); } },
    { "100 points at a place 1e6 away", []() { return WithPointsAway(100, 1e6); } },
    { "isolated points",
      []() {
        return Changed([](Positions& p, Polygons&) { p.insert(p.end(), 9, { 9, 9, 9 }); });
      } },
    { "all points thrice",
      []()
      {
        return Changed(
          [](Positions& p, Polygons&)
          {
            const Positions once = p;
            p.insert(p.end(), once.begin(), once.end());
            p.insert(p.end(), once.begin(), once.end());
          });
      } },
    { "unwelded",
      []()
      {
        return Changed(
          [](Positions& p, Polygons& t)
          {
            Positions apart;
            for (auto& ids : t)
            {
              for (vtkIdType& id : ids)
              {
                apart.push_back(p[id]);
                id = static_cast<vtkIdType>(apart.size() - 1);
              }
            }
            p = apart;
          });
      } },
    { "soup", []() { return Soup(60); } },
    { "dense soup", []() { return Soup(2000); } },
    { "a closed surface of random points",
      []()
      {
        return Changed(
          [](Positions& p, Polygons&)
          {
            std::mt19937 random(3);
            for (auto& x : p)
            {
              for (double& c : x)
              {
                c = static_cast<double>(random()) / 2147483648.0 - 1.0;
              }
            }
          });
      } },
    { "NaN in one point", []() { return WithPoint(1000, NaN); }, BadPoints },
    { "infinity in one point", []() { return WithPoint(1000, -Infinity); }, BadPoints },
    { "NaN in all points",
      []()
      {
        return Changed(
          [](Positions& p, Polygons&)
          {
            for (auto& x : p)
            {
              x = { NaN, NaN, NaN };
            }
          });
      },
      BadPoints },
    { "1e300 in some points", []() { return WithPoint(40, 1e300); } },
    { "the largest number in some points", []() { return WithPoint(40, Largest); } },
    { "NaN in an isolated point",
      []() {
        return Changed([](Positions& p, Polygons&) { p.push_back({ NaN, 0, 0 }); });
      } },
    { "strips", []() { return Strips(); } },
    { "a strip of a bad id",
      []()
      {
        return Damaged(
          [](vtkPolyData* s)
          {
            s->SetStrips(Bare({}, { { 0, 1, 2, 3, 1000000, 4 } })->GetPolys());
            s->GetCellData()->Initialize();
          });
      },
      BadIds },
    { "quads", []() { return Tube(12, 12, false); } },
    { "polygon of 100,000 corners", []() { return Polygon(100000, false); } },
    { "two polygons of 1,000 corners", []() { return Polygon(1000, true); } },
    { "polygons of 0, 1 and 2 corners",
      []() {
        return Changed([](Positions&, Polygons& t) { t.insert(t.end(), { {}, { 3 }, { 4, 5 } }); });
      } },
    { "vertices and lines only", []() { return VertsAndLines(false); } },
    { "vertices and lines too", []() { return VertsAndLines(true); } },
    { "no polygons",
      []()
      {
        return Damaged(
          [](vtkPolyData* s)
          {
            s->SetPolys(nullptr);
            s->GetCellData()->Initialize();
          });
      } },
    { "offset 1e7", []() { return Stretched(1, 1, 1, 1e7); } },
    { "offset 1e16", []() { return Stretched(1, 1, 1, 1e16); } },
    { "offset 1e300", []() { return Stretched(1, 1, 1, 1e300); } },
    { "flat", []() { return Stretched(1, 1, 0); } },
    { "nearly flat", []() { return Stretched(1, 1, 1e-13); } },
    { "on a line", []() { return Stretched(1, 0, 0); } },
    { "in one place", []() { return Stretched(0, 0, 0, 1.0); } },
    { "needle", []() { return Stretched(1e-9, 1e-9, 1); } },
    { "1e200 long, 1e-200 wide", []() { return Stretched(1e200, 1e-200, 1); } },
    { "spike",
      []() {
        return Changed([](Positions& p, Polygons&) { p[9] = { 1e6, 1e6, 1e6 }; });
      } },
    { "float points", []() { return OfType<vtkFloatArray>(); } },
    { "int points", []() { return OfType<vtkIntArray>(); } },
    { "char points", []() { return OfType<vtkCharArray>(); } },
    { "id points", []() { return OfType<vtkIdTypeArray>(); } },
    { "cloud of 1,000 points",
      []() {
        return Cloud(1000, [](double a, double b, double c) { return std::array{ a, b, c }; });
      } },
    { "cloud of a plane",
      []() {
        return Cloud(300, [](double a, double b, double) { return std::array{ a, b, 0.5 }; });
      } },
    { "cloud of a line",
      []() {
        return Cloud(300, [](double a, double, double) { return std::array{ a, a, a }; });
      } },
    { "cloud of equal points",
      []() {
        return Cloud(300, [](double, double, double) { return std::array{ 4.0, 5.0, 6.0 }; });
      } },
    { "cloud of few places",
      []()
      {
        return Cloud(300,
          [](double a, double b, double c) {
            return std::array{ std::round(a), std::round(b), std::round(c) };
          });
      } },
    { "cloud of two clusters",
      []()
      {
        return Cloud(300,
          [](double a, double b, double c) {
            return std::array{ a + (a < 0.5 ? 1e5 : 0.0), b, c };
          });
      } },
    { "cloud at all scales",
      []()
      {
        return Cloud(300,
          [](double a, double b, double c)
          {
            const double s = std::pow(10.0, 300.0 * (2.0 * a - 1.0));
            return std::array{ s * b, s * c, s };
          });
      } },
  };
  AddIds(all);
  AddOffsets(all);
  return all;
}

//------------------------------------------------------------------------------
std::vector<Input> Arrays()
{
  std::vector<Input> all;
  AddMaps(all);
  AddPointArrays(all);
  AddFieldArrays(all);
  AddUnreadArrays(all, []() { return Ellipsoid(); });
  for (Input& input : all)
  {
    input.IsArray = true;
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<Input> Scales()
{
  std::vector<Input> all;
  // Powers of two, near powers of ten: nothing is rounded but by who adds and multiplies.
  for (const auto& [name, scale] :
    { std::pair("5e-324", Smallest), std::pair("1e-300", std::ldexp(1.0, -997)),
      std::pair("1e-170", std::ldexp(1.0, -565)), std::pair("1e-40", std::ldexp(1.0, -133)),
      std::pair("1e30", std::ldexp(1.0, 100)), std::pair("1e154", std::ldexp(1.0, 512)),
      std::pair("1e160", std::ldexp(1.0, 532)), std::pair("1e200", std::ldexp(1.0, 664)),
      std::pair("1e308", std::ldexp(1.0, 1023)), std::pair("1.7e308", 1.7e308) })
  {
    all.push_back(
      { std::string("scale ") + name, [scale = scale]() { return Ellipsoid(scale); }, 0, scale });
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<Input> Surfaces()
{
  std::vector<Input> all = Meshes();
  for (const std::vector<Input>& more : { Arrays(), Scales() })
  {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<Input> Pictures()
{
  std::vector<Input> all;
  const auto add = [&](const std::string& name, const std::function<void(vtkImageData*)>& change)
  {
    all.push_back({ name,
      [change]()
      {
        const auto image = SmallPicture();
        change(image);
        return image;
      } });
  };
  const auto gray = [](vtkIdType, int) { return 7.0; };
  add("picture", [](vtkImageData*) {});
  add("no pixels", [](vtkImageData* i) { i->GetPointData()->Initialize(); });
  add("empty", [](vtkImageData* i) { i->Initialize(); });
  for (const vtkIdType tuples : { 0, 1, 255, 257 })
  {
    add(std::to_string(tuples) + " pixels for 256",
      [=](vtkImageData* i)
      { i->GetPointData()->SetScalars(Filled<vtkUnsignedCharArray>("Pixels", 3, tuples, gray)); });
    BreakLength(all.back(), false, "Pixels", tuples, 256);
  }
  for (const int components : { 1, 2, 4, 5 })
  {
    add(std::to_string(components) + " components",
      [=](vtkImageData* i) {
        i->GetPointData()->SetScalars(
          Filled<vtkUnsignedCharArray>("Pixels", components, 256, gray));
      });
  }
  add("bits",
    [=](vtkImageData* i)
    { i->GetPointData()->SetScalars(Filled<vtkBitArray>("Pixels", 3, 256, gray)); });
  add("ids",
    [=](vtkImageData* i)
    { i->GetPointData()->SetScalars(Filled<vtkIdTypeArray>("Pixels", 3, 256, gray)); });
  add("floats",
    [=](vtkImageData* i)
    { i->GetPointData()->SetScalars(Filled<vtkFloatArray>("Pixels", 3, 256, gray)); });
  for (const double value : { NaN, Infinity, Largest })
  {
    add("pixels of " + std::to_string(value).substr(0, 8),
      [=](vtkImageData* i)
      {
        i->GetPointData()->SetScalars(
          Filled<vtkDoubleArray>("Pixels", 3, 256, [=](vtkIdType, int) { return value; }));
      });
  }
  add("one pixel",
    [=](vtkImageData* i)
    {
      i->SetExtent(0, 0, 0, 0, 0, 0);
      i->GetPointData()->SetScalars(Filled<vtkUnsignedCharArray>("Pixels", 3, 1, gray));
    });
  add("one row", [=](vtkImageData* i) { i->SetExtent(0, 255, 0, 0, 0, 0); });
  add("two slices", [](vtkImageData* i) { i->SetExtent(0, 15, 0, 7, 0, 1); });
  add("standing slice", [](vtkImageData* i) { i->SetExtent(0, 0, 0, 15, 0, 15); });
  add("extent from -3", [](vtkImageData* i) { i->SetExtent(-3, 12, -8, 7, 5, 5); });
  add("extent of 40,000 x 40,000", [](vtkImageData* i) { i->SetExtent(0, 39999, 0, 39999, 0, 0); });
  add("extent of 2^62", [](vtkImageData* i) { i->SetExtent(0, 2147483646, 0, 2147483646, 0, 0); });
  add("backward extent", [](vtkImageData* i) { i->SetExtent(5, 1, 5, 1, 0, 0); });
  for (const double spacing : { 0.0, -1.0, NaN, Largest })
  {
    add("spacing " + std::to_string(spacing).substr(0, 8),
      [=](vtkImageData* i) { i->SetSpacing(spacing, spacing, spacing); });
  }
  add("origin NaN", [](vtkImageData* i) { i->SetOrigin(NaN, NaN, NaN); });
  add("pixels of strings",
    [](vtkImageData* i)
    {
      i->GetPointData()->Initialize();
      i->GetPointData()->AddArray(Words("Pixels", 256));
    });
  AddUnreadArrays(all, []() { return SmallPicture(); });
  return all;
}
}

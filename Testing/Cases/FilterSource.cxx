#include "FilterSource.h"

#include "vtkGeodesicSphereSource.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace fuzz
{
namespace
{
using Surface = vtkSmartPointer<vtkPolyData>;

void AddPolygon(vtkPolyData* surface, std::initializer_list<vtkIdType> ids)
{
  surface->GetPolys()->InsertNextCell(ids);
}

Surface Empty()
{
  auto surface = Surface::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  surface->SetPolys(polygons);
  return surface;
}

Surface Sphere(int frequency)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  auto sphere = Surface::New();
  sphere->DeepCopy(source->GetOutput());
  sphere->GetPointData()->Initialize();
  return sphere;
}

Surface Tetrahedron()
{
  Surface surface = Empty();
  const double corners[4][3] = { { -1, -1, -1 }, { 1, -1, -1 }, { 0, 1, -1 }, { 0, 0, 1 } };
  for (const double* p : corners)
  {
    surface->GetPoints()->InsertNextPoint(p);
  }
  AddPolygon(surface, { 0, 2, 1 });
  AddPolygon(surface, { 0, 1, 3 });
  AddPolygon(surface, { 1, 2, 3 });
  AddPolygon(surface, { 2, 0, 3 });
  return surface;
}

// Polygons written anew, each as change(cell, ids) leaves it, those without ids left out.
template <typename Change>
void ChangePolygons(vtkPolyData* surface, Change change)
{
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, ids);
    change(i, ids.Get());
    if (ids->GetNumberOfIds() > 0)
    {
      polygons->InsertNextCell(ids);
    }
  }
  surface->SetPolys(polygons);
}

template <typename Change>
void ChangePoints(vtkPolyData* surface, Change change)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    change(i, p);
    surface->GetPoints()->SetPoint(i, p);
  }
}

vtkSmartPointer<vtkDataArray> ArrayOf(int type, const char* name, int components, vtkIdType tuples)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(0.0);
  return array;
}
}

//------------------------------------------------------------------------------
double FilterSource::number()
{
  using Limits = std::numeric_limits<double>;
  constexpr double known[] = { 0.0, -0.0, 1.0, Limits::denorm_min(), Limits::min(), 1e-300, 1e-170,
    1e-40, 1e-9, 1e9, 1e38, 1e154, 1e160, 1e200, 1e300, Limits::max(), -Limits::max(),
    Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), 2147483648.0, -1.0 };
  switch (this->below(4))
  {
    case 0:
      return (this->byte() - 128) / 64.0;
    case 1:
      return (this->byte() + 256 * this->byte() - 32768) / 1000.0;
    case 2:
      return known[this->below(static_cast<int>(std::size(known)))];
    default:
      std::uint64_t bits = 0;
      for (int i = 0; i < 8; ++i)
      {
        bits = bits << 8 | static_cast<std::uint64_t>(this->byte());
      }
      double value = 0.0;
      std::memcpy(&value, &bits, sizeof(value));
      return value;
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> FilterSource::base()
{
  switch (this->below(5))
  {
    case 0:
      return Sphere(1 + this->below(3));
    case 1:
      return Tetrahedron();
    case 2: // a cloud
    {
      Surface surface = Empty();
      for (int i = this->below(40); i > 0; --i)
      {
        const double x = this->byte(), y = this->byte(), z = this->byte();
        surface->GetPoints()->InsertNextPoint(x / 128.0 - 1.0, y / 128.0 - 1.0, z / 128.0 - 1.0);
      }
      return surface;
    }
    case 3: // two pieces
    {
      Surface surface = Sphere(1);
      const vtkIdType count = surface->GetNumberOfPoints();
      const Surface other = Sphere(1);
      for (vtkIdType i = 0; i < count; ++i)
      {
        double p[3];
        other->GetPoint(i, p);
        surface->GetPoints()->InsertNextPoint(p[0] + 3.0, p[1], p[2]);
      }
      ChangePolygons(other,
        [&](vtkIdType, vtkIdList* ids) {
          AddPolygon(
            surface, { ids->GetId(0) + count, ids->GetId(1) + count, ids->GetId(2) + count });
        });
      return surface;
    }
    default: // anything
    {
      Surface surface = Empty();
      const int points = this->below(30);
      for (int i = 0; i < points; ++i)
      {
        const double x = this->number(), y = this->number(), z = this->number();
        surface->GetPoints()->InsertNextPoint(x, y, z);
      }
      for (int i = this->below(60); i > 0; --i)
      {
        vtkNew<vtkIdList> ids;
        for (int k = this->flag() ? 3 : this->below(9); k > 0; --k)
        {
          ids->InsertNextId(this->below(std::max(points, 1)));
        }
        surface->GetPolys()->InsertNextCell(ids);
      }
      return surface;
    }
  }
}

//------------------------------------------------------------------------------
void FilterSource::damage(vtkPolyData* surface)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  const vtkIdType polygons = surface->GetNumberOfPolys();
  const vtkIdType point = points > 0 ? this->byte() % points : 0;
  const vtkIdType polygon = polygons > 0 ? this->byte() % polygons : 0;
  switch (this->below(12))
  {
    case 0:
      ChangePoints(surface,
        [&](vtkIdType i, double* p)
        {
          if (i == point)
          {
            p[this->below(3)] = this->number();
          }
        });
      break;
    case 1:
    {
      const double scale = this->number();
      ChangePoints(surface,
        [&](vtkIdType, double* p)
        { std::transform(p, p + 3, p, [=](double x) { return scale * x; }); });
      break;
    }
    case 2:
    {
      const int axis = this->below(3);
      const double scale = this->number();
      ChangePoints(surface, [&](vtkIdType, double* p) { p[axis] *= scale; });
      break;
    }
    case 3:
    {
      const int axis = this->below(3);
      const double offset = this->number();
      ChangePoints(surface, [&](vtkIdType, double* p) { p[axis] += offset; });
      break;
    }
    case 4:
      ChangePolygons(surface,
        [&](vtkIdType i, vtkIdList* ids)
        {
          if (i == polygon && ids->GetNumberOfIds() > 0)
          {
            const double id = this->number();
            ids->SetId(this->byte() % ids->GetNumberOfIds(),
              std::abs(id) < 1e18 ? static_cast<vtkIdType>(id) : point);
          }
        });
      break;
    case 5:
      ChangePolygons(surface,
        [&](vtkIdType i, vtkIdList* ids)
        { ids->SetNumberOfIds(i == polygon ? 0 : ids->GetNumberOfIds()); });
      break;
    case 6:
      if (polygons > 0)
      {
        vtkNew<vtkIdList> ids;
        surface->GetPolys()->GetCellAtId(polygon, ids);
        surface->GetPolys()->InsertNextCell(ids);
      }
      break;
    case 7:
      ChangePolygons(surface,
        [&](vtkIdType i, vtkIdList* ids)
        {
          if (i % (1 + polygon) == 0)
          {
            std::reverse(ids->begin(), ids->end());
          }
        });
      break;
    case 8:
    {
      const double x = this->number(), y = this->number(), z = this->number();
      surface->GetPoints()->InsertNextPoint(x, y, z);
      break;
    }
    case 9:
    {
      vtkNew<vtkPoints> others;
      const int types[] = { VTK_FLOAT, VTK_INT, VTK_CHAR, VTK_LONG_LONG };
      others->SetDataType(types[this->below(4)]);
      // What an integer cannot hold would be undefined before it came to a filter.
      for (vtkIdType i = 0; i < points; ++i)
      {
        const double* p = surface->GetPoint(i);
        const bool isSmall = std::abs(p[0]) < 1.2 && std::abs(p[1]) < 1.2 && std::abs(p[2]) < 1.2;
        const double scale = isSmall && others->GetDataType() != VTK_FLOAT ? 100.0 : isSmall;
        others->InsertNextPoint(
          isSmall ? scale * p[0] : 0.0, isSmall ? scale * p[1] : 0.0, isSmall ? scale * p[2] : 0.0);
      }
      surface->SetPoints(others);
      break;
    }
    case 10:
    {
      vtkNew<vtkCellArray> strips;
      strips->DeepCopy(surface->GetPolys());
      surface->SetStrips(strips);
      surface->SetPolys(nullptr);
      vtkNew<vtkCellArray> none;
      surface->SetPolys(none);
      break;
    }
    default:
      if (points > 1) // two points in one place
      {
        double p[3];
        surface->GetPoint(point, p);
        surface->GetPoints()->SetPoint(this->byte() % points, p);
      }
  }
}

//------------------------------------------------------------------------------
void FilterSource::addArrays(vtkPolyData* surface)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  const auto add = [&](const char* name, int components, int type)
  {
    // Mostly what it should be.
    const int choice = this->byte();
    const vtkIdType tuples = choice < 240 ? points : std::max<vtkIdType>(0, points + choice - 248);
    const int width = choice == 239 ? 1 + this->below(5) : components;
    const auto array = ArrayOf(choice == 238 ? VTK_INT : type, name, width, tuples);
    for (vtkIdType i = 0; i < std::min(tuples, points); ++i)
    {
      double p[3];
      surface->GetPoint(i, p);
      const double largest = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
      const bool isGood = largest > 0.0 && std::isfinite(largest);
      for (int c = 0; c < width; ++c)
      {
        const double value = isGood && c < 3 ? 100.0 * (p[c] / largest) : c == 2;
        array->SetComponent(i, c, type == VTK_UNSIGNED_CHAR ? std::abs(value) : value);
      }
    }
    for (int i = this->flag() ? this->below(4) : 0; i > 0 && tuples > 0; --i)
    {
      const vtkIdType tuple = this->byte() % tuples;
      const double value = this->number();
      const bool isFloating =
        array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
      const bool isHeld =
        isFloating && (array->GetDataType() == VTK_DOUBLE || !(std::abs(value) > 1e38));
      array->SetComponent(tuple, this->below(width), isHeld ? value : 7.0);
    }
    surface->GetPointData()->AddArray(array);
  };
  const int which = this->byte();
  if (which % 16 != 15)
  {
    add("SpherePosition", 3, which & 64 ? VTK_FLOAT : VTK_DOUBLE);
  }
  if (which & 1)
  {
    add("Priority", 1, VTK_DOUBLE);
  }
  if (which & 2)
  {
    add("Colors", 3, VTK_FLOAT);
    surface->GetPointData()->SetActiveScalars("Colors");
  }
  if (which & 4)
  {
    add("Normals", 3, VTK_FLOAT);
    surface->GetPointData()->SetActiveNormals("Normals");
  }
  if (which & 8)
  {
    add("Texture Coordinates", 2, VTK_FLOAT);
    surface->GetPointData()->SetActiveTCoords("Texture Coordinates");
  }
  if (which & 128)
  {
    add("vtkGhostType", 1, which & 32 ? VTK_FLOAT : VTK_UNSIGNED_CHAR);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> FilterSource::surface()
{
  const Surface surface = this->base();
  for (int i = this->below(5); i > 0; --i)
  {
    this->damage(surface);
  }
  this->addArrays(surface);
  return surface;
}

//------------------------------------------------------------------------------
void FilterSource::addPixels(vtkImageData* image)
{
  const int types[] = { VTK_UNSIGNED_CHAR, VTK_DOUBLE, VTK_SHORT, VTK_LONG_LONG };
  const int type = types[this->below(4)];
  const int choice = this->byte();
  const vtkIdType tuples = image->GetNumberOfPoints() + (choice >= 240 ? choice - 248 : 0);
  const auto pixels =
    ArrayOf(type, "Pixels", choice == 239 ? 5 : 1 + choice % 4, std::max<vtkIdType>(tuples, 0));
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    pixels->SetComponent(i, 0, type == VTK_DOUBLE ? this->number() : this->byte());
  }
  image->GetPointData()->SetScalars(pixels);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> FilterSource::picture()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int columns = this->below(9), rows = this->below(9);
  const int origin = this->below(8) == 7 ? this->byte() - 128 : 0;
  image->SetExtent(origin, origin + columns, -origin, rows - origin, 0, this->below(16) == 15);
  this->addPixels(image);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> FilterSource::volume()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int columns = this->below(9), rows = this->below(9), layers = this->below(9);
  image->SetExtent(0, columns, 0, rows, 0, layers);
  const double width = this->flag() ? this->number() : 0.25;
  const double height = this->flag() ? this->number() : width;
  image->SetSpacing(width, width, height);
  image->SetOrigin(-0.5 * width * columns, -0.5 * width * rows, -0.5 * height * layers);
  this->addPixels(image);
  return image;
}
}

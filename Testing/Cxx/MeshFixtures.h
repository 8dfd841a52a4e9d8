// Make meshes, and change their polygons, for tests of filters that read meshes.
#ifndef MeshFixtures_h
#define MeshFixtures_h

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "../Handles.h"
#include "vtkGeodesicSphereSource.h"

#include <cmath>

namespace fixtures
{
/// Return an ellipsoid with three different axes and a map to the sphere, with its center at (10,
/// 0, 0). The mesh has 10 f^2 + 2 points, where f is the frequency.
inline vtkNew<vtkPolyData> Ellipsoid(int frequency = 4)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, 3.0 * p[0] + 10.0, 2.0 * p[1], p[2]);
  }
  return surface;
}

/// Return a head with a nose, an ear and a tail, and with a point array "Height". The map to the
/// sphere is rotated about the z axis.
/// @param[in] angle  angle of the rotation [radians]
inline vtkNew<vtkPolyData> Head(int frequency, double angle)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  vtkNew<vtkPolyData> head;
  head->DeepCopy(source->GetOutput());
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  const auto bump = [](const double* n, double x, double y, double z, double width)
  {
    const double length = std::sqrt(x * x + y * y + z * z);
    return std::exp(((n[0] * x + n[1] * y + n[2] * z) / length - 1.0) / (width * width));
  };
  for (vtkIdType i = 0; i < head->GetNumberOfPoints(); ++i)
  {
    double n[3];
    source->GetOutput()->GetPoint(i, n);
    const double radius = 10.0 + 7.0 * bump(n, 1, 0.1, 0.2, 0.3) +
      4.0 * bump(n, -0.2, 1, 0.6, 0.35) + 9.0 * bump(n, -0.8, -0.3, -0.6, 0.25);
    head->GetPoints()->SetPoint(i, 1.2 * radius * n[0], 0.9 * radius * n[1], radius * n[2]);
    height->InsertNextValue(n[2]);
    head->GetPointData()
      ->GetArray("SpherePosition")
      ->SetTuple3(i, std::cos(angle) * n[0] - std::sin(angle) * n[1],
        std::sin(angle) * n[0] + std::cos(angle) * n[1], n[2]);
  }
  head->GetPointData()->AddArray(height);
  return head;
}

/// Return a torus of revolution around the axis z, with major radius 1. The torus has `along` by
/// `around` quadrilaterals, each divided into two triangles.
/// @param[in] isReversed  whether triangles are clockwise seen from outside
inline vtkNew<vtkPolyData> Torus(double radius, int along, int around, bool isReversed = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const auto id = [=](int i, int j) -> vtkIdType
  { return static_cast<vtkIdType>(i % along) * around + j % around; };
  const double turn = 8.0 * std::atan(1.0);
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const double s = turn * i / along, t = turn * j / around, r = 1.0 + radius * std::cos(t);
      points->InsertNextPoint(r * std::cos(s), r * std::sin(s), radius * std::sin(t));
      const vtkIdType a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
      triangles->InsertNextCell({ a, isReversed ? c : b, isReversed ? b : c });
      triangles->InsertNextCell({ a, isReversed ? d : c, isReversed ? c : d });
    }
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

/// Return a body of two lobes of different size, connected by a neck, like some comets. The origin
/// is inside. The map of each point is the direction from the origin. The body has 10 f^2 + 2
/// points, where f is the frequency.
inline vtkNew<vtkPolyData> TwoLobes(int frequency)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    const double neck = 1.0 - 0.55 * std::exp(-8.0 * p[0] * p[0]);
    surface->GetPoints()->SetPoint(
      i, neck * (1.8 + 0.4 * p[0]) * p[0], 1.1 * neck * p[1], neck * (1.0 + 0.1 * p[1]) * p[2]);
  }
  return surface;
}

/// Change the polygons of a surface one by one. The function change(cell, ids) may change the ids
/// of a polygon. If the function returns false, the polygon is removed.
template <typename Change>
void ChangePolygons(vtkPolyData* surface, Change change)
{
  vtkNew<vtkCellArray> changed;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, ids);
    if (change(i, ids.Get()))
    {
      changed->InsertNextCell(ids);
    }
  }
  surface->SetPolys(changed);
}

/// Reverse the orientation of the triangles 0, step, 2 step and so on.
inline void TurnOverEvery(vtkIdType step, vtkPolyData* surface)
{
  ChangePolygons(surface,
    [step](vtkIdType i, vtkIdList* ids)
    {
      if (i % step == 0)
      {
        const vtkIdType first = ids->GetId(0);
        ids->SetId(0, ids->GetId(1));
        ids->SetId(1, first);
      }
      return true;
    });
}

/// Return a unit sphere with `count` handles. Each handle has 12 edges around.
inline vtkNew<vtkPolyData> SphereWithHandles(int count, int frequency = 40)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  handles::Mesh mesh;
  mesh.Points.resize(source->GetOutput()->GetNumberOfPoints());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    source->GetOutput()->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  ChangePolygons(source->GetOutput(),
    [&](vtkIdType, vtkIdList* ids)
    {
      mesh.Triangles.push_back({ static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)),
        static_cast<int>(ids->GetId(2)) });
      return true;
    });
  handles::addHandles(mesh, count, 2, 14.0 * 1.1 / frequency, 20);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& ids : mesh.Triangles)
  {
    triangles->InsertNextCell({ ids[0], ids[1], ids[2] });
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}
}

#endif

#include "Surfaces.h"

#include "vtkGeodesicSphereSource.h"
#include "vtkGlobalConformalMap.h"
#include "vtkSphericalTextureMap.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cases
{
namespace
{
// A point in [-1, 1]^3 in steps that leave room for small units, of no symmetry.
void Bumpy(const double n[3], double p[3])
{
  const double radius =
    0.5 + 0.06 * std::sin(3.0 * n[0] + 1.0) * std::cos(2.0 * n[1]) + 0.05 * n[0] * n[2];
  const double axes[3] = { 1.3, 1.0, 0.85 };
  for (int c = 0; c < 3; ++c)
  {
    p[c] = std::round(0x1p20 * (radius * axes[c] * n[c] + 0.07 * c)) * 0x1p-20;
  }
}

// A surface mapped to the sphere by its directions from (10, 0, 0).
template <typename Radius>
SurfacePointer Star(int frequency, Radius radius)
{
  const SurfacePointer surface = Sphere(frequency);
  surface->GetPointData()->SetNormals(nullptr);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double n[3];
    surface->GetPoint(i, n);
    const double r = radius(n);
    surface->GetPoints()->SetPoint(i, 10.0 + r * n[0], r * n[1], r * n[2]);
  }
  vtkNew<vtkIdTypeArray> shift; // else vtkCurvedSeamlessSurface warns
  shift->SetName("VertexShift");
  shift->InsertNextValue(0);
  surface->GetFieldData()->AddArray(shift);
  return surface;
}
}

//------------------------------------------------------------------------------
void Scale(vtkPointSet* surface, double scale)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, scale * p[0], scale * p[1], scale * p[2]);
  }
}

//------------------------------------------------------------------------------
SurfacePointer Sphere(int frequency)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  const auto surface = SurfacePointer::New();
  surface->DeepCopy(source->GetOutput());
  return surface;
}

//------------------------------------------------------------------------------
SurfacePointer BumpyMesh(double scale, int frequency)
{
  const SurfacePointer surface = Sphere(frequency);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    Bumpy(surface->GetPoint(i), p);
    points->InsertNextPoint(p);
  }
  surface->SetPoints(points);
  Scale(surface, scale);
  return surface;
}

//------------------------------------------------------------------------------
SurfacePointer BumpyCloud(double scale, int size)
{
  const auto cloud = SurfacePointer::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::uint32_t state = 1;
  const auto random = [&]()
  {
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state) * 0x1p-31 - 1.0;
  };
  while (points->GetNumberOfPoints() < size)
  {
    double n[3] = { random(), random(), random() };
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length > 0.1 && length < 1.0)
    {
      double p[3];
      for (double& c : n)
      {
        c /= length;
      }
      Bumpy(n, p);
      points->InsertNextPoint(p);
    }
  }
  cloud->SetPoints(points);
  Scale(cloud, scale);
  return cloud;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSphericalTextureMap> Painted(double scale)
{
  const auto texture = vtkSmartPointer<vtkSphericalTextureMap>::New();
  texture->SetInputData(BumpyMesh(scale));
  texture->SetViewDirection(0.3, 0.2, 1.0);
  return texture;
}

//------------------------------------------------------------------------------
SurfacePointer Head(int frequency)
{
  return Star(frequency,
    [](const double* n)
    { return 1.0 + 0.1 * std::sin(5.0 * n[0]) * std::cos(4.0 * n[1] + n[2]) + 0.2 * n[2]; });
}

//------------------------------------------------------------------------------
SurfacePointer Limbs(int frequency)
{
  return Star(frequency,
    [](const double* n)
    {
      double r = 0.3;
      for (int c = 0; c < 3; ++c)
      {
        r += std::exp(-(1.0 - std::abs(n[c])) / 0.03);
      }
      return r;
    });
}

//------------------------------------------------------------------------------
SurfacePointer Ring(double scale, int frequency)
{
  const int along = 10 * frequency, around = 6 * frequency;
  const auto surface = SurfacePointer::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const auto id = [=](int i, int j) -> vtkIdType
  { return static_cast<vtkIdType>(i % along) * around + j % around; };
  for (int i = 0; i < along; ++i)
  {
    const double s = 2.0 * vtkMath::Pi() * i / along;
    for (int j = 0; j < around; ++j)
    {
      const double t = 2.0 * vtkMath::Pi() * j / around,
                   tube = 0.4 + 0.06 * std::sin(s + 0.3) + 0.03 * std::cos(2.0 * s - t),
                   r = 1.0 + tube * std::cos(t);
      double p[3] = { r * std::cos(s), 0.9 * r * std::sin(s), tube * std::sin(t + 0.2) };
      for (double& c : p)
      {
        c = std::round(0x1p20 * c) * 0x1p-20;
      }
      points->InsertNextPoint(p);
      triangles->InsertNextCell({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      triangles->InsertNextCell({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  Scale(surface, scale);
  return surface;
}

//------------------------------------------------------------------------------
SurfacePointer MappedRing(double scale, int frequency)
{
  vtkNew<vtkGlobalConformalMap> map;
  map->SetInputData(Ring(scale, frequency));
  map->Update();
  return map->GetOutput();
}

//------------------------------------------------------------------------------
SurfacePointer PointsOf(vtkPolyData* surface)
{
  const auto cloud = SurfacePointer::New();
  cloud->SetPoints(surface->GetPoints());
  return cloud;
}

//------------------------------------------------------------------------------
SurfacePointer Colored(const SurfacePointer& surface)
{
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Heights");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(surface->GetPoint(i)[2]);
  }
  surface->GetPointData()->SetScalars(heights);
  return surface;
}

//------------------------------------------------------------------------------
SurfacePointer WithTexture(const SurfacePointer& surface)
{
  vtkNew<vtkSphericalTextureMap> map;
  map->SetInputData(surface);
  map->SetProjectionToLongitudeLatitude();
  map->Update();
  return map->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> LargePicture()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(512, 512, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 3 * 512 * 512, 100);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> BallVolume(int size, double scale)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  const double step = 2.0 * scale / size, first = 0.5 * step - scale;
  image->SetSpacing(step, step, step);
  image->SetOrigin(first, first, first);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Brightness");
  values->SetNumberOfValues(image->GetNumberOfPoints());
  const auto along = [=](vtkIdType i) { return (2.0 * static_cast<double>(i) + 1.0) / size - 1.0; };
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double radius =
      std::hypot(along(i % size), along(i / size % size), along(i / size / size));
    values->SetValue(i, 100.0 / (1.0 + std::exp(20.0 * (radius - 0.8))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}
}

#include "vtkCurvedSeamlessSurface.h"

#include "CurvedSeamlessSurface.h"
#include "GeodesicSphere.h"
#include "VertexNormals.h"
#include "vtkConformalConversions.h"
#include "vtkMeshConversions.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCurvedSeamlessSurface);

namespace
{
// The array SpherePosition, if there is one; it has to be one vector for each point.
bool ToSpherePositions(vtkPolyData* surface, conformal::Points& positions)
{
  vtkDataArray* array =
    surface->GetPointData()->GetArray(vtkConformalConversions::SpherePositionName());
  if (!array)
  {
    return false;
  }
  if (!vtkConformalConversions::ToVectors(array, positions) ||
    positions.rows() != surface->GetNumberOfPoints())
  {
    throw std::invalid_argument("the array SpherePosition has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples of " +
      std::to_string(array->GetNumberOfComponents()) + " components, but must have " +
      std::to_string(surface->GetNumberOfPoints()) + " of 3");
  }
  return true;
}

// Directions and triangles in which the surface is wanted.
conformal::GeodesicSphere DenseSphere(vtkPolyData* sphere, int frequency)
{
  if (!sphere)
  {
    return conformal::makeGeodesicSphere(frequency);
  }
  conformal::GeodesicSphere dense;
  dense.Faces = vtkConformalConversions::ToTriangles(sphere);
  if (!ToSpherePositions(sphere, dense.Positions))
  {
    dense.Positions = vtkConformalConversions::ToPoints(sphere->GetPoints());
  }
  return dense;
}

conformal::Points MapOf(vtkPolyData* surface, const std::vector<vtkIdType>& pointIds)
{
  conformal::Points all;
  if (!ToSpherePositions(surface, all))
  {
    throw std::invalid_argument(
      "the surface needs a point array SpherePosition: its map to the sphere");
  }
  conformal::Points positions(static_cast<conformal::Index>(pointIds.size()), 3);
  for (conformal::Index v = 0; v < positions.rows(); ++v)
  {
    positions.row(v) = all.row(pointIds[v]);
  }
  return positions;
}

conformal::Points Normals(
  const conformal::CurvedSeamlessSurfaceResult& result, const conformal::Triangles& triangles)
{
  conformal::Points normals = conformal::vertexNormals(result.Positions, triangles);
  for (conformal::Index i = 0; i < normals.rows(); ++i)
  {
    if (normals.row(i).isZero(0.0))
    {
      normals.row(i) = result.Normals.row(i);
    }
    if (normals.row(i).isZero(0.0))
    {
      normals.row(i) = result.Directions.row(i);
    }
  }
  return normals;
}

vtkNew<vtkUnsignedCharArray> DegenerateCells(
  const conformal::Triangles& triangles, const std::vector<unsigned char>& degeneratePoints)
{
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName("Degenerate");
  cells->SetNumberOfValues(triangles.rows());
  for (conformal::Index r = 0; r < triangles.rows(); ++r)
  {
    unsigned char degenerate = 0;
    for (int k = 0; k < 3; ++k)
    {
      degenerate |= degeneratePoints[triangles(r, k)];
    }
    cells->SetValue(r, degenerate);
  }
  return cells;
}
}

//------------------------------------------------------------------------------
vtkCurvedSeamlessSurface::vtkCurvedSeamlessSurface()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::SetSphereConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::SetSphereData(vtkPolyData* sphere)
{
  this->SetInputData(1, sphere);
}

//------------------------------------------------------------------------------
int vtkCurvedSeamlessSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkCurvedSeamlessSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* sphere = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (surface->GetNumberOfPoints() == 0 || (sphere && sphere->GetNumberOfPoints() == 0))
  {
    vtkWarningMacro(<< "the " << (surface->GetNumberOfPoints() == 0 ? "surface" : "dense sphere")
                    << " is empty, and so is the result");
    return 1;
  }
  return vtkConformalConversions::RunCore(this,
    [&]()
    {
      const auto mesh = vtkConformalConversions::ToClosedMesh(this, surface);
      const conformal::Points positions = MapOf(surface, mesh.PointIds);
      const conformal::GeodesicSphere dense = DenseSphere(sphere, this->Frequency);
      const auto result = conformal::buildCurvedSeamlessSurface(positions, mesh.Points,
        mesh.Triangles, dense.Positions, vtkConformalConversions::SMPFor(),
        vtkConformalConversions::ProgressOf(this));

      vtkConformalConversions::SetSurface(output, result.Positions, dense.Faces);
      vtkPointData* pointData = output->GetPointData();
      vtkConformalConversions::AddVectors(
        pointData, vtkConformalConversions::SpherePositionName(), result.Directions);
      vtkConformalConversions::AddVectors(pointData, "Normals", Normals(result, dense.Faces));
      pointData->SetActiveNormals("Normals");
      output->GetCellData()->AddArray(DegenerateCells(dense.Faces, result.Degenerate));
      vtkConformalConversions::AddNumber(output->GetFieldData(), "NumberOfDegenerateTriangles",
        static_cast<long long>(result.NumberOfDegenerateTriangles));
      if (result.NumberOfDegenerateTriangles > 0)
      {
        vtkWarningMacro(<< result.NumberOfDegenerateTriangles
                        << " triangles of the surface are degenerate: the construction is replaced "
                           "there as the cell array Degenerate tells");
      }
    });
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frequency: " << this->Frequency << "\n";
}

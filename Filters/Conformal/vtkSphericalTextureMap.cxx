#include "vtkSphericalTextureMap.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Sphere/SphereOrientation.h"
#include "SphereMap/BalancedPositions.h"
#include "Texture/SphericalTexture.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <stdexcept>

vtkStandardNewMacro(vtkSphericalTextureMap);

namespace
{
void AddTextureArrays(vtkPolyData* output, const conformal::SphericalTexture& texture)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Texture Coordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(texture.Coordinates.rows());
  std::transform(texture.Coordinates.data(),
    texture.Coordinates.data() + texture.Coordinates.size(), coordinates->GetPointer(0),
    [](double value) { return static_cast<float>(value); });
  output->GetPointData()->SetTCoords(coordinates);

  vtkNew<vtkUnsignedCharArray> outside;
  outside->SetName("OutsideImage");
  outside->SetNumberOfValues(static_cast<vtkIdType>(texture.OutsideImage.size()));
  std::copy(texture.OutsideImage.begin(), texture.OutsideImage.end(), outside->GetPointer(0));
  output->GetPointData()->AddArray(outside);
}

// Normalize interpolated vectors, since a mean of unit vectors is shorter than 1.
void Normalize(vtkDataArray* vectors, vtkIdType firstTuple)
{
  for (vtkIdType i = firstTuple; vectors && i < vectors->GetNumberOfTuples(); ++i)
  {
    double v[3];
    vectors->GetTuple(i, v);
    const conformal::PointView view(v, 1);
    conformal::Vector3 inFrame = conformal::frameOf({ view }).toFrame(view[0]);
    vtkMath::Normalize(inFrame.data());
    vectors->SetTuple(i, inFrame.data());
  }
}

// Arrays of which an added point gets the tuple of the nearest corner, since means of labels, ids
// and longitudes have no meaning.
using CopiedArrays = std::vector<std::pair<vtkDataArray*, vtkDataArray*>>; // from, to

CopiedArrays ArraysToCopy(vtkPointData* from, vtkPointData* to)
{
  CopiedArrays copied;
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    const bool isDirection =
      name == glue::SpherePositionName() || name == glue::TexturePositionName();
    vtkDataArray* target = name.empty() ? nullptr : to->GetArray(name.c_str());
    if (target && !isDirection && (glue::HoldsLabels(array) || glue::HoldsPlaces(name)))
    {
      copied.emplace_back(array, target);
    }
  }
  return copied;
}

// Set the points of the output: those of the input in the same sequence, then those added by the
// split.
void AddSplitPoints(
  vtkPolyData* output, vtkPolyData* input, const std::vector<conformal::SurfacePlace>& added)
{
  const vtkIdType kept = input->GetNumberOfPoints();
  const vtkIdType count = kept + static_cast<vtkIdType>(added.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  points->GetData()->InsertTuples(0, kept, 0, input->GetPoints()->GetData());
  vtkPointData* data = output->GetPointData();
  data->InterpolateAllocate(input->GetPointData(), count);
  data->CopyData(input->GetPointData(), 0, kept, 0);
  const CopiedArrays copied = ArraysToCopy(input->GetPointData(), data);
  vtkNew<vtkIdTypeArray> originalIds;
  originalIds->SetName("OriginalPointIds");
  originalIds->SetNumberOfValues(count);
  std::iota(originalIds->Begin(), originalIds->Begin() + kept, vtkIdType(0));
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(3);
  for (vtkIdType i = kept; i < count; ++i)
  {
    const conformal::SurfacePlace& place = added[i - kept];
    conformal::Vector3 position = conformal::Vector3::Zero();
    conformal::Vector3 weights = place.Weights;
    for (int k = 0; k < 3; ++k)
    {
      ids->SetId(k, place.Ids[k]);
      position += weights[k] * conformal::Vector3(input->GetPoint(place.Ids[k]));
    }
    points->SetPoint(i, position.data());
    originalIds->SetValue(i, place.isVertex() ? place.Ids[0] : -1);
    if (place.isVertex())
    {
      data->CopyData(input->GetPointData(), place.Ids[0], i);
    }
    else
    {
      data->InterpolatePoint(input->GetPointData(), i, ids, weights.data());
      conformal::Index nearest = 0;
      weights.maxCoeff(&nearest);
      for (const auto& [from, to] : copied)
      {
        to->SetTuple(i, place.Ids[nearest], from);
      }
    }
  }
  Normalize(data->GetArray(glue::SpherePositionName()), kept);
  Normalize(data->GetArray(glue::TexturePositionName()), kept);
  Normalize(data->GetNormals(), kept);
  output->SetPoints(points);
  data->AddArray(originalIds);
}

void AddSplitTriangles(vtkPolyData* output, vtkPolyData* input,
  const conformal::SphericalTexture& texture, const std::vector<vtkIdType>& cellIds)
{
  const conformal::Triangles& triangles = texture.SplitTriangles;
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(triangles.size());
  std::copy_n(triangles.data(), triangles.size(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, connectivity);
  output->SetPolys(cells);
  vtkNew<vtkIdTypeArray> originalIds;
  originalIds->SetName("OriginalCellIds");
  originalIds->SetNumberOfValues(triangles.rows());
  output->GetCellData()->CopyAllocate(input->GetCellData(), triangles.rows());
  for (vtkIdType i = 0; i < triangles.rows(); ++i)
  {
    originalIds->SetValue(i, cellIds[texture.TriangleIds[i]]);
    output->GetCellData()->CopyData(input->GetCellData(), originalIds->GetValue(i), i);
  }
  output->GetCellData()->AddArray(originalIds);
}

// Return whether the surface has texture positions that were computed by this balance.
bool IsBalanced(vtkPolyData* surface, double areaBalance)
{
  vtkDataArray* balance = surface->GetFieldData()->GetArray(glue::TextureAreaBalanceName());
  return surface->GetPointData()->HasArray(glue::TexturePositionName()) && balance &&
    balance->GetNumberOfValues() == 1 && balance->GetComponent(0, 0) == areaBalance;
}

// Warn of triangles that the balanced map flips.
void WarnOfFlips(
  vtkObject* self, const conformal::Points& positions, const conformal::Triangles& triangles)
{
  const conformal::Index flipped = conformal::countFlippedTriangles(positions, triangles);
  if (flipped > 0)
  {
    vtkWarningWithObjectMacro(self, << flipped << " of " << triangles.rows()
                                    << " triangles show the image backwards, since limbs are too "
                                       "long for the balanced map. To lay the image by the map of "
                                       "the surface, set AreaBalance to 0");
  }
}

// Return the input with the texture positions for the balance, or without any if the balance is 0.
vtkSmartPointer<vtkPolyData> Balanced(vtkObject* self, vtkPolyData* input, double areaBalance,
  const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->ShallowCopy(input);
  if (areaBalance > 0.0 && IsBalanced(input, areaBalance))
  {
    return surface;
  }
  surface->GetPointData()->RemoveArray(glue::TexturePositionName());
  if (areaBalance > 0.0)
  {
    const conformal::MappedMesh mesh = glue::CopyMapped(input, frame);
    const auto warn = [&](const std::exception& error)
    {
      vtkWarningWithObjectMacro(
        self, << "AreaBalance is not used, because the map cannot be balanced: " << error.what());
    };
    try
    {
      const conformal::Points positions = conformal::balancedPositions(mesh, areaBalance, run);
      WarnOfFlips(self, positions, mesh.Triangles);
      glue::AddVectors(surface->GetPointData(), glue::TexturePositionName(), positions);
      return surface;
    }
    catch (const std::invalid_argument& error)
    {
      warn(error);
    }
    catch (const conformal::NumericalFailure& error)
    {
      warn(error);
    }
  }
  return surface;
}

void AddBalance(vtkPolyData* output, double areaBalance)
{
  const bool isBalanced = output->GetPointData()->HasArray(glue::TexturePositionName());
  glue::AddNumber(
    output->GetFieldData(), glue::TextureAreaBalanceName(), isBalanced ? areaBalance : 0.0);
}

void AddGeometry(vtkPolyData* output, vtkPolyData* input,
  const conformal::SphericalTexture& texture, const std::vector<vtkIdType>& cellIds, bool isSplit)
{
  if (!isSplit)
  {
    output->ShallowCopy(input);
    return;
  }
  AddSplitPoints(output, input, texture.AddedPlaces);
  AddSplitTriangles(output, input, texture, cellIds);
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
}

conformal::SphericalTextureOptions OptionsOf(vtkSphericalTextureMap* self)
{
  conformal::SphericalTextureOptions options;
  options.ViewDirection = conformal::Vector3(self->GetViewDirection());
  options.ViewUp = conformal::Vector3(self->GetViewUp());
  options.UseViewPoint = self->GetUseViewPoint();
  options.Projection = static_cast<conformal::SphereProjection>(self->GetProjection());
  options.FieldOfView = self->GetFieldOfView();
  options.Rotation = self->GetRotation();
  options.Scale = conformal::Vector2(self->GetScale());
  options.Wrap = static_cast<conformal::TextureWrap>(self->GetWrap());
  options.SplitSeam = self->GetSplitSeam();
  options.Margin = self->GetMargin();
  return options;
}
}

//------------------------------------------------------------------------------
int vtkSphericalTextureMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto unbalanced = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  conformal::SphericalTextureOptions options = OptionsOf(this);
  const conformal::Vector3 viewPoint(this->ViewPoint);
  const double areaBalance = this->AreaBalance;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(
            this, unbalanced, "the surface is empty; there are no texture coordinates"))
      {
        return;
      }
      const conformal::CoordinateFrame frame = glue::FrameOf({ unbalanced });
      options.ViewPoint = frame.toFrameFromAfar(viewPoint);
      // Relative costs of the balance, and of the steps that are proportional to the number of
      // vertices.
      conformal::Steps steps(
        glue::RunOf(this), { areaBalance > 0.0 ? 2.0 : 0.0, 0.1, 0.05, 0.7, 0.15 });
      const vtkSmartPointer<vtkPolyData> input =
        Balanced(this, unbalanced, areaBalance, frame, steps.next());
      steps.next();
      conformal::Points copy;
      std::vector<vtkIdType> cellIds;
      const conformal::Triangles triangles = glue::ToTriangles(input, cellIds);
      steps.next();
      const conformal::Points map = glue::ToTexturePositions(input);
      const conformal::SphericalTexture texture = conformal::makeSphericalTexture(
        glue::ViewPoints(input->GetPoints(), frame, copy), triangles, map, options, steps.next());
      steps.next();
      AddGeometry(output, input, texture, cellIds, options.SplitSeam);
      AddTextureArrays(output, texture);
      glue::AddSphereImage(output->GetFieldData(), texture.Image);
      AddBalance(output, areaBalance);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalTextureMap::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const projections[] = { "Stereographic", "LongitudeLatitude", "Octahedral",
    "CubeMap", "Disk", "Square" };
  static const char* const wraps[] = { "Clamp", "Repeat", "Mirror" };
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* v, int size)
  {
    os << indent << name << ": (" << v[0];
    for (int i = 1; i < size; ++i)
    {
      os << ", " << v[i];
    }
    os << ")\n";
  };
  vector("ViewDirection", this->ViewDirection, 3);
  vector("ViewUp", this->ViewUp, 3);
  os << indent << "UseViewPoint: " << (this->UseViewPoint ? "On" : "Off") << "\n";
  vector("ViewPoint", this->ViewPoint, 3);
  os << indent << "Projection: " << projections[this->Projection] << "\n";
  os << indent << "FieldOfView: " << this->FieldOfView << "\n";
  os << indent << "Rotation: " << this->Rotation << "\n";
  vector("Scale", this->Scale, 2);
  os << indent << "Wrap: " << wraps[this->Wrap] << "\n";
  os << indent << "SplitSeam: " << (this->SplitSeam ? "On" : "Off") << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "AreaBalance: " << this->AreaBalance << "\n";
}

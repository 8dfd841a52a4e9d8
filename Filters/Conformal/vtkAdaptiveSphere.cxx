#include "vtkAdaptiveSphere.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Glue/Volumes.h"
#include "Sphere/AdaptiveSphere.h"
#include "Texture/PictureDensity.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkAdaptiveSphere);

namespace
{
// Mapped surface, with the id of the input's cell for each triangle.
struct Surface : conformal::MappedMesh
{
  std::vector<vtkIdType> CellIds;
};

Surface ToSurface(vtkPolyData* input)
{
  Surface surface;
  surface.Triangles = glue::ToTriangles(input, surface.CellIds);
  surface.Positions = glue::ToPoints(input->GetPoints(), glue::FrameOf({ input }));
  glue::RequireFiniteTriangles(surface);
  surface.SpherePositions = glue::ToSpherePositions(input);
  return surface;
}

// Return the values of an array of densities, divided by their maximum.
std::vector<double> NumbersOf(vtkDataArray* array, const std::string& name)
{
  if (array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the density array \"" + name + "\" has " +
      std::to_string(array->GetNumberOfComponents()) + " components instead of 1");
  }
  std::vector<double> numbers(array->GetNumberOfTuples());
  double maximum = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    numbers[i] = array->GetComponent(i, 0);
    if (!(numbers[i] >= 0.0) || !std::isfinite(numbers[i]))
    {
      throw std::invalid_argument("the density array \"" + name +
        "\" is negative or not finite "
        "at " +
        std::to_string(i));
    }
    maximum = std::max(maximum, numbers[i]);
  }
  for (double& number : numbers)
  {
    number = maximum > 0.0 ? number / maximum : 0.0;
  }
  return numbers;
}

std::vector<double> WeightsOfArray(
  vtkPolyData* input, const Surface& surface, const std::string& name)
{
  if (vtkDataArray* array = input->GetPointData()->GetArray(name.c_str()))
  {
    return NumbersOf(array, name);
  }
  vtkDataArray* array = input->GetCellData()->GetArray(name.c_str());
  if (!array)
  {
    throw std::invalid_argument("the surface has no point or cell array \"" + name +
      "\"; set DensityArrayName to the name of an array of numbers");
  }
  const std::vector<double> ofCells = NumbersOf(array, name);
  std::vector<double> ofTriangles(surface.CellIds.size());
  for (std::size_t r = 0; r < ofTriangles.size(); ++r)
  {
    ofTriangles[r] = ofCells[surface.CellIds[r]];
  }
  return conformal::vertexMeans(surface, ofTriangles);
}

// Change a density so that half of the points are distributed by the gradient of an image. If the
// image has only one color, the density is not changed.
conformal::SphereDensity WithDetails(conformal::SphereDensity density, vtkPolyData* surface,
  vtkImageData* image, const conformal::Run& run)
{
  vtkDataArray* pixels = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!pixels || image->GetNumberOfPoints() == 0 || image->GetDimensions()[2] != 1)
  {
    throw std::invalid_argument(
      "Density Image needs an image of one slice with point scalars on input port 1");
  }
  conformal::SphereImage layout;
  layout.Projection = conformal::SphereProjection::LongitudeLatitude;
  if (surface->GetFieldData()->HasArray("TextureProjection"))
  {
    if (surface->GetPointData()->HasArray(glue::TexturePositionName()))
    {
      throw std::invalid_argument(
        "Density Image needs a picture that vtkSphericalTextureMap placed "
        "with AreaBalance 0");
    }
    layout = glue::ToSphereImage(surface->GetFieldData());
  }
  return conformal::withDetails(std::move(density), glue::ToPicture(image, pixels), layout, run);
}

// Compute the density at each point of the surface: 1 everywhere, the values of an array, or by
// curvature.
std::vector<double> WeightsOf(
  vtkPolyData* input, const Surface& surface, int density, const std::string& arrayName)
{
  switch (density)
  {
    case vtkAdaptiveSphere::ARRAY:
      return WeightsOfArray(input, surface, arrayName);
    case vtkAdaptiveSphere::CURVATURE:
      return conformal::weightsByBending(surface);
    default:
      return std::vector<double>(surface.Positions.rows(), 1.0);
  }
}
}

//------------------------------------------------------------------------------
vtkAdaptiveSphere::vtkAdaptiveSphere()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkAdaptiveSphere::SetImageConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkAdaptiveSphere::SetImageData(vtkImageData* image)
{
  this->SetInputData(1, image);
}

//------------------------------------------------------------------------------
int vtkAdaptiveSphere::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0);
  return 1;
}

//------------------------------------------------------------------------------
// Request the whole picture, since the density depends on all pixels.
int vtkAdaptiveSphere::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (vtkInformation* info = inputs[1]->GetInformationObject(0))
  {
    glue::RequestWholeImage(info);
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkAdaptiveSphere::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto input = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto image = glue::Held(vtkImageData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const int density = this->Density;
  const std::string arrayName = this->DensityArrayName;
  conformal::AdaptiveSphereOptions options;
  options.NumberOfPoints = this->NumberOfPoints;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, input, "the surface is empty; the output is empty"))
      {
        return;
      }
      // Relative costs of reading, density of the surface, density of the image, mesh and output.
      conformal::Steps steps(glue::RunOf(this), { 0.01, 0.08, 0.04, 0.86, 0.01 });
      steps.next();
      const Surface surface = ToSurface(input);
      conformal::SphereDensity share = conformal::densityOnSurface(
        surface, WeightsOf(input, surface, density, arrayName), steps.next());
      const conformal::Run reading = steps.next();
      if (density == IMAGE)
      {
        share = WithDetails(std::move(share), input, image, reading);
      }
      const conformal::Mesh sphere = conformal::makeAdaptiveSphere(share, options, steps.next());
      steps.next();
      const vtkNew<vtkPolyData> result;
      glue::SetSurface(result, sphere.Positions, sphere.Triangles, {});
      glue::AddVectors(result->GetPointData(), glue::SpherePositionName(), sphere.Positions);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkAdaptiveSphere::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const densities[] = { "Area", "Curvature", "Array", "Image" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Density: " << densities[this->Density] << "\n";
  os << indent << "DensityArrayName: " << this->DensityArrayName << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
}

#include "vtkVolumeSurfacePoints.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Run.h"
#include "Glue/Volumes.h"
#include "Volume/VolumeSurface.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <utility>

vtkStandardNewMacro(vtkVolumeSurfacePoints);

namespace
{
void SetPointCells(vtkPolyData* output)
{
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(output->GetNumberOfPoints(), output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    cells->InsertNextCell(1, &i);
  }
  output->SetVerts(cells);
}

void SetSurfacePoints(vtkPolyData* output, const conformal::VolumeSurface& surface)
{
  glue::SetPoints(output, surface.Positions, {});
  glue::AddVectors(output->GetPointData(), "Normals", surface.Normals);
  output->GetPointData()->SetActiveNormals("Normals");
  glue::AddNumber(output->GetFieldData(), "Level", surface.Level);
  glue::AddNumber(output->GetFieldData(), "CutFraction", surface.CutFraction);
  SetPointCells(output);
}

void WarnOfFaults(vtkObject* self, const conformal::VolumeSurface& surface)
{
  constexpr double accepted = 0.05;
  if (surface.ExceedsEverywhere)
  {
    vtkWarningWithObjectMacro(self, << "all values exceed the level " << surface.Level
                                    << ", so there is no surface; choose a higher Level");
  }
  else if (surface.Positions.rows() == 0)
  {
    vtkWarningWithObjectMacro(
      self, << "no value exceeds the level " << surface.Level
            << ", so there is no object; choose another Level or Component");
  }
  if (surface.CutFraction > accepted)
  {
    vtkWarningWithObjectMacro(self, << "the image cuts the object: " << 100.0 * surface.CutFraction
                                    << " % of the points are at the border of the image, where "
                                       "the surface is closed by a plane");
  }
}
}

//------------------------------------------------------------------------------
int vtkVolumeSurfacePoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkVolumeSurfacePoints::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  glue::RequestWholeImage(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkVolumeSurfacePoints::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto image = glue::Held(vtkImageData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  conformal::VolumeSurfaceOptions options;
  options.Smoothing = this->Smoothing;
  options.UseOtsuLevel = this->LevelMethod == OTSU;
  options.Level = this->Level;
  options.ClosingRadius = this->ClosingRadius;
  options.LargestObject = this->LargestObject;
  const std::string name = this->ArrayName;
  const int component = this->Component;
  const int piece = outputVector->GetInformationObject(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  return glue::RunCore(this,
    [&]()
    {
      if (piece > 0)
      {
        return; // the first piece contains all points
      }
      if (image->GetNumberOfPoints() == 0)
      {
        glue::WarnOfEmptyInput(this, "the image is empty; the output is empty");
        return;
      }
      conformal::Steps steps(glue::RunOf(this), { 0.05, 0.9, 0.05 }); // reading, core, output
      conformal::VolumeImage volume = glue::ToVolume(image, name, component, {}, steps.next());
      const conformal::VolumeSurface surface =
        conformal::sampleVolumeSurface(std::move(volume), options, steps.next());
      steps.next();
      const vtkNew<vtkPolyData> result;
      SetSurfacePoints(result, surface);
      WarnOfFaults(this, surface);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkVolumeSurfacePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "LevelMethod: " << (this->LevelMethod == OTSU ? "Otsu" : "Fixed") << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "ClosingRadius: " << this->ClosingRadius << "\n";
  os << indent << "LargestObject: " << (this->LargestObject ? "On" : "Off") << "\n";
}

#include "vtkSurfaceMismatch.h"

#include "SurfaceMismatch.h"
#include "vtkConformalConversions.h"
#include "vtkMeshConversions.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <vector>

vtkStandardNewMacro(vtkSurfaceMismatch);

namespace
{
// The input, with the distances of its points.
void PassWithDistances(
  vtkPolyData* input, vtkPolyData* output, const std::vector<double>& distances)
{
  output->ShallowCopy(input);
  vtkConformalConversions::AddNumbers(output->GetPointData(), "Distance", distances);
  output->GetPointData()->SetActiveScalars("Distance");
}
}

//------------------------------------------------------------------------------
vtkSurfaceMismatch::vtkSurfaceMismatch()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSurfaceMismatch::SetReferenceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkSurfaceMismatch::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(1, reference);
}

//------------------------------------------------------------------------------
int vtkSurfaceMismatch::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* model = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* referenceOutput = vtkPolyData::GetData(outputVector, 1);

  conformal::SurfaceMismatchOptions options;
  options.LengthUnit = static_cast<conformal::MismatchUnit>(this->LengthUnit);
  options.NumberOfSamples = this->NumberOfSamples;
  options.RandomSeed = this->RandomSeed;
  return vtkConformalConversions::RunCore(this,
    [&]()
    {
      if (model->GetNumberOfPoints() == 0 || reference->GetNumberOfPoints() == 0)
      {
        vtkConformalConversions::WarnOfEmptyInput(this,
          model->GetNumberOfPoints() == 0 ? "the model is empty, nothing was measured"
                                          : "the reference is empty, nothing was measured");
        return;
      }
      conformal::Points modelCopy, referenceCopy;
      const conformal::SurfaceMismatch mismatch = conformal::measureSurfaceMismatch(
        vtkConformalConversions::ViewPoints(model->GetPoints(), modelCopy),
        vtkConformalConversions::ToTriangles(model),
        vtkConformalConversions::ViewPoints(reference->GetPoints(), referenceCopy),
        vtkConformalConversions::ToTriangles(reference), options, vtkConformalConversions::SMPFor(),
        vtkConformalConversions::ProgressOf(this));

      PassWithDistances(model, output, mismatch.ModelDistances);
      PassWithDistances(reference, referenceOutput, mismatch.ReferenceDistances);
      vtkFieldData* data = output->GetFieldData();
      using vtkConformalConversions::AddNumber;
      AddNumber(data, "MeanSquarePointToSurface", mismatch.MeanSquarePointToSurface);
      AddNumber(data, "MeanSquarePointToVertex", mismatch.MeanSquarePointToVertex);
      AddNumber(data, "MeanSquareSurfaceToPoint", mismatch.MeanSquareSurfaceToPoint);
      AddNumber(data, "HausdorffDistance", mismatch.HausdorffDistance);
      AddNumber(data, "WebFraction", mismatch.WebFraction);
      AddNumber(data, "LengthUnit", mismatch.LengthUnit);
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceMismatch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}

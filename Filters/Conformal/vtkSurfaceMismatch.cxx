#include "vtkSurfaceMismatch.h"

#include "Base/AcrossProcesses.h"
#include "Base/Steps.h"
#include "Measure/SurfaceMismatch.h"
#include "vtkConformalConversions.h"
#include "vtkMeshConversions.h"
#include "vtkProcessConversions.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <vector>

vtkStandardNewMacro(vtkSurfaceMismatch);
vtkCxxSetObjectMacro(vtkSurfaceMismatch, Controller, vtkMultiProcessController);

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
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkSurfaceMismatch::~vtkSurfaceMismatch()
{
  this->SetController(nullptr);
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
int vtkSurfaceMismatch::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkConformalConversions::RequestOwnPieces(this, this->Controller, inputs);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkSurfaceMismatch::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto model = vtkConformalConversions::Held(vtkPolyData::GetData(inputVector[0]));
  const auto reference = vtkConformalConversions::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* referenceOutput = vtkPolyData::GetData(outputVector, 1);

  conformal::SurfaceMismatchOptions options;
  options.LengthUnit = static_cast<conformal::MismatchUnit>(this->LengthUnit);
  options.NumberOfSamples = this->NumberOfSamples;
  options.RandomSeed = this->RandomSeed;
  return vtkConformalConversions::RunCore(this, this->Controller,
    [&](vtkConformalConversions::Processes& processes)
    {
      const bool hasModel = processes.firstWith(model->GetNumberOfPoints() > 0) >= 0;
      const bool hasReference = processes.firstWith(reference->GetNumberOfPoints() > 0) >= 0;
      if (!hasModel || !hasReference)
      {
        vtkConformalConversions::WarnOfEmptyInput(this,
          hasModel ? "the reference is empty; nothing was measured"
                   : "the model is empty; nothing was measured");
        return;
      }
      const conformal::Reduce reduce = processes.reduce();
      const conformal::CoordinateFrame frame =
        vtkConformalConversions::FrameOf({ model, reference }, reduce);
      options.CoordinateUnit = frame.Unit;
      const auto modelSize = static_cast<double>(model->GetNumberOfPoints());
      const auto referenceSize = static_cast<double>(reference->GetNumberOfPoints());
      const double sizes = modelSize + referenceSize;
      conformal::Steps steps(processes.run(),
        { 80.0 * sizes, 1500.0 * sizes + 500.0 * options.NumberOfSamples, 10.0 * sizes });
      steps.next();
      conformal::Points modelCopy, referenceCopy;
      conformal::PointView modelPoints =
        vtkConformalConversions::ViewPoints(model->GetPoints(), frame, modelCopy);
      conformal::Triangles modelTriangles = vtkConformalConversions::ToTriangles(model);
      vtkIdType firstOwn = 0;
      if (processes.size() > 1)
      {
        firstOwn = conformal::shareOf(reduce, modelPoints.size()).Before;
        modelTriangles = conformal::gatherTriangles(reduce, modelTriangles, modelPoints.size());
        modelCopy = conformal::gatherRows(
          reduce, vtkConformalConversions::ToPoints(model->GetPoints(), frame));
        modelPoints = modelCopy;
      }
      const conformal::PointView referencePoints =
        vtkConformalConversions::ViewPoints(reference->GetPoints(), frame, referenceCopy);
      const conformal::Triangles referenceTriangles =
        vtkConformalConversions::ToTriangles(reference);
      const conformal::SurfaceMismatch mismatch = conformal::measureSurfaceMismatch(modelPoints,
        modelTriangles, referencePoints, referenceTriangles, options, reduce, steps.next());

      steps.next();
      const auto own = mismatch.ModelDistances.begin() + firstOwn;
      PassWithDistances(model, output, { own, own + model->GetNumberOfPoints() });
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
  static const char* const lengthUnits[] = { "MaxRadius", "HalfDiagonal", "None" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LengthUnit: " << lengthUnits[this->LengthUnit] << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}

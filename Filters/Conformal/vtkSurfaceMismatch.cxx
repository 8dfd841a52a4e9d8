#include "vtkSurfaceMismatch.h"

#include "Base/AcrossProcesses.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Measure/SurfaceMismatch.h"

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
conformal::SurfaceMismatchOptions OptionsOf(vtkSurfaceMismatch* self)
{
  conformal::SurfaceMismatchOptions options;
  options.LengthUnit = static_cast<conformal::MismatchUnit>(self->GetLengthUnit());
  options.NumberOfSamples = self->GetNumberOfSamples();
  options.RandomSeed = self->GetRandomSeed();
  options.CurvatureRadius = self->GetCurvatureRadius();
  return options;
}

// Pass the input to the output, and add the distances of its points.
void PassWithDistances(
  vtkPolyData* input, vtkPolyData* output, const std::vector<double>& distances)
{
  output->ShallowCopy(input);
  glue::AddNumbers(output->GetPointData(), "Distance", distances);
  output->GetPointData()->SetActiveScalars("Distance");
}

// Whole model, gathered on all processes, and the range of points that this process has
// contributed.
struct SharedModel
{
  conformal::PointView Points;
  conformal::Triangles Triangles;
  vtkIdType FirstOwn = 0;
  conformal::Points Copy; // memory of Points, unless they view the input
};

void Share(vtkPolyData* model, const conformal::CoordinateFrame& frame,
  const glue::Processes& processes, const conformal::Reduce& reduce, SharedModel& shared)
{
  shared.Points = glue::ViewPoints(model->GetPoints(), frame, shared.Copy);
  shared.Triangles = glue::ToTriangles(model);
  if (processes.size() > 1)
  {
    shared.FirstOwn = conformal::shareOf(reduce, shared.Points.size()).Before;
    shared.Triangles = conformal::gatherTriangles(reduce, shared.Triangles, shared.Points.size());
    shared.Copy = conformal::gatherRows(reduce, glue::ToPoints(model->GetPoints(), frame));
    shared.Points = shared.Copy;
  }
}

void AddFigures(vtkFieldData* data, const conformal::SurfaceMismatch& mismatch)
{
  glue::AddNumber(data, "MeanSquarePointToSurface", mismatch.MeanSquarePointToSurface);
  glue::AddNumber(data, "MeanSquarePointToVertex", mismatch.MeanSquarePointToVertex);
  glue::AddNumber(data, "MeanSquareSurfaceToPoint", mismatch.MeanSquareSurfaceToPoint);
  glue::AddNumber(data, "HausdorffDistance", mismatch.HausdorffDistance);
  glue::AddNumber(data, "WebFraction", mismatch.WebFraction);
  if (mismatch.HasNormalAngle)
  {
    glue::AddNumber(data, "RootMeanSquareNormalAngle", mismatch.RootMeanSquareNormalAngle);
    glue::AddNumber(data, "RootMeanSquareCurvatureError", mismatch.RootMeanSquareCurvatureError);
  }
  glue::AddNumber(data, "LengthUnit", mismatch.LengthUnit);
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
  glue::RequestOwnPieces(this, this->Controller, inputs);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkSurfaceMismatch::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto model = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto reference = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* referenceOutput = vtkPolyData::GetData(outputVector, 1);
  conformal::SurfaceMismatchOptions options = OptionsOf(this);
  return glue::RunCore(this, this->Controller,
    [&](glue::Processes& processes)
    {
      const bool hasModel = processes.firstWith(model->GetNumberOfPoints() > 0) >= 0;
      const bool hasReference = processes.firstWith(reference->GetNumberOfPoints() > 0) >= 0;
      if (!hasModel || !hasReference)
      {
        glue::WarnOfEmptyInput(this, processes,
          hasModel ? "the reference is empty; there are no distances"
                   : "the model is empty; nothing was measured");
        return;
      }
      const conformal::Reduce reduce = processes.reduce();
      const conformal::CoordinateFrame frame = glue::FrameOf({ model, reference }, reduce);
      options.CoordinateUnit = frame.Unit;
      // Relative costs of reading, figures and output.
      conformal::Steps steps(processes.run(), { 0.05, 0.94, 0.01 });
      steps.next();
      SharedModel shared;
      Share(model, frame, processes, reduce, shared);
      conformal::Points copy;
      const conformal::SurfaceMismatch mismatch = conformal::measureSurfaceMismatch(shared.Points,
        shared.Triangles, glue::ViewPoints(reference->GetPoints(), frame, copy),
        glue::ToTriangles(reference), options, reduce, steps.next());
      steps.next();
      const auto own = mismatch.ModelDistances.begin() + shared.FirstOwn;
      PassWithDistances(model, output, { own, own + model->GetNumberOfPoints() });
      PassWithDistances(reference, referenceOutput, mismatch.ReferenceDistances);
      AddFigures(output->GetFieldData(), mismatch);
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
  os << indent << "CurvatureRadius: " << this->CurvatureRadius << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}

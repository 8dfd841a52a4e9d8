#include "vtkGenusZeroHull.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/CloudInput.h"
#include "Glue/CloudNormals.h"
#include "Glue/CloudWarnings.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Glue/Scanners.h"
#include "Hull/GenusZeroHull.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkGenusZeroHull);
vtkCxxSetObjectMacro(vtkGenusZeroHull, Controller, vtkMultiProcessController);

namespace
{
conformal::GenusZeroHullOptions OptionsOf(vtkGenusZeroHull* self)
{
  conformal::GenusZeroHullOptions options;
  options.Method = static_cast<conformal::HullMethod>(self->GetMethod());
  options.Spacing = self->GetSpacing();
  options.Offset = self->GetOffset();
  options.Persistence = self->GetPersistence();
  options.Genus = static_cast<conformal::HullGenus>(self->GetGenus());
  options.HandleWidth = self->GetHandleWidth();
  options.SmoothingPasses = self->GetSmoothingPasses();
  return options;
}

// Warn of defects of the points and of the hull.
void WarnAbout(vtkGenusZeroHull* self, const conformal::TrainingSamples& samples,
  const conformal::GenusZeroHullResult& hull)
{
  if (samples.numberOfNonFinite() > 0)
  {
    glue::WarnOfNonFinitePoints(self, samples.numberOfNonFinite());
  }
  if (samples.empty())
  {
    vtkWarningWithObjectMacro(self, << "there are no points to wrap; the output is empty");
  }
  else if (samples.dimension() < 3)
  {
    vtkWarningWithObjectMacro(
      self, << "the points are "
            << (samples.dimension() == 2      ? "coplanar"
                   : samples.dimension() == 1 ? "collinear"
                                              : "all equal")
            << ": they enclose nothing, and the hull is a shell around them");
  }
  else if (hull.Leaks)
  {
    vtkWarningWithObjectMacro(self,
      << "the points have a hole nearly as wide as the space behind it; the inside may be wrong");
  }
  else if (hull.NumberOfInsideNodes == 0)
  {
    vtkWarningWithObjectMacro(
      self, << "the points enclose nothing, the hull is a shell around them");
  }
  if (samples.oriented() && hull.Method == conformal::HullMethod::WindingNumbers &&
    !hull.NormalsUsed)
  {
    glue::WarnOfUnusedNormals(self);
  }
  if (conformal::hasHandles(hull))
  {
    glue::WarnOfCutHandles(self, conformal::cutFraction(hull));
  }
  // Even without defects, up to 0.1 % of a closed scan's points are outside, where points are far
  // apart.
  const conformal::Index noticeable = samples.totalSize() / 200;
  if (hull.NumberOfSamplesOutside > noticeable)
  {
    glue::WarnOfPointsApart(self, hull.NumberOfSamplesOutside, samples.totalSize());
  }
  if (hull.NumberOfSamplesInside > noticeable)
  {
    glue::WarnOfPointsInside(self, hull.NumberOfSamplesInside, samples.totalSize());
  }
}

void AddFigures(vtkFieldData* data, const conformal::TrainingSamples& samples,
  const conformal::GenusZeroHullResult& hull, const conformal::FarPoints& far,
  const conformal::CoordinateFrame& frame)
{
  using glue::AddNumber;
  const auto addLength = [&](const char* name, double length)
  { glue::AddLengths(data, name, { length * samples.scale() }, frame); };
  AddNumber(data, "AffineRank", static_cast<long long>(samples.dimension()));
  AddNumber(data, "Method", static_cast<long long>(hull.Method));
  AddNumber(data, "NormalsUsed", static_cast<long long>(hull.NormalsUsed));
  addLength("KernelWidth", hull.Width);
  addLength("GridSpacing", hull.Spacing);
  AddNumber(data, "NumberOfInsideNodes", static_cast<long long>(hull.NumberOfInsideNodes));
  AddNumber(data, "SolidEulerNumber", static_cast<long long>(hull.EulerNumber));
  AddNumber(data, "NumberOfHandles", static_cast<long long>(hull.NumberOfHandles));
  AddNumber(data, "NumberOfCutNodes", static_cast<long long>(hull.NumberOfCutNodes));
  addLength("HoleWidth", hull.LargestHole.Saddle);
  addLength("HoleDepth", hull.LargestHole.Peak);
  AddNumber(data, "Leaks", static_cast<long long>(hull.Leaks));
  AddNumber(
    data, "NumberOfPointsOutside", static_cast<long long>(hull.NumberOfSamplesOutside) + far.Count);
  AddNumber(data, "NumberOfPointsInside", static_cast<long long>(hull.NumberOfSamplesInside));
}
}

//------------------------------------------------------------------------------
vtkGenusZeroHull::vtkGenusZeroHull()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkGenusZeroHull::~vtkGenusZeroHull()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
int vtkGenusZeroHull::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGenusZeroHull::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  glue::RequestOwnPieces(this, this->Controller, inputs);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkGenusZeroHull::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto input = glue::Held(vtkPointSet::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);

  const conformal::GenusZeroHullOptions options = OptionsOf(this);
  const bool inPieces = this->DistributeOutput;
  return glue::RunCore(this, this->Controller,
    [&](glue::Processes& processes)
    {
      // Relative costs of copies, samples, hull and output.
      conformal::Steps steps(processes.run(), { 0.05, 0.02, 0.91, 0.02 });
      glue::CloudInput cloud;
      glue::ReadCloud(input, {}, nullptr, processes.reduce(), cloud);
      glue::SkipCopies({}, processes.reduce(), steps.next(), cloud);
      conformal::TrainingSamples samples(
        cloud.View, {}, cloud.Skip, processes.reduce(), steps.next());
      glue::CloudNormals normals;
      glue::SetNormals(input, cloud.Frame, options.Method, samples, normals);
      conformal::Points scanners;
      glue::SetScanners(input, cloud.Frame, samples, scanners);
      conformal::GenusZeroHullResult hull;
      if (!samples.empty())
      {
        hull = conformal::makeGenusZeroHull(samples, options, steps.next());
      }
      if (processes.isFirst())
      {
        WarnAbout(this, samples, hull);
        glue::WarnOfFarPoints(this, cloud.Far);
      }
      if (!samples.empty())
      {
        steps.next();
        glue::SetSurface(output, samples.restoreAll(hull.Positions), hull.Triangles, cloud.Frame);
        AddFigures(output->GetFieldData(), samples, hull, cloud.Far, cloud.Frame);
        glue::KeepOwnShare(output, inPieces, processes);
      }
    });
}

//------------------------------------------------------------------------------
void vtkGenusZeroHull::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: "
     << (this->Method == AUTOMATIC            ? "Automatic"
            : this->Method == WINDING_NUMBERS ? "WindingNumbers"
                                              : "Distance")
     << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "Persistence: " << this->Persistence << "\n";
  os << indent << "Genus: " << (this->Genus == AS_FOUND ? "AsFound" : "Zero") << "\n";
  os << indent << "HandleWidth: " << this->HandleWidth << "\n";
  os << indent << "SmoothingPasses: " << this->SmoothingPasses << "\n";
  os << indent << "DistributeOutput: " << (this->DistributeOutput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}

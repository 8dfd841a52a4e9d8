#include "vtkDeformationTransfer.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/MappedSurfaces.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Motion/DeformationTransfer.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDeformationTransfer);

namespace
{
using Executive = vtkStreamingDemandDrivenPipeline;

// Return the number of the last pose at or before a time, and that time.
std::size_t PoseAt(const std::vector<double>& times, double time)
{
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return after == times.begin() ? 0 : after - times.begin() - 1;
}

// Append the poses. Those of separate inputs and of blocks are numbered by their times.
void AddPoses(vtkInformationVector* inputs, glue::Surfaces& poses)
{
  const bool isNumbered = glue::TimeStepsOf(inputs).empty();
  glue::AddSurfaces(
    inputs, poses, isNumbered ? glue::MissingBlocks::Empty : glue::MissingBlocks::LeftOut);
}

// Return the pose at the requested time. Replace the requested time by that of the pose.
vtkPolyData* RequestedPose(vtkInformationVector* inputs, const glue::Surfaces& poses, double& time)
{
  const std::vector<double> times = glue::TimeStepsOf(inputs);
  if (!times.empty())
  {
    if (poses.Held.size() != 1)
    {
      throw std::invalid_argument("poses with time steps must be a single surface at each time");
    }
    time = times[PoseAt(times, time)];
    return poses.Held.front();
  }
  const std::vector<double> counted = glue::CountedTimes(poses.Held.size());
  const std::size_t number = PoseAt(counted, time);
  time = counted[number];
  return poses.Held[number];
}

std::vector<int> ContactsOf(vtkPolyData* target, const std::string& name)
{
  std::vector<int> contacts;
  if (name.empty())
  {
    return contacts;
  }
  vtkDataArray* array = target->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the target has no point array \"" + name +
      "\" of 1 component; set ContactArrayName to the name of one, or to an empty one");
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (array->GetComponent(i, 0) != 0.0)
    {
      contacts.push_back(static_cast<int>(i));
    }
  }
  return contacts;
}

// Copy a surface at rest, or name it in the error message.
conformal::MappedMesh CopyAtRest(
  vtkPolyData* surface, const conformal::CoordinateFrame& frame, const char* name)
{
  try
  {
    return glue::CopyMapped(surface, frame);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(std::string("the ") + name + ": " + error.what());
  }
}

vtkSmartPointer<vtkPolyData> Deformed(vtkPolyData* target, const conformal::TransferredShape& shape,
  const conformal::CoordinateFrame& frame)
{
  auto deformed = vtkSmartPointer<vtkPolyData>::New();
  deformed->ShallowCopy(target);
  glue::RemoveNormals(deformed);
  glue::SetPoints(deformed, shape.Positions, frame);
  glue::AddNumber(deformed->GetFieldData(), "TransferResidual", shape.Residual);
  return deformed;
}

void RequireSameCells(vtkPolyData* pose, vtkPolyData* source)
{
  if (pose->GetNumberOfPoints() != source->GetNumberOfPoints())
  {
    throw std::invalid_argument("the pose has " + std::to_string(pose->GetNumberOfPoints()) +
      " points, but the source at rest has " + std::to_string(source->GetNumberOfPoints()));
  }
  glue::RequireCellIds(source);
  glue::RequireCellIds(pose);
  if (!glue::HaveEqualPolygons(pose, source))
  {
    throw std::invalid_argument("the polygons of the pose are not those of the source at rest: a "
                                "pose must have the same points and polygons, in the same order");
  }
}
}

// Surfaces at rest, which do not depend on the pose. They are prepared again only if one of them or
// a property has changed.
struct vtkDeformationTransfer::Prepared
{
  static std::shared_ptr<const Prepared> make(
    const glue::Surfaces& rest, bool align, const std::string& contacts, const conformal::Run& run)
  {
    vtkPolyData *target = rest.Held[0], *source = rest.Held[1];
    const conformal::CoordinateFrame targetFrame = glue::FrameOf({ target }),
                                     sourceFrame = glue::FrameOf({ source });
    conformal::DeformationTransferOptions options;
    options.AlignRotation = align;
    return std::shared_ptr<const Prepared>(
      new Prepared{ rest.Times, align, contacts, targetFrame, sourceFrame,
        conformal::DeformationTransfer(CopyAtRest(source, sourceFrame, "source"),
          CopyAtRest(target, targetFrame, "target"), ContactsOf(target, contacts), options, run) });
  }

  std::vector<vtkMTimeType> Times; // modification times of target and source
  bool AlignRotation;
  std::string ContactArrayName;
  conformal::CoordinateFrame TargetFrame, SourceFrame;
  conformal::DeformationTransfer Transfer;

  bool isOf(const std::vector<vtkMTimeType>& times, bool align, const std::string& contacts) const
  {
    return this->Times == times && this->AlignRotation == align &&
      this->ContactArrayName == contacts;
  }
};

//------------------------------------------------------------------------------
vtkDeformationTransfer::vtkDeformationTransfer()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
vtkDeformationTransfer::~vtkDeformationTransfer() = default;

//------------------------------------------------------------------------------
void vtkDeformationTransfer::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkDeformationTransfer::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkDeformationTransfer::SetPoseConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

//------------------------------------------------------------------------------
void vtkDeformationTransfer::SetPoseData(vtkDataObject* pose)
{
  this->SetInputDataObject(2, pose);
}

//------------------------------------------------------------------------------
void vtkDeformationTransfer::AddPoseConnection(vtkAlgorithmOutput* output)
{
  this->AddInputConnection(2, output);
}

//------------------------------------------------------------------------------
void vtkDeformationTransfer::AddPoseData(vtkDataObject* pose)
{
  this->AddInputDataObject(2, pose);
}

//------------------------------------------------------------------------------
void vtkDeformationTransfer::RemoveAllPoses()
{
  this->SetInputConnection(2, nullptr);
}

//------------------------------------------------------------------------------
int vtkDeformationTransfer::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port < 2)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  glue::AcceptSurfaces(info);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkDeformationTransfer::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  std::vector<double> times = glue::TimeStepsOf(inputs[2]);
  if (times.empty())
  {
    // Blocks can be counted only if the input is up to date. Otherwise, RequestData counts them.
    glue::Surfaces poses;
    try
    {
      AddPoses(inputs[2], poses);
    }
    catch (const std::invalid_argument&)
    {
      return 1; // RequestData reports it
    }
    times = glue::CountedTimes(
      std::max<std::size_t>(poses.Held.size(), inputs[2]->GetNumberOfInformationObjects()));
  }
  if (!times.empty())
  {
    glue::SetTimeSteps(outputs->GetInformationObject(0), times);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkDeformationTransfer::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  const std::vector<double> times = glue::TimeStepsOf(inputs[2]);
  if (!times.empty() && info->Has(Executive::UPDATE_TIME_STEP()))
  {
    // The source of the poses may interpolate, or choose the nearest time.
    const double time = times[PoseAt(times, info->Get(Executive::UPDATE_TIME_STEP()))];
    inputs[2]->GetInformationObject(0)->Set(Executive::UPDATE_TIME_STEP(), time);
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkDeformationTransfer::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkInformation* info = outputs->GetInformationObject(0);
  double time =
    info->Has(Executive::UPDATE_TIME_STEP()) ? info->Get(Executive::UPDATE_TIME_STEP()) : 0.0;
  const bool align = this->AlignRotation;
  const std::string contacts = this->ContactArrayName;
  return glue::RunCore(this,
    [&]()
    {
      glue::Surfaces rest, poses;
      glue::AddSurfaces(inputs[0], rest);
      glue::AddSurfaces(inputs[1], rest);
      AddPoses(inputs[2], poses);
      if (glue::HasEmpty(this, rest) || (poses.Held.empty() && glue::HasEmpty(this, poses)))
      {
        return;
      }
      vtkPolyData *target = rest.Held[0], *source = rest.Held[1];
      vtkPolyData* pose = RequestedPose(inputs[2], poses, time);
      if (glue::TimeStepsOf(inputs[2]).empty())
      {
        glue::SetTimeSteps(info, glue::CountedTimes(poses.Held.size()));
      }
      if (glue::IsEmptyInput(this, pose, "the pose is empty; the output is empty"))
      {
        return;
      }
      RequireSameCells(pose, source);
      const bool isKept = this->Kept && this->Kept->isOf(rest.Times, align, contacts);
      conformal::Steps steps(glue::RunOf(this), { isKept ? 0.0 : 0.9, 0.08, 0.02 });
      const conformal::Run preparing = steps.next();
      const auto prepared = isKept ? this->Kept : Prepared::make(rest, align, contacts, preparing);
      const conformal::TransferredShape shape = prepared->Transfer.transfer(
        glue::ToPoints(pose->GetPoints(), prepared->SourceFrame), steps.next());
      steps.next();
      output->ShallowCopy(Deformed(target, shape, prepared->TargetFrame));
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
      this->Kept = prepared;
    });
}

//------------------------------------------------------------------------------
void vtkDeformationTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AlignRotation: " << (this->AlignRotation ? "on" : "off") << "\n";
  os << indent << "ContactArrayName: " << this->ContactArrayName << "\n";
}

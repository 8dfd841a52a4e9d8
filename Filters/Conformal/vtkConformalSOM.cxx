#include "vtkConformalSOM.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/CloudInput.h"
#include "Glue/CloudNormals.h"
#include "Glue/CloudWarnings.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Learn/ConformalSOM.h"
#include "Measure/Distortion.h"
#include "Mesh/GeodesicSphere.h"
#include "Surface/VertexShift.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkConformalSOM);
vtkCxxSetObjectMacro(vtkConformalSOM, Controller, vtkMultiProcessController);

namespace
{
conformal::ConformalSOMOptions OptionsOf(vtkConformalSOM* self)
{
  conformal::ConformalSOMOptions options;
  options.Lattice = static_cast<conformal::Lattice>(self->GetLattice());
  options.Frequency = self->GetFrequency();
  options.NumberOfNeurons = self->GetNumberOfNeurons();
  options.SphereMap = static_cast<conformal::SphereMap>(self->GetSphereMap());
  options.AreaBalance = self->GetAreaBalance();
  options.TrainingMode = static_cast<conformal::TrainingMode>(self->GetTrainingMode());
  options.RandomSeed = static_cast<unsigned int>(self->GetRandomSeed());
  options.ReferencePoint = static_cast<conformal::ReferencePoint>(self->GetReferencePoint());
  options.NumberOfEpochs = self->GetNumberOfEpochs();
  options.SamplesPerEpoch = self->GetSamplesPerEpoch();
  options.InitialNeighborhoodRadius = self->GetInitialNeighborhoodRadius();
  options.NeighborhoodTimeConstant = self->GetNeighborhoodTimeConstant();
  options.InitialLearningRate = self->GetInitialLearningRate();
  options.LearningRateTimeConstant = self->GetLearningRateTimeConstant();
  options.PassesPerLevel = self->GetPassesPerLevel();
  options.SamplesPerNeuron = self->GetSamplesPerNeuron();
  options.NumberOfPolishRounds = self->GetNumberOfPolishRounds();
  options.Smoothness = self->GetSmoothness();
  options.AutomaticPriority = self->GetAutomaticPriority();
  options.StartingShape = static_cast<conformal::StartingShape>(self->GetStartingShape());
  options.HullIndicator = static_cast<conformal::HullIndicator>(self->GetHullIndicator());
  return options;
}

// The priorities of this process's points, none where it has no points.
conformal::NumberView ViewPriorities(
  vtkPointSet* input, const std::string& name, std::vector<double>& copy)
{
  if (name.empty() || input->GetNumberOfPoints() == 0)
  {
    return {};
  }
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the input has no point array \"" + name + "\" with 1 component");
  }
  return glue::ViewNumbers(array, copy);
}

// How many priorities are no use as weights, on all processes.
vtkIdType CountUnusable(
  const conformal::NumberView& priorities, const std::string& name, const conformal::Reduce& reduce)
{
  std::int64_t unusable = 0, positive = 0;
  for (vtkIdType i = 0; i < priorities.size(); ++i)
  {
    const bool usable = std::isfinite(priorities[i]) && priorities[i] >= 0.0;
    unusable += !usable;
    positive += usable && priorities[i] > 0.0;
  }
  std::int64_t sums[] = { priorities.size(), unusable, positive };
  reduce.sum(sums, 3);
  if (sums[0] > 0 && sums[2] == 0)
  {
    throw std::invalid_argument("no point has a positive priority in the array \"" + name + "\"");
  }
  return sums[1];
}

bool MayStartFromMesh(const conformal::ConformalSOMOptions& options)
{
  using conformal::StartingShape;
  return options.TrainingMode == conformal::TrainingMode::Batch &&
    (options.StartingShape == StartingShape::Automatic ||
      options.StartingShape == StartingShape::Mesh);
}

// The input's own triangles, on all processes, as a mesh to start from; an empty one where they are
// not to be used. StartingShape Automatic takes them if they are a surface of all samples.
conformal::MappedMesh OwnMesh(vtkConformalSOM* self, vtkPointSet* input, bool must,
  const conformal::TrainingSamples& samples, const conformal::CoordinateFrame& frame,
  glue::Processes& processes, const conformal::Run& run)
{
  vtkPolyData* surface = vtkPolyData::SafeDownCast(input);
  const conformal::Reduce reduce = processes.reduce();
  std::int64_t counts[] = { input->GetNumberOfPoints() > 0, glue::HasTriangles(surface) };
  reduce.sum(counts, 2);
  const bool inPieces = counts[0] > 1;
  if (must && (counts[1] == 0 || inPieces))
  {
    throw std::invalid_argument(
      std::string("StartingShape Mesh needs a closed mesh as input, but ") +
      (inPieces ? "it is spread over several processes" : "it has no polygons"));
  }
  if (counts[1] > 0 && inPieces && processes.isFirst())
  {
    vtkWarningWithObjectMacro(self, << "the input's polygons are spread over several processes; "
                                       "learning does not start from them, as it may on one");
  }
  conformal::MappedMesh own;
  if (glue::HasTriangles(surface) && !inPieces)
  {
    if (must)
    {
      static_cast<conformal::Mesh&>(own) =
        glue::Outward(glue::ToClosedMesh(self, surface, frame, run));
    }
    else if (samples.dimension() == 3 && surface->GetNumberOfPoints() == samples.totalSize())
    {
      static_cast<conformal::Mesh&>(own) = glue::ToMeshIfClosed(surface, frame, run);
    }
  }
  return glue::GatherMesh(reduce, own);
}

// What the points have that their user should know.
void WarnAbout(vtkConformalSOM* self, const conformal::TrainingSamples& samples, vtkIdType unusable)
{
  if (unusable > 0)
  {
    vtkWarningWithObjectMacro(
      self, << unusable << " priorities are negative or not finite and count as 0");
  }
  if (samples.numberOfNonFinite() > 0)
  {
    glue::WarnOfNonFinitePoints(self, samples.numberOfNonFinite());
  }
  if (samples.empty())
  {
    vtkWarningWithObjectMacro(self, << "there are no points to learn from; the output is empty");
  }
  else if (samples.dimension() < 3)
  {
    vtkWarningWithObjectMacro(self, << "the points are "
                                    << (samples.dimension() == 2      ? "coplanar"
                                           : samples.dimension() == 1 ? "collinear"
                                                                      : "all equal")
                                    << "; the mesh is flat");
  }
}

// What is wrong with the mesh, and what to do about it.
void WarnAbout(vtkConformalSOM* self, const conformal::SurfaceVerdict& verdict)
{
  using Tolerated = conformal::ToleratedVerdict;
  if (verdict.UnmetFraction > Tolerated::UnmetFraction)
  {
    vtkWarningWithObjectMacro(self, << 100.0 * verdict.UnmetFraction
                                    << " % of the points lie apart from the mesh: it does not "
                                       "reach parts of the object. Learn with more neurons, or "
                                       "from another StartingShape or HullIndicator");
  }
  if (verdict.InvertedFraction > Tolerated::InvertedFraction)
  {
    vtkWarningWithObjectMacro(self, << "at " << 100.0 * verdict.InvertedFraction
                                    << " % of the points the mesh faces the wrong way, or two of "
                                       "its sides lie on them: too little of the object is there. "
                                       "Give normals, or add points where there are none");
  }
  // A geodesic lattice of few neurons has some folds where limbs meet.
  if (verdict.FoldedFraction > 2.0 * Tolerated::FoldedFraction)
  {
    vtkWarningWithObjectMacro(self, << 100.0 * verdict.FoldedFraction
                                    << " % of the mesh's edges are folded: the points are too few "
                                       "or too noisy for it. Learn with fewer neurons or with more "
                                       "Smoothness");
  }
}

// What learning saw that its user should know.
void WarnAbout(vtkConformalSOM* self, const conformal::ConformalSOMResult& result,
  const conformal::TrainingSamples& samples)
{
  // Where noise is as large, the hull has handles by chance.
  constexpr double muchNoise = 0.01, manyUnresolved = 0.05;
  const vtkIdType size = samples.totalSize();
  if (result.HullLeaks)
  {
    vtkWarningWithObjectMacro(
      self, << "the points have holes too large to distinguish inside from outside; the mesh may "
               "also follow the inner side of the points");
  }
  if (result.Hulled && result.Indicator == conformal::HullIndicator::WindingNumbers &&
    samples.oriented() && !result.NormalsUsed)
  {
    glue::WarnOfUnusedNormals(self);
  }
  if (result.Noise > muchNoise)
  {
    vtkWarningWithObjectMacro(self, << "the points have noise of about " << 100.0 * result.Noise
                                    << " % of the largest radius, which the mesh does not follow; "
                                       "nor does it follow details that are as small");
  }
  else if (result.Verdict.UnresolvedFraction > manyUnresolved)
  {
    vtkWarningWithObjectMacro(self, << 100.0 * result.Verdict.UnresolvedFraction
                                    << " % of the points lie farther than 2 % of the largest "
                                       "radius from the plane of their neighbors: they are too "
                                       "few for the object's details, and the mesh between them "
                                       "is a guess. Add points");
  }
  if (result.Verdict.LayerDistance > 0.0)
  {
    vtkWarningWithObjectMacro(self, << "the points lie on two layers, "
                                    << 100.0 * result.Verdict.LayerDistance
                                    << " % of the largest radius apart, and the mesh lies between "
                                       "them. Register the scans anew");
  }
  if (result.Noise <= muchNoise && result.CutFraction > 0.0)
  {
    glue::WarnOfCutHandles(self, result.CutFraction);
  }
  if (result.NumberOfSamplesOutside > size / 1000)
  {
    glue::WarnOfPointsApart(self, result.NumberOfSamplesOutside, size);
  }
  if (result.UnsupportedFraction > 0.002)
  {
    vtkWarningWithObjectMacro(self, << 100.0 * result.UnsupportedFraction
                                    << " % of the mesh area has no points nearby: it spans holes "
                                       "in the data or gaps between limbs");
  }
  if (!result.ConformalMapFits && samples.dimension() == 3)
  {
    const double error =
      conformal::measureDistortion(result.Positions, result.Triangles, result.SpherePositions)
        .MeanQuasiConformalError;
    vtkWarningWithObjectMacro(
      self, << "limbs are too long for a conformal map in double precision; "
               "SpherePosition is one to one, but its mean quasi-conformal "
               "error is "
            << error << ", where 1 is conformal");
  }
  WarnAbout(self, conformal::withoutLeftOut(result.Verdict, result.NumberOfSamplesOutside, size));
}

void AddFigures(vtkFieldData* data, const conformal::TrainingSamples& samples,
  const conformal::ConformalSOMResult& result, bool polished,
  const conformal::CoordinateFrame& frame)
{
  using glue::AddNumber;
  AddNumber(data, "CloudDimension", static_cast<long long>(samples.dimension()));
  AddNumber(data, "UnsupportedFraction", result.UnsupportedFraction);
  AddNumber(data, "UnmetFraction", result.Verdict.UnmetFraction);
  AddNumber(data, "InvertedFraction", result.Verdict.InvertedFraction);
  AddNumber(data, "FoldedFraction", result.Verdict.FoldedFraction);
  AddNumber(data, "AreaRatio", result.AreaRatio);
  AddNumber(data, "UnresolvedFraction", result.Verdict.UnresolvedFraction);
  glue::AddLengths(data, "NoiseLevel", { result.Noise * samples.scale() }, frame);
  glue::AddLengths(
    data, "LayerDistance", { result.Verdict.LayerDistance * samples.scale() }, frame);
  AddNumber(data, "StartedFromHull", static_cast<long long>(result.Hulled));
  AddNumber(data, "StartedFromMesh", static_cast<long long>(result.FromMesh));
  AddNumber(data, "HullIndicator", static_cast<long long>(result.Indicator));
  AddNumber(data, "NormalsUsed", static_cast<long long>(result.NormalsUsed));
  AddNumber(data, "NumberOfStarts", static_cast<long long>(result.NumberOfStarts));
  AddNumber(data, "Polished", static_cast<long long>(polished));
}

using Records = std::vector<conformal::TrainingRecord>;

void FillHistory(vtkTable* table, const Records& history)
{
  const auto addColumn = [&](const char* name, auto value)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const conformal::TrainingRecord& record : history)
    {
      column->InsertNextValue(value(record));
    }
    table->AddColumn(column);
  };
  using Record = conformal::TrainingRecord;
  addColumn("Frequency", [](const Record& r) { return r.Frequency; });
  addColumn("NeighborhoodRadius", [](const Record& r) { return r.NeighborhoodRadius; });
  addColumn("LearningRate", [](const Record& r) { return r.LearningRate; });
  addColumn("MeanSquareError", [](const Record& r) { return r.MeanSquareError; });
  addColumn("MeanDisplacement", [](const Record& r) { return r.MeanDisplacement; });
}
}

//------------------------------------------------------------------------------
vtkConformalSOM::vtkConformalSOM()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkConformalSOM::~vtkConformalSOM()
{
  this->SetPriorityArrayName(nullptr);
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkConformalSOM::SetNumberOfNeurons(int number)
{
  constexpr auto minimum = static_cast<int>(conformal::MinimumNeurons);
  const auto maximum =
    static_cast<int>(conformal::geodesicSphereSize(this->GetFrequencyMaxValue()));
  number = number == 0 ? 0 : std::clamp(number, minimum, maximum);
  if (this->NumberOfNeurons != number)
  {
    this->NumberOfNeurons = number;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkConformalSOM::GetNumberOfNeurons()
{
  return this->NumberOfNeurons > 0
    ? this->NumberOfNeurons
    : static_cast<int>(conformal::geodesicSphereSize(this->Frequency));
}

//------------------------------------------------------------------------------
int vtkConformalSOM::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkConformalSOM::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkConformalSOM::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  glue::RequestOwnPieces(this, this->Controller, inputs);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkConformalSOM::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto input = glue::Held(vtkPointSet::GetData(inputVector[0]));
  const auto start = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* history = vtkTable::GetData(outputVector, 1);
  const conformal::ConformalSOMOptions options = OptionsOf(this);
  const std::string priorityName = this->PriorityArrayName ? this->PriorityArrayName : "";
  const bool measuresErrors = this->GenerateErrorScalars, inPieces = this->DistributeOutput;
  return glue::RunCore(this, this->Controller,
    [&](glue::Processes& processes)
    {
      std::vector<double> priorityCopy;
      const conformal::NumberView priorities = ViewPriorities(input, priorityName, priorityCopy);
      const vtkIdType unusable = CountUnusable(priorities, priorityName, processes.reduce());
      glue::CloudInput cloud;
      glue::ReadCloud(input, priorities, nullptr, processes.reduce(), cloud);
      const conformal::CoordinateFrame frame = cloud.Frame;
      const auto size = static_cast<double>(input->GetNumberOfPoints());
      const auto neurons = static_cast<double>(conformal::numberOfNeurons(options));
      // Reading, normals and mesh of the polygons, learning, errors, the vertex shift, the
      // output.
      const bool hasTriangles = glue::HasTriangles(vtkPolyData::SafeDownCast(input));
      const double polygons = hasTriangles ? size : 0.0;
      const auto learningFrom = [&](double vertices)
      { return conformal::workOfConformalSOM(options) + 5000.0 * vertices; };
      const double ofErrors = measuresErrors ? 450.0 * size : 0.0, ofOutput = 10.0 * neurons;
      const bool polished =
        options.TrainingMode != conformal::TrainingMode::Online && options.NumberOfPolishRounds > 0;
      const double ofShift =
        polished ? conformal::workOfVertexShift(static_cast<conformal::Index>(neurons)) : 0.0;
      conformal::Steps steps(processes.run(),
        { 40.0 * size, 600.0 * polygons, 1000.0 * polygons, learningFrom(polygons), ofErrors,
          ofShift, ofOutput });
      conformal::TrainingSamples samples(
        cloud.View, priorities, cloud.Skip, processes.reduce(), steps.next());
      steps.next();
      glue::CloudNormals normals;
      if (options.TrainingMode != conformal::TrainingMode::Online &&
        options.HullIndicator != conformal::HullIndicator::Distance)
      {
        const bool needed = options.HullIndicator == conformal::HullIndicator::WindingNumbers;
        glue::FindNormals(input, frame, processes.reduce(), needed, normals);
      }
      if (normals.Known)
      {
        samples.setNormals(normals.View);
      }
      if (processes.isFirst())
      {
        WarnAbout(this, samples, unusable);
        glue::WarnOfFarPoints(this, cloud.Far);
      }
      if (samples.empty())
      {
        return;
      }
      conformal::MappedMesh mesh;
      const conformal::Run meshing = steps.next();
      if (start)
      {
        mesh = glue::ToSharedMesh(this, start, frame, processes);
      }
      else if (MayStartFromMesh(options))
      {
        mesh = OwnMesh(this, input, options.StartingShape == conformal::StartingShape::Mesh,
          samples, frame, processes, meshing);
      }
      const bool hasMesh = mesh.Positions.rows() > 0;
      steps.replan({ learningFrom(start ? 0.0 : static_cast<double>(mesh.Positions.rows())),
        ofErrors, ofShift, ofOutput });
      const conformal::ConformalSOMResult result =
        conformal::trainConformalSOM(samples, options, hasMesh ? &mesh : nullptr, steps.next());
      if (processes.isFirst())
      {
        WarnAbout(this, result, samples);
      }
      const vtkNew<vtkPolyData> surface;
      glue::SetSurface(surface, result.Positions, result.Triangles, frame);
      glue::AddVectors(surface->GetPointData(), glue::SpherePositionName(), result.SpherePositions);
      glue::AddNumbers(surface->GetPointData(), "Supported", result.Supported);
      const conformal::Run measuring = steps.next();
      if (measuresErrors)
      {
        glue::AddLengths(surface->GetPointData(), "QuantizationError",
          conformal::quantizationErrors(samples, result, measuring), frame);
      }
      const conformal::Run shifting = steps.next();
      AddFigures(surface->GetFieldData(), samples, result, polished, frame);
      if (polished)
      {
        glue::AddNumber(surface->GetFieldData(), "VertexShift",
          conformal::vertexShift(result, samples, shifting));
      }
      steps.next();
      glue::KeepOwnShare(surface, inPieces, processes);
      output->ShallowCopy(surface);
      FillHistory(history, processes.isFirst() ? result.History : Records());
    });
}

//------------------------------------------------------------------------------
void vtkConformalSOM::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lattice: "
     << (this->Lattice == GEODESIC      ? "Geodesic"
            : this->Lattice == ADAPTIVE ? "Adaptive"
                                        : "Automatic")
     << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "NumberOfNeurons: " << this->GetNumberOfNeurons() << "\n";
  os << indent << "SphereMap: "
     << (this->SphereMap == CONFORMAL_MAP ? "Conformal"
            : this->SphereMap == BALANCED ? "Balanced"
                                          : "Lattice")
     << "\n";
  os << indent << "AreaBalance: " << this->AreaBalance << "\n";
  os << indent << "TrainingMode: " << (this->TrainingMode == ONLINE ? "Online" : "Batch") << "\n";
  os << indent
     << "PriorityArrayName: " << (this->PriorityArrayName ? this->PriorityArrayName : "(none)")
     << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "ReferencePoint: "
     << (this->ReferencePoint == CONFORMAL   ? "Conformal"
            : this->ReferencePoint == WINNER ? "Winner"
            : this->ReferencePoint == AFFINE ? "Affine"
                                             : "Automatic")
     << "\n";
  os << indent << "NumberOfEpochs: " << this->NumberOfEpochs << "\n";
  os << indent << "SamplesPerEpoch: " << this->SamplesPerEpoch << "\n";
  os << indent << "InitialNeighborhoodRadius: " << this->InitialNeighborhoodRadius << "\n";
  os << indent << "NeighborhoodTimeConstant: " << this->NeighborhoodTimeConstant << "\n";
  os << indent << "InitialLearningRate: " << this->InitialLearningRate << "\n";
  os << indent << "LearningRateTimeConstant: " << this->LearningRateTimeConstant << "\n";
  os << indent << "PassesPerLevel: " << this->PassesPerLevel << "\n";
  os << indent << "SamplesPerNeuron: " << this->SamplesPerNeuron << "\n";
  os << indent << "NumberOfPolishRounds: " << this->NumberOfPolishRounds << "\n";
  os << indent << "Smoothness: " << this->Smoothness << "\n";
  os << indent << "AutomaticPriority: " << (this->AutomaticPriority ? "On" : "Off") << "\n";
  os << indent << "StartingShape: "
     << (this->StartingShape == SPHERE    ? "Sphere"
            : this->StartingShape == HULL ? "Hull"
            : this->StartingShape == MESH ? "Mesh"
                                          : "Automatic")
     << "\n";
  os << indent << "HullIndicator: "
     << (this->HullIndicator == AUTOMATIC_INDICATOR  ? "Automatic"
            : this->HullIndicator == WINDING_NUMBERS ? "WindingNumbers"
                                                     : "Distance")
     << "\n";
  os << indent << "GenerateErrorScalars: " << (this->GenerateErrorScalars ? "On" : "Off") << "\n";
  os << indent << "DistributeOutput: " << (this->DistributeOutput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}

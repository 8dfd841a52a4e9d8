#include "vtkConformalSOM.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/CloudInput.h"
#include "Glue/CloudNormals.h"
#include "Glue/CloudSelection.h"
#include "Glue/CloudWarnings.h"
#include "Glue/LearningStages.h"
#include "Glue/Meshes.h"
#include "Glue/PatternArrays.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Glue/Scanners.h"
#include "Learn/ConformalSOM.h"
#include "Surface/VertexShift.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
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
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkConformalSOM);
vtkCxxSetObjectMacro(vtkConformalSOM, Controller, vtkMultiProcessController);

namespace
{
// Convert the properties of the filter to options of the learner.
// @param[out] stages  filled by the learner with GenerateStages; must outlive the options
conformal::ConformalSOMOptions OptionsOf(
  vtkConformalSOM* self, std::vector<conformal::LearningStage>& stages)
{
  conformal::ConformalSOMOptions options;
  options.MeshType = static_cast<conformal::MeshType>(self->GetMeshType());
  options.NumberOfNeurons = self->GetNumberOfNeurons();
  options.TrainingMode = static_cast<conformal::TrainingMode>(self->GetTrainingMode());
  options.StartingShape = static_cast<conformal::StartingShape>(self->GetStartingShape());
  options.HullMethod = static_cast<conformal::HullMethod>(self->GetHullMethod());
  options.Genus = static_cast<conformal::HullGenus>(self->GetGenus());
  options.ReferencePoint = static_cast<conformal::ReferencePoint>(self->GetReferencePoint());
  options.RandomSeed = static_cast<unsigned int>(self->GetRandomSeed());
  options.Online.NumberOfEpochs = self->GetNumberOfEpochs();
  options.Online.SamplesPerEpoch = self->GetSamplesPerEpoch();
  const double* constants = self->GetOnlineConstants();
  options.Online.InitialNeighborhoodRadius = constants[0];
  options.Online.NeighborhoodTimeConstant = constants[1];
  options.Online.InitialLearningRate = constants[2];
  options.Online.LearningRateTimeConstant = constants[3];
  options.Fit.Iterations = self->GetFitIterations();
  options.Fit.Smoothness = self->GetSmoothness();
  options.Opening.Border = static_cast<conformal::Border>(self->GetBorder());
  options.Opening.HoleSize = self->GetHoleSize();
  if (self->GetGenerateStages())
  {
    options.Observer = [&](const conformal::LearningStage& stage) { stages.push_back(stage); };
  }
  return options;
}

// Return which points are learned.
glue::CloudPart PartOf(vtkConformalSOM* self)
{
  return { static_cast<conformal::RemoveGround>(self->GetRemoveGround()),
    static_cast<conformal::Side>(self->GetSide()) };
}

// Return the priorities of the points of this process. The view is empty if there are no points.
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

// Count, over all processes, the priorities that are negative or not finite.
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

// Skip copies of points in Batch mode, in which the weight of a point is the area around it. In
// Online mode, a point with copies is used more often.
void SkipCopies(const conformal::ConformalSOMOptions& options,
  const conformal::NumberView& priorities, const conformal::Reduce& reduce,
  const conformal::Run& run, glue::CloudInput& cloud)
{
  if (options.TrainingMode == conformal::TrainingMode::Batch)
  {
    glue::SkipCopies(priorities, reduce, run, cloud);
  }
}

bool MayStartFromMesh(const conformal::ConformalSOMOptions& options)
{
  using conformal::StartingShape;
  return options.TrainingMode == conformal::TrainingMode::Batch &&
    options.MeshType != conformal::MeshType::Geodesic &&
    (options.StartingShape == StartingShape::Automatic ||
      options.StartingShape == StartingShape::Mesh);
}

// Return the input's triangles as a mesh from which learning starts, equal on all processes. The
// mesh is empty if learning must not start from these triangles. With StartingShape Automatic, they
// are used only if they form a closed surface through all samples.
conformal::MappedMesh OwnMesh(vtkConformalSOM* self, vtkPointSet* input, bool must,
  const conformal::TrainingSamples& samples, const glue::CloudInput& cloud,
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
    vtkWarningWithObjectMacro(self,
      << "the input's polygons are spread over several processes; "
         "learning does not start from them. To use them, give the whole input to one process");
  }
  conformal::MappedMesh own;
  if (glue::HasTriangles(surface) && !inPieces)
  {
    if (must)
    {
      static_cast<conformal::Mesh&>(own) =
        glue::Outward(glue::ToClosedMesh(self, surface, cloud.Frame, run));
    }
    else if (samples.dimension() == 3 &&
      surface->GetNumberOfPoints() == samples.totalSize() + cloud.NumberOfCopies)
    {
      static_cast<conformal::Mesh&>(own) = glue::ToMeshIfClosed(surface, cloud.Frame, run);
    }
  }
  return glue::GatherMesh(reduce, own);
}

// Return the mesh from which learning starts: the mesh on input port 1 or, without this mesh, the
// input's triangles. The mesh is empty if learning starts from neither.
conformal::MappedMesh StartingMesh(vtkConformalSOM* self, vtkPointSet* input, vtkPolyData* start,
  const conformal::ConformalSOMOptions& options, const conformal::TrainingSamples& samples,
  const glue::CloudInput& cloud, glue::Processes& processes, const conformal::Run& run)
{
  if (processes.firstWith(start) >= 0)
  {
    const vtkNew<vtkPolyData> nothing; // on processes without the mesh
    return glue::ToSharedMesh(
      self, start ? start : static_cast<vtkPolyData*>(nothing), cloud.Frame, processes);
  }
  if (!MayStartFromMesh(options))
  {
    return {};
  }
  const bool must = options.StartingShape == conformal::StartingShape::Mesh;
  return OwnMesh(self, input, must, samples, cloud, processes, run);
}

// Memory of the normals, the scanners and the pattern values of points, and numbers of points that
// are left out.
struct PointAttributes
{
  glue::LeftOut LeftOut;
  glue::CloudNormals Normals;
  conformal::Points Scanners;
  glue::PatternArrays Patterns;
};

// Set the normals, the scanners and the pattern values of the samples to those of the input. Online
// learning uses neither normals nor scanners.
void SetAttributes(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::ConformalSOMOptions& options, conformal::TrainingSamples& samples,
  PointAttributes& attributes)
{
  if (options.TrainingMode != conformal::TrainingMode::Online)
  {
    glue::SetNormals(input, frame, options.HullMethod, samples, attributes.Normals);
    glue::SetScanners(input, frame, samples, attributes.Scanners);
  }
  if (!attributes.Patterns.Arrays.empty())
  {
    samples.setPatternValues(attributes.Patterns.Values);
  }
}

// Warn of points that are left out.
void WarnAbout(vtkConformalSOM* self, const glue::LeftOut& leftOut,
  const conformal::TrainingSamples& samples, const glue::CloudPart& part)
{
  const conformal::Index all = samples.totalSize() + leftOut.Layer;
  if (leftOut.Ground > 0)
  {
    glue::WarnOfGround(self, leftOut.Ground, leftOut.Ground + all);
  }
  else if (part.Ground == conformal::RemoveGround::On)
  {
    glue::WarnOfMissingGround(self);
  }
  if (leftOut.Layer > 0)
  {
    glue::WarnOfLayer(self, leftOut.Layer, all, part.Side);
  }
}

// Warn of defects of the input's points, and of points that are left out.
void WarnAbout(vtkConformalSOM* self, const conformal::TrainingSamples& samples, vtkIdType unusable,
  const conformal::FarPoints& far, const PointAttributes& attributes, const glue::CloudPart& part)
{
  WarnAbout(self, attributes.LeftOut, samples, part);
  if (attributes.Patterns.NumberOfUnusable > 0)
  {
    vtkWarningWithObjectMacro(self, << attributes.Patterns.NumberOfUnusable
                                    << " points have a value that is not finite in a pattern "
                                       "array, and are left out");
  }
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
    vtkWarningWithObjectMacro(
      self, << "the points are "
            << (samples.dimension() == 2      ? "coplanar; the mesh is flat"
                   : samples.dimension() == 1 ? "collinear; the mesh is flat"
                                              : "all equal; the mesh has no size"));
  }
  glue::WarnOfFarPoints(self, far);
}

// Warn of defects of the mesh, and recommend remedies.
void WarnAbout(vtkConformalSOM* self, const conformal::SurfaceQuality& quality)
{
  using Tolerated = conformal::ToleratedQuality;
  if (quality.UncoveredFraction > Tolerated::UncoveredFraction)
  {
    vtkWarningWithObjectMacro(self, << 100.0 * quality.UncoveredFraction
                                    << " % of the points lie apart from the mesh: it does not "
                                       "reach parts of the object. Learn with more neurons, or "
                                       "with another StartingShape or HullMethod of "
                                       "vtkConformalSOM");
  }
  if (quality.InvertedFraction > Tolerated::InvertedFraction)
  {
    vtkWarningWithObjectMacro(self,
      << "at " << 100.0 * quality.InvertedFraction
      << " % of the points the mesh faces the wrong way, or two of "
         "its sides lie on them: too little of the object is sampled. Provide right normals, or "
         "add points where there are none");
  }
  // Twice the tolerance, since a geodesic mesh of few neurons has some folds where limbs join.
  if (quality.FoldedFraction > 2.0 * Tolerated::FoldedFraction)
  {
    vtkWarningWithObjectMacro(
      self, << 100.0 * quality.FoldedFraction
            << " % of the mesh's edges are folded: the points are too few or too noisy. Learn with "
               "fewer neurons, or with a larger Smoothness of vtkConformalSOM");
  }
}

// Warn if the map of a solid object is not conformal.
void WarnOfMap(vtkConformalSOM* self, const conformal::ConformalSOMResult& result)
{
  using Tolerated = conformal::ToleratedMap;
  if (!result.HasConformalMap)
  {
    return;
  }
  const double error = result.MeanQuasiConformalError, maximum = result.MaximumQuasiConformalError;
  if (!result.ConformalMapFits)
  {
    vtkWarningWithObjectMacro(
      self, << "no conformal map was found, since limbs are too long for double precision, or "
               "triangles are thin or folded; SpherePosition is one to one, but its mean "
               "quasi-conformal error is "
            << error << ", where 1 is conformal");
  }
  else if (error > Tolerated::MeanError || maximum > Tolerated::MaximumError)
  {
    vtkWarningWithObjectMacro(
      self, << "the map to the sphere is not conformal everywhere: its mean "
               "quasi-conformal error is "
            << error << ", its maximum " << maximum
            << ", where 1 is conformal. Parts of the mesh are joined by a "
               "thread, or have thin triangles. Learn with other numbers of "
               "neurons, or remove outliers");
  }
}

// Warn of defects of the result, and of defects of the points that learning has detected.
void WarnAbout(vtkConformalSOM* self, const conformal::ConformalSOMResult& result,
  const conformal::TrainingSamples& samples)
{
  // If the noise is above muchNoise, handles of the hull may be caused by noise.
  constexpr double muchNoise = 0.01, manyUndersampled = 0.015;
  const vtkIdType size = samples.totalSize();
  const bool isUndersampled = result.Quality.UndersampledFraction > manyUndersampled;
  const bool isUnknown = isUndersampled && size < conformal::MinimumEvaluated;
  if (result.HullLeaks)
  {
    vtkWarningWithObjectMacro(
      self, << "the points have holes too large to distinguish inside from outside; the mesh may "
               "also follow the inner side of the points");
  }
  if (result.FromHull && result.Hull == conformal::HullMethod::WindingNumbers &&
    samples.oriented() && !result.NormalsUsed)
  {
    glue::WarnOfUnusedNormals(self);
  }
  // Few points lie off the planes of their neighbors, also without noise.
  if (result.Noise > muchNoise && size >= conformal::MinimumEvaluated)
  {
    vtkWarningWithObjectMacro(self,
      << "the points have noise of about " << 100.0 * result.Noise
      << " % of the largest radius. The mesh follows neither the noise nor details of its size");
  }
  else if (isUnknown)
  {
    vtkWarningWithObjectMacro(
      self, << "the input has " << size
            << " points, which are too few for the object's details: the mesh may lie apart from "
               "them, and is uncertain between them. Add points");
  }
  else if (isUndersampled)
  {
    vtkWarningWithObjectMacro(
      self, << 100.0 * result.Quality.UndersampledFraction
            << " % of the points lie farther than 2 % of the largest "
               "radius from the plane of their neighbors: they are too "
               "few for the object's details, and the mesh between them is uncertain. Add points");
  }
  if (result.Quality.LayerDistance > 0.0)
  {
    vtkWarningWithObjectMacro(self, << "the points lie on two layers, "
                                    << 100.0 * result.Quality.LayerDistance
                                    << " % of the largest radius apart, and the mesh lies between "
                                       "them. Register the scans again");
  }
  if (result.Noise <= muchNoise && result.CutFraction > 0.0)
  {
    glue::WarnOfCutHandles(self, result.CutFraction);
  }
  const conformal::Index apart = result.NumberOfSamplesOutside + result.NumberOfOutliers;
  if (apart > size / 1000 && !isUnknown)
  {
    glue::WarnOfPointsApart(self, apart, size);
  }
  if (samples.dimension() < 3 || isUnknown)
  {
    return; // another warning says that the mesh is flat, hence folded at the rim, and its sides
            // meet; or that the points are too few, which is the cause of all defects of the mesh
  }
  if (result.UnsupportedFraction > 0.002)
  {
    vtkWarningWithObjectMacro(self, << 100.0 * result.UnsupportedFraction
                                    << " % of the mesh area has no points nearby (holes in the "
                                       "data, or gaps between limbs). See array Supported");
  }
  WarnOfMap(self, result);
  if (result.SelfIntersections > 0)
  {
    vtkWarningWithObjectMacro(
      self, << result.SelfIntersections
            << " pairs of triangles cross each other: parts of the surface "
               "are closer together than its triangles are long. Learn with "
               "more neurons");
  }
  WarnAbout(self, conformal::withoutLeftOut(result.Quality, result.NumberOfSamplesOutside, size));
}

// Warn of parts of the object that the border leaves out, and of a border that is missing.
void WarnOfBorder(
  vtkConformalSOM* self, const conformal::BorderReport& result, conformal::Border border)
{
  constexpr double muchDropped = 0.01;
  if (result.BorderFailed)
  {
    vtkWarningWithObjectMacro(self, << "the points have no border that can be followed; the "
                                       "surface stays closed. See array Supported");
  }
  else if (result.NumberOfBorders == 0 && border == conformal::Border::Open)
  {
    vtkWarningWithObjectMacro(self, << "Border OPEN has no effect; the surface stays closed, since "
                                       "the points have no hole, lie in one plane, or are too few, "
                                       "or learning started from the input's polygons");
  }
  if (result.NumberOfBorders > 0 && border == conformal::Border::Automatic)
  {
    vtkWarningWithObjectMacro(self, << "the surface has a border where the points end; "
                                    << 100.0 * result.OpenFraction
                                    << " % of the closed surface has no points nearby and is left "
                                       "out. To close the surface, set Border to CLOSED");
  }
  if (result.DroppedFraction > muchDropped)
  {
    vtkWarningWithObjectMacro(self, << "the points lie on several sheets; the largest is kept, and "
                                    << 100.0 * result.DroppedFraction
                                    << " % of the closed surface is left out with the others");
  }
}

void AddFigures(vtkFieldData* data, const conformal::TrainingSamples& samples,
  const conformal::ConformalSOMResult& result, double vertexShift,
  const conformal::CoordinateFrame& frame)
{
  using glue::AddNumber;
  AddNumber(data, "AffineRank", static_cast<long long>(samples.dimension()));
  AddNumber(data, "UnsupportedFraction", result.UnsupportedFraction);
  AddNumber(data, "NumberOfHandles", static_cast<long long>(result.NumberOfHandles));
  AddNumber(data, "NumberOfBorders", static_cast<long long>(result.NumberOfBorders));
  AddNumber(data, "OpenFraction", result.OpenFraction);
  AddNumber(data, "NumberOfOutliers", static_cast<long long>(result.NumberOfOutliers));
  AddNumber(data, "UncoveredFraction", result.Quality.UncoveredFraction);
  AddNumber(data, "InvertedFraction", result.Quality.InvertedFraction);
  AddNumber(data, "FoldedFraction", result.Quality.FoldedFraction);
  if (result.NumberOfHandles == 0)
  {
    AddNumber(data, "MeanQuasiConformalError", result.MeanQuasiConformalError);
    AddNumber(data, "MaximumQuasiConformalError", result.MaximumQuasiConformalError);
  }
  AddNumber(data, "SelfIntersections", static_cast<long long>(result.SelfIntersections));
  AddNumber(data, "AreaRatio", result.AreaRatio);
  AddNumber(data, "UndersampledFraction", result.Quality.UndersampledFraction);
  glue::AddLengths(data, "NoiseLevel", { result.Noise * samples.scale() }, frame);
  glue::AddLengths(
    data, "LayerDistance", { result.Quality.LayerDistance * samples.scale() }, frame);
  AddNumber(data, "EffectiveDegreesOfFreedom", result.DegreesOfFreedom);
  AddNumber(data, "StartedFromHull", static_cast<long long>(result.FromHull));
  AddNumber(data, "StartedFromMesh", static_cast<long long>(result.FromMesh));
  AddNumber(data, "HullMethod", static_cast<long long>(result.Hull));
  AddNumber(data, "NormalsUsed", static_cast<long long>(result.NormalsUsed));
  AddNumber(data, "NumberOfStarts", static_cast<long long>(result.NumberOfStarts));
  AddNumber(data, "VertexShift", vertexShift);
}

// Learn the mesh, and warn of its defects on the first process. The steps are the mesh from which
// learning starts, and learning.
conformal::ConformalSOMResult Learn(vtkConformalSOM* self, vtkPointSet* input, vtkPolyData* start,
  const conformal::TrainingSamples& samples, const conformal::ConformalSOMOptions& options,
  const glue::CloudInput& cloud, glue::Processes& processes, conformal::Steps& steps)
{
  const conformal::MappedMesh mesh =
    StartingMesh(self, input, start, options, samples, cloud, processes, steps.next());
  const bool hasStart = mesh.Positions.rows() > 0;
  conformal::ConformalSOMResult result =
    conformal::trainConformalSOM(samples, options, hasStart ? &mesh : nullptr, steps.next());
  if (processes.isFirst())
  {
    WarnAbout(self, result, samples);
    WarnOfBorder(self, result, options.Opening.Border);
  }
  return result;
}

// Make the output surface, equal on all ranks, in two steps: quantization errors and vertex shift.
vtkNew<vtkPolyData> SurfaceOf(const conformal::ConformalSOMResult& result,
  const conformal::TrainingSamples& samples, const conformal::ConformalSOMOptions& options,
  const PointAttributes& attributes, const conformal::CoordinateFrame& frame,
  conformal::Steps& steps)
{
  vtkNew<vtkPolyData> surface;
  glue::SetSurface(surface, result.Positions, result.Triangles, frame);
  if (result.NumberOfHandles == 0)
  {
    glue::AddVectors(surface->GetPointData(), glue::SpherePositionName(), result.SpherePositions);
  }
  glue::AddNumbers(surface->GetPointData(), "Supported", result.Supported);
  if (!result.StandardError.empty())
  {
    std::vector<double> errors = result.StandardError;
    for (double& error : errors)
    {
      error *= samples.scale();
    }
    glue::AddLengths(surface->GetPointData(), "StandardError", std::move(errors), frame);
  }
  glue::AddLengths(surface->GetPointData(), "QuantizationError",
    conformal::quantizationErrors(samples, result, options, steps.next()), frame);
  glue::AddPatternArrays(surface->GetPointData(), attributes.Patterns, result.PatternValues);
  const bool isFitted =
    options.TrainingMode == conformal::TrainingMode::Batch && options.Fit.Iterations > 0;
  const conformal::Run shifting = steps.next();
  const double shift = isFitted ? conformal::vertexShift(result, samples, shifting) : 0.0;
  AddFigures(surface->GetFieldData(), samples, result, shift, frame);
  using glue::AddNumber;
  vtkFieldData* data = surface->GetFieldData();
  AddNumber(data, "NumberOfGroundPoints", static_cast<long long>(attributes.LeftOut.Ground));
  AddNumber(data, "NumberOfOtherLayerPoints", static_cast<long long>(attributes.LeftOut.Layer));
  return surface;
}

void FillHistory(vtkTable* table, const std::vector<conformal::TrainingRecord>& history)
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

// Set output ports 1 and 2, the training history and the stages. They are empty on all ranks but
// the first.
void SetRecords(vtkInformationVector* outputs, const conformal::ConformalSOMResult& result,
  const std::vector<conformal::LearningStage>& stages, const conformal::CoordinateFrame& frame,
  bool isFirst)
{
  vtkMultiBlockDataSet* blocks = vtkMultiBlockDataSet::GetData(outputs, 2);
  glue::SetStages(blocks, stages, frame); // on all ranks, which all report an error
  if (!isFirst)
  {
    blocks->Initialize();
  }
  FillHistory(vtkTable::GetData(outputs, 1),
    isFirst ? result.History : std::vector<conformal::TrainingRecord>());
}
}

//------------------------------------------------------------------------------
vtkConformalSOM::vtkConformalSOM()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkConformalSOM::~vtkConformalSOM()
{
  this->SetPriorityArrayName(nullptr);
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkConformalSOM::AddPatternArray(const char* name, double weight)
{
  this->PatternArrays.emplace_back(name ? name : "", weight);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkConformalSOM::RemoveAllPatternArrays()
{
  if (!this->PatternArrays.empty())
  {
    this->PatternArrays.clear();
    this->Modified();
  }
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
  static const char* const types[] = { "vtkPolyData", "vtkTable", "vtkMultiBlockDataSet" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
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
  std::vector<conformal::LearningStage> stages;
  conformal::ConformalSOMOptions options = OptionsOf(this, stages);
  const std::string priorityName = this->PriorityArrayName ? this->PriorityArrayName : "";
  const glue::WeightedNames patternNames = this->PatternArrays;
  const bool inPieces = this->DistributeOutput;
  const glue::CloudPart part = PartOf(this);
  return glue::RunCore(this, this->Controller,
    [&](glue::Processes& processes)
    {
      std::vector<double> priorityCopy;
      const conformal::NumberView priorities = ViewPriorities(input, priorityName, priorityCopy);
      const vtkIdType unusable = CountUnusable(priorities, priorityName, processes.reduce());
      glue::CloudInput cloud;
      PointAttributes attributes;
      glue::ReadCloud(input, priorities, nullptr, processes.reduce(), cloud);
      glue::ReadPatternArrays(input, patternNames, processes.reduce(), cloud, attributes.Patterns);
      conformal::Steps steps(processes.run(), { 0.01, 0.03, 0.02, 0.88, 0.02, 0.02, 0.02 });
      SkipCopies(options, priorities, processes.reduce(), steps.next(), cloud);
      options.Opening.HoleSize /= cloud.Frame.Unit;
      conformal::TrainingSamples samples = glue::SelectedSamples(
        cloud, priorities, part, processes.reduce(), steps.next(), attributes.LeftOut);
      SetAttributes(input, cloud.Frame, options, samples, attributes);
      if (processes.isFirst())
      {
        WarnAbout(this, samples, unusable, cloud.Far, attributes, part);
      }
      if (!samples.empty())
      {
        const auto result = Learn(this, input, start, samples, options, cloud, processes, steps);
        const auto surface = SurfaceOf(result, samples, options, attributes, cloud.Frame, steps);
        SetRecords(outputVector, result, stages, cloud.Frame, processes.isFirst());
        steps.next();
        glue::KeepOwnShare(surface, inPieces, processes);
        output->ShallowCopy(surface);
      }
    });
}

//------------------------------------------------------------------------------
void vtkConformalSOM::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const meshTypes[] = { "Automatic", "Geodesic", "Adaptive" };
  static const char* const references[] = { "Automatic", "Conformal", "Winner", "Affine" };
  static const char* const shapes[] = { "Automatic", "Sphere", "Hull", "Mesh" };
  static const char* const methods[] = { "Automatic", "Distance", "WindingNumbers" };
  os << indent << "MeshType: " << meshTypes[this->MeshType] << "\n";
  os << indent << "NumberOfNeurons: " << this->NumberOfNeurons << "\n";
  os << indent << "TrainingMode: " << (this->TrainingMode == ONLINE ? "Online" : "Batch") << "\n";
  os << indent
     << "PriorityArrayName: " << (this->PriorityArrayName ? this->PriorityArrayName : "(none)")
     << "\n";
  os << indent << "NumberOfPatternArrays: " << this->PatternArrays.size() << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "ReferencePoint: " << references[this->ReferencePoint] << "\n";
  os << indent << "NumberOfEpochs: " << this->NumberOfEpochs << "\n";
  os << indent << "SamplesPerEpoch: " << this->SamplesPerEpoch << "\n";
  os << indent << "OnlineConstants: (" << this->OnlineConstants[0] << ", "
     << this->OnlineConstants[1] << ", " << this->OnlineConstants[2] << ", "
     << this->OnlineConstants[3] << ")\n";
  os << indent << "FitIterations: " << this->FitIterations << "\n";
  os << indent << "Smoothness: " << this->Smoothness << "\n";
  os << indent << "StartingShape: " << shapes[this->StartingShape] << "\n";
  os << indent << "HullMethod: " << methods[this->HullMethod] << "\n";
  os << indent << "Genus: " << (this->Genus == AS_FOUND ? "AsFound" : "Zero") << "\n";
  static const char* const borders[] = { "Automatic", "Closed", "Open" };
  os << indent << "Border: " << borders[this->Border] << "\n";
  os << indent << "HoleSize: " << this->HoleSize << "\n";
  static const char* const grounds[] = { "Automatic", "Off", "On" };
  os << indent << "RemoveGround: " << grounds[this->RemoveGround] << "\n";
  static const char* const sides[] = { "Outer", "Inner", "Both" };
  os << indent << "Side: " << sides[this->Side] << "\n";
  os << indent << "GenerateStages: " << (this->GenerateStages ? "On" : "Off") << "\n";
  os << indent << "DistributeOutput: " << (this->DistributeOutput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}

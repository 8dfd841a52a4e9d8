#include "vtkSphericalTimeSeries.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/MappedSurfaces.h"
#include "Glue/Points.h"
#include "Glue/RegisteredSurfaces.h"
#include "Glue/Run.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/GenusZeroCheck.h"
#include "Motion/SphericalTimeSeries.h"
#include "Motion/SurfaceMotion.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSphericalTimeSeries);

// Not in an anonymous namespace: vtkSphericalTimeSeries::Series has members of these types.
namespace timeSeries
{
// Surface of a time step of the input.
struct SeriesStep
{
  double Time = 0.0;
  vtkSmartPointer<vtkPolyData> Surface;
  int Used = -1;     // index among the time steps that are used; -1 if the surface is skipped
  std::string Fault; // why it is skipped
};

// What is shown of a time step that is used.
struct UsedStep
{
  vtkPolyData* Surface = nullptr; // that of its SeriesStep
  glue::SurfaceToRegister Registered;
  conformal::SphericalRegistrationResult Result;
  conformal::MovingSurface Moving;
};

// Time to show: a time step that is used, or a time between two of them.
struct TimePlace
{
  std::size_t First = 0, Second = 0; // equal for the time of a time step
  double Fraction = 0.0;
};
}

namespace
{
using Executive = vtkStreamingDemandDrivenPipeline;
using timeSeries::SeriesStep;
using timeSeries::TimePlace;
using timeSeries::UsedStep;

// Compute the mean of values at vertices, weighted by area.
double MeanOver(const conformal::MappedMesh& mesh, const std::vector<double>& values)
{
  const Eigen::VectorXd areas = conformal::vertexAreas(mesh.Positions, mesh.Triangles);
  const Eigen::Map<const Eigen::VectorXd> all(values.data(), areas.size());
  return areas.dot(all) / areas.sum();
}

std::vector<double> SpeedsOf(const std::vector<double>& velocities)
{
  std::vector<double> speeds(velocities.size());
  std::transform(velocities.begin(), velocities.end(), speeds.begin(),
    [](double velocity) { return std::abs(velocity); });
  return speeds;
}

std::vector<double> SpeedsOf(const conformal::Points& velocities)
{
  std::vector<double> speeds;
  for (conformal::Index v = 0; v < velocities.rows(); ++v)
  {
    speeds.push_back(velocities.row(v).norm());
  }
  return speeds;
}

// Return values of all points from values of vertices; 0 at points of no triangle.
conformal::Points OfAllPoints(const UsedStep& step, const conformal::Points& ofVertices)
{
  conformal::Points all = conformal::Points::Zero(step.Registered.Map.rows(), 3);
  for (std::size_t v = 0; v < step.Registered.PointIds.size(); ++v)
  {
    all.row(step.Registered.PointIds[v]) = ofVertices.row(static_cast<conformal::Index>(v));
  }
  return all;
}

std::vector<double> OfAllPoints(const UsedStep& step, const std::vector<double>& ofVertices)
{
  std::vector<double> all(step.Registered.Map.rows(), 0.0);
  for (std::size_t v = 0; v < step.Registered.PointIds.size(); ++v)
  {
    all[step.Registered.PointIds[v]] = ofVertices[v];
  }
  return all;
}

void AddMotion(vtkPolyData* surface, const UsedStep& step, const conformal::SurfaceMotion& motion,
  const conformal::CoordinateFrame& frame)
{
  vtkPointData* data = surface->GetPointData();
  glue::AddVectors(data, "Velocity", OfAllPoints(step, motion.Velocities) * frame.Unit);
  glue::AddLengths(data, "NormalVelocity", OfAllPoints(step, motion.Normal), frame);
  glue::AddVectors(data, "TangentialVelocity", OfAllPoints(step, motion.Tangential) * frame.Unit);
  glue::AddNumbers(data, "AreaRate", OfAllPoints(step, motion.AreaRates));
  glue::AddNumbers(data, "ShearRate", OfAllPoints(step, motion.ShearRates));
}

// Set the time steps of both outputs, unless there are none.
void SetTimesOf(vtkInformationVector* outputs, const std::vector<double>& times)
{
  for (int port = 0; port < 2 && !times.empty(); ++port)
  {
    glue::SetTimeSteps(outputs->GetInformationObject(port), times);
  }
}

conformal::SurfaceMotion NoMotion(conformal::Index size)
{
  conformal::SurfaceMotion motion;
  motion.Velocities = motion.Tangential = conformal::Points::Zero(size, 3);
  motion.Normal.assign(size, 0.0);
  motion.AreaRates = motion.ShearRates = motion.Normal;
  return motion;
}
}

// Time steps of the input, and their maps.
class vtkSphericalTimeSeries::Series
{
public:
  std::vector<SeriesStep> Steps; // those read so far
  std::vector<double> Times;     // of an input with time steps; empty otherwise
  double Interval = 1.0;         // between separate inputs
  glue::FeatureList Features;
  bool IsDone = false;
  conformal::KnownRegistrations Known;

  void Forget()
  {
    this->Steps.clear();
    this->IsDone = false;
  }

  bool IsEmpty() const
  {
    return std::all_of(this->Steps.begin(), this->Steps.end(),
      [](const SeriesStep& step) { return step.Surface->GetNumberOfPoints() == 0; });
  }

  // Return the times of all time steps, also of those that are not read yet.
  std::vector<double> AllTimes() const
  {
    return this->Times.empty() ? glue::CountedTimes(this->Steps.size(), this->Interval)
                               : this->Times;
  }

  bool HasAll() const { return !this->Times.empty() && this->Steps.size() == this->Times.size(); }

  // Read the time steps that the input offers now: one of an input with time steps, otherwise all.
  void Read(vtkInformationVector* inputs)
  {
    if (this->HasAll())
    {
      return;
    }
    glue::Surfaces surfaces;
    if (!this->Times.empty())
    {
      glue::AddSurfaces(inputs, surfaces);
      this->AddStep(surfaces);
      return;
    }
    glue::AddSurfaces(inputs, surfaces, glue::MissingBlocks::Empty);
    this->Steps.clear();
    const std::vector<double> times = glue::CountedTimes(surfaces.Held.size(), this->Interval);
    for (std::size_t s = 0; s < times.size(); ++s)
    {
      this->Steps.push_back({ times[s], surfaces.Held[s], -1, {} });
    }
  }

  // Make the maps of all time steps correspond, unless all surfaces are empty.
  void Compute(vtkAlgorithm* self, const conformal::SphericalTimeSeriesOptions& options,
    int reference, const std::string& landmarkArrayName)
  {
    if (this->IsEmpty())
    {
      glue::WarnOfEmptyInput(self, "all surfaces are empty; the output is empty");
      return;
    }
    // Relative costs of reading each surface, registration and table.
    std::vector<double> shares(this->Steps.size(), 0.03 / static_cast<double>(this->Steps.size()));
    shares.insert(shares.end(), { 0.92, 0.05 });
    conformal::Steps progress(glue::RunOf(self), shares);
    this->Convert(self, landmarkArrayName, progress);
    this->Register(options, reference, progress.next());
    this->Tabulate(progress.next());
    this->IsDone = true;
    this->Warn(self);
  }

  // Write the surface at a time.
  void Show(double time, vtkPolyData* output) const
  {
    const TimePlace place = this->PlaceOf(time);
    const UsedStep& step = this->Used[place.First];
    output->ShallowCopy(step.Surface);
    conformal::SurfaceMotion motion;
    const bool isBetween = place.Second != place.First;
    if (isBetween)
    {
      const conformal::MovingSurface& later = this->Used[place.Second].Moving;
      // Very close to a time step, quotients of differences would have no digits.
      const double fraction = std::clamp(place.Fraction, 1e-6, 1.0 - 1e-6);
      conformal::MovingSurface between = step.Moving;
      between.Time += fraction * (later.Time - step.Moving.Time);
      between.Surface.Positions =
        conformal::positionsBetween(step.Moving.Surface, later.Surface, fraction);
      motion = conformal::computeMotion(step.Moving, between, later);
      this->SetPositions(step, between.Surface.Positions, output);
    }
    else
    {
      motion = this->MotionOf(place.First);
    }
    glue::SetRegistration(
      output, glue::PlacesOfAll(step.Registered, step.Result.SpherePositions), step.Result);
    AddMotion(output, step, motion, this->Frame);
    const double shown = isBetween || this->Used.size() < 2
      ? std::clamp(time, this->Used.front().Moving.Time, this->Used.back().Moving.Time)
      : step.Moving.Time;
    glue::AddNumber(output->GetFieldData(), "IsInterpolated", static_cast<long long>(isBetween));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), shown);
  }

  vtkTable* Table() const { return this->Rows; }

private:
  // Append the surface of the next time step of an input with time steps.
  void AddStep(const glue::Surfaces& surfaces)
  {
    if (surfaces.Held.size() > 1)
    {
      throw std::invalid_argument("an input with time steps must be a single surface at each time, "
                                  "but has " +
        std::to_string(surfaces.Held.size()) + " at time step " +
        std::to_string(this->Steps.size()));
    }
    const auto surface =
      surfaces.Held.empty() ? vtkSmartPointer<vtkPolyData>::New() : surfaces.Held.front();
    this->Steps.push_back({ this->Times[this->Steps.size()], surface, -1, {} });
  }

  void Tabulate(const conformal::Run& run)
  {
    vtkNew<vtkStringArray> states;
    vtkNew<vtkIdTypeArray> folds;
    states->SetName("State");
    folds->SetName("NumberOfFolds");
    std::vector<double> times, areas, volumes, moves, stretches, growths, shears, normals, tangents;
    for (std::size_t s = 0; s < this->Steps.size(); ++s)
    {
      const int k = this->Steps[s].Used;
      times.push_back(this->Steps[s].Time);
      states->InsertNextValue(
        k < 0 ? "skipped" : (static_cast<int>(s) == this->Reference ? "reference" : "registered"));
      folds->InsertNextValue(k < 0 ? 0 : this->Used[k].Result.NumberOfFolds);
      for (std::vector<double>* column :
        { &areas, &volumes, &moves, &stretches, &growths, &shears, &normals, &tangents })
      {
        column->push_back(0.0);
      }
      if (k >= 0)
      {
        const conformal::MappedMesh& mesh = this->Used[k].Moving.Surface;
        const conformal::SurfaceMotion motion = this->MotionOf(k);
        areas.back() = conformal::surfaceArea(mesh.Positions, mesh.Triangles);
        volumes.back() = conformal::signedVolume(mesh.Positions, mesh.Triangles);
        moves.back() = this->MoveOf(k) / std::sqrt(areas.back());
        stretches.back() = this->Used[k].Result.Stretch;
        growths.back() = MeanOver(mesh, motion.AreaRates);
        shears.back() = MeanOver(mesh, motion.ShearRates);
        normals.back() = MeanOver(mesh, SpeedsOf(motion.Normal));
        tangents.back() = MeanOver(mesh, SpeedsOf(motion.Tangential));
      }
      run.report(static_cast<double>(s + 1) / static_cast<double>(this->Steps.size()));
    }
    const double area = areas[this->Reference], volume = volumes[this->Reference];
    for (std::size_t s = 0; s < times.size(); ++s)
    {
      areas[s] /= area;
      volumes[s] = volume != 0.0 ? volumes[s] / volume : 0.0;
    }
    this->Rows = vtkSmartPointer<vtkTable>::New();
    vtkFieldData* rows = this->Rows->GetRowData();
    glue::AddNumbers(rows, "Time", times);
    rows->AddArray(states);
    glue::AddNumbers(rows, "RelativeArea", areas);
    glue::AddNumbers(rows, "RelativeVolume", volumes);
    glue::AddNumbers(rows, "RelativeDisplacement", moves);
    glue::AddNumbers(rows, "RegistrationStretch", stretches);
    rows->AddArray(folds);
    glue::AddNumbers(rows, "MeanAreaRate", growths);
    glue::AddNumbers(rows, "MeanShearRate", shears);
    glue::AddLengths(rows, "MeanNormalSpeed", normals, this->Frame);
    glue::AddLengths(rows, "MeanTangentialSpeed", tangents, this->Frame);
  }

  // Convert all surfaces, and find those that cannot be used.
  void Convert(vtkObject* self, const std::string& landmarkArrayName, conformal::Steps& progress)
  {
    std::vector<vtkPointSet*> sets;
    for (const SeriesStep& step : this->Steps)
    {
      sets.push_back(step.Surface);
    }
    this->Frame = glue::FrameOf(sets);
    this->Used.clear();
    this->Inputs.clear();
    std::map<double, int> numbers; // of landmarks
    for (std::size_t s = 0; s < this->Steps.size(); ++s)
    {
      SeriesStep& step = this->Steps[s];
      step.Used = -1;
      const conformal::Run part = progress.next();
      try
      {
        this->ConvertOne(self, s, landmarkArrayName, numbers, part);
      }
      catch (const std::invalid_argument& error)
      {
        step.Fault = error.what();
      }
    }
  }

  void Register(
    conformal::SphericalTimeSeriesOptions options, int reference, const conformal::Run& run)
  {
    const auto size = static_cast<int>(this->Steps.size());
    if (reference >= size)
    {
      throw std::invalid_argument("ReferenceStep is " + std::to_string(reference) +
        ", but there are only " + std::to_string(size) + " time steps, counted from 0");
    }
    if (this->Steps[reference].Used < 0)
    {
      throw std::invalid_argument("time step " + std::to_string(reference) +
        ", which is ReferenceStep, cannot be used: " + this->Steps[reference].Fault +
        "; set ReferenceStep to another time step");
    }
    options.Reference = this->Steps[reference].Used;
    this->Reference = reference;
    const auto results = conformal::registerTimeSeries(this->Inputs, this->Known, options, run);
    for (std::size_t k = 0; k < results.size(); ++k)
    {
      this->Used[k].Result = results[k];
      this->Used[k].Moving.Surface = this->Inputs[k].Surface.Surface;
      this->Used[k].Moving.Surface.SpherePositions = results[k].SpherePositions;
      this->Used[k].Moving.Time = this->Inputs[k].Time;
    }
    this->Inputs.clear();
  }

  void Warn(vtkObject* self) const
  {
    conformal::Index unmet = 0;
    std::string ambiguous;
    for (std::size_t s = 0; s < this->Steps.size(); ++s)
    {
      if (this->Steps[s].Used < 0)
      {
        vtkWarningWithObjectMacro(
          self, << "time step " << s << " is skipped and interpolated: " << this->Steps[s].Fault);
      }
      else
      {
        const conformal::SphericalRegistrationResult& result =
          this->Used[this->Steps[s].Used].Result;
        unmet += result.NumberOfUnmetLandmarks;
        if (result.IsAmbiguous)
        {
          ambiguous += (ambiguous.empty() ? "" : ", ") + std::to_string(s);
        }
      }
    }
    if (!ambiguous.empty())
    {
      vtkWarningWithObjectMacro(
        self, << "two correspondences are about equally good, such as head and tail of similar "
                 "shape, at the time steps "
              << ambiguous << "; inspect these steps, or add landmarks");
    }
    if (unmet > 0)
    {
      vtkWarningWithObjectMacro(
        self, << unmet << " landmarks cannot be matched without folds of a map");
    }
  }

  void ConvertOne(vtkObject* self, std::size_t number, const std::string& landmarkArrayName,
    std::map<double, int>& numbers, const conformal::Run& run)
  {
    SeriesStep& step = this->Steps[number];
    if (step.Surface->GetNumberOfPoints() == 0)
    {
      throw std::invalid_argument("the surface is empty");
    }
    UsedStep used;
    used.Surface = step.Surface;
    used.Registered =
      glue::ToSurfaceToRegister(self, step.Surface, this->Features, this->Frame, run);
    // Reject maps that registration would reject.
    const conformal::PreparedSurface usable(used.Registered.Core, {}, false, false, "given");
    conformal::TimeStep input;
    input.Name = "time step " + std::to_string(number);
    input.Time = step.Time;
    input.Surface = used.Registered.Core;
    if (!landmarkArrayName.empty() &&
      step.Surface->GetPointData()->HasArray(landmarkArrayName.c_str()))
    {
      for (const auto& [value, vertex] :
        glue::LandmarksOf(step.Surface, used.Registered, landmarkArrayName))
      {
        const int next = static_cast<int>(numbers.size());
        input.Landmarks[numbers.emplace(value, next).first->second] = vertex;
      }
    }
    step.Used = static_cast<int>(this->Used.size());
    step.Fault.clear();
    this->Used.push_back(std::move(used));
    this->Inputs.push_back(std::move(input));
  }

  TimePlace PlaceOf(double time) const
  {
    TimePlace place;
    const auto timeOf = [&](std::size_t k) { return this->Used[k].Moving.Time; };
    while (place.First + 1 < this->Used.size() && timeOf(place.First + 1) <= time)
    {
      ++place.First;
    }
    place.Second = place.First;
    if (time > timeOf(place.First) && place.First + 1 < this->Used.size())
    {
      ++place.Second;
      place.Fraction = (time - timeOf(place.First)) / (timeOf(place.Second) - timeOf(place.First));
    }
    return place;
  }

  conformal::SurfaceMotion MotionOf(std::size_t used) const
  {
    const UsedStep& step = this->Used[used];
    if (this->Used.size() < 2)
    {
      return NoMotion(step.Moving.Surface.Positions.rows());
    }
    const std::size_t before = used > 0 ? used - 1 : used,
                      after = used + 1 < this->Used.size() ? used + 1 : used;
    return conformal::computeMotion(
      this->Used[before].Moving, step.Moving, this->Used[after].Moving);
  }

  // Compute the mean distance to the same positions on the sphere at the previous time step.
  double MoveOf(std::size_t used) const
  {
    if (used == 0)
    {
      return 0.0;
    }
    const conformal::MappedMesh& mesh = this->Used[used].Moving.Surface;
    const conformal::Points before =
      conformal::positionsBetween(mesh, this->Used[used - 1].Moving.Surface, 1.0);
    std::vector<double> distances(mesh.Positions.rows());
    for (conformal::Index v = 0; v < mesh.Positions.rows(); ++v)
    {
      distances[v] = (mesh.Positions.row(v) - before.row(v)).norm();
    }
    return MeanOver(mesh, distances);
  }

  // Move the points that are vertices, and remove normals, which are no longer correct.
  void SetPositions(
    const UsedStep& step, const conformal::Points& positions, vtkPolyData* surface) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->DeepCopy(surface->GetPoints());
    for (std::size_t v = 0; v < step.Registered.PointIds.size(); ++v)
    {
      const conformal::Vector3 p =
        conformal::Vector3(positions.row(static_cast<conformal::Index>(v))) * this->Frame.Unit;
      points->SetPoint(step.Registered.PointIds[v], p.data());
    }
    surface->SetPoints(points);
    glue::RemoveNormals(surface);
  }

  std::vector<UsedStep> Used;
  std::vector<conformal::TimeStep> Inputs; // of the registration
  vtkSmartPointer<vtkTable> Rows;          // a row for each time step
  conformal::CoordinateFrame Frame;
  int Reference = 0;
};

//------------------------------------------------------------------------------
vtkSphericalTimeSeries::vtkSphericalTimeSeries()
  : Kept(std::make_unique<Series>())
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkSphericalTimeSeries::~vtkSphericalTimeSeries() = default;

//------------------------------------------------------------------------------
void vtkSphericalTimeSeries::AddFeature(const char* name, double weight)
{
  this->Features.emplace_back(name ? name : "", weight);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalTimeSeries::RemoveAllFeatures()
{
  if (!this->Features.empty())
  {
    this->Features.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkSphericalTimeSeries::GetTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkSphericalTimeSeries::FillInputPortInformation(int, vtkInformation* info)
{
  glue::AcceptSurfaces(info);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTimeSeries::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTimeSeries::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // This request is made whenever an input or a property has changed.
  this->Kept->Forget();
  this->Kept->Times = glue::TimeStepsOf(inputs[0]);
  this->Kept->Interval = this->TimeInterval;
  std::vector<double> times = this->Kept->Times;
  if (times.empty())
  {
    // Blocks can be counted only if the input is up to date. Otherwise, RequestData counts them.
    glue::Surfaces surfaces;
    try
    {
      glue::AddSurfaces(inputs[0], surfaces, glue::MissingBlocks::Empty);
    }
    catch (const std::invalid_argument&)
    {
      return 1; // RequestData reports it
    }
    times = glue::CountedTimes(
      std::max<std::size_t>(surfaces.Held.size(), inputs[0]->GetNumberOfInformationObjects()),
      this->TimeInterval);
  }
  SetTimesOf(outputs, times);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTimeSeries::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  const std::vector<double>& times = this->Kept->Times;
  if (!times.empty())
  {
    // If all time steps are known, request the last one again, so that the input does not change.
    const std::size_t next = std::min(this->Kept->Steps.size(), times.size() - 1);
    inputs[0]->GetInformationObject(0)->Set(Executive::UPDATE_TIME_STEP(), times[next]);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTimeSeries::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  vtkInformation* info = outputVector->GetInformationObject(0);
  const double time =
    info->Has(Executive::UPDATE_TIME_STEP()) ? info->Get(Executive::UPDATE_TIME_STEP()) : 0.0;
  request->Remove(Executive::CONTINUE_EXECUTING());
  Series& series = *this->Kept;
  conformal::SphericalTimeSeriesOptions options;
  options.Registration.PositionWeight = this->PositionWeight;
  options.Registration.ShapeWeight = this->ShapeWeight;
  options.Registration.StretchWeight = this->StretchWeight;
  options.Registration.Frequency = this->Frequency;
  options.NumberOfSweeps = this->NumberOfSweeps;
  const std::string landmarks = this->LandmarkArrayName;
  return glue::RunCore(this,
    [&]()
    {
      if (!series.IsDone)
      {
        series.Read(inputVector[0]);
        SetTimesOf(outputVector, series.AllTimes());
        if (!series.Times.empty() && !series.HasAll())
        {
          request->Set(Executive::CONTINUE_EXECUTING(), 1);
          return;
        }
        series.Features = this->Features;
        options.FeatureWeights = glue::WeightsOf(series.Features);
        series.Compute(this, options, this->ReferenceStep, landmarks);
      }
      if (series.IsDone)
      {
        series.Show(time, output);
        table->ShallowCopy(series.Table());
      }
    });
}

//------------------------------------------------------------------------------
void vtkSphericalTimeSeries::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReferenceStep: " << this->ReferenceStep << "\n";
  os << indent << "TimeInterval: " << this->TimeInterval << "\n";
  os << indent << "PositionWeight: " << this->PositionWeight << "\n";
  os << indent << "ShapeWeight: " << this->ShapeWeight << "\n";
  os << indent << "StretchWeight: " << this->StretchWeight << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "NumberOfSweeps: " << this->NumberOfSweeps << "\n";
  os << indent << "LandmarkArrayName: " << this->LandmarkArrayName << "\n";
  os << indent << "NumberOfFeatures: " << this->Features.size() << "\n";
}

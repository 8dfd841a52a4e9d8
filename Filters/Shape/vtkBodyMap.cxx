#include "vtkBodyMap.h"

#include "Base/Steps.h"
#include "Body/BodyCoordinates.h"
#include "Body/BodyRelief.h"
#include "Body/Planetocentric.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Mesh/GenusZeroCheck.h"
#include "Sphere/SphereCoverage.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkBodyMap);

namespace
{
void AddPoint(vtkFieldData* data, const char* name, const conformal::Vector3& point,
  const conformal::CoordinateFrame& frame)
{
  conformal::Points row = point.transpose();
  glue::LengthsFromFrame(row.data(), 3, frame, name);
  glue::AddVectors(data, name, row);
}

// Add an array of 9 components: the columns of the matrix, each of which is an axis.
void AddAxes(vtkFieldData* data, const char* name, const Eigen::Matrix3d& axes)
{
  glue::AddTuple(data, name, axes.data(), 9);
}

void AddAngles(vtkPointData* data, const conformal::Points& map)
{
  std::vector<double> longitudes(map.rows()), latitudes(map.rows());
  for (conformal::Index i = 0; i < map.rows(); ++i)
  {
    const conformal::Vector2 degrees = conformal::toLongitudeLatitude(map.row(i));
    longitudes[i] = degrees[0];
    latitudes[i] = degrees[1];
  }
  glue::AddNumbers(data, "Longitude", longitudes);
  glue::AddNumbers(data, "Latitude", latitudes);
}

// Add planetocentric coordinates, and the frame that vtkBodyMapImage needs to draw them.
void AddPlanetocentric(vtkPolyData* output, const conformal::Points& points,
  const conformal::BodyCoordinatesOptions& options, const conformal::CoordinateFrame& frame)
{
  const conformal::PlanetocentricFrame axes = conformal::planetocentricFrame(options);
  const conformal::Points values = conformal::planetocentricCoordinates(points, axes);
  const auto column = [&](int k)
  {
    std::vector<double> result(values.rows());
    Eigen::VectorXd::Map(result.data(), values.rows()) = values.col(k);
    return result;
  };
  glue::AddNumbers(output->GetPointData(), "PlanetocentricLongitude", column(0));
  glue::AddNumbers(output->GetPointData(), "PlanetocentricLatitude", column(1));
  glue::AddLengths(output->GetPointData(), "Radius", column(2), frame);
  AddPoint(output->GetFieldData(), "BodyCenter", axes.Center, frame);
  AddAxes(output->GetFieldData(), "BodyAxes", axes.Axes);
}

void AddRelief(vtkPolyData* output, const conformal::Mesh& body, bool isEllipsoid,
  const conformal::CoordinateFrame& frame)
{
  const conformal::ReferenceEllipsoid reference =
    isEllipsoid ? conformal::referenceEllipsoid(body) : conformal::referenceSphere(body);
  const conformal::BodyRelief relief = conformal::measureRelief(body, reference);
  glue::AddLengths(output->GetPointData(), "Height", relief.Heights, frame);
  glue::AddNumbers(output->GetPointData(), "Slope", relief.Slopes);
  AddPoint(output->GetFieldData(), "ReferenceCenter", reference.Center, frame);
  AddPoint(output->GetFieldData(), "ReferenceRadii", reference.Radii, frame);
  AddAxes(output->GetFieldData(), "ReferenceAxes", reference.Axes);
}

void SetGraticule(vtkPolyData* output, const std::vector<conformal::GraticuleLine>& lines,
  const conformal::CoordinateFrame& frame)
{
  conformal::Index size = 0;
  for (const conformal::GraticuleLine& line : lines)
  {
    size += line.Positions.rows();
  }
  conformal::Points points(size, 3);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> isMeridian;
  isMeridian->SetName("IsMeridian");
  std::vector<double> degrees;
  conformal::Index first = 0;
  for (const conformal::GraticuleLine& line : lines)
  {
    const conformal::Index count = line.Positions.rows();
    if (count < 2)
    {
      continue; // the line is in a hole of the map
    }
    points.middleRows(first, count) = line.Positions;
    cells->InsertNextCell(static_cast<int>(count));
    for (conformal::Index i = 0; i < count; ++i)
    {
      cells->InsertCellPoint(first + i);
    }
    first += count;
    isMeridian->InsertNextValue(line.IsMeridian);
    degrees.push_back(line.Degrees);
  }
  points.conservativeResize(first, 3);
  glue::SetPoints(output, points, frame);
  output->SetLines(cells);
  output->GetCellData()->AddArray(isMeridian);
  glue::AddNumbers(output->GetCellData(), "Degrees", degrees);
}

// Measure how the map covers the sphere. One direction should belong to only one point of the body.
conformal::SphereCoverage CoverageOf(const conformal::MappedMesh& body)
{
  conformal::Triangles triangles = body.Triangles;
  if (conformal::signedVolume(body.Positions, triangles) < 0.0)
  {
    triangles.col(1).swap(triangles.col(2));
  }
  return conformal::measureSphereCoverage(body.SpherePositions, triangles);
}

conformal::Points DirectionsOf(vtkPolyData* places)
{
  conformal::Points directions(places->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < directions.rows(); ++i)
  {
    double p[3];
    places->GetPoint(i, p);
    if (!(std::abs(p[0]) <= 1e9 && std::abs(p[1]) <= 90.0))
    {
      throw std::invalid_argument("place " + std::to_string(i) +
        " must have a finite longitude as x and a latitude in [-90, 90] as y, in degrees");
    }
    directions.row(i) = conformal::toDirection({ p[0], p[1] });
  }
  return directions;
}

void WarnOfFolds(vtkObject* self, const conformal::MappedMesh& body)
{
  const conformal::SphereCoverage coverage = CoverageOf(body);
  if (coverage.NumberOfFolds > 0 || coverage.Times > 1.5)
  {
    vtkWarningWithObjectMacro(
      self, << "the map to the sphere covers it " << std::lround(coverage.Times) << " times with "
            << coverage.NumberOfFolds
            << " folded triangles: some longitudes and latitudes belong to several points");
  }
}

void AddPoles(vtkPolyData* output, const conformal::BodyCoordinates& coordinates,
  const conformal::CoordinateFrame& frame)
{
  AddPoint(output->GetFieldData(), "BodyNorthPole", coordinates.NorthPole, frame);
  AddPoint(output->GetFieldData(), "BodySouthPole", coordinates.SouthPole, frame);
  AddPoint(output->GetFieldData(), "BodyMarker", coordinates.Marker, frame);
}

// Add what is known of positions: poles, marker and planetocentric coordinates.
void AddPlaces(vtkPolyData* output, const conformal::Points& points,
  const conformal::BodyCoordinates& coordinates, const conformal::BodyCoordinatesOptions& options,
  const conformal::CoordinateFrame& frame)
{
  AddPoles(output, coordinates, frame);
  AddPlanetocentric(output, points, options, frame);
}

// Move the optional places to their positions on the body.
void SetPlaces(vtkPolyData* output, vtkPolyData* places, const conformal::MappedMesh& body,
  const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  if (!places)
  {
    return;
  }
  glue::RequireCellIds(places);
  const conformal::Points points = conformal::placeOnBody(body, DirectionsOf(places), run);
  if (!points.allFinite())
  {
    throw std::invalid_argument("some places lie where the map of the surface has a hole");
  }
  output->ShallowCopy(places);
  glue::SetPoints(output, points, frame);
}

conformal::BodyCoordinatesOptions OptionsOf(vtkBodyMap* self)
{
  conformal::BodyCoordinatesOptions options;
  options.RotationAxis = conformal::Vector3(self->GetRotationAxis());
  options.UseMarkerPoint = self->GetUseMarkerPoint();
  options.Center = conformal::Vector3(self->GetCenter());
  options.MarkerPoint = conformal::Vector3(self->GetMarkerPoint());
  return options;
}

// Convert the points in the options from the unit of the user to a frame.
void ToFrame(conformal::BodyCoordinatesOptions& options, const conformal::CoordinateFrame& frame)
{
  if (!options.Center.allFinite() || !options.MarkerPoint.allFinite())
  {
    throw std::invalid_argument("Center and MarkerPoint must be finite");
  }
  options.Center = frame.toFrameFromAfar(options.Center);
  options.MarkerPoint = frame.toFrameFromAfar(options.MarkerPoint);
}
}

//------------------------------------------------------------------------------
vtkBodyMap::vtkBodyMap()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
void vtkBodyMap::SetPlacesConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkBodyMap::SetPlacesData(vtkPolyData* places)
{
  this->SetInputData(1, places);
}

//------------------------------------------------------------------------------
int vtkBodyMap::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkBodyMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto places = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* graticule = vtkPolyData::GetData(outputVector, 1);
  vtkPolyData* placed = vtkPolyData::GetData(outputVector, 2);
  conformal::BodyCoordinatesOptions options = OptionsOf(this);
  const bool isEllipsoid = this->Reference == ELLIPSOID;
  const double spacing = this->GraticuleSpacing;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      // Reading, coordinates, relief, graticule, places.
      conformal::Steps steps(glue::RunOf(this), { 0.06, 0.45, 0.19, 0.3, places ? 0.3 : 0.0 });
      steps.next();
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      conformal::MappedMesh body = glue::CopyOriented(this, surface, frame);
      ToFrame(options, frame);
      const conformal::BodyCoordinates coordinates =
        conformal::findBodyCoordinates(body, options, steps.next());
      body.SpherePositions = coordinates.SpherePositions;
      WarnOfFolds(this, body);
      steps.next();
      const vtkNew<vtkPolyData> result;
      result->ShallowCopy(surface);
      glue::ReplaceSpherePositions(result, coordinates.SpherePositions);
      glue::RemoveAreaDistortions(result);
      AddAngles(result->GetPointData(), coordinates.SpherePositions);
      AddRelief(result, body, isEllipsoid, frame);
      AddPlaces(result, body.Positions, coordinates, options, frame);
      const std::vector<conformal::GraticuleLine> lines =
        conformal::makeGraticule(body, spacing, steps.next());
      SetPlaces(placed, places, body, frame, steps.next());
      SetGraticule(graticule, lines, frame);
      graticule->GetFieldData()->PassData(surface->GetFieldData()); // as VTK does before a run
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkBodyMap::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto print = [&](const char* name, const double values[3]) {
    os << indent << name << ": (" << values[0] << ", " << values[1] << ", " << values[2] << ")\n";
  };
  this->Superclass::PrintSelf(os, indent);
  print("Center", this->Center);
  print("RotationAxis", this->RotationAxis);
  os << indent << "UseMarkerPoint: " << (this->UseMarkerPoint ? "On" : "Off") << "\n";
  print("MarkerPoint", this->MarkerPoint);
  os << indent << "Reference: " << (this->Reference == SPHERE ? "Sphere" : "Ellipsoid") << "\n";
  os << indent << "GraticuleSpacing: " << this->GraticuleSpacing << "\n";
}

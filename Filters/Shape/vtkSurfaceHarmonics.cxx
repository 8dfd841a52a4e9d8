#include "vtkSurfaceHarmonics.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/HarmonicTables.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Harmonics/HarmonicAlignment.h"
#include "Harmonics/HarmonicFit.h"
#include "Harmonics/HarmonicSurface.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Linear/EdgeWeights.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

vtkStandardNewMacro(vtkSurfaceHarmonics);

namespace
{
// Point array whose harmonics are computed. In the matrix of values, its columns follow those of
// the coordinates and of earlier arrays.
struct ChosenArray
{
  std::string Name;
  int Components = 0;
  conformal::Index First = 0;
};

// Return the names of the columns of an array in the table.
std::vector<std::string> ColumnNames(const ChosenArray& array)
{
  std::vector<std::string> names;
  names.reserve(array.Components);
  for (int c = 0; c < array.Components; ++c)
  {
    names.push_back(array.Name + (array.Components > 1 ? "_" + std::to_string(c) : ""));
  }
  return names;
}

std::vector<ChosenArray> ArraysOf(vtkPolyData* surface, const std::vector<std::string>& names)
{
  std::vector<ChosenArray> arrays;
  conformal::Index first = 3;
  std::set<std::string> columns = { "Degree", "Order", "X", "Y", "Z" };
  for (const std::string& name : names)
  {
    vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
    if (!array || array->GetNumberOfComponents() < 1)
    {
      throw std::invalid_argument("the surface has no point array \"" + name + "\" of numbers");
    }
    arrays.push_back({ name, array->GetNumberOfComponents(), first });
    for (const std::string& column : ColumnNames(arrays.back()))
    {
      if (!columns.insert(column).second || name == glue::SpherePositionName())
      {
        throw std::invalid_argument("the point array \"" + name +
          "\" has the name of the map or of a column of the table; rename it");
      }
    }
    first += array->GetNumberOfComponents();
  }
  return arrays;
}

conformal::Index NumberOfColumns(const std::vector<ChosenArray>& arrays)
{
  return arrays.empty() ? 3 : arrays.back().First + arrays.back().Components;
}

// Return the matrix of values at the points: coordinates in the frame, then the chosen arrays.
conformal::Columns ValuesOf(
  vtkPolyData* surface, const conformal::Points& positions, const std::vector<ChosenArray>& arrays)
{
  conformal::Columns values(positions.rows(), NumberOfColumns(arrays));
  values.leftCols(3) = positions;
  for (const ChosenArray& chosen : arrays)
  {
    vtkDataArray* array = surface->GetPointData()->GetArray(chosen.Name.c_str());
    for (int c = 0; c < chosen.Components; ++c)
    {
      for (conformal::Index i = 0; i < values.rows(); ++i)
      {
        values(i, chosen.First + c) = array->GetComponent(i, c);
      }
    }
    if (!values.middleCols(chosen.First, chosen.Components).allFinite())
    {
      throw std::invalid_argument(
        "the point array \"" + chosen.Name + "\" has values that are not finite");
    }
  }
  return values;
}

conformal::MappedMesh MeshOf(vtkPolyData* surface, const conformal::CoordinateFrame& frame)
{
  conformal::MappedMesh mesh = glue::CopyMapped(surface, frame);
  glue::RequireFiniteTriangles(mesh);
  return mesh;
}

// Return the coefficients of a reference surface's coordinates, converted to a frame.
conformal::Columns ReferenceOf(vtkTable* table, const conformal::CoordinateFrame& frame)
{
  conformal::Points coordinates = glue::FromTable(table).Coefficients.leftCols(3);
  for (conformal::Index i = 0; i < coordinates.rows(); ++i)
  {
    coordinates.row(i) = frame.toFrameFromAfar(coordinates.row(i));
  }
  return coordinates;
}

conformal::HarmonicAlignment AlignmentOf(const conformal::Columns& coefficients,
  vtkTable* reference, int kind, const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  const bool movesSurface = kind == vtkSurfaceHarmonics::MAP_AND_SURFACE;
  const conformal::Columns coordinates = coefficients.leftCols(3);
  if (reference)
  {
    return conformal::alignToReference(
      coordinates, ReferenceOf(reference, frame), movesSurface, run);
  }
  conformal::HarmonicAlignment alignment = conformal::alignToEllipsoid(coordinates);
  if (!movesSurface)
  {
    alignment.SurfaceRotation.setIdentity();
    alignment.Center.setZero();
  }
  return alignment;
}

// Return positions after the rigid motion of an alignment.
conformal::Points Moved(
  const conformal::Points& positions, const conformal::HarmonicAlignment& alignment)
{
  return (positions.rowwise() - alignment.Center.transpose()) *
    alignment.SurfaceRotation.transpose();
}

conformal::Columns AlignedCoefficients(const conformal::Columns& coefficients,
  const conformal::HarmonicAlignment& alignment, const conformal::Run& run)
{
  conformal::Columns aligned = conformal::rotateHarmonics(coefficients, alignment.MapRotation, run);
  aligned.row(0).head(3) -= std::sqrt(4.0 * conformal::Pi) * alignment.Center.transpose();
  aligned.leftCols(3) = (aligned.leftCols(3) * alignment.SurfaceRotation.transpose()).eval();
  return aligned;
}

void AddTable(vtkTable* table, const conformal::Columns& coefficients,
  const std::vector<ChosenArray>& arrays, const conformal::CoordinateFrame& frame)
{
  glue::Harmonics harmonics = { coefficients, {} };
  glue::LengthsFromFrame(
    harmonics.Coefficients.data(), 3 * coefficients.rows(), frame, "a coefficient");
  for (const ChosenArray& chosen : arrays)
  {
    const std::vector<std::string> columns = ColumnNames(chosen);
    harmonics.Names.insert(harmonics.Names.end(), columns.begin(), columns.end());
  }
  if (!coefficients.allFinite())
  {
    throw std::overflow_error("values of the arrays are too large for their harmonics");
  }
  glue::ToTable(harmonics, table);
}

// Add the rebuilt values of a chosen array, with the name of this array.
void AddRebuilt(vtkPointData* data, const ChosenArray& chosen, const conformal::Columns& values)
{
  if (!values.allFinite())
  {
    throw std::overflow_error(
      "values of the array \"" + chosen.Name + "\" are too large for their harmonics");
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName(chosen.Name.c_str());
  array->SetNumberOfComponents(chosen.Components);
  array->SetNumberOfTuples(values.rows());
  for (int c = 0; c < chosen.Components; ++c)
  {
    for (conformal::Index i = 0; i < values.rows(); ++i)
    {
      array->SetComponent(i, c, values(i, c));
    }
  }
  data->AddArray(array);
}

std::vector<double> PowerOf(const conformal::Columns& coefficients)
{
  const Eigen::VectorXd power = conformal::powerPerDegree(coefficients) / (4.0 * conformal::Pi);
  return { power.begin(), power.end() };
}

// Add the field data that describe the harmonics before the alignment.
void AddSummary(vtkFieldData* data, const conformal::Columns& coefficients,
  const std::vector<ChosenArray>& arrays, const conformal::CoordinateFrame& frame)
{
  std::vector<double> power = PowerOf(coefficients.leftCols(3));
  std::vector<double> spectrum(power.size(), 0.0);
  for (std::size_t l = 1; l < power.size() && power[1] > 0.0; ++l)
  {
    spectrum[l] = std::sqrt(power[l] / power[1]);
  }
  glue::AreasFromFrame(
    power.data(), static_cast<conformal::Index>(power.size()), frame, "HarmonicPower");
  glue::AddNumbers(data, "HarmonicPower", power);
  glue::AddNumbers(data, "ShapeSpectrum", spectrum);
  for (const ChosenArray& chosen : arrays)
  {
    glue::AddNumbers(data, ("HarmonicPower_" + chosen.Name).c_str(),
      PowerOf(coefficients.middleCols(chosen.First, chosen.Components)));
  }
}

void AddAlignment(vtkFieldData* data, const conformal::HarmonicAlignment& alignment,
  const conformal::CoordinateFrame& frame)
{
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const RowMajor map = alignment.MapRotation, surface = alignment.SurfaceRotation;
  conformal::Vector3 center = alignment.Center;
  glue::LengthsFromFrame(center.data(), 3, frame, "SurfaceCenter");
  glue::AddTuple(data, "MapRotation", map.data(), 9);
  glue::AddTuple(data, "SurfaceRotation", surface.data(), 9);
  glue::AddTuple(data, "SurfaceCenter", center.data(), 3);
  glue::AddNumber(data, "AxisEndMargin", alignment.EndMargin);
}

double RootMeanSquareDistance(const conformal::MappedMesh& mesh, const conformal::Points& rebuilt)
{
  const Eigen::VectorXd areas = conformal::vertexAreas(mesh.Positions, mesh.Triangles);
  const Eigen::VectorXd squares = (rebuilt - mesh.Positions).rowwise().squaredNorm();
  return std::sqrt(squares.dot(areas) / areas.sum());
}

// Options of the computation for one surface.
struct HarmonicsJob
{
  int Degree, Kept; // maximum degrees of the fit, and of the rebuilt surface
  int Alignment;    // value of vtkSurfaceHarmonics::GetAlignment()
  int Frequency;    // frequency of the geodesic sphere; 0 for the input's mesh
  std::vector<ChosenArray> Arrays;

  // Return relative costs of reading, fit, alignment, rotation, the rebuilt surface, the geodesic
  // surface, and the output.
  std::vector<double> shares(bool hasReference) const
  {
    const bool isAligned = this->Alignment != vtkSurfaceHarmonics::NONE;
    return { 0.03, 0.7, isAligned && hasReference ? 0.2 : 0.0, isAligned ? 0.01 : 0.0, 0.15,
      this->Frequency > 0 ? 0.1 : 0.0, 0.02 };
  }
};

// Set the output to the surface rebuilt on a geodesic sphere.
void SetGeodesicSurface(vtkPolyData* output, const HarmonicsJob& job,
  const conformal::Columns& aligned, const conformal::CoordinateFrame& frame,
  const conformal::Run& run)
{
  const conformal::HarmonicSurface made =
    conformal::makeHarmonicSurface(conformal::upToDegree(aligned, job.Kept), job.Frequency, run);
  glue::SetSurface(output, made.Positions, made.Triangles, frame);
  glue::AddVectors(output->GetPointData(), glue::SpherePositionName(), made.SpherePositions);
  for (const ChosenArray& chosen : job.Arrays)
  {
    AddRebuilt(
      output->GetPointData(), chosen, made.Values.middleCols(chosen.First - 3, chosen.Components));
  }
}

// Coefficients of a surface, before and after the alignment.
struct FittedHarmonics
{
  conformal::CoordinateFrame Frame;
  conformal::MappedMesh Mesh;
  conformal::Columns Coefficients; // before the alignment
  conformal::HarmonicAlignment Alignment;
  conformal::Columns Aligned;
};

FittedHarmonics Fit(
  vtkPolyData* surface, vtkTable* reference, const HarmonicsJob& job, conformal::Steps& steps)
{
  steps.next();
  FittedHarmonics fit;
  fit.Frame = glue::FrameOf({ surface });
  fit.Mesh = MeshOf(surface, fit.Frame);
  const conformal::Columns values = ValuesOf(surface, fit.Mesh.Positions, job.Arrays);
  fit.Coefficients = conformal::fitHarmonics(fit.Mesh, values, job.Degree, steps.next());
  fit.Aligned = fit.Coefficients;
  const conformal::Run aligning = steps.next(), rotating = steps.next();
  if (job.Alignment != vtkSurfaceHarmonics::NONE)
  {
    fit.Alignment = AlignmentOf(fit.Coefficients, reference, job.Alignment, fit.Frame, aligning);
    fit.Aligned = AlignedCoefficients(fit.Coefficients, fit.Alignment, rotating);
  }
  return fit;
}

// Set the output to the surface rebuilt on the mesh of the input.
void SetInputSurface(vtkPolyData* output, vtkPolyData* input, const HarmonicsJob& job,
  const conformal::Columns& rebuilt, const FittedHarmonics& fit)
{
  output->ShallowCopy(input);
  glue::RemoveNormals(output);
  glue::SetPoints(output, Moved(rebuilt.leftCols(3), fit.Alignment), fit.Frame);
  glue::ReplaceSpherePositions(
    output, fit.Mesh.SpherePositions * fit.Alignment.MapRotation.transpose());
  glue::RemoveDistortions(output); // of the surface before its points were moved
  for (const ChosenArray& chosen : job.Arrays)
  {
    AddRebuilt(output->GetPointData(), chosen, rebuilt.middleCols(chosen.First, chosen.Components));
  }
}

void SetRebuiltSurface(vtkPolyData* output, vtkPolyData* input, const HarmonicsJob& job,
  const conformal::Columns& rebuilt, const FittedHarmonics& fit, const conformal::Run& run)
{
  if (job.Frequency > 0)
  {
    SetGeodesicSurface(output, job, fit.Aligned, fit.Frame, run);
  }
  else
  {
    SetInputSurface(output, input, job, rebuilt, fit);
  }
}
}

//------------------------------------------------------------------------------
vtkSurfaceHarmonics::vtkSurfaceHarmonics()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSurfaceHarmonics::AddPointArray(const char* name)
{
  const std::string added = name ? name : "";
  const bool isThere =
    std::find(this->PointArrays.begin(), this->PointArrays.end(), added) != this->PointArrays.end();
  if (!added.empty() && !isThere)
  {
    this->PointArrays.push_back(added);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceHarmonics::RemoveAllPointArrays()
{
  if (!this->PointArrays.empty())
  {
    this->PointArrays.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceHarmonics::SetReferenceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkSurfaceHarmonics::SetReferenceData(vtkTable* reference)
{
  this->SetInputData(1, reference);
}

//------------------------------------------------------------------------------
vtkTable* vtkSurfaceHarmonics::GetCoefficients()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkSurfaceHarmonics::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceHarmonics::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceHarmonics::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto reference = glue::Held(vtkTable::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* tableOutput = vtkTable::GetData(outputVector, 1);
  HarmonicsJob job{ this->Degree, std::min(this->ReconstructionDegree, this->Degree),
    this->Alignment, this->MeshType == GEODESIC ? this->Frequency : 0, {} };
  const std::vector<std::string> names = this->PointArrays;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; it has no harmonics"))
      {
        return;
      }
      glue::RequireCellIds(surface);
      job.Arrays = ArraysOf(surface, names);
      conformal::Steps steps(glue::RunOf(this), job.shares(reference != nullptr));
      const FittedHarmonics fit = Fit(surface, reference, job, steps);
      const conformal::Columns rebuilt = conformal::evaluateHarmonics(
        conformal::upToDegree(fit.Coefficients, job.Kept), fit.Mesh.SpherePositions, steps.next());
      const vtkNew<vtkPolyData> result;
      SetRebuiltSurface(result, surface, job, rebuilt, fit, steps.next());
      steps.next();
      vtkFieldData* data = result->GetFieldData();
      glue::AddLengths(data, "RootMeanSquareDistance",
        { RootMeanSquareDistance(fit.Mesh, rebuilt.leftCols(3)) }, fit.Frame);
      AddSummary(data, fit.Coefficients, job.Arrays, fit.Frame);
      AddAlignment(data, fit.Alignment, fit.Frame);
      const vtkNew<vtkTable> table;
      AddTable(table, fit.Aligned, job.Arrays, fit.Frame);
      output->ShallowCopy(result);
      tableOutput->ShallowCopy(table);
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceHarmonics::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const meshTypes[] = { "Input", "Geodesic" };
  static const char* const alignments[] = { "None", "Map", "MapAndSurface" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "ReconstructionDegree: " << this->ReconstructionDegree << "\n";
  os << indent << "MeshType: " << meshTypes[this->MeshType] << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "Alignment: " << alignments[this->Alignment] << "\n";
  os << indent << "NumberOfPointArrays: " << this->PointArrays.size() << "\n";
}

#include "vtkSphericalAlignment.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Linear/EdgeWeights.h"
#include "Measure/SphericalAlignment.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSphericalAlignment);

namespace
{
// Corresponding pairs of positions on the sphere, with weights.
struct Pairs
{
  conformal::Points From, To;
  Eigen::VectorXd Weights;
};

// Return the map of a surface to the whole sphere. The map of a sheet is a hemisphere, and its
// border would not remain on the equator.
conformal::Points WholeMapOf(vtkPolyData* surface, const std::string& name)
{
  conformal::Points map = glue::ToSpherePositions(surface);
  constexpr double rounding = 1e-6; // of a border that is on the equator, in a map stored as floats
  if (map.col(2).minCoeff() >= -rounding)
  {
    throw std::invalid_argument("the map of the " + name +
      " covers only the hemisphere z >= 0, as that of a sheet (a surface with a border); only maps "
      "to the whole sphere can be aligned");
  }
  return map;
}

Pairs PairsOfLandmarks(const std::vector<std::pair<vtkIdType, vtkIdType>>& landmarks,
  const conformal::Points& map, const conformal::Points& reference)
{
  const auto size = static_cast<conformal::Index>(landmarks.size());
  Pairs pairs = { conformal::Points(size, 3), conformal::Points(size, 3),
    Eigen::VectorXd::Ones(size) };
  for (conformal::Index i = 0; i < size; ++i)
  {
    const auto [id, referenceId] = landmarks[i];
    if (id < 0 || id >= map.rows() || referenceId < 0 || referenceId >= reference.rows())
    {
      throw std::invalid_argument("landmark " + std::to_string(i) + " refers to the points " +
        std::to_string(id) + " and " + std::to_string(referenceId) + " of " +
        std::to_string(map.rows()) + " and " + std::to_string(reference.rows()));
    }
    pairs.From.row(i) = map.row(id);
    pairs.To.row(i) = reference.row(referenceId);
  }
  return pairs;
}

Pairs PairsOfSurfaces(vtkPolyData* surface, const conformal::Points& map, vtkPolyData* reference,
  const conformal::Run& run)
{
  const conformal::CoordinateFrame frame = glue::FrameOf({ surface, reference });
  // Relative costs of reference, surface and foot points.
  conformal::Steps steps(run, { 0.03, 0.03, 0.94 });
  steps.next();
  conformal::MappedMesh other;
  other.Positions = glue::ToPoints(reference->GetPoints(), frame);
  other.Triangles = glue::ToTriangles(reference);
  other.SpherePositions = WholeMapOf(reference, "reference");
  steps.next();
  const conformal::Points points = glue::ToPoints(surface->GetPoints(), frame);
  const conformal::Triangles triangles = glue::ToTriangles(surface);
  if (triangles.rows() == 0 || other.Triangles.rows() == 0)
  {
    throw std::invalid_argument(
      "without landmarks both surfaces must have triangles; add landmarks or triangles");
  }
  if (!points.allFinite() || !other.Positions.allFinite())
  {
    throw std::invalid_argument("some points are not finite");
  }
  return { map, conformal::carryMap(points, other, steps.next()),
    conformal::vertexAreas(points, triangles) };
}

void AddAlignment(vtkFieldData* data, const conformal::SphericalAlignmentResult& result)
{
  glue::AddNumber(data, "AlignmentError", result.Error);
  glue::AddTuple(data, "AlignmentCenter", result.Transform.Center.data(), 3);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = result.Transform.Rotation;
  glue::AddTuple(data, "AlignmentRotation", rows.data(), 9);
}
}

//------------------------------------------------------------------------------
vtkSphericalAlignment::vtkSphericalAlignment()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSphericalAlignment::SetReferenceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkSphericalAlignment::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(1, reference);
}

//------------------------------------------------------------------------------
void vtkSphericalAlignment::AddLandmark(vtkIdType pointId, vtkIdType referencePointId)
{
  this->Landmarks.emplace_back(pointId, referencePointId);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalAlignment::RemoveAllLandmarks()
{
  if (!this->Landmarks.empty())
  {
    this->Landmarks.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkSphericalAlignment::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto reference = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const auto landmarks = this->Landmarks;
  const auto kind = static_cast<conformal::AlignmentKind>(this->Transform);
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; there is nothing to align") ||
        glue::IsEmptyInput(this, reference, "the reference is empty; nothing was aligned"))
      {
        return;
      }
      glue::RequireCellIds(surface); // landmarks do not use cells, but the output has them
      const bool hasLandmarks = !landmarks.empty();
      // Relative costs of reading the map, pairs, transform, new map and output.
      conformal::Steps steps(glue::RunOf(this), { 0.01, 0.55, 0.4, 0.01, 0.03 });
      steps.next();
      conformal::Points map = WholeMapOf(surface, "surface");
      const conformal::Run pairing = steps.next();
      const Pairs pairs = hasLandmarks
        ? PairsOfLandmarks(landmarks, map, WholeMapOf(reference, "reference"))
        : PairsOfSurfaces(surface, map, reference, pairing);
      const conformal::SphericalAlignmentResult result =
        conformal::alignSpheres(pairs.From, pairs.To, pairs.Weights, kind, steps.next());
      steps.next();
      result.Transform.applyTo(map);

      steps.next();
      output->ShallowCopy(surface);
      glue::ReplaceSpherePositions(output, map);
      if (kind == conformal::AlignmentKind::Moebius)
      {
        glue::RemoveAreaDistortions(output);
      }
      AddAlignment(output->GetFieldData(), result);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalAlignment::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const transforms[] = { "Rotation", "Moebius" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Transform: " << transforms[this->Transform] << "\n";
  os << indent << "NumberOfLandmarks: " << this->Landmarks.size() << "\n";
}

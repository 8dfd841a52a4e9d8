#include "vtkConsistentRemesh.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/CarriedArrays.h"
#include "Glue/MappedSurfaces.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Measure/SurfaceMismatch.h"
#include "Register/ConsistentRemesh.h"
#include "Register/ShapeModes.h"
#include "Register/SphericalMorph.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkConsistentRemesh);

namespace
{
// Set a surface to the common mesh with the points of one shape.
void SetShape(vtkPolyData* surface, const conformal::ConsistentMeshes& meshes,
  const conformal::Points& shape, vtkCellArray* triangles, const conformal::CoordinateFrame& frame)
{
  glue::SetPoints(surface, shape, frame);
  surface->SetPolys(triangles);
  glue::AddVectors(surface->GetPointData(), glue::SpherePositionName(), meshes.Sphere.Positions);
}

double MeanSquareDistance(const conformal::Points& model, const conformal::Triangles& triangles,
  const conformal::MappedMesh& reference, const conformal::Run& run)
{
  conformal::SurfaceMismatchOptions options;
  options.NumberOfSamples = 1; // samples are not used for this distance
  return conformal::measureSurfaceMismatch(
    model, triangles, reference.Positions, reference.Triangles, options, {}, run)
    .MeanSquarePointToSurface;
}

void AddScores(vtkFieldData* data, const conformal::ShapeModes& modes, conformal::Index shape)
{
  if (modes.Modes.empty())
  {
    return;
  }
  const Eigen::VectorXd row = modes.Scores.row(shape);
  glue::AddTuple(data, "ShapeScores", row.data(), static_cast<int>(row.size()));
}

void AddModes(
  vtkPolyData* mean, const conformal::ShapeModes& modes, const conformal::CoordinateFrame& frame)
{
  for (std::size_t k = 0; k < modes.Modes.size(); ++k)
  {
    const std::string name = "ShapeMode" + std::to_string(k + 1);
    conformal::Points mode = modes.Modes[k];
    glue::LengthsFromFrame(mode.data(), mode.size(), frame, name.c_str());
    glue::AddVectors(mean->GetPointData(), name.c_str(), mode);
  }
  if (!modes.Modes.empty())
  {
    mean->GetPointData()->SetActiveVectors("ShapeMode1"); // which filters such as vtkWarpVector use
    glue::AddNumbers(mean->GetFieldData(), "ExplainedVariance", modes.Explained);
  }
}

// Return relative costs of the steps: surfaces, mesh, linear mean and modes, rigid mean, the arrays
// and the distance of each block, and the arrays of the mean.
std::vector<double> SharesOf(std::size_t numberOfSurfaces, int meanType)
{
  const double each = 1.0 / static_cast<double>(numberOfSurfaces);
  std::vector<double> shares = { 0.04, 0.35, 0.03,
    meanType == vtkConsistentRemesh::RIGID_MEAN ? 0.4 : 0.0 };
  for (std::size_t s = 0; s < numberOfSurfaces; ++s)
  {
    shares.insert(shares.end(), { 0.03 * each, 0.5 * each });
  }
  shares.push_back(0.05);
  return shares;
}

// Surfaces on the common mesh, and their mean.
struct Remeshed
{
  Remeshed(const glue::Surfaces& surfaces, bool alignsBlocks)
    : Surfaces(surfaces)
    , AlignsBlocks(alignsBlocks)
  {
  }

  const glue::Surfaces& Surfaces;
  const bool AlignsBlocks; // as at the start of the run
  conformal::CoordinateFrame Frame;
  std::vector<conformal::MappedMesh> Meshes;
  conformal::ConsistentMeshes Common;
  conformal::ShapeModes Modes;
  vtkNew<vtkPolyData> Cells;
};

void FindMeanAndModes(Remeshed& remeshed, const conformal::ShapeModesOptions& options, bool isRigid,
  conformal::Steps& steps)
{
  remeshed.Modes = conformal::findShapeModes(
    remeshed.Common.Sphere.Triangles, remeshed.Common.Positions, options, steps.next());
  const conformal::Run averaging = steps.next();
  if (isRigid)
  {
    remeshed.Modes.Mean =
      conformal::rigidMean(remeshed.Common.Sphere, remeshed.Modes.Aligned, averaging);
  }
}

vtkNew<vtkPolyData> BlockOf(
  vtkObject* self, const Remeshed& remeshed, std::size_t s, conformal::Steps& steps)
{
  const conformal::ConsistentMeshes& common = remeshed.Common;
  const conformal::Points& positions =
    remeshed.AlignsBlocks ? remeshed.Modes.Aligned[s] : common.Positions[s];
  vtkNew<vtkPolyData> block;
  SetShape(block, common, positions, remeshed.Cells->GetPolys(), remeshed.Frame);
  glue::CarryPointArrays(
    self, { remeshed.Surfaces.Held[s] }, common.Weights[s], block->GetPointData(), steps.next());
  glue::AddNumber(block->GetFieldData(), "MeanSquarePointToSurface",
    MeanSquareDistance(
      common.Positions[s], common.Sphere.Triangles, remeshed.Meshes[s], steps.next()));
  AddScores(block->GetFieldData(), remeshed.Modes, static_cast<conformal::Index>(s));
  return block;
}

vtkNew<vtkPolyData> MeanOf(vtkObject* self, const Remeshed& remeshed, const conformal::Run& run)
{
  const std::vector<vtkPolyData*> surfaces = remeshed.Surfaces.pointers();
  const std::vector<double> shares(surfaces.size(), 1.0 / static_cast<double>(surfaces.size()));
  vtkNew<vtkPolyData> mean;
  SetShape(mean, remeshed.Common, remeshed.Modes.Mean, remeshed.Cells->GetPolys(), remeshed.Frame);
  glue::CarryPointArrays(self, surfaces,
    glue::BlendedWeights(remeshed.Common.Weights, surfaces, shares), mean->GetPointData(), run);
  AddModes(mean, remeshed.Modes, remeshed.Frame);
  return mean;
}
}

//------------------------------------------------------------------------------
vtkConsistentRemesh::vtkConsistentRemesh()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkConsistentRemesh::GetMeanSurface()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkConsistentRemesh::FillInputPortInformation(int, vtkInformation* info)
{
  glue::AcceptSurfaces(info);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkConsistentRemesh::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkConsistentRemesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector, 0);
  vtkPolyData* meanOutput = vtkPolyData::GetData(outputVector, 1);
  conformal::ConsistentRemeshOptions remesh;
  remesh.MeshType = static_cast<conformal::RemeshMeshType>(this->MeshType);
  remesh.Frequency = this->Frequency;
  remesh.NumberOfPoints = this->NumberOfPoints;
  conformal::ShapeModesOptions options;
  options.Alignment = static_cast<conformal::ShapeAlignment>(this->Alignment);
  options.NumberOfModes = this->NumberOfModes;
  const bool alignsBlocks = this->AlignBlocks;
  const int meanType = this->MeanType;
  return glue::RunCore(this,
    [&]()
    {
      glue::Surfaces surfaces;
      glue::AddSurfaces(inputVector[0], surfaces);
      if (glue::HasEmpty(this, surfaces))
      {
        return;
      }
      conformal::Steps steps(glue::RunOf(this), SharesOf(surfaces.Held.size(), meanType));
      Remeshed remeshed(surfaces, alignsBlocks);
      remeshed.Meshes = glue::ToMappedMeshes(surfaces, remeshed.Frame, steps.next());
      remeshed.Common = conformal::remeshConsistently(remeshed.Meshes, remesh, steps.next());
      FindMeanAndModes(remeshed, options, meanType == RIGID_MEAN, steps);
      glue::SetTriangles(remeshed.Cells, remeshed.Common.Sphere.Triangles);
      const vtkNew<vtkMultiBlockDataSet> blocks;
      for (std::size_t s = 0; s < surfaces.Held.size(); ++s)
      {
        glue::SetNamedBlock(blocks, surfaces, s, BlockOf(this, remeshed, s, steps));
      }
      const auto mean = MeanOf(this, remeshed, steps.next());
      output->ShallowCopy(blocks);
      meanOutput->ShallowCopy(mean);
    });
}

//------------------------------------------------------------------------------
void vtkConsistentRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const meshTypes[] = { "Geodesic", "Adaptive" };
  static const char* const alignments[] = { "None", "Rigid", "Similarity" };
  static const char* const meanTypes[] = { "Linear", "Rigid" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshType: " << meshTypes[this->MeshType] << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Alignment: " << alignments[this->Alignment] << "\n";
  os << indent << "AlignBlocks: " << this->AlignBlocks << "\n";
  os << indent << "MeanType: " << meanTypes[this->MeanType] << "\n";
  os << indent << "NumberOfModes: " << this->NumberOfModes << "\n";
}

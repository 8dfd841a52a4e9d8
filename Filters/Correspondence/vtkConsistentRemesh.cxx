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

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkConsistentRemesh);

namespace
{
// The mesh that all have, with other points.
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
  options.NumberOfSamples = 1; // of the other direction
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
  vtkNew<vtkDoubleArray> scores;
  scores->SetName("ShapeScores");
  scores->SetNumberOfComponents(static_cast<int>(modes.Scores.cols()));
  const Eigen::VectorXd row = modes.Scores.row(shape);
  scores->InsertNextTuple(row.data());
  data->AddArray(scores);
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
    glue::AddNumbers(mean->GetFieldData(), "ExplainedVariance", modes.Explained);
  }
}
}

//------------------------------------------------------------------------------
vtkConsistentRemesh::vtkConsistentRemesh()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkConsistentRemesh::GetMeanShape()
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
  remesh.Lattice = static_cast<conformal::RemeshLattice>(this->Lattice);
  remesh.Frequency = this->Frequency;
  remesh.NumberOfPoints = this->NumberOfPoints;
  conformal::ShapeModesOptions options;
  options.Alignment = static_cast<conformal::ShapeAlignment>(this->Alignment);
  options.NumberOfModes = this->NumberOfModes;
  return glue::RunCore(this,
    [&]()
    {
      using namespace glue;
      Surfaces surfaces;
      AddSurfaces(inputVector[0], surfaces);
      const std::vector<vtkPolyData*> held = surfaces.pointers();
      const auto isEmpty = [](vtkPolyData* surface) { return surface->GetNumberOfPoints() == 0; };
      if (held.empty() || std::any_of(held.begin(), held.end(), isEmpty))
      {
        WarnOfEmptyInput(this, "a surface is empty; the output is empty");
        return;
      }
      const double size = surfaces.numberOfPoints();
      const auto count = static_cast<double>(held.size());
      const auto points = remesh.Lattice == conformal::RemeshLattice::Adaptive
        ? static_cast<double>(remesh.NumberOfPoints)
        : 10.0 * remesh.Frequency * remesh.Frequency;
      const double components = NumberOfCarriedComponents(held.front());
      // The surfaces, their mesh, mean and modes, each block, and the mean's arrays.
      std::vector<double> work = { 150.0 * size,
        conformal::workOfConsistentRemesh(size, count, remesh),
        conformal::workOfShapeModes(points, count) };
      for (vtkPolyData* surface : held)
      {
        const auto own = static_cast<double>(surface->GetNumberOfPoints());
        work.push_back(components * (20.0 * own + 100.0 * points));
        work.push_back(2000.0 * own + 3500.0 * points);
      }
      work.push_back(components * (20.0 * size + 100.0 * points) + 100.0 * count * points);
      conformal::Steps steps(RunOf(this), work);
      conformal::CoordinateFrame frame;
      const std::vector<conformal::MappedMesh> meshes =
        ToMappedMeshes(surfaces, frame, steps.next());
      const conformal::ConsistentMeshes common =
        conformal::remeshConsistently(meshes, remesh, steps.next());
      const conformal::ShapeModes modes =
        conformal::findShapeModes(common.Sphere.Triangles, common.Positions, options, steps.next());

      const vtkNew<vtkPolyData> mesh;
      SetTriangles(mesh, common.Sphere.Triangles);
      const vtkNew<vtkMultiBlockDataSet> blocks;
      std::vector<const conformal::ResampleWeights*> parts;
      std::vector<conformal::Index> sizes;
      for (std::size_t s = 0; s < held.size(); ++s)
      {
        const auto number = static_cast<unsigned int>(s);
        const vtkNew<vtkPolyData> block;
        SetShape(block, common, common.Positions[s], mesh->GetPolys(), frame);
        CarryPointArrays(this, { held[s] }, common.Weights[s], block->GetPointData(), steps.next());
        AddNumber(block->GetFieldData(), "MeanSquarePointToSurface",
          MeanSquareDistance(
            common.Positions[s], common.Sphere.Triangles, meshes[s], steps.next()));
        AddScores(block->GetFieldData(), modes, static_cast<conformal::Index>(s));
        blocks->SetBlock(number, block);
        if (!surfaces.Names[s].empty())
        {
          blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), surfaces.Names[s].c_str());
        }
        parts.push_back(&common.Weights[s]);
        sizes.push_back(held[s]->GetNumberOfPoints());
      }
      const conformal::Run averaging = steps.next();
      const vtkNew<vtkPolyData> mean;
      SetShape(mean, common, modes.Mean, mesh->GetPolys(), frame);
      CarryPointArrays(this, held,
        conformal::blended(parts, sizes, std::vector<double>(held.size(), 1.0 / count)),
        mean->GetPointData(), averaging);
      AddModes(mean, modes, frame);
      output->ShallowCopy(blocks);
      meanOutput->ShallowCopy(mean);
    });
}

//------------------------------------------------------------------------------
void vtkConsistentRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const lattices[] = { "Geodesic", "Adaptive" };
  static const char* const alignments[] = { "None", "Rigid", "Similarity" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lattice: " << lattices[this->Lattice] << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Alignment: " << alignments[this->Alignment] << "\n";
  os << indent << "NumberOfModes: " << this->NumberOfModes << "\n";
}

#include "vtkConformalDistortion.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Measure/Distortion.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <vector>

vtkStandardNewMacro(vtkConformalDistortion);

namespace
{
// Compute, for each cell, the mean over its triangles. Cells without triangles get the value that
// means no distortion.
std::vector<double> OfCells(vtkIdType numberOfCells, const std::vector<vtkIdType>& cellIds,
  const std::vector<double>& ofTriangles, double none)
{
  std::vector<double> sums(numberOfCells, 0.0);
  std::vector<int> counts(numberOfCells, 0);
  for (std::size_t r = 0; r < cellIds.size(); ++r)
  {
    sums[cellIds[r]] += ofTriangles[r];
    ++counts[cellIds[r]];
  }
  for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
  {
    sums[cell] = counts[cell] > 0 ? sums[cell] / counts[cell] : none;
  }
  return sums;
}

void AddFigures(vtkFieldData* data, const conformal::Distortion& distortion)
{
  using glue::AddNumber;
  AddNumber(data, "MeanAngleDistortion", distortion.MeanAngleDistortion);
  AddNumber(data, "MeanQuasiConformalError", distortion.MeanQuasiConformalError);
  AddNumber(data, "MaximumQuasiConformalError", distortion.MaximumQuasiConformalError);
  AddNumber(data, "AreaDistortionDeviation", distortion.AreaDistortionDeviation);
  AddNumber(data, "SphereDegree", distortion.SphereDegree);
  AddNumber(
    data, "NumberOfFlippedTriangles", static_cast<long long>(distortion.NumberOfFlippedTriangles));
  AddNumber(data, "NumberOfZeroAreaTriangles",
    static_cast<long long>(distortion.NumberOfZeroAreaTriangles));
}
}

//------------------------------------------------------------------------------
int vtkConformalDistortion::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto input = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, input, "the surface is empty; there are no measures"))
      {
        return;
      }
      // Relative costs of the steps, all proportional to the number of triangles.
      conformal::Steps steps(glue::RunOf(this), { 0.1, 0.03, 0.81, 0.02, 0.02, 0.02 });
      steps.next();
      std::vector<vtkIdType> cellIds;
      conformal::Points copy;
      const conformal::Triangles triangles = glue::ToTriangles(input, cellIds);
      steps.next();
      const conformal::Points map = glue::ToSpherePositions(input);
      const conformal::Distortion distortion = conformal::measureDistortion(
        glue::ViewPoints(input->GetPoints(), glue::FrameOf({ input }), copy), triangles, map,
        steps.next());

      const vtkNew<vtkPolyData> result;
      result->ShallowCopy(input);
      const auto addCellArray = [&](
                                  const char* name, const std::vector<double>& values, double none)
      {
        steps.next();
        glue::AddNumbers(
          result->GetCellData(), name, OfCells(input->GetNumberOfCells(), cellIds, values, none));
      };
      addCellArray("AngleDistortion", distortion.AngleDistortion, 0.0);
      addCellArray("AreaDistortion", distortion.AreaDistortion, 0.0);
      addCellArray("QuasiConformalError", distortion.QuasiConformalError, 1.0);

      AddFigures(result->GetFieldData(), distortion);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkConformalDistortion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

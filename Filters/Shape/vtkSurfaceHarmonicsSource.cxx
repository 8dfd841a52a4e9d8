#include "vtkSurfaceHarmonicsSource.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/HarmonicTables.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Harmonics/HarmonicSurface.h"
#include "Harmonics/SphericalHarmonics.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <vector>

vtkStandardNewMacro(vtkSurfaceHarmonicsSource);

//------------------------------------------------------------------------------
int vtkSurfaceHarmonicsSource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceHarmonicsSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto table = glue::Held(vtkTable::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const int frequency = this->Frequency, kept = this->ReconstructionDegree;
  return glue::RunCore(this,
    [&]()
    {
      using namespace glue;
      if (table->GetNumberOfColumns() == 0)
      {
        WarnOfEmptyInput(this, "the table of coefficients is empty; there is no surface");
        return;
      }
      glue::Harmonics harmonics = glue::FromTable(table);
      conformal::Columns coefficients = conformal::upToDegree(harmonics.Coefficients, kept);
      const conformal::Points coordinates = coefficients.leftCols(3);
      const conformal::CoordinateFrame frame = conformal::frameOf({ coordinates });
      coefficients.leftCols(3) = coordinates / frame.Unit;
      // Relative costs of surface and output.
      conformal::Steps steps(RunOf(this), { 0.9, 0.1 });
      const conformal::HarmonicSurface made =
        conformal::makeHarmonicSurface(coefficients, frequency, steps.next());
      steps.next();
      const vtkNew<vtkPolyData> result;
      SetSurface(result, made.Positions, made.Triangles, frame);
      AddVectors(result->GetPointData(), SpherePositionName(), made.SpherePositions);
      for (std::size_t c = 0; c < harmonics.Names.size(); ++c)
      {
        const Eigen::VectorXd values = made.Values.col(static_cast<conformal::Index>(c));
        AddNumbers(result->GetPointData(), harmonics.Names[c].c_str(),
          std::vector<double>(values.begin(), values.end()));
      }
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceHarmonicsSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "ReconstructionDegree: " << this->ReconstructionDegree << "\n";
}

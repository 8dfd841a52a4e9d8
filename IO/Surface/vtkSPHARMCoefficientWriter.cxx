#include "vtkSPHARMCoefficientWriter.h"

#include "SPHARM/SPHARMCoefficients.h"
#include "Glue/HarmonicTables.h"
#include "vtkSurfaceConversions.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <string>

vtkStandardNewMacro(vtkSPHARMCoefficientWriter);

//------------------------------------------------------------------------------
int vtkSPHARMCoefficientWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSPHARMCoefficientWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  const std::string path = this->FileName; // observers of the progress may set another
  const conformal::Points coordinates =
    glue::FromTable(vtkTable::SafeDownCast(this->GetInput(0)))
      .Coefficients.leftCols(3);
  conformal::NamedArray array =
    conformal::makeArray("Coefficients", conformal::ScalarType::Float64, 3);
  for (conformal::Index i = 0; i < coordinates.rows(); ++i)
  {
    conformal::append(array, coordinates.row(i).data());
  }
  const std::string text = conformal::makeSPHARMCoefficients(array, progress);
  vtkSurfaceConversions::WriteTogether({ { path, text } });
}

//------------------------------------------------------------------------------
void vtkSPHARMCoefficientWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

#include "vtkSPHARMCoefficientWriter.h"

#include "Glue/HarmonicTables.h"
#include "SPHARM/SPHARMCoefficients.h"

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
void vtkSPHARMCoefficientWriter::WriteFiles(const conformal::Run& run)
{
  const std::string path = this->FileName; // a copy: observers may change it
  const conformal::Points coordinates =
    glue::FromTable(vtkTable::SafeDownCast(this->GetInput(0))).Coefficients.leftCols(3);
  conformal::NamedArray array =
    conformal::makeArray("Coefficients", conformal::ScalarType::Float64, 3);
  for (conformal::Index i = 0; i < coordinates.rows(); ++i)
  {
    conformal::append(array, coordinates.row(i).data());
  }
  const std::string text = conformal::makeSPHARMCoefficients(array, run);
  this->WriteTogether({ { path, text } });
}

//------------------------------------------------------------------------------
void vtkSPHARMCoefficientWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

/**
 * @class   vtkSPHARMCoefficientWriter
 * @brief   write spherical-harmonic coefficients for SPHARM-PDM (.coef)
 *
 * Write spherical-harmonic coefficients, the second output of vtkSurfaceHarmonics, to a file of
 * SPHARM-PDM, a program for shape analysis.
 *
 * Input port 0: vtkTable as from vtkSurfaceHarmonics: columns "Degree", "Order", "X", "Y" and "Z".
 * Other columns are left out. SPHARM-PDM scales harmonics differently. The writer converts the
 * coefficients, so that programs of SPHARM-PDM compute the same surface. Numbers have 15 digits.
 * vtkSPHARMCoefficientReader reads the file.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSPHARMCoefficientReader vtkSurfaceHarmonics vtkSurfaceFileWriter
 */

#ifndef vtkSPHARMCoefficientWriter_h
#define vtkSPHARMCoefficientWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkSPHARMCoefficientWriter : public vtkSurfaceFileWriter
{
public:
  static vtkSPHARMCoefficientWriter* New();
  vtkTypeMacro(vtkSPHARMCoefficientWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSPHARMCoefficientWriter() = default;
  ~vtkSPHARMCoefficientWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFiles(const conformal::Run& run) override;

private:
  vtkSPHARMCoefficientWriter(const vtkSPHARMCoefficientWriter&) = delete;
  void operator=(const vtkSPHARMCoefficientWriter&) = delete;
};

#endif

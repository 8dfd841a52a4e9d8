/**
 * @class   vtkSPHARMCoefficientReader
 * @brief   read spherical-harmonic coefficients of SPHARM-PDM (.coef)
 *
 * Give a table, of which vtkSurfaceHarmonicsSource makes the surface.
 *
 * Output port 0: vtkTable as vtkSurfaceHarmonics makes it, a row for each harmonic: columns
 * "Degree", "Order" (int) and "X", "Y", "Z" (double). Numbers are those of real orthonormal
 * harmonics without the Condon-Shortley phase, so that vtkSurfaceHarmonicsSource makes the
 * surface of the file: those of orders above 0 are (-1)^m / sqrt(2) times the file's.
 *
 * SPHARM-PDM's own surfaces (..._SPHARM.vtk) are evaluated at the points opposite to those of its
 * sphere mesh: their points are those of vtkSurfaceHarmonicsSource at minus that direction.
 *
 * A file that breaks the rules or ends early gives an error with its line, an empty output, and an
 * error code of vtkErrorCode. A reader that is asked to abort gives an empty output without an
 * error.
 *
 * @sa
 * vtkSPHARMCoefficientWriter vtkSurfaceHarmonicsSource vtkSurfaceHarmonics
 */

#ifndef vtkSPHARMCoefficientReader_h
#define vtkSPHARMCoefficientReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class VTKIOSURFACE_EXPORT vtkSPHARMCoefficientReader : public vtkTableAlgorithm
{
public:
  static vtkSPHARMCoefficientReader* New();
  vtkTypeMacro(vtkSPHARMCoefficientReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to read. Default is none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether a file is of this format, judged by its first bytes and not by its name.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  /**
   * The usual extension of such files, with a dot.
   */
  const char* GetFileExtensions() { return ".coef"; }

  /**
   * What a list of file types calls them.
   */
  const char* GetDescriptiveName() { return "SPHARM-PDM coefficients"; }

protected:
  vtkSPHARMCoefficientReader();
  ~vtkSPHARMCoefficientReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSPHARMCoefficientReader(const vtkSPHARMCoefficientReader&) = delete;
  void operator=(const vtkSPHARMCoefficientReader&) = delete;

  char* FileName = nullptr;
};

#endif

/**
 * @class   vtkSPHARMCoefficientReader
 * @brief   read spherical-harmonic coefficients of SPHARM-PDM (.coef)
 *
 * Read a table of coefficients, from which vtkSurfaceHarmonicsSource makes the surface.
 *
 * Output port 0: vtkTable as from vtkSurfaceHarmonics, with a row for each harmonic: columns
 * "Degree", "Order" (int) and "X", "Y", "Z" (double). Coefficients are those of real orthonormal
 * harmonics without the Condon-Shortley phase, as vtkSurfaceHarmonicsSource needs them. Those of
 * orders above 0 are (-1)^m / sqrt(2) times the file's.
 *
 * SPHARM-PDM evaluates its own surfaces (..._SPHARM.vtk) at the points opposite to those of its
 * sphere mesh. Their points are those of vtkSurfaceHarmonicsSource in the negative direction.
 *
 * A malformed or truncated file causes an error with the number of its line, an empty output, and
 * an error code of vtkErrorCode. An aborted reader gives an empty output without an error.
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
   * Return whether the first bytes of a file are of this format. The name does not matter.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  /**
   * Return the usual extension of such files, with a dot.
   */
  const char* GetFileExtensions() { return ".coef"; }

  /**
   * Return the name of the format for lists of file types.
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

/**
 * @class   vtkSPHARMCoefficientReader
 * @brief   read spherical-harmonic coefficients of SPHARM-PDM (.coef)
 *
 * Read the spherical-harmonic coefficients of a surface from a file of SPHARM-PDM, a program for
 * shape analysis. vtkSurfaceHarmonicsSource makes the surface from the resulting table.
 *
 * Output port 0: vtkTable as from vtkSurfaceHarmonics, with one row for each harmonic: columns
 * "Degree", "Order" (int) and "X", "Y", "Z" (double). The coefficients belong to real orthonormal
 * harmonics without the Condon-Shortley phase, as required by vtkSurfaceHarmonicsSource. Let m be
 * the absolute value of the order. If m is above 0, the coefficient of the file is multiplied by
 * (-1)^m / sqrt(2). If m is 0, the coefficient of the file is not changed.
 *
 * SPHARM-PDM also writes the surface that the coefficients define, to a file ..._SPHARM.vtk. Each
 * point d of the sphere corresponds to one surface point. In the file, this surface point is the
 * sum of coefficients times harmonics at -d instead of d. The surface of vtkSurfaceHarmonicsSource
 * thus has this point at the direction -d.
 *
 * If a file is malformed or truncated, the error message states the number of the line. The output
 * is then empty, and an error code of vtkErrorCode is set. If the reader is aborted, the output is
 * empty, and there is no error.
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
   * Return whether the first bytes of a file are those of a coefficient file. The name of the file
   * is not tested.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  /**
   * Return the usual extension of coefficient files, with a dot.
   */
  const char* GetFileExtensions() { return ".coef"; }

  /**
   * Return the name of the format, as shown in lists of file types.
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

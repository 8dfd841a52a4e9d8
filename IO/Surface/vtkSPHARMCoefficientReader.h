/**
 * @class   vtkSPHARMCoefficientReader
 * @brief   read spherical-harmonic coefficients of SPHARM-PDM (.coef)
 *
 * Read the spherical-harmonic coefficients of a surface from a file of the program SPHARM-PDM.
 * vtkSurfaceHarmonicsSource makes the surface from the resulting table.
 *
 * Output port 0: vtkTable as from vtkSurfaceHarmonics, with one row for each harmonic: columns
 * "Degree", "Order" (int) and "X", "Y", "Z" (double). The coefficients belong to real orthonormal
 * harmonics without the Condon-Shortley phase, as required by vtkSurfaceHarmonicsSource. Let m be
 * the absolute value of the order. If m is above 0, the coefficient in the table is that of the
 * file, multiplied by (-1)^m / sqrt(2). If m is 0, the coefficient in the table is that of the
 * file.
 *
 * SPHARM-PDM also writes the surface of the coefficients, to a file ..._SPHARM.vtk. In this file,
 * the surface point that corresponds to a point d of the sphere mesh is the sum of the harmonics at
 * -d. To get this surface point from vtkSurfaceHarmonicsSource, also evaluate the harmonics at -d.
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

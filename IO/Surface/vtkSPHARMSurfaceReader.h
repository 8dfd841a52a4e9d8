/**
 * @class   vtkSPHARMSurfaceReader
 * @brief   read surfaces of SPHARM-PDM (_surf) with their sphere (_para)
 *
 * Read a surface, such as shape_surf.vtk, and its sphere, shape_para.vtk, as the point array
 * "SpherePosition".
 *
 * Output port 0: vtkPolyData, the points (float or double) and polygons of a legacy VTK file, such
 * as shape_surf.vtk, text or binary. Its arrays are ignored.
 * - point array "SpherePosition" (double, 3 components), of unit length: the points of the sphere,
 *   shape_para.vtk, which must have the same polygons.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader vtkSPHARMSurfaceWriter vtkSPHARMCoefficientReader
 */

#ifndef vtkSPHARMSurfaceReader_h
#define vtkSPHARMSurfaceReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkSPHARMSurfaceReader : public vtkSurfaceFileReader
{
public:
  static vtkSPHARMSurfaceReader* New();
  vtkTypeMacro(vtkSPHARMSurfaceReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file whose points are the positions of the surface's points on the sphere. Default
   * is none: for shape_surf.vtk or shape.vtk, the file shape_para.vtk is read if it exists.
   */
  vtkSetFilePathMacro(SphereFileName);
  vtkGetFilePathMacro(SphereFileName);
  ///@}

  /**
   * Return whether the first bytes of a file are of this format and its sphere is beside it. Other
   * legacy VTK files are left to VTK's own reader, which reads their arrays.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".vtk"; }
  const char* GetDescriptiveName() override { return "SPHARM-PDM surfaces"; }

protected:
  vtkSPHARMSurfaceReader() = default;
  ~vtkSPHARMSurfaceReader() override;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;
  std::vector<std::string> FilesReadToo() override;

private:
  vtkSPHARMSurfaceReader(const vtkSPHARMSurfaceReader&) = delete;
  void operator=(const vtkSPHARMSurfaceReader&) = delete;

  char* SphereFileName = nullptr;
};

#endif

/**
 * @class   vtkSPHARMSurfaceReader
 * @brief   read surfaces of SPHARM-PDM (_surf) with their sphere (_para)
 *
 * Read a surface of SPHARM-PDM, a program for shape analysis. The surface is a file such as
 * shape_surf.vtk, and its sphere is the file shape_para.vtk. The sphere is the same mesh, with each
 * point at its position on the unit sphere. The points of the sphere become the point array
 * "SpherePosition".
 *
 * Output port 0: vtkPolyData, the points (float or double) and polygons of a legacy VTK file, such
 * as shape_surf.vtk, text or binary. Arrays of the file are ignored.
 * - point array "SpherePosition" (double, 3 components): the points of the sphere, shape_para.vtk,
 *   as unit vectors. The sphere must have the same polygons as the surface.
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
   * is none: the name is made from FileName. For example, shape_para.vtk is used for a FileName of
   * shape_surf.vtk or shape.vtk, if shape_para.vtk exists.
   */
  vtkSetFilePathMacro(SphereFileName);
  vtkGetFilePathMacro(SphereFileName);
  ///@}

  /**
   * Return whether a file begins as a legacy VTK file, and has a sphere file in the same folder.
   * Read other legacy VTK files with the readers of VTK, which also read arrays.
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

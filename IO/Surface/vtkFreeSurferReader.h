/**
 * @class   vtkFreeSurferReader
 * @brief   read FreeSurfer's surfaces with their sphere and their curvature
 *
 * Read a surface file of FreeSurfer, a program for brain surfaces, such as lh.white. Optionally,
 * also read a sphere file and a file of values at the points. The points of a sphere, such as
 * lh.sphere, become the point array "SpherePosition", the surface's map to the sphere. A file with
 * one number for each point, such as lh.curv, becomes the point array Curvature.
 *
 * Output port 0: vtkPolyData, the points (float) and the triangles or quads of a surface, such as
 * lh.white.
 * - point array "SpherePosition" (double, 3 components): the points of the file SphereFileName,
 *   such as lh.sphere, as unit vectors. The sphere must have the same faces as the surface.
 * - point array "Curvature" (float, 1 component): the values of the file CurvatureFileName, such as
 *   lh.curv or lh.thickness. Files of values are read in their new layout (floats) and old layout
 *   (16-bit integers).
 *
 * Some files contain the geometry of the scanned volume after the faces. The reader ignores this
 * geometry, and does not transform the coordinates of the file. vtkSurfaceFileReader describes what
 * all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader
 */

#ifndef vtkFreeSurferReader_h
#define vtkFreeSurferReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkFreeSurferReader : public vtkSurfaceFileReader
{
public:
  static vtkFreeSurferReader* New();
  vtkTypeMacro(vtkFreeSurferReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of a surface file, such as lh.sphere, whose points are the positions of the surface's
   * points on the sphere. Default is none.
   */
  vtkSetFilePathMacro(SphereFileName);
  vtkGetFilePathMacro(SphereFileName);
  ///@}

  ///@{
  /**
   * Name of a file with one number for each point, such as lh.curv or lh.thickness. Default is
   * none.
   */
  vtkSetFilePathMacro(CurvatureFileName);
  vtkGetFilePathMacro(CurvatureFileName);
  ///@}

  /**
   * Return whether the first bytes of a file are those of a FreeSurfer surface. The name of the
   * file is not tested.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override
  {
    return ".white .pial .inflated .smoothwm .orig .sphere";
  }
  const char* GetDescriptiveName() override { return "FreeSurfer surfaces"; }

protected:
  vtkFreeSurferReader() = default;
  ~vtkFreeSurferReader() override;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;
  std::vector<std::string> FilesReadToo() override;

private:
  vtkFreeSurferReader(const vtkFreeSurferReader&) = delete;
  void operator=(const vtkFreeSurferReader&) = delete;

  char* SphereFileName = nullptr;
  char* CurvatureFileName = nullptr;
};

#endif

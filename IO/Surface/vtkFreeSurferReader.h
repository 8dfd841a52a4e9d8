/**
 * @class   vtkFreeSurferReader
 * @brief   read FreeSurfer's surfaces with their sphere and their curvature
 *
 * Read a surface such as lh.white. Optionally, read its sphere (as "SpherePosition") and a file
 * with one number for each point (as Curvature).
 *
 * Output port 0: vtkPolyData, the points (float) and the triangles or quads of a surface, such as
 * lh.white.
 * - point array "SpherePosition" (double, 3 components), of unit length: the points of the file
 *   SphereFileName, such as lh.sphere, which must have the same faces.
 * - point array "Curvature" (float, 1 component): the values of the file CurvatureFileName, such as
 *   lh.curv or lh.thickness, of the new or the old layout.
 *
 * The volume geometry that follows the faces is ignored: points have the coordinates of the file.
 * vtkSurfaceFileReader describes what all readers of this module have in common.
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
   * Name of the file whose points are the positions of the surface's points on the sphere, such as
   * lh.sphere. Default is none.
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
   * Return whether the first bytes of a file are of this format. The name does not matter.
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

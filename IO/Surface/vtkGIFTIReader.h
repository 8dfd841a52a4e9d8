/**
 * @class   vtkGIFTIReader
 * @brief   read GIFTI surfaces with their sphere and numbers at their points
 *
 * Read a surface (.surf.gii) and, if named, its sphere (as "SpherePosition") and a file with
 * arrays of numbers at the points.
 *
 * Output port 0: vtkPolyData, the points (float or double, as in the file) and triangles of a
 * surface (.surf.gii): ASCII, Base64Binary or GZipBase64Binary, of both orders of bytes and of
 * indices.
 * - point array "SpherePosition" (double, 3 components), of unit length: the points of the file
 *   SphereFileName, which has the same triangles.
 * - point arrays of the type of all other arrays of the file and of the file ShapeFileName
 *   (.shape.gii, .func.gii, .label.gii), named by their metadata "Name", else by their intent, such
 *   as "Shape".
 *
 * Matrices of other coordinate systems and label tables are not read. An entity of the file's own
 * or an array in another file is an error. vtkSurfaceFileReader describes what all
 * readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader
 */

#ifndef vtkGIFTIReader_h
#define vtkGIFTIReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkGIFTIReader : public vtkSurfaceFileReader
{
public:
  static vtkGIFTIReader* New();
  vtkTypeMacro(vtkGIFTIReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File whose points are the positions of the surface's points on the sphere. Default is none.
   */
  vtkSetFilePathMacro(SphereFileName);
  vtkGetFilePathMacro(SphereFileName);
  ///@}

  ///@{
  /**
   * File with arrays of numbers at the surface's points, such as .shape.gii, .func.gii or
   * .label.gii. Default is none.
   */
  vtkSetFilePathMacro(ShapeFileName);
  vtkGetFilePathMacro(ShapeFileName);
  ///@}

  /**
   * Whether a file is of this format, judged by its first bytes and not by its name.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".gii"; }
  const char* GetDescriptiveName() override { return "GIFTI surfaces"; }

protected:
  vtkGIFTIReader() = default;
  ~vtkGIFTIReader() override;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;
  std::vector<std::string> FilesReadToo() override;

private:
  vtkGIFTIReader(const vtkGIFTIReader&) = delete;
  void operator=(const vtkGIFTIReader&) = delete;

  char* SphereFileName = nullptr;
  char* ShapeFileName = nullptr;
};

#endif

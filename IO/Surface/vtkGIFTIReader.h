/**
 * @class   vtkGIFTIReader
 * @brief   read GIFTI surfaces with their sphere and numbers at their points
 *
 * Read a surface (.surf.gii). Optionally, read its sphere (as "SpherePosition") and a file with
 * arrays of numbers at the points.
 *
 * Output port 0: vtkPolyData, the points (float or double, as in the file) and triangles of a
 * surface (.surf.gii). Encodings are ASCII, Base64Binary and GZipBase64Binary, with both byte
 * orders and both orders of indices.
 * - point array "SpherePosition" (double, 3 components), of unit length: the points of the file
 *   SphereFileName, which must have the same triangles.
 * - point arrays, in their own types, from all other arrays of the file and from the file
 *   ShapeFileName (.shape.gii, .func.gii, .label.gii). Their name is the metadata "Name", or else
 *   their intent, such as "Shape".
 *
 * Matrices of other coordinate systems and label tables are ignored. XML entities declared by the
 * file, and arrays in external files, are errors. vtkSurfaceFileReader describes what all readers
 * of this module have in common.
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
   * Name of the file whose points are the positions of the surface's points on the sphere. Default
   * is none.
   */
  vtkSetFilePathMacro(SphereFileName);
  vtkGetFilePathMacro(SphereFileName);
  ///@}

  ///@{
  /**
   * Name of a file with arrays of numbers at the surface's points, such as .shape.gii, .func.gii or
   * .label.gii. Default is none.
   */
  vtkSetFilePathMacro(ShapeFileName);
  vtkGetFilePathMacro(ShapeFileName);
  ///@}

  /**
   * Return whether the first bytes of a file are of this format. The name does not matter.
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

/**
 * @class   vtkGIFTIReader
 * @brief   read GIFTI surfaces with their map to the sphere and their point arrays
 *
 * Read a surface in the neuroimaging format GIFTI (.surf.gii). Optionally, also read a sphere file
 * and a file of values at the points. The points of a sphere become the point array
 * "SpherePosition", the surface's map to the sphere. A file with numbers for each point becomes
 * point arrays.
 *
 * Output port 0: vtkPolyData, the points (float or double, as in the file) and triangles of a
 * surface (.surf.gii). Files with the encodings ASCII, Base64Binary and GZipBase64Binary are read,
 * with both byte orders, and both row-major and column-major arrays.
 * - point array "SpherePosition" (double, 3 components): the points of the file SphereFileName, as
 *   unit vectors. The sphere must have the same triangles as the surface.
 * - point arrays, with the types of the file: all other arrays of the surface file, and the arrays
 *   of the file ShapeFileName (.shape.gii, .func.gii, .label.gii). The name of an array is its
 *   metadata "Name". Without this metadata, the name is the intent (meaning) of the array, such as
 *   "Shape".
 *
 * Matrices of coordinate systems and label tables are ignored. A file that declares XML entities,
 * or refers to arrays in external files, causes an error. vtkSurfaceFileReader describes what all
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
   * Name of a surface file whose points are the positions of the surface's points on the sphere.
   * Default is none.
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
   * Return whether the first bytes of a file are those of a GIFTI surface. The name of the file is
   * not tested.
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

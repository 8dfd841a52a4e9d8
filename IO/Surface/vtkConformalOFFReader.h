/**
 * @class   vtkConformalOFFReader
 * @brief   read meshes and clouds in the OFF format of Geomview, with all its prefixes
 *
 * Read Geomview's OFF files, text or binary, with normals, colors and texture coordinates.
 *
 * Output port 0: vtkPolyData, the points and polygons of a file whose keyword is
 * [ST][C][N][4][n]OFF, of three dimensions, as text (points are double) or BINARY (float). The
 * keyword may be missing, but CanReadFile() does not know such a file. The fourth coordinate of
 * 4OFF divides the others.
 * - point array "Normals" (type of the points, 3 components), active: N.
 * - point array "TCoords" (type of the points, 2 components), active: ST.
 * - point array "RGB" or "RGBA" (unsigned char), active scalars: C, and what stands behind the
 *   coordinates of a plain OFF. If no number is more than 1 they are fractions, else bytes.
 * - cell array "RGB" or "RGBA" (unsigned char), active scalars: colors behind the ids of faces;
 *   white where a face has none.
 * - cell array "ColorIndex" (int, 1 component): a single number there; -1 where there is none.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader
 */

#ifndef vtkConformalOFFReader_h
#define vtkConformalOFFReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkConformalOFFReader : public vtkSurfaceFileReader
{
public:
  static vtkConformalOFFReader* New();
  vtkTypeMacro(vtkConformalOFFReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether a file is of this format, judged by its first bytes and not by its name.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".off"; }
  const char* GetDescriptiveName() override { return "OFF meshes"; }

protected:
  vtkConformalOFFReader() = default;
  ~vtkConformalOFFReader() override = default;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkConformalOFFReader(const vtkConformalOFFReader&) = delete;
  void operator=(const vtkConformalOFFReader&) = delete;
};

#endif

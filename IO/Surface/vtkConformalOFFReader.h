/**
 * @class   vtkConformalOFFReader
 * @brief   read meshes and clouds in the OFF format of Geomview, with all its prefixes
 *
 * Read Geomview's OFF files, text or binary, with normals, colors and texture coordinates.
 *
 * Output port 0: vtkPolyData, the points and polygons of a three-dimensional file with the keyword
 * [ST][C][N][4][n]OFF. Points of text files are double, those of BINARY files float. The keyword
 * may be missing; CanReadFile() then returns false. The fourth coordinate of 4OFF divides the
 * others.
 * - point array "Normals" (type of the points, 3 components), active: N.
 * - point array "TCoords" (type of the points, 2 components), active: ST.
 * - point array "RGB" or "RGBA" (unsigned char), active scalars: C, and additional columns of a
 *   plain OFF. If no number exceeds 1 they are fractions, otherwise bytes.
 * - cell array "RGB" or "RGBA" (unsigned char), active scalars: colors after the ids of faces;
 *   white for a face without color.
 * - cell array "ColorIndex" (int, 1 component): a single number after the ids of faces; -1 for a
 *   face without one.
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
   * Return whether the first bytes of a file are of this format. The name does not matter.
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

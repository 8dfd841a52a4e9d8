/**
 * @class   vtkConformalOFFReader
 * @brief   read OFF meshes and clouds (Geomview), with normals, colors and texture coordinates
 *
 * Read points and polygons from an OFF file of Geomview, text or binary, with normals, colors and
 * texture coordinates.
 *
 * Output port 0: vtkPolyData, the points and polygons of a file with three-dimensional points. A
 * file begins with the keyword [ST][C][N][4][n]OFF, in which each prefix in brackets is optional,
 * and the order of the first three does not matter.
 * Points of text files are double, and points of BINARY files are float. A file without the keyword
 * is also read, but CanReadFile() returns false for this file. With prefix 4, points have four
 * coordinates in the file: the first three are divided by the fourth.
 * - point array "Normals" (type of the points, 3 components), active: from a file with prefix N.
 * - point array "TCoords" (type of the points, 2 components), active: from a file with prefix ST.
 * - point array "RGB" or "RGBA" (unsigned char), active scalars: from a file with prefix C, or from
 *   additional columns of a text file without prefix C. If no number of the file's colors exceeds
 *   1, the numbers are read as colors in [0, 1], otherwise in [0, 255].
 * - cell array "RGB" or "RGBA" (unsigned char), active scalars: colors after the point ids of the
 *   faces. A face without color is white.
 * - cell array "ColorIndex" (int, 1 component): index of a color, read if only one number follows
 *   the point ids of a face. The value is -1 for other faces.
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
   * Return whether the first bytes of a file are those of an OFF file. The name of the file is not
   * tested.
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

/**
 * @class   vtkConformalPLYReader
 * @brief   read scans in the PLY format: every property, strips, doubles, visible clouds
 *
 * Read PLY files of all three formats. Unlike ParaView's PLY Reader, it keeps every property of a
 * point and double precision. It reads triangle strips, range grids, and clouds without triangles,
 * to which it adds vertices so that they are visible. Broken files cause an error.
 *
 * Output port 0: vtkPolyData, the points and polygons of a PLY file of any of its three formats.
 * The points are floats if x, y and z are, otherwise doubles. Triangle strips become triangles, and
 * so do neighbors in the grid of a range scan. vtkSurfaceFileReader describes what all readers of
 * this module have in common.
 * - point array "Normals" (float or double, 3 components), active: nx, ny, nz.
 * - point array "RGB" or "RGBA" (unsigned char, 3 or 4 components), active scalars: red, green,
 *   blue, alpha, also with the prefix "diffuse_".
 * - point array "TCoords" (float or double, 2 components), active: s, t or u, v or texture_u,
 *   texture_v.
 * - point arrays (1 component) with the name and type of every other scalar property of a vertex.
 * - cell arrays (1 component) with the name and type of every scalar property of a face, unless the
 *   file has strips or a grid.
 *
 * Unlike vtkPLYReader this reader keeps all properties and double precision, reads strips, and
 * checks every id. No file makes it crash.
 *
 * @sa
 * vtkSurfaceFileReader
 */

#ifndef vtkConformalPLYReader_h
#define vtkConformalPLYReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkConformalPLYReader : public vtkSurfaceFileReader
{
public:
  static vtkConformalPLYReader* New();
  vtkTypeMacro(vtkConformalPLYReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Maximum edge length of a triangle between neighbors in the grid of a range scan. Longer edges
   * would bridge gaps of the object. At least 0. Default is 0: 4 times the median length between
   * neighbors.
   */
  vtkSetClampMacro(MaximumEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  /**
   * Return whether the first lines of a file are of this format. The name does not matter.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".ply"; }
  const char* GetDescriptiveName() override { return "PLY scans and meshes"; }

protected:
  vtkConformalPLYReader() = default;
  ~vtkConformalPLYReader() override = default;

  bool CutsFiles() const override { return true; }
  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkConformalPLYReader(const vtkConformalPLYReader&) = delete;
  void operator=(const vtkConformalPLYReader&) = delete;

  double MaximumEdgeLength = 0.0;
};

#endif

/**
 * @class   vtkConformalPLYReader
 * @brief   read PLY meshes, triangle strips and point clouds, with every property, also doubles
 *
 * Read points and polygons from a PLY file, as text or binary. Unlike ParaView's PLY Reader, this
 * reader keeps double precision and every property of a point. This reader also reads triangle
 * strips, point clouds, and range grids (points in the cells of a scanner's grid). Each point of a
 * cloud gets a vertex cell, so that ParaView draws the cloud. Malformed files cause an error.
 *
 * Output port 0: vtkPolyData, the points and polygons of a PLY file: ascii, binary_little_endian or
 * binary_big_endian. The points are float if the properties x, y and z are float, otherwise double.
 * Triangle strips become triangles. A range scan is a file with a range grid: neighboring points of
 * the grid are connected by triangles. vtkSurfaceFileReader describes what all readers of this
 * module have in common.
 * - point array "Normals" (float or double, 3 components), active: properties nx, ny, nz or
 *   normal_x, normal_y, normal_z.
 * - point array "RGB" or "RGBA" (unsigned char, 3 or 4 components), active scalars: properties red,
 *   green, blue and alpha, also with the prefix "diffuse_".
 * - point array "TCoords" (float or double, 2 components), active: properties s, t or u, v or
 *   texture_u, texture_v.
 * - point arrays with the name and type of every other scalar property of a vertex (1 component).
 *   Properties NAME_0, NAME_1 and so on of equal type become one array NAME with several
 *   components.
 * - cell arrays (1 component) with the name and type of every scalar property of a face. If a file
 *   has strips or a grid, the output has no cell arrays.
 *
 * In contrast, VTK's class vtkPLYReader keeps only some properties, has only single precision, and
 * does not read strips. This reader checks every point id, so that malformed files cannot crash a
 * program.
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
   * Maximum length of an edge between neighboring points in the grid of a range scan, in the unit
   * of the points. Triangles with a longer edge are left out, since they would span gaps between
   * parts of the object. The length is at least 0. Default is 0: the maximum is 4 times the median
   * distance between neighboring points.
   */
  vtkSetClampMacro(MaximumEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  /**
   * Return whether the first lines of a file are those of a PLY file. The name of the file is not
   * tested.
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

/**
 * @class   vtkConformalPLYReader
 * @brief   read scans in the PLY format: every property, strips, doubles, visible clouds
 *
 * Output port 0: vtkPolyData, the points and polygons of a PLY file of any of its three formats.
 * The points are floats if x, y and z are, else doubles. A file without cells is a cloud and gets
 * one vertex for each point, so that it can be seen. Triangle strips become triangles, and so do
 * neighbours in the grid of a range scan.
 * - point array "Normals" (float or double, 3 components), active: nx, ny, nz.
 * - point array "RGB" or "RGBA" (unsigned char, 3 or 4 components), active scalars: red, green,
 *   blue, alpha, also with "diffuse_" before them.
 * - point array "TCoords" (float or double, 2 components), active: s, t or u, v or texture_u,
 *   texture_v.
 * - point arrays (1 component) of the name and type of every other scalar property of a vertex.
 * - cell arrays (the same) of the scalar properties of a face, unless the file has strips or a
 *   grid.
 * - field arrays "NumberOfDroppedPoints", "NumberOfDroppedPolygons", "NumberOfReplacedValues"
 *   (vtkIdType, 1 component): each there only if not 0, and then said in a warning. A point of a
 *   cloud is dropped if a coordinate is not finite, a polygon if it has fewer than 3 ids or one of
 *   them twice; other values that are not finite are replaced by 0.
 *
 * A file that breaks the rules, ends early, or has a mesh with a point that is not finite or an id
 * that no point has, gives an error with its line or byte, an empty output, and an error code of
 * vtkErrorCode. Numbers are read alike in every locale.
 *
 * Unlike vtkPLYReader this reader keeps all properties and double precision, reads strips, checks
 * every id, and survives any file.
 */

#ifndef vtkConformalPLYReader_h
#define vtkConformalPLYReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkIOSurfaceModule.h" // for export macro

class VTKIOSURFACE_EXPORT vtkConformalPLYReader : public vtkAbstractPolyDataReader
{
public:
  static vtkConformalPLYReader* New();
  vtkTypeMacro(vtkConformalPLYReader, vtkAbstractPolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Longest edge of a triangle between neighbours in the grid of a range scan; longer ones would
   * bridge gaps of the object. At least 0. Default is 0, which takes 4 times the median length
   * between neighbours.
   */
  vtkSetClampMacro(MaximumEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  /**
   * Whether a file is a PLY file, told by its first lines, whatever its name is.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  /**
   * The usual extensions of such files, with a dot, between blanks.
   */
  virtual const char* GetFileExtensions() { return ".ply"; }

  /**
   * What a list of file types calls them.
   */
  virtual const char* GetDescriptiveName() { return "PLY scans and meshes"; }

protected:
  vtkConformalPLYReader();
  ~vtkConformalPLYReader() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  // Says how many things were amiss, in a warning and in the output's field data.
  void Warn(vtkPolyData* output, const char* name, vtkTypeUInt64 count, const char* message);

  vtkConformalPLYReader(const vtkConformalPLYReader&) = delete;
  void operator=(const vtkConformalPLYReader&) = delete;

  double MaximumEdgeLength = 0.0;
};

#endif

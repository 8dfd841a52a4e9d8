/**
 * @class   vtkGuMeshReader
 * @brief   read meshes in the .m format of MeshLib, with their sphere map
 *
 * Read a mesh in the .m format of MeshLib, a library of X. Gu. A vertex or face of such a file may
 * have named values, called traits. The trait sph becomes the point array "SpherePosition". The
 * traits normal, uv and rgb become normals, texture coordinates and colors.
 *
 * Output port 0: vtkPolyData, the vertices (double) and faces of the file.
 * - point array "SpherePosition" (double, 3 components): trait sph of the vertices, positions on
 *   the unit sphere. Programs of H. Hoppe write this trait. Either all vertices must have the
 *   trait, or none.
 * - point array "Normals" (double, 3 components), active: trait normal; 0 where it is missing.
 * - point array "TCoords" (double, 2 components), active: trait uv; 0 where it is missing.
 * - point and cell array "RGB" (unsigned char, 3 components), active scalars: trait rgb of vertices
 *   and of faces; white where it is missing.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader
 */

#ifndef vtkGuMeshReader_h
#define vtkGuMeshReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkGuMeshReader : public vtkSurfaceFileReader
{
public:
  static vtkGuMeshReader* New();
  vtkTypeMacro(vtkGuMeshReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Return whether the first bytes of a file are those of a .m mesh. The name of the file is not
   * tested.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".m"; }
  const char* GetDescriptiveName() override { return "Gu's meshes with traits"; }

protected:
  vtkGuMeshReader() = default;
  ~vtkGuMeshReader() override = default;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkGuMeshReader(const vtkGuMeshReader&) = delete;
  void operator=(const vtkGuMeshReader&) = delete;
};

#endif

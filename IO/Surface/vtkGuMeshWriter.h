/**
 * @class   vtkGuMeshWriter
 * @brief   write meshes in the .m format of MeshLib, with their sphere map
 *
 * Write points and polygons to a file in the .m format of MeshLib, a library of X. Gu. Named values
 * of each point (traits) store the position on the sphere, the normal, the texture coordinates and
 * the color.
 *
 * Input port 0: vtkPolyData. The file has points, polygons and the active colors of the polygons.
 * Arrays of the points become traits:
 * - array "SpherePosition" (3 components): trait sph.
 * - active normals, texture coordinates and colors (3 unsigned chars): traits normal, uv and rgb.
 *
 * Numbers have enough digits for readers to restore the exact values.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkGuMeshReader
 */

#ifndef vtkGuMeshWriter_h
#define vtkGuMeshWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkGuMeshWriter : public vtkSurfaceFileWriter
{
public:
  static vtkGuMeshWriter* New();
  vtkTypeMacro(vtkGuMeshWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGuMeshWriter() = default;
  ~vtkGuMeshWriter() override = default;

  void WriteFiles(const conformal::Run& run) override;

private:
  vtkGuMeshWriter(const vtkGuMeshWriter&) = delete;
  void operator=(const vtkGuMeshWriter&) = delete;
};

#endif

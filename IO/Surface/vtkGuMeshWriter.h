/**
 * @class   vtkGuMeshWriter
 * @brief   write meshes in the .m format of MeshLib, with their sphere map
 *
 * Write points and polygons, and as traits of the points "SpherePosition" (sph), normals,
 * texture coordinates and colors.
 *
 * Input port 0: vtkPolyData. What is written is Gu's .m: points and polygons, and of the points as
 * traits
 * - array "SpherePosition" (3 components): trait sph,
 * - active normals, texture coordinates and colors (3 unsigned chars): normal, uv, rgb,
 *
 * and of the polygons active colors. Numbers are written so that they are read back the same.
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

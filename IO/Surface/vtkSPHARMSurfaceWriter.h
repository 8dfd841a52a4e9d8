/**
 * @class   vtkSPHARMSurfaceWriter
 * @brief   write surfaces for SPHARM-PDM (_surf) with their sphere (_para)
 *
 * Write triangles into a file, such as shape_surf.vtk, and their point array "SpherePosition" into
 * shape_para.vtk beside it.
 *
 * Input port 0: vtkPolyData, triangles with the point array "SpherePosition" (3 components).
 *
 * The writer makes two legacy VTK files of the same triangles: FileName, such as shape_surf.vtk,
 * and shape_para.vtk beside it. The points of the latter are SpherePosition, of unit length. If a
 * name has no _surf before the extension, _para is appended to it. Numbers are written with enough
 * digits to be read back exactly. Other arrays are left out.
 *
 * An existing sphere is replaced like the surface, even if another program made it. A warning is
 * given if the sphere existed but the surface did not.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkSPHARMSurfaceReader
 */

#ifndef vtkSPHARMSurfaceWriter_h
#define vtkSPHARMSurfaceWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkSPHARMSurfaceWriter : public vtkSurfaceFileWriter
{
public:
  static vtkSPHARMSurfaceWriter* New();
  vtkTypeMacro(vtkSPHARMSurfaceWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSPHARMSurfaceWriter() = default;
  ~vtkSPHARMSurfaceWriter() override = default;

  void WriteFiles(const conformal::Run& run) override;

private:
  vtkSPHARMSurfaceWriter(const vtkSPHARMSurfaceWriter&) = delete;
  void operator=(const vtkSPHARMSurfaceWriter&) = delete;
};

#endif

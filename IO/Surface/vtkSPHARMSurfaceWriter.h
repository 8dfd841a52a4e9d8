/**
 * @class   vtkSPHARMSurfaceWriter
 * @brief   write surfaces for SPHARM-PDM (_surf) with their sphere (_para)
 *
 * Write two files for SPHARM-PDM, a program for shape analysis: a surface of triangles, such as
 * shape_surf.vtk, and its sphere, shape_para.vtk in the same folder. The point array
 * "SpherePosition" gives the points of the sphere: the positions of the surface's points on the
 * unit sphere.
 *
 * Input port 0: vtkPolyData, triangles with the point array "SpherePosition" (3 components).
 *
 * The writer makes two legacy VTK files with the same triangles: the surface FileName, such as
 * shape_surf.vtk, and the sphere shape_para.vtk. The points of the sphere are SpherePosition, as
 * unit vectors. The name of the sphere file is made from FileName: _surf before the extension is
 * replaced by _para. If there is no _surf, _para is inserted before the extension. Numbers have
 * enough digits for readers to restore the exact values. Other arrays are left out.
 *
 * An existing file of the sphere is replaced, even if another program made the file. If the file of
 * the sphere existed before but the file of the surface did not, there is a warning.
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

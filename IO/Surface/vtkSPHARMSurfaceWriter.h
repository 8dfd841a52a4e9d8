/**
 * @class   vtkSPHARMSurfaceWriter
 * @brief   write surfaces for SPHARM-PDM (_surf) with their sphere (_para)
 *
 * Write triangles into a file, such as shape_surf.vtk, and their point array "SpherePosition"
 * into shape_para.vtk beside it.
 *
 * Input port 0: vtkPolyData, triangles with the point array "SpherePosition" (3 components).
 *
 * What is written are two legacy VTK files of the same triangles: FileName, such as shape_surf.vtk,
 * and shape_para.vtk beside it, whose points are SpherePosition, of unit length. (Where a name has
 * no _surf before the extension, _para is added to it.) Numbers are written so that they are read
 * back the same; other arrays are left out.
 *
 * The sphere is replaced as the surface is, whoever made it. A warning says so if it was there and
 * the surface was not.
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

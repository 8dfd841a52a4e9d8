/**
 * @class   vtkConformalOFFWriter
 * @brief   write OFF files as text, with normals, colors and texture coordinates
 *
 * Write points and polygons to an OFF file of Geomview, as text, with the active normals, colors
 * and texture coordinates.
 *
 * Input port 0: vtkPolyData. The file has the active normals, texture coordinates and colors of the
 * points. The file also has the active colors of the polygons. If the polygons have no colors, the
 * file has their integer array "ColorIndex" (1 component), indices of colors. Numbers have enough
 * digits for readers to restore the exact values.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkConformalOFFReader
 */

#ifndef vtkConformalOFFWriter_h
#define vtkConformalOFFWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkConformalOFFWriter : public vtkSurfaceFileWriter
{
public:
  static vtkConformalOFFWriter* New();
  vtkTypeMacro(vtkConformalOFFWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkConformalOFFWriter() = default;
  ~vtkConformalOFFWriter() override = default;

  void WriteFiles(const conformal::Run& run) override;

private:
  vtkConformalOFFWriter(const vtkConformalOFFWriter&) = delete;
  void operator=(const vtkConformalOFFWriter&) = delete;
};

#endif

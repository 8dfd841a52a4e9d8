/**
 * @class   vtkConformalPLYWriter
 * @brief   write PLY with all arrays
 *
 * Write binary PLY with all arrays of points and polygons, including "SpherePosition".
 * vtkConformalPLYReader reads the arrays back.
 *
 * Input port 0: vtkPolyData. The file is PLY, binary little endian, with all arrays of points and
 * polygons. Active normals, texture coordinates and colors have their usual names. Other arrays of
 * several components become NAME_0, NAME_1 and so on, which vtkConformalPLYReader joins again.
 * 8-byte integers become doubles.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkConformalPLYReader
 */

#ifndef vtkConformalPLYWriter_h
#define vtkConformalPLYWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkConformalPLYWriter : public vtkSurfaceFileWriter
{
public:
  static vtkConformalPLYWriter* New();
  vtkTypeMacro(vtkConformalPLYWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkConformalPLYWriter() = default;
  ~vtkConformalPLYWriter() override = default;

  void WriteFiles(const conformal::Run& run) override;

private:
  vtkConformalPLYWriter(const vtkConformalPLYWriter&) = delete;
  void operator=(const vtkConformalPLYWriter&) = delete;
};

#endif

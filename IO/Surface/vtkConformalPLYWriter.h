/**
 * @class   vtkConformalPLYWriter
 * @brief   write PLY files with all arrays of points and polygons
 *
 * Write points, polygons and all their arrays to a binary PLY file, including "SpherePosition".
 * vtkConformalPLYReader reads these arrays.
 *
 * Input port 0: vtkPolyData. The file is a PLY file, binary little endian, with all arrays of
 * points and polygons. Active normals, texture coordinates and colors get the usual names of PLY,
 * such as nx, s and red. Any other array NAME with several components becomes the properties
 * NAME_0, NAME_1 and so on, from which vtkConformalPLYReader makes one array. 8-byte integers
 * become doubles.
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

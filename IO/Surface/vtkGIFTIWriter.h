/**
 * @class   vtkGIFTIWriter
 * @brief   write GIFTI surfaces with all arrays of points
 *
 * Input port 0: vtkPolyData. What is written is GIFTI, compressed: points in their type, triangles,
 * and every array of the points by its name. Polygons of more corners are an error.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkGIFTIReader
 */

#ifndef vtkGIFTIWriter_h
#define vtkGIFTIWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkGIFTIWriter : public vtkSurfaceFileWriter
{
public:
  static vtkGIFTIWriter* New();
  vtkTypeMacro(vtkGIFTIWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGIFTIWriter() = default;
  ~vtkGIFTIWriter() override = default;

  void WriteFiles(const std::function<bool(double)>& progress) override;

private:
  vtkGIFTIWriter(const vtkGIFTIWriter&) = delete;
  void operator=(const vtkGIFTIWriter&) = delete;
};

#endif

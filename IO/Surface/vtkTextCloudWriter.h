/**
 * @class   vtkTextCloudWriter
 * @brief   write clouds of points as text
 *
 * Write one point on a line, with all its numbers between blanks; a remark at the start names
 * the columns. Polygons are left out.
 *
 * Input port 0: vtkPolyData. What is written is one point on a line, all its numbers between
 * blanks; a remark at the start names the columns if there are more than x, y and z. Arrays of
 * several components other than active normals and colors (3 unsigned chars) become several
 * columns; a name that another column has gets "_" behind it. Polygons are left out. Numbers are
 * written so that they are read back the same.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkTextCloudReader
 */

#ifndef vtkTextCloudWriter_h
#define vtkTextCloudWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkTextCloudWriter : public vtkSurfaceFileWriter
{
public:
  static vtkTextCloudWriter* New();
  vtkTypeMacro(vtkTextCloudWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkTextCloudWriter() = default;
  ~vtkTextCloudWriter() override = default;

  void WriteFiles(const conformal::Run& run) override;

private:
  vtkTextCloudWriter(const vtkTextCloudWriter&) = delete;
  void operator=(const vtkTextCloudWriter&) = delete;
};

#endif

/**
 * @class   vtkTextCloudWriter
 * @brief   write clouds of points as text
 *
 * Write one point per line, with all its numbers separated by blanks. A comment at the beginning
 * names the columns. Polygons are left out.
 *
 * Input port 0: vtkPolyData. Each line has one point, with all its numbers separated by blanks. A
 * comment at the beginning names the columns if there are more than x, y and z. Arrays of several
 * components other than active normals and colors (3 unsigned chars) become several columns. A name
 * that another column already has gets a trailing "_". Polygons are left out. Numbers are written
 * with enough digits to be read back exactly.
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

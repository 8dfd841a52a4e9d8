/**
 * @class   vtkTextCloudWriter
 * @brief   write point clouds as text
 *
 * Write a point cloud as text, with one point in each line. The coordinates of the point and its
 * values in all arrays are separated by blanks. A comment at the beginning names the columns.
 * Polygons are left out.
 *
 * Input port 0: vtkPolyData. Each line has the coordinates of one point and its values in all
 * arrays, separated by blanks. If there are more columns than x, y and z, a comment at the
 * beginning names the columns. Columns of active normals and colors (3 unsigned chars) get the
 * names that vtkTextCloudReader recognizes. Any other array with several components becomes several
 * columns. If two columns would have the same name, "_" is appended to the name of the second
 * column. Polygons are left out. Numbers have enough digits for readers to restore the exact
 * values.
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

/**
 * @class   vtkPCDReader
 * @brief   read clouds in the PCD format of the Point Cloud Library
 *
 * Read a point cloud from a PCD file, text, binary or compressed, with all fields (named numbers of
 * the points). Points with non-finite coordinates are left out: in a PCD file, they mean that the
 * scanner measured nothing.
 *
 * Output port 0: vtkPolyData, the points of a file, with one vertex for each point. Versions 0.5 to
 * 0.7 of the format are read: ascii, binary and binary_compressed. The points are float if the
 * fields x, y and z are float, otherwise double. Points with non-finite coordinates are dropped
 * without a warning.
 * - point array "Normals" (float or double, 3 components), active: fields normal_x, normal_y and
 *   normal_z.
 * - point array "RGB" or "RGBA" (unsigned char), active scalars: field rgb or rgba of four bytes.
 * - field array "ScannerPosition" (double, 3 components, 1 tuple): position in the line VIEWPOINT.
 *   The array is absent if the position is (0, 0, 0), the default, and the points do not form an
 *   image (HEIGHT is 1).
 * - one point array for every other field, with the name, type and number of components of the
 *   field. Padding fields, which have no data, are left out.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader
 */

#ifndef vtkPCDReader_h
#define vtkPCDReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkPCDReader : public vtkSurfaceFileReader
{
public:
  static vtkPCDReader* New();
  vtkTypeMacro(vtkPCDReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Return whether the first bytes of a file are those of a PCD file. The name of the file is not
   * tested.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".pcd"; }
  const char* GetDescriptiveName() override { return "PCD point clouds"; }

protected:
  vtkPCDReader() = default;
  ~vtkPCDReader() override = default;

  bool CutsFiles() const override { return true; }
  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkPCDReader(const vtkPCDReader&) = delete;
  void operator=(const vtkPCDReader&) = delete;
};

#endif

/**
 * @class   vtkPCDReader
 * @brief   read clouds in the PCD format of the Point Cloud Library
 *
 * Read PCD clouds as text, binary or compressed, with all fields. Points that are not finite, where
 * the scanner measured nothing, are left out.
 *
 * Output port 0: vtkPolyData, the points of a file of version 0.5 to 0.7, ascii, binary or
 * binary_compressed, with one vertex for each. The points are floats if x, y and z are, otherwise
 * doubles. Points that are not finite, where the scanner measured nothing, are dropped without a
 * warning.
 * - point array "Normals" (float or double, 3 components), active: normal_x, normal_y, normal_z.
 * - point array "RGB" or "RGBA" (unsigned char), active scalars: rgb or rgba of four bytes.
 * - point arrays with the name, type and count of every other field except padding.
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
   * Return whether the first bytes of a file are of this format. The name does not matter.
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

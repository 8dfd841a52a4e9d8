/**
 * @class   vtkPlateModelReader
 * @brief   read plate models of small bodies (.tab, .ver) of the Planetary Data System
 *
 * Read the vertices and triangular plates of a shape model, with or without numbered rows.
 *
 * Output port 0: vtkPolyData, the vertices (double) and triangles of a text file that has numbers
 * of vertices and plates and a row for each: X Y Z or I X Y Z, then A B C, I A B C, or 3 A B C, of
 * which the 3 may stand on a line of its own. I counts from 0 or 1; A, B and C number the vertices
 * from 1, or from 0 where a plate names vertex 0. Coordinates are in the file's unit, mostly
 * kilometers. Labels (.lbl, .xml) are not read.
 *
 * Models of lines "v X Y Z" and "f A B C" are files for vtkOBJReader, and digital elevation models
 * of longitude, latitude and radius (other .tab files) are no plate models: neither is read.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader vtkBodyMap
 */

#ifndef vtkPlateModelReader_h
#define vtkPlateModelReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkPlateModelReader : public vtkSurfaceFileReader
{
public:
  static vtkPlateModelReader* New();
  vtkTypeMacro(vtkPlateModelReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether a file is of this format, judged by its first bytes and not by its name.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".tab .ver"; }
  const char* GetDescriptiveName() override { return "Plate models of small bodies"; }

protected:
  vtkPlateModelReader() = default;
  ~vtkPlateModelReader() override = default;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkPlateModelReader(const vtkPlateModelReader&) = delete;
  void operator=(const vtkPlateModelReader&) = delete;
};

#endif

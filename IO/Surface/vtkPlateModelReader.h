/**
 * @class   vtkPlateModelReader
 * @brief   read plate models of small bodies (.tab, .ver) of the Planetary Data System
 *
 * Read the vertices and triangular plates of a shape model, with or without numbered rows.
 *
 * Output port 0: vtkPolyData, the vertices (double) and triangles of a text file. The file begins
 * with the numbers of vertices and plates and has a row for each. Rows of vertices are X Y Z or I X
 * Y Z. Rows of plates are A B C, I A B C, or 3 A B C, where the 3 may have its own line. I counts
 * from 0 or 1. A, B and C number the vertices from 1, or from 0 if a plate refers to vertex 0.
 * Coordinates are in the file's unit, mostly kilometers. Labels (.lbl, .xml) are ignored.
 *
 * Two similar formats are not supported. vtkOBJReader reads models with lines "v X Y Z" and "f A B
 * C". Digital elevation models of longitude, latitude and radius (other .tab files) are no plate
 * models.
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
   * Return whether the first bytes of a file are of this format. The name does not matter.
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

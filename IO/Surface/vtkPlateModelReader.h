/**
 * @class   vtkPlateModelReader
 * @brief   read plate models of small bodies (.tab, .ver) of the Planetary Data System
 *
 * Read the vertices and triangular plates of a small body's shape model from a text file, with or
 * without numbered rows.
 *
 * Output port 0: vtkPolyData, the vertices (double) and triangles of a text file. The file begins
 * with the numbers of vertices and plates, and has one row for each vertex and each plate. Let X, Y
 * and Z be the coordinates of a vertex, I the number of a row, and A, B and C the numbers of a
 * plate's vertices. Rows of vertices are X Y Z or I X Y Z. Rows of plates are A B C, I A B C, or 3
 * A B C, where the 3 may be on a separate line. I begins with 0 or 1. Vertices are numbered from 1,
 * or from 0 if a plate refers to vertex 0. Coordinates are in the unit of the file, usually
 * kilometers. Label files (.lbl, .xml) are not read.
 *
 * This reader does not read two similar kinds of files. For models with lines "v X Y Z" and "f A B
 * C", use vtkOBJReader. Other .tab files, with longitude, latitude and radius, are digital
 * elevation models instead of plate models.
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
   * Return whether the first bytes of a file are those of a plate model. The name of the file is
   * not tested.
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

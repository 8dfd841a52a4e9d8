/**
 * @class   vtkPlateModelReader
 * @brief   read plate models of small bodies (.tab, .ver) of the Planetary Data System
 *
 * Read the shape model of a small body, such as an asteroid, from a text file. The model is a mesh
 * of triangles, called plates. The reader accepts files with and without row numbers.
 *
 * Output port 0: vtkPolyData, the vertices (double) and triangles of a text file. The file contains
 * the number of vertices, a row for each vertex, the number of plates, and a row for each plate. In
 * some files, both numbers are on the first line.
 * - Rows of vertices are X Y Z or I X Y Z, where I is the number of the row, and X, Y and Z are
 *   coordinates.
 * - Rows of plates are A B C, I A B C, or 3 A B C, where A, B and C are the numbers of the plate's
 *   vertices. The 3 is the number of the plate's vertices. In some files, the 3 is on a separate
 *   line.
 *
 * The row number I begins with 0 or 1. If a plate refers to vertex 0, vertices are numbered from 0,
 * otherwise from 1. Coordinates are in the unit of the file, usually kilometers. Label files (.lbl,
 * .xml) are not read.
 *
 * To read models with lines "v X Y Z" and "f A B C", use vtkOBJReader instead of this reader. This
 * reader also does not read .tab files with longitude, latitude and radius, which are digital
 * elevation models.
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

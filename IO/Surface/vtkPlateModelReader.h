/**
 * @class   vtkPlateModelReader
 * @brief   read plate models of small bodies (.tab, .ver, .icq) of the Planetary Data System
 *
 * Read the shape model of a small body, such as an asteroid, from a text file. The model is a mesh
 * of triangles, called plates. The reader accepts files with and without row numbers. It also reads
 * the unit and the name of the body from the label beside the file, if there is one.
 *
 * Output port 0: vtkPolyData, the vertices (double) and triangles of a text file. There are three
 * kinds of files. The first kind contains the number of vertices, a row for each vertex, the number
 * of plates, and a row for each plate. In some files, both numbers are on the first line.
 * - Rows of vertices are X Y Z or I X Y Z, where I is the number of the row, and X, Y and Z are
 *   coordinates.
 * - Rows of plates are A B C, I A B C, or 3 A B C, where A, B and C are the numbers of the plate's
 *   vertices. The 3 is the number of the plate's vertices. In some files, the 3 is on a separate
 *   line.
 *
 * The row number I begins with 0 or 1. If a plate refers to vertex 0, vertices are numbered from 0,
 * otherwise from 1.
 *
 * In files of the second kind, rows have tags: v X Y Z is a vertex, and f A B C a plate. Vertices
 * are numbered from 1. Files of the third kind (ICQ, implicitly connected quadrilaterals) contain a
 * number q and 6 (q + 1)^2 vertices. The vertices are grids on the six sides of a cube. Vertices
 * with equal coordinates on the borders of the grids become one vertex. Each quadrilateral is
 * divided along its shorter diagonal.
 *
 * Coordinates are in the unit of the file, usually kilometers. A label is a file of the same name
 * with the extension .lbl (PDS3) or .xml (PDS4). It adds these field arrays:
 * - "MetersPerUnit" (double, 1 value): length of the unit of the coordinates [m]: 1000 if the label
 *   has kilometers, 1 if it has meters. If the label has both, there is a warning and no array.
 * - "TargetName" (string, 1 value): name of the body, such as "433 EROS".
 *
 * The reader does not read .tab files with longitude, latitude and radius, which are digital
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

#include <string> // for names of files
#include <vector> // for names of files

class vtkPolyData;

class VTKIOSURFACE_EXPORT vtkPlateModelReader : public vtkSurfaceFileReader
{
public:
  static vtkPlateModelReader* New();
  vtkTypeMacro(vtkPlateModelReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Return whether the first bytes of a file are those of a plate model, and the extension is not
   * .obj. OBJ files can begin like plate models with tags.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".tab .ver .icq"; }
  const char* GetDescriptiveName() override { return "Plate models of small bodies"; }

protected:
  vtkPlateModelReader() = default;
  ~vtkPlateModelReader() override = default;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;
  std::vector<std::string> FilesReadToo() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  // Add what a label contains to the field data of the output.
  void AddLabel(const std::string& name, vtkPolyData* output);

  vtkPlateModelReader(const vtkPlateModelReader&) = delete;
  void operator=(const vtkPlateModelReader&) = delete;
};

#endif

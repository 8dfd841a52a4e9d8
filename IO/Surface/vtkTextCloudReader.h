/**
 * @class   vtkTextCloudReader
 * @brief   read point clouds as text: XYZ, ASC, TXT, CSV, NTS, PTS
 *
 * Read a point cloud from a text file, one point from each line: XYZ, ASC, TXT, CSV, NTS and PTS
 * files. Numbers may be separated by blanks, tabs, commas or semicolons. A line of column names
 * determines which columns are normals, colors and intensities. Without this line, the number of
 * columns and the values determine the meaning of the columns.
 *
 * Output port 0: vtkPolyData, one point (double) and one vertex for each line. Numbers are
 * separated by blanks, tabs, commas or semicolons. Blank lines and lines that begin with #, // or ;
 * are skipped. If the first line of numbers contains only one number, this is the number of points
 * that follow, as in PTS files. A file of this kind can have several blocks of points, each after
 * its number of points.
 *
 * A line of column names before the numbers defines the meaning of the columns. The line of names
 * can be a comment. Without column names, the number of columns and the values in the first hundred
 * lines determine the meaning.
 * - point array "Normals" (double, 3 components), active: columns nx, ny, nz or normal_x, normal_y,
 *   normal_z. Without names, normals are the last three of six columns, if all of these vectors
 *   have length 1 (within 0.01) or 0, and at least one has length 1.
 * - point array "RGB" (unsigned char, 3 components), active scalars: columns r, g, b or red, green,
 *   blue, if all values are integers in [0, 255]. Without names, colors are the last three of six
 *   columns, if these columns are not normals. Of nine columns, the last six are normals and
 *   colors, in either order.
 * - point array "Intensity" (double, 1 component): column i or intensity. Without names, the
 *   intensity is the fourth of four columns. Of seven columns, the last four are intensity and
 *   colors, in either order.
 * - one point array (double, 1 component) for every other column, with the name of the column.
 *   Without names, the arrays are "Column4" and so on.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader vtkPTSReader vtkSimplePointsReader vtkDelimitedTextReader
 */

#ifndef vtkTextCloudReader_h
#define vtkTextCloudReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkTextCloudReader : public vtkSurfaceFileReader
{
public:
  static vtkTextCloudReader* New();
  vtkTypeMacro(vtkTextCloudReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the decimal separator is a comma, as in 0,5. If on, commas do not separate numbers.
   * Default is off: commas are decimal separators only if semicolons separate the numbers, and no
   * number has a point. Decimal commas in a file with blanks between numbers cause an error.
   */
  vtkSetMacro(DecimalComma, bool);
  vtkGetMacro(DecimalComma, bool);
  vtkBooleanMacro(DecimalComma, bool);
  ///@}

  ///@{
  /**
   * Whether lines without a valid point are skipped, and counted in the field array
   * "NumberOfSkippedLines". Default is off: a line without a valid point is an error.
   */
  vtkSetMacro(SkipMalformedLines, bool);
  vtkGetMacro(SkipMalformedLines, bool);
  vtkBooleanMacro(SkipMalformedLines, bool);
  ///@}

  /**
   * Return whether the first lines of a file are points as text. The name of the file is not
   * tested.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".xyz .asc .txt .csv .nts .pts"; }
  const char* GetDescriptiveName() override { return "Point clouds as text"; }

protected:
  vtkTextCloudReader() = default;
  ~vtkTextCloudReader() override = default;

  bool CutsFiles() const override { return true; }
  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkTextCloudReader(const vtkTextCloudReader&) = delete;
  void operator=(const vtkTextCloudReader&) = delete;

  bool DecimalComma = false;
  bool SkipMalformedLines = false;
};

#endif

/**
 * @class   vtkTextCloudReader
 * @brief   read clouds of points as text: XYZ, ASC, TXT, CSV, NTS, PTS
 *
 * Read one point from each line, with any separator of the numbers: XYZ, ASC, TXT, CSV, NTS and PTS
 * files. A line of column names, or the numbers themselves, determine which columns are normals,
 * colors and intensities.
 *
 * Output port 0: vtkPolyData, one point (double) and one vertex for each line. Numbers are
 * separated by blanks, tabs, commas or semicolons. Blank lines and lines that begin with #, // or ;
 * are skipped. A number alone on the first line is the number of points that follow, as in PTS
 * files, which may have several such blocks.
 *
 * A line of column names before the numbers, also as a comment, defines the columns. Otherwise
 * their number and their values in the first hundred lines determine them.
 * - point array "Normals" (double, 3 components), active: columns nx, ny, nz or normal_x ...; the
 *   last three of six if all are of unit length.
 * - point array "RGB" (unsigned char, 3 components), active scalars: columns r, g, b or red ... if
 *   all are integers in 0..255; the last three of six; with the normals of nine.
 * - point array "Intensity" (double, 1 component): column i or intensity; the fourth of four; with
 *   the colors of seven.
 * - point arrays (double, 1 component) with the name of every other column, or "Column4" and so on.
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
   * Whether the decimal separator is a comma, as in 0,5. Commas then do not separate numbers.
   * Default is off: a file with such numbers between blanks or semicolons is refused.
   */
  vtkSetMacro(DecimalComma, bool);
  vtkGetMacro(DecimalComma, bool);
  vtkBooleanMacro(DecimalComma, bool);
  ///@}

  ///@{
  /**
   * Whether lines without a valid point are skipped and counted in field array
   * "NumberOfSkippedLines". Default is off: such a line is an error.
   */
  vtkSetMacro(SkipMalformedLines, bool);
  vtkGetMacro(SkipMalformedLines, bool);
  vtkBooleanMacro(SkipMalformedLines, bool);
  ///@}

  /**
   * Return whether the first lines of a file are of this format. The name does not matter.
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

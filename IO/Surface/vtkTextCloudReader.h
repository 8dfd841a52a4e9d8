/**
 * @class   vtkTextCloudReader
 * @brief   read clouds of points as text: XYZ, ASC, TXT, CSV, NTS, PTS
 *
 * Read one point from each line, whatever separates the numbers: XYZ, ASC, TXT, CSV, NTS and PTS
 * files. Normals, colors and intensities are recognized by a line of names, or by the numbers
 * themselves.
 *
 * Output port 0: vtkPolyData, one point (double) and one vertex for each line. Numbers are
 * separated by blanks, tabs, commas or semicolons. Lines that are blank or begin with #, // or ;
 * are passed over. A number alone on the first line is the number of points that follow, as in PTS
 * files, which may have several such blocks.
 *
 * A line of names before the numbers, a remark or not, tells the columns; without it their number
 * and their values in the first hundred lines do.
 * - point array "Normals" (double, 3 components), active: columns nx, ny, nz or normal_x ...; the
 *   last three of six if all are of unit length.
 * - point array "RGB" (unsigned char, 3 components), active scalars: columns r, g, b or red ... if
 *   all are whole numbers in 0..255; the last three of six; with the normals of nine.
 * - point array "Intensity" (double, 1 component): column i or intensity; the fourth of four; with
 *   the colors of seven.
 * - point arrays (double, 1 component) of the name of every other column, or "Column4" and so on.
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
   * Whether one half is written 0,5. Commas part no numbers then. Default is off, and then a file
   * that has such numbers between blanks or semicolons is refused.
   */
  vtkSetMacro(DecimalComma, bool);
  vtkGetMacro(DecimalComma, bool);
  vtkBooleanMacro(DecimalComma, bool);
  ///@}

  ///@{
  /**
   * Whether lines that are no points are counted in field array "NumberOfSkippedLines" instead of
   * being an error. Default is off.
   */
  vtkSetMacro(SkipMalformedLines, bool);
  vtkGetMacro(SkipMalformedLines, bool);
  vtkBooleanMacro(SkipMalformedLines, bool);
  ///@}

  /**
   * Whether a file is of this format, judged by its first lines and not by its name.
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

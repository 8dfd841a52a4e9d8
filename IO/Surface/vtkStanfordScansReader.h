/**
 * @class   vtkStanfordScansReader
 * @brief   read range scans and the motions that align them as one cloud
 *
 * Read all PLY files that a .conf file of the Stanford scanning repository names, each moved by its
 * transform there. The point array ScanId has the number of each point's scan.
 *
 * Output port 0: vtkPolyData, the points (double) of all PLY files that a .conf file of the
 * Stanford scanning repository names, each moved as the file says, with one vertex for each.
 * - point array "ScanId" (int, 1 component): which of the scans that the file names, counted from
 * 0.
 * - point arrays of the names and types that all scans have, such as "confidence", "intensity".
 * - field array "NumberOfMissingScans" (vtkIdType, 1 component): named by the file and not there,
 * only if not 0, and then reported in a warning. If none is there it is an error.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader vtkConformalPLYReader
 */

#ifndef vtkStanfordScansReader_h
#define vtkStanfordScansReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkStanfordScansReader : public vtkSurfaceFileReader
{
public:
  static vtkStanfordScansReader* New();
  vtkTypeMacro(vtkStanfordScansReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the quaternions turn the other way. Default is off: a point is turned by the inverse of
   * the rotation that a quaternion commonly stands for, as the repository's files want it. Wrong
   * scans do not overlap.
   */
  vtkSetMacro(InvertRotation, bool);
  vtkGetMacro(InvertRotation, bool);
  vtkBooleanMacro(InvertRotation, bool);
  ///@}

  ///@{
  /**
   * Whether the file may name scans outside of its folder, by their paths or by links. Default is
   * off.
   */
  vtkSetMacro(AllowExternalFiles, bool);
  vtkGetMacro(AllowExternalFiles, bool);
  vtkBooleanMacro(AllowExternalFiles, bool);
  ///@}

  ///@{
  /**
   * Whether it is an error if a scan that the file names is not there. Default is off: the others
   * are read, with a warning.
   */
  vtkSetMacro(RequireAllScans, bool);
  vtkGetMacro(RequireAllScans, bool);
  vtkBooleanMacro(RequireAllScans, bool);
  ///@}

  /**
   * Whether a file is of this format, judged by its first bytes and not by its name.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".conf"; }
  const char* GetDescriptiveName() override { return "Aligned range scans"; }

protected:
  vtkStanfordScansReader() = default;
  ~vtkStanfordScansReader() override = default;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;
  std::vector<std::string> FilesReadToo() override;

private:
  vtkStanfordScansReader(const vtkStanfordScansReader&) = delete;
  void operator=(const vtkStanfordScansReader&) = delete;

  bool InvertRotation = false;
  bool AllowExternalFiles = false;
  bool RequireAllScans = false;
};

#endif

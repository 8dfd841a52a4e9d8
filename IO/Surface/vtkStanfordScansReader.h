/**
 * @class   vtkStanfordScansReader
 * @brief   read range scans and the motions that align them as one cloud
 *
 * Read all PLY files that a .conf file of the Stanford scanning repository lists, and apply to each
 * its transform from that file. The point array ScanId has the number of each point's scan.
 *
 * Output port 0: vtkPolyData, the points (double) of all PLY files that a .conf file of the
 * Stanford scanning repository lists. Each scan is transformed as specified there. There is one
 * vertex for each point.
 * - point array "ScanId" (int, 1 component): number of the scan in the file, counted from 0.
 * - point arrays that all scans have with equal names and types, such as "confidence", "intensity".
 * - field array "NumberOfMissingScans" (vtkIdType, 1 component): number of listed scans that do not
 *   exist. The array exists only if it is not 0, with a warning. If all scans are missing, it is an
 *   error.
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
   * Whether to invert the rotations. Default is off: a point is rotated by the inverse of the
   * rotation that a quaternion commonly represents, as in the repository's files. If scans do not
   * overlap, change this property.
   */
  vtkSetMacro(InvertRotation, bool);
  vtkGetMacro(InvertRotation, bool);
  vtkBooleanMacro(InvertRotation, bool);
  ///@}

  ///@{
  /**
   * Whether the file may refer to scans outside of its folder, by paths or links. Default is off.
   */
  vtkSetMacro(AllowExternalFiles, bool);
  vtkGetMacro(AllowExternalFiles, bool);
  vtkBooleanMacro(AllowExternalFiles, bool);
  ///@}

  ///@{
  /**
   * Whether a listed scan that does not exist is an error. Default is off: the other scans are
   * read, with a warning.
   */
  vtkSetMacro(RequireAllScans, bool);
  vtkGetMacro(RequireAllScans, bool);
  vtkBooleanMacro(RequireAllScans, bool);
  ///@}

  /**
   * Return whether the first bytes of a file are of this format. The name does not matter.
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

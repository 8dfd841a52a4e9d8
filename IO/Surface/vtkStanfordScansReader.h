/**
 * @class   vtkStanfordScansReader
 * @brief   read several aligned range scans as one point cloud
 *
 * Read all range scans that a .conf file lists, as one point cloud. Files of this kind come from
 * the Stanford 3D Scanning Repository. Each scan is a PLY file, for which the .conf file specifies
 * a transform. The reader applies these transforms, so that the scans are aligned. The point array
 * ScanId contains the number of each point's scan.
 *
 * Output port 0: vtkPolyData, the points (double) of all scans that the .conf file lists. Each scan
 * is transformed as specified in the .conf file. There is one vertex for each point.
 * - point array "ScanId" (int, 1 component): number of the point's scan in the list, counted from
 *   0.
 * - point array "ScannerPosition" (float, 3 components): position of the scanner of each point. The
 *   scanners of the repository scan along the z axis of a scan. The position is in this direction
 *   from the point, a thousand times the largest coordinate of the scan away.
 * - every point array that all scans have with the same name, type and number of components, such
 *   as "confidence" or "intensity".
 * - field array "NumberOfMissingScans" (vtkIdType, 1 component): number of listed scans that do not
 *   exist. If this number is 0, the array is absent. Otherwise, there is a warning. If all scans
 *   are missing, there is an error.
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
   * Whether each point is rotated by the quaternion that the .conf file specifies for its scan.
   * Default is off: each point is rotated by the inverse of this rotation, as the files of the
   * Stanford repository require. If the scans do not fit together, change this property.
   */
  vtkSetMacro(InvertRotation, bool);
  vtkGetMacro(InvertRotation, bool);
  vtkBooleanMacro(InvertRotation, bool);
  ///@}

  ///@{
  /**
   * Whether the .conf file may refer, by paths or links, to scans outside of its folder. Default is
   * off.
   */
  vtkSetMacro(AllowExternalFiles, bool);
  vtkGetMacro(AllowExternalFiles, bool);
  vtkBooleanMacro(AllowExternalFiles, bool);
  ///@}

  ///@{
  /**
   * Whether it is an error if a listed scan does not exist. Default is off: the other scans are
   * read, with a warning.
   */
  vtkSetMacro(RequireAllScans, bool);
  vtkGetMacro(RequireAllScans, bool);
  vtkBooleanMacro(RequireAllScans, bool);
  ///@}

  /**
   * Return whether the first bytes of a file are those of a .conf file of scans. The name of the
   * file is not tested.
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

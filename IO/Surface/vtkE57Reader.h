/**
 * @class   vtkE57Reader
 * @brief   read clouds of laser scanners from E57 files, with poses, colors and positions of
 * scanners
 *
 * Read the scans of an E57 file as one point cloud. E57 (ASTM E2807) is the exchange format of
 * laser scanners. Each scan is rotated and translated by its pose, so that the scans are aligned.
 *
 * Output port 0: vtkPolyData, the points of all scans of a file, or of one scan (ScanId), with one
 * vertex for each point. Points without a measurement are dropped without a warning. The unit of
 * length of E57 files is the meter. The checksums of the file are checked.
 * - point array "RGB" (unsigned char, 3 components), active scalars: colors. Colors of more than 8
 *   bits are mapped from their limits in the file to 0 to 255.
 * - point array "Intensity" (1 component): intensity, in the unit of the file.
 * - point array "Normals" (float or double, 3 components), active: normals (extension nor), rotated
 *   by the pose.
 * - one point array (1 component) for every other number of the points, with the name in the file,
 *   such as "rowIndex" or "timeStamp". If several scans are read, only numbers that all scans have
 *   become arrays. Integers have the smallest type for their range. Scaled integers are double.
 * - point array "ScanId" (int, 1 component): number of the point's scan in the file, from 0. The
 *   array is absent if only one scan with points is read.
 * - field array "ScannerPosition" (double, 3 components, 1 tuple): position of the scanner, the
 *   translation of the pose. The array is absent unless the points have spherical coordinates, or a
 *   row and a column, since other clouds may contain points of several positions. If several scans
 *   with this position are read, "ScannerPosition" (float, 3 components) is a point array instead.
 * - field array "CoordinateShift" (double, 3 components, 1 tuple): vector that was subtracted from
 *   the coordinates, see ShiftCoordinates. The array is absent if no vector was subtracted.
 *
 * The points are float if this loses nothing: if rounding to floats changes coordinates by at most
 * a quarter of their resolution. Otherwise, they are double. The resolution is the scale of scaled
 * integers, such as 0.1 mm. Coordinates of single precision in the file become float unless the
 * pose more than doubles their magnitude. Coordinates of double precision remain double.
 *
 * Pictures in the file are not read.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader vtkConformalLASReader vtkConformalSOM
 */

#ifndef vtkE57Reader_h
#define vtkE57Reader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkE57Reader : public vtkSurfaceFileReader
{
public:
  static vtkE57Reader* New();
  vtkTypeMacro(vtkE57Reader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of the scan to read, from 0, or -1 (default) for all scans. The point array ScanId
   * contains these numbers. Choose one scan if all scans need too much memory, or if their poses
   * are wrong, so that the scans must be aligned by another program.
   */
  vtkSetClampMacro(ScanId, int, -1, 9999);
  vtkGetMacro(ScanId, int);
  ///@}

  ///@{
  /**
   * Whether a vector is subtracted from coordinates that are far from the origin, such as those of
   * maps. Default is on. Switch it off if points must keep the coordinates of the file, for example
   * to lie beside the points of other files.
   *
   * A vector is subtracted only if floats do not suffice, and the largest coordinate is at least 10
   * times the largest side of the bounding box. The vector is the center of the box, rounded to a
   * power of 10. The field array CoordinateShift contains the vector. Its sum with a point is the
   * position in the file.
   */
  vtkSetMacro(ShiftCoordinates, bool);
  vtkGetMacro(ShiftCoordinates, bool);
  vtkBooleanMacro(ShiftCoordinates, bool);
  ///@}

  /**
   * Return whether the first bytes of a file are those of an E57 file. The name of the file is not
   * tested.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".e57"; }
  const char* GetDescriptiveName() override { return "E57 scans"; }

protected:
  vtkE57Reader() = default;
  ~vtkE57Reader() override = default;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkE57Reader(const vtkE57Reader&) = delete;
  void operator=(const vtkE57Reader&) = delete;

  int ScanId = -1;
  bool ShiftCoordinates = true;
};

#endif

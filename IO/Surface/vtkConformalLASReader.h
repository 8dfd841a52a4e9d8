/**
 * @class   vtkConformalLASReader
 * @brief   read clouds of laser scanners from LAS files, with colors, intensity and classes
 *
 * Read a point cloud from a LAS file, the format of laser scanners on aircraft. Scale and offset of
 * the coordinates are applied. Compressed files (LAZ) are not read: convert them to LAS, for
 * example by the program pdal or laszip.
 *
 * Output port 0: vtkPolyData, the points of a file of version 1.0 to 1.4 in point format 0 to 10,
 * with one vertex for each point.
 * - point array "RGB" (unsigned char, 3 components), active scalars: colors. If a number of any
 *   color is above 255, all numbers are divided by 256.
 * - point array "Intensity" (unsigned short): strength of the returned pulse.
 * - point arrays "ReturnNumber" and "NumberOfReturns" (unsigned char): number of the return within
 *   its pulse, from 1, and number of returns of the pulse.
 * - point array "Classification" (unsigned char): class of the point, such as 2 for the ground.
 * - point array "PointSourceId" (unsigned short): number of the file or flight line of the point.
 * - point array "GPSTime" (double): time of the pulse [s], only if the point format has it.
 * - point array "NearInfrared" (unsigned short): only if the point format has it.
 * - field array "CoordinateShift" (double, 3 components, 1 tuple): vector that was subtracted from
 *   the coordinates, see ShiftCoordinates. The array is absent if no vector was subtracted.
 *
 * The points are float if this loses nothing: if rounding to floats changes coordinates by at most
 * a quarter of the scale of the file. For a scale of 1 mm, this holds up to 4 km from the origin.
 * Otherwise, the points are double. Flags, scan angles, user data, waveforms and extra bytes of the
 * points are not read.
 *
 * Unlike vtkLASReader, this reader needs no library, and keeps the precision of the file.
 *
 * vtkSurfaceFileReader describes what all readers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileReader vtkE57Reader
 */

#ifndef vtkConformalLASReader_h
#define vtkConformalLASReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileReader.h"

class VTKIOSURFACE_EXPORT vtkConformalLASReader : public vtkSurfaceFileReader
{
public:
  static vtkConformalLASReader* New();
  vtkTypeMacro(vtkConformalLASReader, vtkSurfaceFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
   * Return whether the first bytes of a file are those of a LAS or LAZ file. The name of the file
   * is not tested. For LAZ files, the error of the reader describes the conversion to LAS.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  const char* GetFileExtensions() override { return ".las .laz"; }
  const char* GetDescriptiveName() override { return "LAS point clouds"; }

protected:
  vtkConformalLASReader() = default;
  ~vtkConformalLASReader() override = default;

  conformal::SurfaceResult Parse(conformal::ByteReader& input, const conformal::FilePiece& piece,
    const conformal::Run& run) override;

private:
  vtkConformalLASReader(const vtkConformalLASReader&) = delete;
  void operator=(const vtkConformalLASReader&) = delete;

  bool ShiftCoordinates = true;
};

#endif

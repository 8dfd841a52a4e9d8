/**
 * @class   vtkTIFFStackWriter
 * @brief   write a volume or a map as a TIFF stack that ImageJ and Fiji open with its spacing
 *
 * Write an image to a TIFF file that the programs ImageJ and Fiji, and the Python package tifffile,
 * open with spacing, unit, slices, channels and time steps. The file is not compressed, since
 * ImageJ reads stacks only so.
 *
 * Input port 0: vtkImageData, a picture, a volume, or the volumes of several time steps, one after
 * the other along z (see NumberOfFrames). Each component of the written array becomes a
 * channel. Values of the types unsigned char and unsigned short keep their type. All other values
 * are written as floats (32 bits), or see PixelType. Values must be finite. Origin and direction of
 * the image are not written, since the format has no place for them.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkTIFFStackReader vtkSurfaceLayers vtkSurfaceFileWriter
 */

#ifndef vtkTIFFStackWriter_h
#define vtkTIFFStackWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

#include <string> // for properties

class VTKIOSURFACE_EXPORT vtkTIFFStackWriter : public vtkSurfaceFileWriter
{
public:
  static vtkTIFFStackWriter* New();
  vtkTypeMacro(vtkTIFFStackWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Types of the numbers in the file.
   */
  enum PixelTypes
  {
    AUTOMATIC = 0,
    UINT16 = 1,
    FLOAT32 = 2
  };

  /**
   * Directions of the y axis in pictures.
   */
  enum YAxes
  {
    DOWN = 0,
    UP = 1
  };

  ///@{
  /**
   * Name of the point array to write. Empty (default) selects the active scalars.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Unit of the spacing, such as "micron". Empty (default) selects the field data "Unit" of the
   * image, as vtkTIFFStackReader reads it, or no unit.
   */
  vtkSetMacro(Unit, std::string);
  vtkGetMacro(Unit, std::string);
  ///@}

  ///@{
  /**
   * Type of the numbers in the file. AUTOMATIC (default): unsigned integers of 8 and 16 bits as
   * they are, all others as FLOAT32. UINT16: whole numbers from 0 to 65535; values are rounded, and
   * values out of this range are an error. FLOAT32: floats of 32 bits.
   */
  vtkSetClampMacro(PixelType, int, AUTOMATIC, FLOAT32);
  vtkGetMacro(PixelType, int);
  void SetPixelTypeToAutomatic() { this->SetPixelType(AUTOMATIC); }
  void SetPixelTypeToUInt16() { this->SetPixelType(UINT16); }
  void SetPixelTypeToFloat32() { this->SetPixelType(FLOAT32); }
  ///@}

  ///@{
  /**
   * Direction of the y axis in the pictures of the file. DOWN (default): the first row of a picture
   * has the smallest y, so that positions are those of ImageJ. UP: the last row has the smallest y.
   * Use UP for maps, so that north is up in the pictures, and for vtkTIFFStackReader with UP.
   */
  vtkSetClampMacro(YAxis, int, DOWN, UP);
  vtkGetMacro(YAxis, int);
  void SetYAxisToDown() { this->SetYAxis(DOWN); }
  void SetYAxisToUp() { this->SetYAxis(UP); }
  ///@}

  ///@{
  /**
   * Number of time steps. The slices of the image are divided into so many volumes of equal size,
   * the first time step first. The number of slices must be a multiple of it. At least 1. Default
   * is 1.
   *
   * vtkImageAppend with AppendAxis 2 makes such an image of the volumes of several time steps.
   */
  vtkSetClampMacro(NumberOfFrames, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfFrames, int);
  ///@}

  ///@{
  /**
   * Time between two time steps, in seconds. Must be positive. Written only if NumberOfFrames is
   * above 1. Default is 1.
   */
  vtkSetMacro(FrameInterval, double);
  vtkGetMacro(FrameInterval, double);
  ///@}

protected:
  vtkTIFFStackWriter() = default;
  ~vtkTIFFStackWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFiles(const conformal::Run& run) override;

private:
  vtkTIFFStackWriter(const vtkTIFFStackWriter&) = delete;
  void operator=(const vtkTIFFStackWriter&) = delete;

  std::string ArrayName;
  std::string Unit;
  int PixelType = AUTOMATIC;
  int YAxis = DOWN;
  int NumberOfFrames = 1;
  double FrameInterval = 1.0;
};

#endif

/**
 * @class   vtkTIFFStackReader
 * @brief   read a volume from a TIFF stack of ImageJ or Fiji, with its channels and spacing
 *
 * Read a stack of pictures from a TIFF file, such as a volume of a microscope that the programs
 * ImageJ and Fiji have written. The description of ImageJ is used: channels become components,
 * frames become time steps, and the spacing is that of the file.
 *
 * Output port 0: vtkImageData, a volume with the origin (0, 0, 0). The slices of the file follow
 * each other along z.
 * - active scalars "Intensity", of the type of the file, with a component for each channel. Values
 *   that are not finite become 0, with a warning.
 * - field data "Unit" (vtkStringArray, 1 value): unit of the spacing, such as "micron"; only if the
 *   file has one.
 *
 * A file that ImageJ has not written is read with a spacing of 1, and each page is a slice. Pages
 * may have 8, 16, 32 or 64 bits per number, in strips that are uncompressed or compressed by
 * deflate, in either byte order. Files beyond 4 GB may be BigTIFF, or stacks of ImageJ. For other
 * files, such as those with tiles or compressed by LZW, the error message states what is not read.
 *
 * Unlike this reader, vtkTIFFReader ignores the description.
 *
 * If a file is malformed or truncated, the error message states the offset of the byte. The output
 * is then empty, and an error code of vtkErrorCode is set. If the reader is aborted, the output is
 * empty, and there is no error.
 *
 * @sa
 * vtkTIFFStackWriter vtkVolumeSurfacePoints vtkTIFFReader
 */

#ifndef vtkTIFFStackReader_h
#define vtkTIFFStackReader_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <functional> // for Report
#include <string>     // for Report

class VTKIOSURFACE_EXPORT vtkTIFFStackReader : public vtkImageAlgorithm
{
public:
  static vtkTIFFStackReader* New();
  vtkTypeMacro(vtkTIFFStackReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
   * Name of the file to read. Default is none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Direction of the y axis in the pictures of the file. DOWN (default): the first row of a picture
   * has the smallest y, so that positions are those of ImageJ. UP: the last row has the smallest y.
   * Use UP for maps, such as those that vtkTIFFStackWriter has written
   * with UP. With UP, a volume is a mirror image of that of ImageJ.
   */
  vtkSetClampMacro(YAxis, int, DOWN, UP);
  vtkGetMacro(YAxis, int);
  void SetYAxisToDown() { this->SetYAxis(DOWN); }
  void SetYAxisToUp() { this->SetYAxis(UP); }
  ///@}

  /**
   * Return whether the first bytes of a file are those of a TIFF file. The name of the file is not
   * tested.
   */
  static int CanReadFile(VTK_FILEPATH const char* name);

  /**
   * Return the usual extensions of the files, each with a dot.
   */
  const char* GetFileExtensions() { return ".tif .tiff"; }

  /**
   * Return the name of the format, as shown in lists of file types.
   */
  const char* GetDescriptiveName() { return "TIFF stack of ImageJ"; }

protected:
  vtkTIFFStackReader();
  ~vtkTIFFStackReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTIFFStackReader(const vtkTIFFStackReader&) = delete;
  void operator=(const vtkTIFFStackReader&) = delete;

  int Report(const std::function<void(const std::string&)>& read);

  char* FileName = nullptr;
  int YAxis = DOWN;
};

#endif

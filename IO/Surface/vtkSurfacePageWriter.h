/**
 * @class   vtkSurfacePageWriter
 * @brief   write a web page that shows a surface and its sphere in any browser
 *
 * Write one file that needs no network: surface and sphere turn side by side, with a picture or
 * any point array as color; a point picked on the one is marked on the other.
 *
 * Input port 0: vtkPolyData, the surface; polygons and strips are triangulated, vertices and lines
 * are left out.
 * - point array "SpherePosition" (float or double, 3 components): its map to the sphere.
 * - active texture coordinates of the points (float or double, 2 components): needed with a
 * picture. Surfaces have to be cut along the picture's seams, by SplitSeam of
 * vtkSphericalTextureMap.
 * - all other point arrays of numbers: shown as colors with a legend; arrays of 3 or 4 unsigned
 * chars as the colors that they are, other arrays of several components by the length of their
 * tuples. "Normals" and "vtkGhostType" are left out. Values that are not finite are shown as none.
 *
 * Input port 1, optional: vtkImageData, the picture: one slice of unsigned char, 3 (RGB) or 4
 * (RGBA) components.
 *
 * The page is one file that needs no network, and sends nothing: it opens in any browser of 2023 or
 * later, on phones too. Surface and sphere turn side by side, and a slider turns the surface into
 * the sphere. A point picked on the one is marked on the other, with its position, its longitude
 * and latitude as vtkBodyMap has them, and its values. Its title is the name of the file without
 * the ending.
 *
 * It is drawn by three.js, which is put into the page from where it is installed: on Debian by
 * package libjs-three. Without it there is an error that says so.
 *
 * Positions have 16 bits for each coordinate, within the bounds of the surface, places on the
 * sphere are within 0.006 degrees, values within 1/65534 of their array's range; whole numbers are
 * exact (within a range of 4 * 10^9). With the picture as JPEG, a page of 64,002 points has at most
 * 3 MB unless it has many arrays: each is up to 0.2 MB.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkTexturedSurfaceWriter vtkSphericalTextureMap
 */

#ifndef vtkSurfacePageWriter_h
#define vtkSurfacePageWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

#include <string> // for names

class vtkAlgorithmOutput;
class vtkImageData;

class VTKIOSURFACE_EXPORT vtkSurfacePageWriter : public vtkSurfaceFileWriter
{
public:
  static vtkSurfacePageWriter* New();
  vtkTypeMacro(vtkSurfacePageWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The picture: one slice of unsigned char, RGB or RGBA.
   */
  void SetTextureConnection(vtkAlgorithmOutput* algOutput);
  void SetTextureData(vtkImageData* picture);
  ///@}

  ///@{
  /**
   * Name of the point array that the page shows at first; others are chosen from a menu. If empty,
   * the picture, without one the active colors, or else the first array that is not constant.
   * Default is empty.
   */
  vtkSetMacro(ColorArrayName, std::string);
  vtkGetMacro(ColorArrayName, std::string);
  ///@}

  ///@{
  /**
   * Direction from the model to the viewer when the page is opened, in the coordinates of the
   * model. Of any length, but not zero. The sphere is turned so that its middle is the point of the
   * surface that the viewer meets first. Default is (0, 0, 1).
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * Direction in the coordinates of the model that the viewer sees as up. Of any length, but not
   * zero, and not parallel to ViewDirection. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Whether the picture comes again beyond the texture coordinates 0 and 1, instead of its border
   * drawn out. Default is off.
   */
  vtkSetMacro(RepeatTexture, bool);
  vtkGetMacro(RepeatTexture, bool);
  vtkBooleanMacro(RepeatTexture, bool);
  ///@}

  ///@{
  /**
   * Pixels along the longer side of the picture in the page; larger ones are shrunk. In [1, 8192].
   * Default is 2048, which every phone can show.
   */
  vtkSetClampMacro(MaximumTextureSize, int, 1, 8192);
  vtkGetMacro(MaximumTextureSize, int);
  ///@}

  ///@{
  /**
   * Quality of the picture as JPEG, from 1 (small) to 100. Default is 85.
   */
  vtkSetClampMacro(TextureQuality, int, 1, 100);
  vtkGetMacro(TextureQuality, int);
  ///@}

  ///@{
  /**
   * A build of three.js that is a classic script or a CommonJS module: three.min.js, three.js or
   * three.cjs, of release 111 or later. If empty, that of Debian's package libjs-three. Default is
   * empty.
   */
  vtkSetMacro(ThreeJSFileName, std::string);
  vtkGetMacro(ThreeJSFileName, std::string);
  ///@}

protected:
  vtkSurfacePageWriter();
  ~vtkSurfacePageWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFiles(const conformal::Run& run) override;

private:
  vtkSurfacePageWriter(const vtkSurfacePageWriter&) = delete;
  void operator=(const vtkSurfacePageWriter&) = delete;

  std::string ColorArrayName;
  double ViewDirection[3] = { 0.0, 0.0, 1.0 };
  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  bool RepeatTexture = false;
  int MaximumTextureSize = 2048;
  int TextureQuality = 85;
  std::string ThreeJSFileName;
};

#endif

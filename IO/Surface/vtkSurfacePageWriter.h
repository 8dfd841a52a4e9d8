/**
 * @class   vtkSurfacePageWriter
 * @brief   write a web page that shows a surface and its sphere in any browser
 *
 * Write a web page that shows a surface and its map to the sphere. The page is one file that needs
 * no network. The page shows the surface and the sphere side by side. Both are colored by a picture
 * or any point array. The user can rotate surface and sphere. A point that is picked on the surface
 * is also marked on the sphere, and vice versa.
 *
 * Input port 0: vtkPolyData, the surface. Polygons and strips are triangulated. Vertex and line
 * cells are left out.
 * - point array "SpherePosition" (float or double, 3 components): position of the point on the
 *   sphere.
 * - active texture coordinates of the points (float or double, 2 components): required if there is
 *   a picture. The surface must be cut along the seams of the picture, as by the property SplitSeam
 *   of vtkSphericalTextureMap.
 * - all other numeric point arrays: shown as colors with a legend. An array of 3 or 4 unsigned
 *   chars is shown directly as RGB or RGBA colors. For other arrays with several components, the
 *   magnitude of each tuple is shown. "Normals" and "vtkGhostType" are left out. Values that are
 *   not finite are shown as missing.
 *
 * Input port 1, optional: vtkImageData, the picture: one slice of unsigned char, 3 (RGB) or 4
 * (RGBA) components.
 *
 * The page is one file that needs no network and sends no data. Any browser of 2023 or later can
 * open the page, on computers and phones. The user rotates the surface and the sphere by mouse,
 * touch or keyboard, together or separately. A slider morphs the surface into the sphere. A point
 * that is picked on the surface is also marked on the sphere, and vice versa. For a picked point,
 * the page shows the position, the values, and the longitude and latitude as in vtkBodyMap. The
 * title of the page is the name of the file without the extension.
 *
 * The page uses the library three.js for graphics. The writer copies this library into the page
 * from a file on this computer, see ThreeJSFileName. On Debian, the package libjs-three contains
 * this file. If the file is missing, there is an error. The wheel for pip contains the library.
 *
 * Data in the page are rounded. Each coordinate is a 16-bit integer, scaled to the bounds of the
 * surface. Positions on the sphere have an error of at most 0.006 degrees. Values have an error of
 * at most 1/65534 of the range of their array. Integers are exact if the range of their array is at
 * most 4 * 10^9. A page of 64,002 points, with a picture and few arrays, has at most 3 MB. Each
 * further array adds up to 0.2 MB.
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
   * Set the picture: one slice of unsigned char, RGB or RGBA.
   */
  void SetTextureConnection(vtkAlgorithmOutput* algOutput);
  void SetTextureData(vtkImageData* picture);
  ///@}

  ///@{
  /**
   * Name of the point array that the page shows first. A menu offers the other arrays. If the name
   * is empty (default), the page first shows the picture. Without a picture, the page shows the
   * active colors. Without colors, the page shows the first array that is not constant.
   */
  vtkSetMacro(ColorArrayName, std::string);
  vtkGetMacro(ColorArrayName, std::string);
  ///@}

  ///@{
  /**
   * Direction from the model to the viewer when the page is opened, in the coordinates of the
   * model. The vector may have any length but 0. The line of sight through the surface's centroid
   * intersects the surface. The first intersection is shown in the middle of the sphere. Default is
   * (0, 0, 1).
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * Direction that is up for the viewer, in the coordinates of the model. The vector may have any
   * length but 0, and must not be parallel to ViewDirection. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Whether the picture is repeated where texture coordinates are outside of [0, 1]. Default is
   * off: the color at the border of the picture is used there.
   */
  vtkSetMacro(RepeatTexture, bool);
  vtkGetMacro(RepeatTexture, bool);
  vtkBooleanMacro(RepeatTexture, bool);
  ///@}

  ///@{
  /**
   * Maximum number of pixels along the longer side of the picture in the page. Larger pictures are
   * scaled down. The number is in [1, 8192]. Default is 2048, a size that every phone supports.
   */
  vtkSetClampMacro(MaximumTextureSize, int, 1, 8192);
  vtkGetMacro(MaximumTextureSize, int);
  ///@}

  ///@{
  /**
   * JPEG quality of the picture. With 1, the page is smallest. With 100, the quality is best. In
   * [1, 100]. Default is 85.
   */
  vtkSetClampMacro(TextureQuality, int, 1, 100);
  vtkGetMacro(TextureQuality, int);
  ///@}

  ///@{
  /**
   * File name of three.js, release 111 or later, as a classic script or a CommonJS module:
   * three.min.js, three.js or three.cjs. If the name is empty (default), the library in the wheel
   * for pip is used, or otherwise the file of Debian's package libjs-three.
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

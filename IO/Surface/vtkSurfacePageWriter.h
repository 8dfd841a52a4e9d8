/**
 * @class   vtkSurfacePageWriter
 * @brief   write a web page that shows a surface and its sphere in any browser
 *
 * Write one file that needs no network. Surface and sphere rotate side by side, colored by a
 * picture or any point array. A point picked on one is marked on the other.
 *
 * Input port 0: vtkPolyData, the surface; polygons and strips are triangulated, vertices and lines
 * are left out.
 * - point array "SpherePosition" (float or double, 3 components): its map to the sphere.
 * - active texture coordinates of the points (float or double, 2 components): required with a
 *   picture. The surface must be cut along the picture's seams, by SplitSeam of
 *   vtkSphericalTextureMap.
 * - all other numeric point arrays: shown as colors with a legend. Arrays of 3 or 4 unsigned chars
 *   are colors themselves; other arrays of several components are shown by the length of their
 *   tuples. "Normals" and "vtkGhostType" are left out. Values that are not finite are shown as
 *   missing.
 *
 * Input port 1, optional: vtkImageData, the picture: one slice of unsigned char, 3 (RGB) or 4
 * (RGBA) components.
 *
 * The page is one file that needs no network, and sends nothing. It opens in any browser of 2023 or
 * later, also on phones. Surface and sphere rotate side by side, and a slider morphs the surface
 * into the sphere. A point picked on one is marked on the other, with its position, its values, and
 * its longitude and latitude as in vtkBodyMap. The title is the name of the file without the
 * ending.
 *
 * The page draws with three.js. The writer copies it into the page from its installation: package
 * libjs-three on Debian. A missing three.js is an error.
 *
 * Positions have 16 bits per coordinate, within the bounds of the surface. Positions on the sphere
 * have an error of at most 0.006 degrees. Values have an error of at most 1/65534 of their array's
 * range; integers are exact within a range of 4 * 10^9. With the picture as JPEG, a page of 64,002
 * points has at most 3 MB, unless it has many arrays. Each array adds up to 0.2 MB.
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
   * Name of the point array that the page shows first; a menu offers the others. If empty
   * (default): the picture, else the active colors, else the first array that is not constant.
   */
  vtkSetMacro(ColorArrayName, std::string);
  vtkGetMacro(ColorArrayName, std::string);
  ///@}

  ///@{
  /**
   * Direction from the model to the viewer when the page opens, in the coordinates of the model. Of
   * any length but 0. The middle of the sphere shows the first point of the surface along the line
   * of sight. Default is (0, 0, 1).
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * Direction that is up for the viewer, in the coordinates of the model. Of any length but 0, and
   * not parallel to ViewDirection. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Whether the picture repeats beyond the texture coordinates 0 and 1. Default is off: the color
   * of its border is used.
   */
  vtkSetMacro(RepeatTexture, bool);
  vtkGetMacro(RepeatTexture, bool);
  vtkBooleanMacro(RepeatTexture, bool);
  ///@}

  ///@{
  /**
   * Maximum number of pixels along the longer side of the picture in the page; larger pictures are
   * scaled down. In [1, 8192]. Default is 2048, which every phone supports.
   */
  vtkSetClampMacro(MaximumTextureSize, int, 1, 8192);
  vtkGetMacro(MaximumTextureSize, int);
  ///@}

  ///@{
  /**
   * JPEG quality of the picture: 1 is smallest, 100 is best. In [1, 100]. Default is 85.
   */
  vtkSetClampMacro(TextureQuality, int, 1, 100);
  vtkGetMacro(TextureQuality, int);
  ///@}

  ///@{
  /**
   * File name of three.js, release 111 or later, as a classic script or a CommonJS module:
   * three.min.js, three.js or three.cjs. If empty (default), that of Debian's package libjs-three.
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

/**
 * @class   vtkBodyMapImage
 * @brief   draw a map of a body: any array in one of four projections of the sphere
 *
 * Make an image of the whole body to which vtkBodyMap has given longitudes and latitudes. Point
 * arrays mark pixels beyond the outline of the map, and pixels on meridians and parallels.
 *
 * Input port 0: vtkPolyData, an output of vtkBodyMap, or any surface with the point array
 * "SpherePosition" (3 components) and the north pole (0, 0, 1). Polygons and strips are treated as
 * triangles.
 *
 * Output port 0: vtkImageData of ImageSize pixels, filled by the whole map. The coordinates of a
 * pixel are those of its middle on the map, so that origin and spacing are the values of a world
 * file. EQUIRECTANGULAR: degrees from the central meridian, and degrees of latitude. Other
 * projections: units of the sphere's radius.
 * - the drawn point array, as active scalars with the same name, type and components. Integers are
 *   rounded.
 * - point array "OutsideMap" (unsigned char): 1 beyond the outline of the map; values are 0 there.
 * - point array "OutsideSurface" (unsigned char): 1 beyond the outline and where the map to the
 *   sphere has a hole.
 * - point array "Graticule" (unsigned char), unless GraticuleSpacing is 0: 1 on meridians and
 *   parallels, one pixel wide. Meridians end at the last parallel, except every 90 degrees.
 * - point array "BodyPosition" (double, 3 components) with GeneratePositions: the point of the body
 *   that the pixel shows, the inverse of the map; 0 outside.
 *
 * A pixel shows the point of the body whose position on the sphere is the pixel's middle. Every
 * point of the body, whatever its shape, has a position on the map. Where many vertices share a
 * pixel, the image undersamples the surface.
 *
 * The image is not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008)). The quincuncial
 * projection is that of C. S. Peirce (1879), computed by an elliptic integral with complex
 * arguments (Carlson 1995); see Documentation/references.bib.
 *
 * @sa
 * vtkBodyMap vtkSphericalTextureImage vtkPNGWriter vtkTIFFWriter
 */

#ifndef vtkBodyMapImage_h
#define vtkBodyMapImage_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for ArrayName

class VTKFILTERSSHAPE_EXPORT vtkBodyMapImage : public vtkImageAlgorithm
{
public:
  static vtkBodyMapImage* New();
  vtkTypeMacro(vtkBodyMapImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Projections
  {
    EQUIRECTANGULAR = 0,
    LAMBERT_AZIMUTHAL = 1,
    MOLLWEIDE = 2,
    PEIRCE_QUINCUNCIAL = 3
  };

  ///@{
  /**
   * Name of the point array to draw. Empty (default) selects the active scalars.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Projection. EQUIRECTANGULAR (default): longitude and latitude, 2 : 1. LAMBERT_AZIMUTHAL: equal
   * areas, the northern hemisphere left and the southern right, 2 : 1. MOLLWEIDE: equal areas, an
   * ellipse, 2 : 1. PEIRCE_QUINCUNCIAL: equal angles, except at four points of the equator; a
   * square with the north pole in the middle and the south pole in its corners, 1 : 1.
   */
  vtkSetClampMacro(Projection, int, EQUIRECTANGULAR, PEIRCE_QUINCUNCIAL);
  vtkGetMacro(Projection, int);
  void SetProjectionToEquirectangular() { this->SetProjection(EQUIRECTANGULAR); }
  void SetProjectionToLambertAzimuthal() { this->SetProjection(LAMBERT_AZIMUTHAL); }
  void SetProjectionToMollweide() { this->SetProjection(MOLLWEIDE); }
  void SetProjectionToPeirceQuincuncial() { this->SetProjection(PEIRCE_QUINCUNCIAL); }
  ///@}

  ///@{
  /**
   * Meridian in the middle, in degrees. If a pole is in the middle, the meridian that runs down
   * from it. In [-360, 360]. Default is 0.
   */
  vtkSetClampMacro(CentralLongitude, double, -360.0, 360.0);
  vtkGetMacro(CentralLongitude, double);
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels. At least (1, 1); the number of pixels must fit into an
   * int. Default is (2000, 1000).
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /**
   * Angle between the lines of "Graticule", in degrees; 0 for none. In [0, 90]; values below 1 are
   * set to 0. Default is 15.
   */
  vtkSetClampMacro(GraticuleSpacing, double, 0.0, 90.0);
  vtkGetMacro(GraticuleSpacing, double);
  ///@}

  ///@{
  /**
   * Whether to add the point array "BodyPosition", the point of the body that each pixel shows.
   * Default is off.
   */
  vtkSetMacro(GeneratePositions, bool);
  vtkGetMacro(GeneratePositions, bool);
  vtkBooleanMacro(GeneratePositions, bool);
  ///@}

protected:
  vtkBodyMapImage() = default;
  ~vtkBodyMapImage() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBodyMapImage(const vtkBodyMapImage&) = delete;
  void operator=(const vtkBodyMapImage&) = delete;

  std::string ArrayName;
  int Projection = EQUIRECTANGULAR;
  double CentralLongitude = 0.0;
  int ImageSize[2] = { 2000, 1000 };
  double GraticuleSpacing = 15.0;
  bool GeneratePositions = false;
};

#endif

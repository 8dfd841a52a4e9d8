/**
 * @class   vtkBodyMapImage
 * @brief   draw a map of a body: any point array in one of six projections of the sphere
 *
 * Draw a map of a whole body for which vtkBodyMap has computed longitudes and latitudes. The map is
 * an image whose pixels show the values of a point array. Further point arrays mark pixels beyond
 * the outline of the map, and pixels on meridians and parallels.
 *
 * Input port 0: vtkPolyData, an output of vtkBodyMap, or any surface with the point array
 * "SpherePosition" (3 components). In this array, (0, 0, 1) is the north pole. Polygons and strips
 * are treated as triangles.
 *
 * Output port 0: vtkImageData of ImageSize pixels, which the map fills. The coordinates of a pixel
 * are the coordinates of its middle on the map. A world file, which defines the position of an
 * image on a map, can therefore contain the origin and spacing of this image. If Projection is
 * EQUIRECTANGULAR, the coordinates are degrees of longitude from the central meridian, and degrees
 * of latitude. For other projections, the unit is the radius of the sphere.
 * - active scalars: the drawn point array, with the same name, type and number of components.
 *   Integers of 1 component are labels: a pixel has the label of the nearest corner of its
 *   triangle. Other integers, such as colors, are rounded.
 * - point array "OutsideMap" (unsigned char): 1 beyond the outline of the map, otherwise 0. Where
 *   the value is 1, the drawn values are 0.
 * - point array "OutsideSurface" (unsigned char): 1 beyond the outline, and where the map to the
 *   sphere has a hole (no triangle of the surface is mapped there); otherwise 0.
 * - point array "Graticule" (unsigned char), unless GraticuleSpacing is 0: 1 on meridians and
 *   parallels, which are one pixel wide. Meridians at multiples of 90 degrees end at the poles. All
 *   other meridians end at the parallels nearest to the poles.
 * - point array "BodyPosition" (double, 3 components) only with GeneratePositions: the point of the
 *   body that the pixel shows; 0 outside of the map or the surface.
 * - point array "AreaScale" (double), only with GenerateAreaScale: the area of the body that the
 *   pixel shows, over the mean; 0 outside of the map or the surface.
 * - field data "AreaScaleRange" (2 values, double), only with GenerateAreaScale: pixels below the
 *   first scale show 5 percent of the body's area, and pixels above the second 5 percent.
 * - field data "CapsuleAspect" (double), only with Projection CAPSULE: ratio of length to diameter
 *   of the capsule. The unit of coordinates is the radius of the capsule.
 *
 * A pixel shows the point of the body whose position on the sphere is projected to the pixel's
 * middle. For any shape of the body, every point of the body has a position on the map. If many
 * vertices are mapped into one pixel, the image loses details of the surface.
 *
 * The image is not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008)). The projection
 * PEIRCE_QUINCUNCIAL is that of C. S. Peirce (1879), computed by an elliptic integral with complex
 * arguments (Carlson 1995); see Documentation/references.bib. The projection CAPSULE is our own.
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
    PEIRCE_QUINCUNCIAL = 3,
    MERCATOR = 4,
    CAPSULE = 5
  };

  enum CoordinateKinds
  {
    MAP = 0,
    PLANETOCENTRIC = 1
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
   * Projection of the sphere to the map, with the ratio of width to height. EQUIRECTANGULAR
   * (default): longitude and latitude, 2 : 1. LAMBERT_AZIMUTHAL: preserves areas; the northern
   * hemisphere is left, and the southern is right, 2 : 1. MOLLWEIDE: preserves areas; the map is an
   * ellipse, 2 : 1. PEIRCE_QUINCUNCIAL: preserves angles, except at four points of the equator; the
   * north pole is in the middle, and the south pole in the corners, 1 : 1. MERCATOR: preserves
   * angles; the map ends at latitudes of 85.05 degrees, 1 : 1. CAPSULE: for long bodies; see
   * CapsuleAspect.
   */
  vtkSetClampMacro(Projection, int, EQUIRECTANGULAR, CAPSULE);
  vtkGetMacro(Projection, int);
  void SetProjectionToEquirectangular() { this->SetProjection(EQUIRECTANGULAR); }
  void SetProjectionToLambertAzimuthal() { this->SetProjection(LAMBERT_AZIMUTHAL); }
  void SetProjectionToMollweide() { this->SetProjection(MOLLWEIDE); }
  void SetProjectionToPeirceQuincuncial() { this->SetProjection(PEIRCE_QUINCUNCIAL); }
  void SetProjectionToMercator() { this->SetProjection(MERCATOR); }
  void SetProjectionToCapsule() { this->SetProjection(CAPSULE); }
  ///@}

  ///@{
  /**
   * Coordinates of the map. MAP (default): longitude and latitude of the map to the sphere
   * ("SpherePosition"), which are one to one on bodies of any shape. PLANETOCENTRIC: longitude and
   * latitude of rays from the center of the body, as catalogs use them. A pixel then shows the
   * point farthest from the center. Other points on the same ray are not shown. The field arrays
   * "BodyCenter" and "BodyAxes" of vtkBodyMap determine center and directions. Without these
   * arrays, the center is (0, 0, 0), north is the z axis, and longitude 0 is towards the x axis.
   */
  vtkSetClampMacro(Coordinates, int, MAP, PLANETOCENTRIC);
  vtkGetMacro(Coordinates, int);
  void SetCoordinatesToMap() { this->SetCoordinates(MAP); }
  void SetCoordinatesToPlanetocentric() { this->SetCoordinates(PLANETOCENTRIC); }
  ///@}

  ///@{
  /**
   * Longitude of the meridian in the middle of the map, in degrees. If a pole is in the middle of
   * the map, this meridian runs from the pole towards the lower edge. In [-360, 360]. Default is 0.
   */
  vtkSetClampMacro(CentralLongitude, double, -360.0, 360.0);
  vtkGetMacro(CentralLongitude, double);
  ///@}

  ///@{
  /**
   * Ratio of length to diameter of the capsule, a cylinder with round ends, for Projection CAPSULE.
   * The sphere is mapped conformally to the capsule. The map shows the cylinder as a rectangle, and
   * the ends as disks above and below, in the middle of the image. On a body of this shape, pixels
   * show equal areas. With 0 (default), the aspect is that with which areas differ least from those
   * of the body; the field data "CapsuleAspect" of the map is its value. Set the aspect to draw
   * several bodies alike. In [1, 25]; values below 1 select the aspect automatically.
   */
  vtkSetClampMacro(CapsuleAspect, double, 0.0, 25.0);
  vtkGetMacro(CapsuleAspect, double);
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels. At least (1, 1). The number of pixels must fit into an
   * int. Default is (2000, 1000).
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /**
   * Angle between neighboring lines of the array "Graticule", in degrees. With 0, there are no
   * lines. In [0, 90]; values below 1 are set to 0. Default is 15.
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

  ///@{
  /**
   * Whether to add the point array "AreaScale", the area of the body that each pixel shows, over
   * the mean. The field data "AreaScaleRange" then state how much areas differ. Only with
   * Coordinates MAP. Default is off.
   */
  vtkSetMacro(GenerateAreaScale, bool);
  vtkGetMacro(GenerateAreaScale, bool);
  vtkBooleanMacro(GenerateAreaScale, bool);
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
  int Coordinates = MAP;
  double CentralLongitude = 0.0;
  double CapsuleAspect = 0.0;
  int ImageSize[2] = { 2000, 1000 };
  double GraticuleSpacing = 15.0;
  bool GeneratePositions = false;
  bool GenerateAreaScale = false;
};

#endif

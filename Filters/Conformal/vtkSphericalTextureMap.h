/**
 * @class   vtkSphericalTextureMap
 * @brief   compute texture coordinates from a map to the sphere, for a chosen view
 *
 * Add active texture coordinates to a mapped surface. A picture that is loaded as Texture in the
 * Display section then appears with its middle facing the ViewDirection. STEREOGRAPHIC is the
 * projection of section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008). Three
 * more projections hold the whole sphere.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components).
 * Polygons and strips are treated as triangles.
 *
 * Output port 0: the input, with point arrays
 * - "Texture Coordinates" (float, 2 components), active: s to the right and t upwards in the image.
 *   Finite everywhere, and in [0, 1] unless Wrap is REPEAT.
 * - "OutsideImage" (unsigned char, 1 component): 1 where the point lies outside of the image.
 *
 * With SplitSeam also
 * - point array "OriginalPointIds" (vtkIdType, 1 component): the input's point, or -1 for a point
 *   where an edge was cut. The input's points come first, in their order.
 * - cell array "OriginalCellIds" (vtkIdType, 1 component): the input's cell of which the triangle
 *   is a part. Cell data are copied, point data are interpolated on cut edges. Vertices and lines
 *   are left out.
 *
 * Field data define how the image is laid on the sphere:
 * - "SpherePole" (double, 3 components, unit vector): position of the image's middle on the sphere.
 * - "SphereUp", "SphereRight" (double, 3 components, unit vectors): directions on the sphere at the
 *   pole, towards the top and the right edge of the image.
 * - "TextureProjection" (vtkIdType, 1 component), "TextureFieldOfView", "TextureMargin" (double, 1
 *   component) and "TextureScale" (double, 2 components): the properties.
 *
 * A view of the model determines the pole. Stereographic projection maps the image to the sphere,
 * and the sphere to the surface: section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008). The projection is
 * conformal and most regular near the pole. The other projections hold the whole sphere in one
 * image.
 *
 * Implementation note: the paper specifies neither how a view determines the pole nor the rotation
 * of the image. Here the line of sight passes through the centroid of the surface's area, and the
 * pole is its first intersection with the surface. If the line misses the surface, the pole is the
 * surface's farthest point towards the viewer. With UseViewPoint, the pole is a chosen point. The
 * image is upright for the viewer and not mirrored, on average over a cap of an eighth of
 * FieldOfView around the pole.
 *
 * @sa
 * vtkSphericalTextureImage vtkCurvedSeamlessSurface vtkConformalSOM vtkTextureMapToSphere
 */

#ifndef vtkSphericalTextureMap_h
#define vtkSphericalTextureMap_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkSphericalTextureMap : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalTextureMap* New();
  vtkTypeMacro(vtkSphericalTextureMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Direction from the model to the viewer, in the coordinates of the model. Of any length but 0.
   * Default is (0, 0, 1).
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
   * Whether the pole is at ViewPoint, viewed along the surface's normal. Default is off: the pole
   * is where the line of sight in ViewDirection intersects the surface.
   */
  vtkSetMacro(UseViewPoint, bool);
  vtkGetMacro(UseViewPoint, bool);
  vtkBooleanMacro(UseViewPoint, bool);
  ///@}

  ///@{
  /**
   * Point on the model, such as a picked one; the closest point of the surface is the pole. Used
   * only with UseViewPoint. Default is (0, 0, 0).
   */
  vtkSetVector3Macro(ViewPoint, double);
  vtkGetVector3Macro(ViewPoint, double);
  ///@}

  /**
   * Projections of the sphere to the plane; Documentation/SphericalCoordinates.md has the formulas.
   */
  enum Projections
  {
    STEREOGRAPHIC = 0,
    LONGITUDE_LATITUDE = 1,
    OCTAHEDRAL = 2,
    CUBE_MAP = 3
  };

  ///@{
  /**
   * Projection of the image. STEREOGRAPHIC (default) is the paper's: conformal, for one picture
   * from one side. LONGITUDE_LATITUDE (images of 2 : 1), OCTAHEDRAL (1 : 1) and CUBE_MAP (3 : 2)
   * hold the whole sphere and have seams: use SplitSeam.
   */
  vtkSetClampMacro(Projection, int, STEREOGRAPHIC, CUBE_MAP);
  vtkGetMacro(Projection, int);
  void SetProjectionToStereographic() { this->SetProjection(STEREOGRAPHIC); }
  void SetProjectionToLongitudeLatitude() { this->SetProjection(LONGITUDE_LATITUDE); }
  void SetProjectionToOctahedral() { this->SetProjection(OCTAHEDRAL); }
  void SetProjectionToCubeMap() { this->SetProjection(CUBE_MAP); }
  ///@}

  ///@{
  /**
   * Angle on the sphere, in degrees, across the circle inscribed in the image. 180 puts that circle
   * on the equator: the image covers a hemisphere, and a little more in its corners. Used only by
   * STEREOGRAPHIC. In [0.001, 340]. Default is 180.
   */
  vtkSetClampMacro(FieldOfView, double, 0.001, 340.0);
  vtkGetMacro(FieldOfView, double);
  ///@}

  ///@{
  /**
   * Angle, in degrees, by which the image is rotated counter-clockwise about the pole, seen by the
   * viewer. Default is 0.
   */
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /**
   * Factors by which the image is widened and heightened about its middle. (1.5, 1) shows a picture
   * of 3 : 2 undistorted. In [0.001, 1000]. Default is (1, 1).
   */
  vtkSetVector2Macro(Scale, double);
  vtkGetVector2Macro(Scale, double);
  ///@}

  /**
   * Extensions of the image beyond its borders.
   */
  enum Wraps
  {
    CLAMP = 0,
    REPEAT = 1,
    MIRROR = 2
  };

  ///@{
  /**
   * Extension of the image beyond its borders. CLAMP (default): the color of the border. REPEAT:
   * the image again, with coordinates outside of [0, 1], for a repeating texture. MIRROR: the image
   * mirrored at its borders; SplitSeam cuts the surface there.
   */
  vtkSetClampMacro(Wrap, int, CLAMP, MIRROR);
  vtkGetMacro(Wrap, int);
  void SetWrapToClamp() { this->SetWrap(CLAMP); }
  void SetWrapToRepeat() { this->SetWrap(REPEAT); }
  void SetWrapToMirror() { this->SetWrap(MIRROR); }
  ///@}

  ///@{
  /**
   * Whether to cut the surface along the projection's seams and folds and along the image's
   * borders. Then no triangle shows the image backwards or squeezed. The output consists of
   * triangles and is no longer a closed mesh. Default is off.
   *
   * Points on the cuts are duplicated for each side, and "OutsideImage" is equal at all corners of
   * a triangle. STEREOGRAPHIC then has no image within 10 degrees of the opposite pole.
   */
  vtkSetMacro(SplitSeam, bool);
  vtkGetMacro(SplitSeam, bool);
  vtkBooleanMacro(SplitSeam, bool);
  ///@}

  ///@{
  /**
   * Margin along the seams of OCTAHEDRAL and CUBE_MAP, as a fraction of the side of the image
   * (CUBE_MAP: of a face). A renderer that interpolates between pixels then finds valid values
   * there, if the image has padding, as from vtkSphericalTextureImage. In [0, 0.25]. Default is 0.
   */
  vtkSetClampMacro(Margin, double, 0.0, 0.25);
  vtkGetMacro(Margin, double);
  ///@}

protected:
  vtkSphericalTextureMap() = default;
  ~vtkSphericalTextureMap() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalTextureMap(const vtkSphericalTextureMap&) = delete;
  void operator=(const vtkSphericalTextureMap&) = delete;

  double ViewDirection[3] = { 0.0, 0.0, 1.0 };
  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  bool UseViewPoint = false;
  double ViewPoint[3] = { 0.0, 0.0, 0.0 };
  int Projection = STEREOGRAPHIC;
  double FieldOfView = 180.0;
  double Rotation = 0.0;
  double Scale[2] = { 1.0, 1.0 };
  int Wrap = CLAMP;
  bool SplitSeam = false;
  double Margin = 0.0;
};

#endif

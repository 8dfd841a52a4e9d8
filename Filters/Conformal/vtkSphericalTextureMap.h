/**
 * @class   vtkSphericalTextureMap
 * @brief   compute texture coordinates from a map to the sphere, for a chosen view
 *
 * Compute texture coordinates of a surface from its map to the sphere, and make them active. If a
 * picture is the texture of the surface (in ParaView: Texture in the Display section), the middle
 * of the picture faces the ViewDirection. STEREOGRAPHIC is the projection of section 4.2 of C.-Y.
 * Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008). Three other projections show the
 * whole sphere in one image, and two show a hemisphere.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components).
 * Polygons and strips are treated as triangles.
 *
 * Output port 0: the input, with point arrays
 * - "Texture Coordinates" (float, 2 components), active: s to the right and t upward in the image.
 *   All values are finite. They are in [0, 1] unless Wrap is REPEAT.
 * - "OutsideImage" (unsigned char, 1 component): 1 for points outside of the image, otherwise 0.
 *
 * If AreaBalance is above 0, the output also has
 * - point array "TexturePosition" (double, 3 components): position of the point on the unit sphere
 *   by which the picture is placed. "SpherePosition" does not change.
 *
 * If SplitSeam is on, the output also has
 * - point array "OriginalPointIds" (vtkIdType, 1 component): id of the input's point, or -1 for a
 *   point where an edge was cut. Points of the input are first, in the sequence of the input.
 * - cell array "OriginalCellIds" (vtkIdType, 1 component): id of the input's cell of which the
 *   triangle is a part. Cell data are copied. Where edges are cut, point data are interpolated, but
 *   integers of 1 component are labels, and copied from the nearest corner of the triangle.
 * Vertices and lines are left out.
 *
 * Field data define the placement of the image on the sphere:
 * - "SpherePole" (double, 3 components, unit vector): position of the image's middle on the sphere.
 * - "SphereUp", "SphereRight" (double, 3 components, unit vectors): tangent directions of the
 *   sphere at SpherePole, towards the top and towards the right edge of the image.
 * - "TextureProjection" (vtkIdType, 1 component), "TextureFieldOfView", "TextureMargin",
 *   "TextureAreaBalance" (double, 1 component) and "TextureScale" (double, 2 components): values of
 *   the properties Projection, FieldOfView, Margin, AreaBalance and Scale.
 *
 * The pole is the point of the sphere at the middle of the image. A view of the model determines
 * the pole. Stereographic projection maps the image to the sphere. The inverse of the surface's map
 * then maps the sphere to the surface. This is the texture mapping in section 4.2 of C.-Y. Liou,
 * Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless surface",
 * Neurocomputing 71 (2008). Stereographic projection is conformal, and enlarges areas least near
 * the pole.
 *
 * Implementation note: the paper does not specify how a view determines the pole and the rotation
 * of the image. Here the line of sight passes through the centroid of the surface's area. The pole
 * is the position on the sphere of the first intersection of this line with the surface. If there
 * is no intersection, the vertex nearest to the viewer defines the pole. With UseViewPoint, the
 * point of the surface closest to ViewPoint defines the pole. The viewer sees the image unmirrored.
 * Before the property Rotation is applied, the image is also upright for the viewer, on average
 * over a cap around the pole. The radius of the cap is an eighth of FieldOfView.
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
   * Direction from the model to the viewer, in the coordinates of the model. The vector may have
   * any length but 0. Default is (0, 0, 1).
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
   * Whether the middle of the image is placed at ViewPoint, viewed along the surface's normal.
   * Default is off: the middle is placed where the line of sight in ViewDirection intersects the
   * surface.
   */
  vtkSetMacro(UseViewPoint, bool);
  vtkGetMacro(UseViewPoint, bool);
  vtkBooleanMacro(UseViewPoint, bool);
  ///@}

  ///@{
  /**
   * Point on the model, such as a picked point. The middle of the image is placed at the closest
   * point of the surface. Used only with UseViewPoint. Default is (0, 0, 0).
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
    CUBE_MAP = 3,
    DISK = 4,
    SQUARE = 5
  };

  ///@{
  /**
   * Projection of the image. STEREOGRAPHIC (default): the paper's conformal projection, for one
   * picture from one side. LONGITUDE_LATITUDE (images of 2 : 1), OCTAHEDRAL (1 : 1) and CUBE_MAP (3
   * : 2) show the whole sphere. These three projections have seams, at which the image is
   * discontinuous. SplitSeam cuts the surface along the seams.
   *
   * DISK and SQUARE (1 : 1) show the hemisphere z >= 0, to which vtkGlobalConformalMap and
   * vtkConformalSOM map surfaces with a border. The border of the surface is the circle inscribed
   * in the image, or the border of the image. Both projections are conformal, except for SQUARE at
   * the four corners. They do not use ViewDirection, ViewUp, ViewPoint and Rotation.
   */
  vtkSetClampMacro(Projection, int, STEREOGRAPHIC, SQUARE);
  vtkGetMacro(Projection, int);
  void SetProjectionToStereographic() { this->SetProjection(STEREOGRAPHIC); }
  void SetProjectionToLongitudeLatitude() { this->SetProjection(LONGITUDE_LATITUDE); }
  void SetProjectionToOctahedral() { this->SetProjection(OCTAHEDRAL); }
  void SetProjectionToCubeMap() { this->SetProjection(CUBE_MAP); }
  void SetProjectionToDisk() { this->SetProjection(DISK); }
  void SetProjectionToSquare() { this->SetProjection(SQUARE); }
  ///@}

  ///@{
  /**
   * Trade-off of the picture between angles (0) and areas (1). With 0 (default), the picture is
   * placed by "SpherePosition". If that map is conformal, the picture is not distorted, but long
   * parts of the surface get few pixels. With a larger value, the picture is placed by another map
   * of the surface, "TexturePosition", in which the pixels are distributed more evenly. With 0.5,
   * areas and angles are distorted moderately. In [0, 1].
   *
   * The map is computed as by vtkGlobalConformalMap, on about 8,000 samples of the surface. If the
   * input has the array "TexturePosition" of another vtkSphericalTextureMap with the same
   * AreaBalance, the array is used again. If "SpherePosition" does not cover the sphere exactly
   * once, there is a warning, and the picture is placed by "SpherePosition".
   */
  vtkSetClampMacro(AreaBalance, double, 0.0, 1.0);
  vtkGetMacro(AreaBalance, double);
  ///@}

  ///@{
  /**
   * Angle on the sphere, in degrees, that the inscribed circle of the image covers. With 180, the
   * circle is the equator: the image covers a hemisphere, and a little more in its corners. Used
   * only by STEREOGRAPHIC. In [0.001, 340]. Default is 180.
   */
  vtkSetClampMacro(FieldOfView, double, 0.001, 340.0);
  vtkGetMacro(FieldOfView, double);
  ///@}

  ///@{
  /**
   * Angle, in degrees, by which the image is rotated about its middle, counter-clockwise for the
   * viewer. Default is 0.
   */
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /**
   * Factors by which the width and the height of the image are scaled about its middle. For
   * example, use (1.5, 1) for a picture with the ratio 3 : 2 of width to height. The picture is
   * then not distorted. In [0.001, 1000]. Default is (1, 1).
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
   * Extension of the image beyond its borders. CLAMP (default): the color of the border continues.
   * REPEAT: the image is repeated; texture coordinates are then also outside of [0, 1], and the
   * texture must be set to repeat. MIRROR: the image is mirrored at its borders. SplitSeam then
   * cuts the surface along the borders.
   */
  vtkSetClampMacro(Wrap, int, CLAMP, MIRROR);
  vtkGetMacro(Wrap, int);
  void SetWrapToClamp() { this->SetWrap(CLAMP); }
  void SetWrapToRepeat() { this->SetWrap(REPEAT); }
  void SetWrapToMirror() { this->SetWrap(MIRROR); }
  ///@}

  ///@{
  /**
   * Whether to cut the surface along the projection's seams (where the image is discontinuous) and
   * folds (where the image is not smooth), and along the image's borders. Without cuts, triangles
   * that cross a seam show a large part of the image squeezed or mirrored. With cuts, the output
   * consists of triangles and is not a closed mesh. Default is off.
   *
   * Points on a cut are duplicated, so that each side of the cut has its own points. With cuts,
   * "OutsideImage" is equal at all corners of a triangle. With STEREOGRAPHIC, the region within 10
   * degrees of the point opposite to the pole is then outside of the image.
   */
  vtkSetMacro(SplitSeam, bool);
  vtkGetMacro(SplitSeam, bool);
  vtkBooleanMacro(SplitSeam, bool);
  ///@}

  ///@{
  /**
   * Width of the margin along the seams of OCTAHEDRAL and CUBE_MAP, as a fraction of the side of
   * the image (for CUBE_MAP: of a face). In an image of vtkSphericalTextureImage, the margin has
   * the values of the other side of the seam. The seam is thus invisible, even if the renderer
   * interpolates between pixels. In [0, 0.25]. Default is 0.
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
  double AreaBalance = 0.0;
};

#endif

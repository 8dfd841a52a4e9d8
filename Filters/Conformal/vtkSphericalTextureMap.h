/**
 * @class   vtkSphericalTextureMap
 * @brief   compute texture coordinates from a map to the sphere, for a chosen view
 *
 * Give a mapped surface texture coordinates, which become its active ones: load a picture as
 * Texture in the Display section and it shows, its middle facing the ViewDirection. Section 4.2
 * of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008), and three projections that
 * hold all of the sphere.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components).
 * Polygons and strips are treated as triangles.
 *
 * Output port 0: the input, with point arrays
 * - "Texture Coordinates" (float, 2 components): s to the right and t upwards in the image, finite
 *   everywhere and in [0, 1] unless Wrap is REPEAT; the active texture coordinates.
 * - "OutsideImage" (unsigned char, 1 component): 1 where the image does not reach.
 *
 * With SplitSeam also
 * - point array "OriginalPointIds" (vtkIdType, 1 component): the point of the input that each is,
 * or -1 for a point where an edge was cut. The input's points come first, in their order.
 * - cell array "OriginalCellIds" (vtkIdType, 1 component): the cell of the input that each triangle
 *   is a part of. Cell data are copied, point data interpolated on cut edges. Vertices and lines
 * are left out.
 *
 * and field data, which say how the image lies on the sphere,
 * - "SpherePole" (double, 3 components, unit vector): the place of the image's middle, as the
 *   projections have it.
 * - "SphereUp", "SphereRight" (likewise): directions on the sphere there, towards the top and the
 *   right edge of the image.
 * - "TextureProjection" (vtkIdType, 1 component), "TextureFieldOfView", "TextureMargin" (double,
 *   1 component) and "TextureScale" (double, 2 components): the properties.
 *
 * The view of the model chooses the pole, the image goes to the sphere by stereographic projection
 * and from the sphere to the surface: section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008). The projection is
 * conformal and most regular near the pole. The other projections hold all of the sphere in one
 * image.
 *
 * Implementation note: the paper leaves open how a view chooses the pole and how the image is
 * turned. Here the pole is the point met first by a viewer looking along the line through the
 * centroid of the surface's area (or, should that line miss the surface, its farthest point that
 * way), or a point picked by the user. The image stands upright for the viewer and is not mirrored,
 * in the mean over a cap of an eighth of FieldOfView around the pole.
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
   * Direction from the model to the viewer, in the coordinates of the model. Of any length, but not
   * zero. Default is (0, 0, 1).
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
   * Whether the pole is at ViewPoint, seen along the surface's normal there, instead of where the
   * view in ViewDirection meets the surface. Default is off.
   */
  vtkSetMacro(UseViewPoint, bool);
  vtkGetMacro(UseViewPoint, bool);
  vtkBooleanMacro(UseViewPoint, bool);
  ///@}

  ///@{
  /**
   * A point on the model, as a picker returns it; the closest point of the surface is taken. Only
   * with UseViewPoint. Default is (0, 0, 0).
   */
  vtkSetVector3Macro(ViewPoint, double);
  vtkGetVector3Macro(ViewPoint, double);
  ///@}

  /** How the sphere becomes a plane; SphericalCoordinates.md has the formulas. */
  enum Projections
  {
    STEREOGRAPHIC = 0,
    LONGITUDE_LATITUDE = 1,
    OCTAHEDRAL = 2,
    CUBE_MAP = 3
  };

  ///@{
  /**
   * Projection of the image. STEREOGRAPHIC is the paper's: conformal, for one picture seen from one
   * side. LONGITUDE_LATITUDE (images of 2 : 1), OCTAHEDRAL (1 : 1) and CUBE_MAP (3 : 2) hold all of
   * the sphere, and have seams: use SplitSeam. Default is STEREOGRAPHIC.
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
   * Degrees of the sphere from one side to the other of the circle inscribed in the image. 180 lays
   * that circle on the equator, so that the image covers a hemisphere and a little more in its
   * corners. Only for STEREOGRAPHIC. In [0.001, 340]. Default is 180.
   */
  vtkSetClampMacro(FieldOfView, double, 0.001, 340.0);
  vtkGetMacro(FieldOfView, double);
  ///@}

  ///@{
  /**
   * Degrees by which the viewer sees the image turned counter-clockwise about the pole. Default is
   * 0.
   */
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /**
   * Factors by which the image is wider and higher, about its middle. (1.5, 1) shows a picture of
   * 3 : 2 undistorted. In [0.001, 1000]. Default is (1, 1).
   */
  vtkSetVector2Macro(Scale, double);
  vtkGetVector2Macro(Scale, double);
  ///@}

  /** What is to be seen where the image does not reach. */
  enum Wraps
  {
    CLAMP = 0,
    REPEAT = 1,
    MIRROR = 2
  };

  ///@{
  /**
   * What lies where the image does not reach. CLAMP (default): the border of the image. REPEAT: the
   * image again; its coordinates go on beyond [0, 1], for a texture that repeats. MIRROR: the image
   * mirrored at its borders, where SplitSeam cuts the surface.
   */
  vtkSetClampMacro(Wrap, int, CLAMP, MIRROR);
  vtkGetMacro(Wrap, int);
  void SetWrapToClamp() { this->SetWrap(CLAMP); }
  void SetWrapToRepeat() { this->SetWrap(REPEAT); }
  void SetWrapToMirror() { this->SetWrap(MIRROR); }
  ///@}

  ///@{
  /**
   * Whether to cut the surface along the projection's seams and folds and the image's borders, so
   * that no triangle shows the image backwards or squeezed. The output consists of triangles and is
   * no closed mesh any more. Default is off.
   *
   * The points there get a copy for each side, and "OutsideImage" is the same at all corners of
   * each triangle. STEREOGRAPHIC then has no image within 10 degrees of the opposite pole.
   */
  vtkSetMacro(SplitSeam, bool);
  vtkGetMacro(SplitSeam, bool);
  vtkBooleanMacro(SplitSeam, bool);
  ///@}

  ///@{
  /**
   * Share of the image's side (CUBE_MAP: of a face's) left free along the seams of OCTAHEDRAL and
   * CUBE_MAP, so that a renderer that mixes neighboring pixels finds what belongs there, if the
   * image was made for it, as vtkSphericalTextureImage does. In [0, 0.25]. Default is 0.
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

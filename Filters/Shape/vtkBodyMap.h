/**
 * @class   vtkBodyMap
 * @brief   give a mapped body longitudes and latitudes, heights and slopes
 *
 * Transform the surface's map to the sphere, the point array "SpherePosition". Its poles come to
 * lie on the rotation axis, and longitude 0 passes through a marker. The second output has
 * meridians and parallels on the body. The third output has places given by longitude and latitude.
 * These coordinates are neither planetocentric nor planetographic.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components), as
 * written by vtkGlobalConformalMap. Polygons and strips are treated as triangles.
 *
 * Input port 1, optional: vtkPolyData with points on the map: outlines, paths, landing sites. x is
 * the longitude and y the latitude, in degrees.
 *
 * Output port 0: the input of port 0, with point arrays (double)
 * - "SpherePosition" (3 components): the same map, after a transform that preserves angles. The
 *   north pole is (0, 0, 1), longitude 0 lies towards (1, 0, 0).
 * - "Longitude" in [0, 360), to the east, in degrees.
 * - "Latitude" in [-90, 90], in degrees.
 * - "Height": distance from the center of a reference ellipsoid or sphere, minus that of the
 *   reference in the same direction.
 * - "Slope": angle between the normals of surface and reference, in degrees, in [0, 180].
 *
 * Output port 1: vtkPolyData, meridians and parallels on the body as polylines, with cell arrays
 * - "IsMeridian" (vtkIdType): 1 for a meridian, 0 for a parallel.
 * - "Degrees" (double): longitude of the meridian, or latitude of the parallel.
 *
 * Output port 2: the input of port 1 with its points on the body, by the inverse of the map.
 *
 * Field data of port 0 (double): "BodyNorthPole", "BodySouthPole", "BodyMarker" (3 components) are
 * points of the body. "ReferenceCenter", "ReferenceRadii" (3 components) and "ReferenceAxes" (9
 * components, axis by axis) describe the reference.
 *
 * The poles are the intersections of the rotation axis with the surface that are farthest from
 * Center on either side. East is counter-clockwise around the north pole seen from outside, even if
 * the map was mirrored. The transform balances the body's area between north and south, weighted by
 * the sine of the latitude.
 *
 * @note These are coordinates of a map, one to one on bodies of any shape. On such bodies a
 * direction from a center may intersect the surface several times or not at all. The coordinates
 * are neither planetocentric nor planetographic: latitude is no angle at the center or at the axis,
 * longitude is no angle of rotation, and degrees have no common length. They depend on the mesh and
 * on the chosen map. Do not mix them with coordinates of a catalog. See Documentation/Filters.md.
 *
 * The coordinates are not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008)).
 *
 * @sa
 * vtkBodyMapImage vtkGlobalConformalMap vtkSphericalTextureMap
 */

#ifndef vtkBodyMap_h
#define vtkBodyMap_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkAlgorithmOutput;

class VTKFILTERSSHAPE_EXPORT vtkBodyMap : public vtkPolyDataAlgorithm
{
public:
  static vtkBodyMap* New();
  vtkTypeMacro(vtkBodyMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum References
  {
    SPHERE = 0,
    ELLIPSOID = 1
  };

  ///@{
  /**
   * Places on the map, to be put on the body: x is the longitude, y the latitude, in degrees.
   */
  void SetPlacesConnection(vtkAlgorithmOutput* algOutput);
  void SetPlacesData(vtkPolyData* places);
  ///@}

  ///@{
  /**
   * A point of the rotation axis, inside the body. Default is (0, 0, 0).
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Direction of the rotation axis to the north, of any length but 0. Default is (0, 0, 1).
   */
  vtkSetVector3Macro(RotationAxis, double);
  vtkGetVector3Macro(RotationAxis, double);
  ///@}

  ///@{
  /**
   * Whether longitude 0 passes through the point of the surface closest to MarkerPoint. Default is
   * off: it passes through the point farthest from Center in a direction perpendicular to the axis,
   * the projection of x (or of y if the axis is x).
   */
  vtkSetMacro(UseMarkerPoint, bool);
  vtkGetMacro(UseMarkerPoint, bool);
  vtkBooleanMacro(UseMarkerPoint, bool);
  ///@}

  ///@{
  /**
   * Marker of longitude 0, which passes through the point of the surface closest to this one. Used
   * only with UseMarkerPoint. Default is (1, 0, 0).
   */
  vtkSetVector3Macro(MarkerPoint, double);
  vtkGetVector3Macro(MarkerPoint, double);
  ///@}

  ///@{
  /**
   * Reference of heights and slopes. SPHERE: the sphere around the center of the body's volume with
   * the same volume. ELLIPSOID (default): an ellipsoid of that center and volume with the body's
   * axes of inertia, its radii in the ratio of the moments.
   */
  vtkSetClampMacro(Reference, int, SPHERE, ELLIPSOID);
  vtkGetMacro(Reference, int);
  void SetReferenceToSphere() { this->SetReference(SPHERE); }
  void SetReferenceToEllipsoid() { this->SetReference(ELLIPSOID); }
  ///@}

  ///@{
  /**
   * Angle between meridians, and between parallels, on output port 1, in degrees. In [1, 90].
   * Default is 15.
   */
  vtkSetClampMacro(GraticuleSpacing, double, 1.0, 90.0);
  vtkGetMacro(GraticuleSpacing, double);
  ///@}

protected:
  vtkBodyMap();
  ~vtkBodyMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBodyMap(const vtkBodyMap&) = delete;
  void operator=(const vtkBodyMap&) = delete;

  double Center[3] = { 0.0, 0.0, 0.0 };
  double RotationAxis[3] = { 0.0, 0.0, 1.0 };
  bool UseMarkerPoint = false;
  double MarkerPoint[3] = { 1.0, 0.0, 0.0 };
  int Reference = ELLIPSOID;
  double GraticuleSpacing = 15.0;
};

#endif

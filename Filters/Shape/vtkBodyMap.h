/**
 * @class   vtkBodyMap
 * @brief   compute longitudes, latitudes, heights and slopes on a mapped body, such as an asteroid
 *
 * Compute longitude, latitude, height and slope at each point of a body that is mapped to the
 * sphere. The map is the point array "SpherePosition". The filter transforms the map so that the
 * poles are on the rotation axis. Longitude 0 passes through a marker, a chosen point of the body.
 * The second output has meridians and parallels on the body. The third output has the positions on
 * the body of given places, such as landing sites. The places are given by longitude and latitude.
 * These longitudes and latitudes are neither planetocentric nor planetographic.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components), such
 * as the output of vtkGlobalConformalMap. Polygons and strips are treated as triangles.
 *
 * Input port 1, optional: vtkPolyData, places on the map, such as outlines, paths or landing sites.
 * The coordinate x of a point is its longitude, and y is its latitude, in degrees.
 *
 * Output port 0: the input of port 0, with point arrays (double)
 * - "SpherePosition" (3 components): the map of the input, after a transform that preserves angles.
 *   The north pole is (0, 0, 1). Longitude 0 is towards (1, 0, 0).
 * - "Longitude": longitude, increasing to the east, in degrees, in [0, 360).
 * - "Latitude": latitude, in degrees, in [-90, 90].
 * - "Height": height of the point over the reference, an ellipsoid or sphere with the volume of the
 *   body (property Reference). The height is the distance of the point from the center of the
 *   reference, minus the radius of the reference in the direction of the point. For the volume, a
 *   hole of the surface is closed by a cone to the mean of the vertices. With large holes, heights
 *   and slopes thus depend on the mesh.
 * - "Slope": angle between the normals of the surface and of the reference, in degrees, in [0,
 *   180].
 *
 * - "PlanetocentricLongitude": longitude of the direction from Center to the point, increasing to
 *   the east, in degrees, in [0, 360). Longitude 0 is towards the marker, see UseMarkerPoint.
 * - "PlanetocentricLatitude": angle between this direction and the equator, in degrees, in [-90,
 *   90].
 * - "Radius": distance of the point from Center.
 *
 * Output port 1: vtkPolyData, meridians and parallels on the body as polylines, with cell arrays
 * - "IsMeridian" (vtkIdType): 1 for a meridian, 0 for a parallel.
 * - "Degrees" (double): longitude of the meridian, or latitude of the parallel.
 *
 * Output port 2: the input of port 1, with each point moved to its position on the body. The
 * inverse of the map gives this position.
 *
 * Field data of port 0 (double): "BodyNorthPole", "BodySouthPole" and "BodyMarker" (3 components)
 * are the positions of the poles and of the marker on the body. "ReferenceCenter", "ReferenceRadii"
 * (3 components) and "ReferenceAxes" (9 components, axis by axis) describe the reference.
 * "BodyCenter" (3 components) and "BodyAxes" (9 components: the directions of longitude 0, of
 * longitude 90 degrees and of north) describe the planetocentric coordinates.
 *
 * The rotation axis passes through Center. The poles are intersections of the rotation axis with
 * the surface. On each side of Center, the intersection farthest from Center is the pole. East is
 * counter-clockwise around the north pole seen from outside, even if the input's map reverses the
 * orientation. The transform balances north and south: the mean of the sine of the latitude over
 * the area of the body is 0.
 *
 * @note Longitude and latitude are coordinates of a map to the sphere. These coordinates are one to
 * one on bodies of any shape, even if a ray from the center intersects the surface several times.
 * The coordinates are neither planetocentric nor planetographic. Latitude is not an angle at the
 * center or at the axis, and longitude is not an angle of rotation. The length of a degree differs
 * from place to place. The coordinates depend on the mesh and on the chosen map. Do not combine
 * these coordinates with coordinates of a catalog. For catalogs, use the planetocentric arrays. See
 * Documentation/Filters.md.
 *
 * This method is an own construction of the project. The coordinates are not part of the paper
 * (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless surface",
 * Neurocomputing 71 (2008)).
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
   * Set the places whose positions on the body are computed. The coordinate x of a point is its
   * longitude, and y is its latitude, in degrees.
   */
  void SetPlacesConnection(vtkAlgorithmOutput* algOutput);
  void SetPlacesData(vtkPolyData* places);
  ///@}

  ///@{
  /**
   * Point on the rotation axis, inside the body. Default is (0, 0, 0).
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Direction of the rotation axis towards the north pole. The vector may have any length but 0.
   * Default is (0, 0, 1).
   */
  vtkSetVector3Macro(RotationAxis, double);
  vtkGetVector3Macro(RotationAxis, double);
  ///@}

  ///@{
  /**
   * Whether longitude 0 passes through the point of the surface closest to MarkerPoint. Default is
   * off: longitude 0 passes through the farthest intersection of the surface with a ray from
   * Center. The direction of this ray is perpendicular to the rotation axis, as close as possible
   * to the x axis. If the rotation axis is the x axis, the y axis is used instead.
   */
  vtkSetMacro(UseMarkerPoint, bool);
  vtkGetMacro(UseMarkerPoint, bool);
  vtkBooleanMacro(UseMarkerPoint, bool);
  ///@}

  ///@{
  /**
   * Marker: longitude 0 passes through the point of the surface closest to this position. Used only
   * with UseMarkerPoint. Default is (1, 0, 0).
   */
  vtkSetVector3Macro(MarkerPoint, double);
  vtkGetVector3Macro(MarkerPoint, double);
  ///@}

  ///@{
  /**
   * Reference surface for heights and slopes. SPHERE: the sphere whose volume and centroid are
   * those of the body. ELLIPSOID (default): an ellipsoid with the volume and centroid of the body.
   * The axes of the ellipsoid are the body's principal axes of inertia. The radii are proportional
   * to the square roots of the body's second moments along these axes.
   */
  vtkSetClampMacro(Reference, int, SPHERE, ELLIPSOID);
  vtkGetMacro(Reference, int);
  void SetReferenceToSphere() { this->SetReference(SPHERE); }
  void SetReferenceToEllipsoid() { this->SetReference(ELLIPSOID); }
  ///@}

  ///@{
  /**
   * Angle between neighboring meridians, and between neighboring parallels, on output port 1, in
   * degrees. In [1, 90]. Default is 15.
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

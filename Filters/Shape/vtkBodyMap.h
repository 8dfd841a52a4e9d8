/**
 * @class   vtkBodyMap
 * @brief   give a mapped body longitudes and latitudes, heights and slopes
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components), as
 * vtkGlobalConformalMap writes it. Polygons and strips are treated as triangles.
 *
 * Input port 1, optional: vtkPolyData whose points are places on the map, x the longitude and y the
 * latitude in degrees: outlines, paths, landing sites.
 *
 * Output port 0: the input of port 0, with point arrays (double)
 * - "SpherePosition" (3 components): the same map, turned and moved by a transform that keeps
 *   angles. The north pole is (0, 0, 1), longitude 0 lies towards (1, 0, 0).
 * - "Longitude" in [0, 360), to the east, and "Latitude" in [-90, 90], in degrees.
 * - "Height": distance from the center of a reference ellipsoid or sphere, less that of the
 *   reference in that direction. "Slope": degrees between the normals of surface and reference
 *   there, in [0, 180].
 *
 * Output port 1: vtkPolyData, meridians and parallels on the body as polylines, with cell arrays
 * "IsMeridian" (vtkIdType) and "Degrees" (double): its longitude, or latitude.
 *
 * Output port 2: the input of port 1, its points put on the body: the inverse of the map.
 *
 * Field data of port 0 (double): "BodyNorthPole", "BodySouthPole", "BodyMarker" (3 components):
 * points of the body; "ReferenceCenter", "ReferenceRadii" (3 components), "ReferenceAxes" (9
 * components, the three axes one after the other).
 *
 * The poles are where the rotation axis leaves the surface, farthest from Center to both sides.
 * East is counter-clockwise around the north pole seen from outside, also if the map was mirrored.
 * The transform is the one with as much of the body's area to the north as to the south, each part
 * weighted by the sine of its latitude.
 *
 * @note
 * These are coordinates of a map, one to one on bodies of any shape, where directions from a center
 * meet a surface several times or not at all. They are not planetocentric or planetographic ones:
 * latitude is no angle at the center nor at the axis, longitudes are no angles of rotation, and
 * degrees have no common length. They depend on the mesh and on the map that was chosen, and must
 * not be exchanged for those of a catalog. See Documentation/Filters.md.
 *
 * Not in the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved
 * seamless surface", Neurocomputing 71 (2008)).
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
   * Places on the map to put on the body: input port 1.
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
   * Whether longitude 0 goes through the point of the surface closest to MarkerPoint. Default is
   * off: through the one farthest from Center in the direction of x (of y if the axis is x), made
   * perpendicular to the axis.
   */
  vtkSetMacro(UseMarkerPoint, bool);
  vtkGetMacro(UseMarkerPoint, bool);
  vtkBooleanMacro(UseMarkerPoint, bool);
  ///@}

  ///@{
  /**
   * See UseMarkerPoint. Default is (1, 0, 0).
   */
  vtkSetVector3Macro(MarkerPoint, double);
  vtkGetVector3Macro(MarkerPoint, double);
  ///@}

  ///@{
  /**
   * What heights and slopes are measured from: the SPHERE around the middle of the body's volume
   * that has its volume, or the ELLIPSOID that also has its axes of inertia, with radii in the
   * ratio of its moments. Default is ELLIPSOID.
   */
  vtkSetClampMacro(Reference, int, SPHERE, ELLIPSOID);
  vtkGetMacro(Reference, int);
  void SetReferenceToSphere() { this->SetReference(SPHERE); }
  void SetReferenceToEllipsoid() { this->SetReference(ELLIPSOID); }
  ///@}

  ///@{
  /**
   * Degrees between the lines of output port 1. In [1, 90]. Default is 15.
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

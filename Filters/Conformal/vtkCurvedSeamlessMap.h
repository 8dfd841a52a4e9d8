/**
 * @class   vtkCurvedSeamlessMap
 * @brief   evaluate a curved seamless surface (CSS) anywhere, with derivatives and the inverse map
 *
 * The filter vtkCurvedSeamlessSurface samples a smooth, closed surface in finitely many directions.
 * This class evaluates the surface in any direction. A direction is a point of the unit sphere.
 * Each direction corresponds to one point of the surface. ToSurface() maps a direction to this
 * point and its normal. Differentiate() computes derivatives, metric tensors and area elements.
 * ToSphere() maps a point near the surface to the direction of the closest point of the surface. No
 * pipeline is needed.
 *
 * Build() needs a vtkPolyData, a closed surface of genus zero from vtkConformalSOM or any other
 * source. Polygons and strips are cut into triangles. Coincident points of open edges (edges of
 * only one triangle) are merged, triangles are oriented consistently, and isolated points are
 * dropped. Each kind of change causes one warning. The surface has
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. The map must cover the sphere exactly once.
 * - field array "VertexShift" (1 component, optional, at least 1 tuple): shift of the vertices
 *   before the triangles are curved, see the property VertexShift of vtkCurvedSeamlessSurface.
 *
 * The array arguments of one call must be distinct arrays. It is an error if an array of the
 * surface has a different number of tuples than the surface has points or cells.
 *
 * The surface is made by the CSS algorithm of Section 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang,
 * "Conformal self-organizing map on curved seamless surface", Neurocomputing 71 (2008).
 * Schwarz-Christoffel maps are conformal maps of triangles, Eqs. 4 and 5. For each flat triangle in
 * space, the algorithm uses a Schwarz-Christoffel map between this triangle and the flat triangle
 * of its corners on the sphere.
 *
 * Implementation note: a dome is the curved patch that replaces a flat triangle. The property
 * DomeHeight of vtkCurvedSeamlessSurface selects the shape of the domes. In the published
 * algorithm, the maps of two neighboring triangles differ along their common edge. Published domes
 * bulge outward everywhere, even where the surface is concave. To reproduce the published maps and
 * domes, set SeamMode of vtkCurvedSeamlessSurface to PER_TRIANGLE, and DomeHeight to PUBLISHED. By
 * default, the map is continuous and one to one across all edges, and domes follow the curvature of
 * the surface.
 *
 * @sa
 * vtkCurvedSeamlessSurface vtkConformalSOM
 */

#ifndef vtkCurvedSeamlessMap_h
#define vtkCurvedSeamlessMap_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for std::shared_ptr

class vtkDataArray;
class vtkDoubleArray;
class vtkPointSet;
class vtkPolyData;

namespace conformal
{
class CurvedSeamlessSurface;
}

namespace glue
{
struct BuiltSurface;
struct CurvedSeamlessProperties;
}

class VTKFILTERSCONFORMAL_EXPORT vtkCurvedSeamlessMap : public vtkObject
{
public:
  static vtkCurvedSeamlessMap* New();
  vtkTypeMacro(vtkCurvedSeamlessMap, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Build the map of a surface with the default properties of vtkCurvedSeamlessSurface. For other
   * properties, call vtkCurvedSeamlessSurface::BuildMap(). If the surface is not valid, an error is
   * reported, no map is built, and the function returns false.
   */
  bool Build(vtkPolyData* surface);

  /**
   * Return whether a map has been built.
   */
  bool IsBuilt() const { return this->Map != nullptr; }

  /**
   * Map directions (3 components, of any length but 0) to positions on the surface and outward unit
   * normals, each with 3 components. If the property DomeHeight (shape of the curved patches) is
   * CURVATURE, the default, or FITTED, the normals are shading normals, which are continuous across
   * edges. Otherwise the normals are those of the flat triangles. If there is no map, or a
   * direction is not valid, an error is reported and the function returns false.
   */
  bool ToSurface(
    vtkDataArray* directions, vtkDoubleArray* positions, vtkDoubleArray* normals = nullptr);

  /**
   * Compute derivatives of the positions. Let J be the matrix of derivatives of the position with
   * respect to the unit direction. The product of J and the direction is 0. Argument `derivatives`
   * gets J (9 components, row by row), and `metrics` gets the metric tensor J^T J (9 components).
   * Argument `areaElements` gets the ratio of area on the surface to area on the unit sphere (1
   * component). Null arguments are skipped. If DomeHeight is PUBLISHED or SCALED, derivatives do
   * not exist, since these domes have ridges. The function then reports an error and returns false.
   */
  bool Differentiate(vtkDataArray* directions, vtkDoubleArray* derivatives,
    vtkDoubleArray* metrics = nullptr, vtkDoubleArray* areaElements = nullptr);

  /**
   * Map points on or near the surface to unit directions. The direction of a point is the direction
   * of the closest point of the surface. If `closestPoints` is not null, this array gets the
   * closest points. If DomeHeight is PUBLISHED or SCALED, the inverse does not exist. The function
   * then reports an error and returns false.
   */
  bool ToSphere(
    vtkDataArray* points, vtkDoubleArray* directions, vtkDoubleArray* closestPoints = nullptr);

  /**
   * Return the number of triangles for which the usual construction of the map or the dome fails. A
   * triangle without area in space or on the sphere is mapped affinely. If DomeHeight is CURVATURE
   * or FITTED, a dome that would fold over is replaced by the flat triangle. If DomeHeight is
   * PUBLISHED or SCALED, triangles whose normal is opposite to that of a neighbor are also counted.
   */
  vtkIdType GetNumberOfDegeneratePatches();

  /**
   * Return the mean and the maximum angle, in degrees, between the normals on the two sides of an
   * edge, over all edges. Normals here are perpendicular to the curved surface, unlike the shading
   * normals of ToSurface(). Both angles are 0 if there is no map, or if DomeHeight is PUBLISHED or
   * SCALED.
   */
  void GetNormalJumps(double jumps[2]);

#ifndef __VTK_WRAP__
  /**
   * Use a map that a filter of this module has built. If the argument is null, remove the map.
   */
  void Take(std::shared_ptr<const glue::BuiltSurface> map);

  /**
   * Build the map of a surface with given properties. If DomeHeight is FITTED, the cloud is
   * required. Otherwise, the cloud may be null.
   */
  bool Build(
    const glue::CurvedSeamlessProperties& properties, vtkPolyData* surface, vtkPointSet* cloud);
#endif

protected:
  vtkCurvedSeamlessMap();
  ~vtkCurvedSeamlessMap() override;

private:
  vtkCurvedSeamlessMap(const vtkCurvedSeamlessMap&) = delete;
  void operator=(const vtkCurvedSeamlessMap&) = delete;

  const conformal::CurvedSeamlessSurface& Built() const;

  std::shared_ptr<const glue::BuiltSurface> Map;
};

#endif

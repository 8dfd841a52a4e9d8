/**
 * @class   vtkCurvedSeamlessMap
 * @brief   evaluate a curved seamless surface anywhere, with derivatives and the inverse map (CSS)
 *
 * Evaluate the surface that vtkCurvedSeamlessSurface samples, as a function. Map a direction to its
 * point of the surface, with normal, derivatives, metric tensor and area element. Map a point near
 * the surface to its direction. No pipeline is needed.
 *
 * Build() takes a vtkPolyData, a closed surface of genus zero from vtkConformalSOM or any other
 * source. Polygons and strips are cut into triangles. Coincident points of open edges are merged,
 * triangles are oriented consistently, and isolated points are dropped, each with one warning.
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. The map must cover the sphere exactly once.
 * - field array "VertexShift" (1 component, optional, at least 1 tuple): see VertexShift of
 *   vtkCurvedSeamlessSurface.
 *
 * The array arguments of one call must be distinct arrays. Arrays that do not fit the points or
 * cells of the surface or the cloud are an error.
 *
 * This is the CSS algorithm of Section 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), with
 * Schwarz-Christoffel maps between the flat triangles (Eqs. 4 and 5).
 *
 * Implementation note: as published, the maps of two triangles differ along their common edge. The
 * published domes of the unit sphere rise outwards everywhere, in hollows too. SeamMode
 * PER_TRIANGLE and DomeHeight PUBLISHED of vtkCurvedSeamlessSurface reproduce both. The defaults
 * are one map that is continuous and one to one across all edges, and domes that follow the
 * surface's own curvature.
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
   * properties call vtkCurvedSeamlessSurface::BuildMap(). Returns false, with an error and without
   * a map, if the surface is not valid.
   */
  bool Build(vtkPolyData* surface);

  /**
   * Return whether a map has been built.
   */
  bool IsBuilt() const { return this->Map != nullptr; }

  /**
   * Map directions (3 components, of any length but 0) to positions on the surface and outward unit
   * normals, each with 3 components. With CURVATURE and FITTED the normals are shading normals,
   * which are continuous across edges; otherwise they are those of the flat triangles. Returns
   * false, with an error, if there is no map or a direction is not valid.
   */
  bool ToSurface(
    vtkDataArray* directions, vtkDoubleArray* positions, vtkDoubleArray* normals = nullptr);

  /**
   * Compute derivatives of the positions. J (9 components, row by row) is the derivative with
   * respect to the unit direction; its product with the direction itself is 0. The metric tensor is
   * J^T J (9 components). The area element (1 component) is area on the surface per area on the
   * unit sphere. Null arguments are skipped. Not available with PUBLISHED and SCALED, whose domes
   * have ridges.
   */
  bool Differentiate(vtkDataArray* directions, vtkDoubleArray* derivatives,
    vtkDoubleArray* metrics = nullptr, vtkDoubleArray* areaElements = nullptr);

  /**
   * Map points on or near the surface to unit directions. Optionally return the closest points of
   * the surface, to which these directions belong. Not available with PUBLISHED and SCALED.
   */
  bool ToSphere(
    vtkDataArray* points, vtkDoubleArray* directions, vtkDoubleArray* closestPoints = nullptr);

  /**
   * Return the number of triangles where the construction is replaced. Triangles degenerate in
   * space or on the sphere are mapped affinely. With CURVATURE and FITTED, patches that would turn
   * over are flattened. With PUBLISHED and SCALED, triangles with a neighbor that faces the
   * opposite way count, too.
   */
  vtkIdType GetNumberOfDegeneratePatches();

  /**
   * Return the mean and the maximum angle, in degrees, between the surface's own normals on the two
   * sides of an edge, over all edges. Both are 0 without a map or with PUBLISHED and SCALED.
   */
  void GetNormalJumps(double jumps[2]);

#ifndef __VTK_WRAP__
  /**
   * Use a map that a filter of this module has built; null removes the map.
   */
  void Take(std::shared_ptr<const glue::BuiltSurface> map);

  /**
   * Build the map of a surface, as Build(), with given properties.
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

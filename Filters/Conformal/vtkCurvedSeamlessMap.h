/**
 * @class   vtkCurvedSeamlessMap
 * @brief   evaluate a curved seamless surface anywhere, with derivatives and the inverse map (CSS)
 *
 * What vtkCurvedSeamlessSurface samples, as a function: of any direction its point of the surface,
 * with normal, derivatives, metric tensor and area element; of any point near the surface its
 * direction. No pipeline is needed.
 *
 * Build() takes a vtkPolyData, a closed surface of genus zero, of a vtkConformalSOM or any other
 * origin. Polygons and strips are cut into triangles. Coincident points of open edges are merged,
 * triangles turned to agree with each other, isolated points dropped, each with one warning.
 * - point array "SpherePosition" (3 components, of any length but 0): where on the sphere the point
 *   lies. The map must cover the sphere exactly once.
 * - field array "VertexShift" (1 component, optional, at least 1 tuple): see VertexShift of
 *   vtkCurvedSeamlessSurface.
 *
 * The arrays of a call must be different ones. Arrays that do not fit the points or cells of the
 * surface or the cloud are an error.
 *
 * This is the CSS algorithm of Section 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), with
 * Schwarz-Christoffel maps between the flat triangles (Eqs. 4 and 5).
 *
 * Implementation note: as published the maps of two triangles differ along their common edge, and
 * the domes of the unit sphere rise outwards everywhere, in hollows too. SeamMode PER_TRIANGLE and
 * DomeHeight PUBLISHED of vtkCurvedSeamlessSurface do it as published. The defaults are one map
 * that is continuous and one to one across all edges, and domes that follow the surface's own
 * curvature.
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
   * a map, if the surface has none.
   */
  bool Build(vtkPolyData* surface);

  /**
   * Whether there is a map.
   */
  bool IsBuilt() const { return this->Map != nullptr; }

  /**
   * From directions (3 components, of any length but 0) to positions on the surface and outward
   * unit normals, each with 3 components. With CURVATURE and FITTED these normals are those for
   * shading, continuous across edges; else those of the flat triangles. Returns false, with an
   * error, if there is no map or a direction is none.
   */
  bool ToSurface(
    vtkDataArray* directions, vtkDoubleArray* positions, vtkDoubleArray* normals = nullptr);

  /**
   * Derivatives J of the positions with the unit direction (9 components, row by row; along the
   * direction itself nothing changes), metric tensors J^T J (9 components) and area elements (1
   * component: area on the surface for area on the unit sphere). What is null is left out. Not with
   * PUBLISHED and SCALED, whose domes have ridges.
   */
  bool Differentiate(vtkDataArray* directions, vtkDoubleArray* derivatives,
    vtkDoubleArray* metrics = nullptr, vtkDoubleArray* areaElements = nullptr);

  /**
   * From points on the surface, or near it, to unit directions, and if wanted the closest points of
   * the surface, whose directions these are. Not with PUBLISHED and SCALED.
   */
  bool ToSphere(
    vtkDataArray* points, vtkDoubleArray* directions, vtkDoubleArray* closestPoints = nullptr);

  /**
   * Triangles of the surface where the construction is replaced: without a shape in space or on the
   * sphere, mapped affinely; with CURVATURE and FITTED those that would turn over, and are flatter;
   * with PUBLISHED and SCALED those with a neighbor that faces the opposite way.
   */
  vtkIdType GetNumberOfDegeneratePatches();

  /**
   * Mean and largest angle, in degrees, between the surface's own normals on the two sides of an
   * edge, along all edges; both 0 without a map or with PUBLISHED and SCALED.
   */
  void GetNormalJumps(double jumps[2]);

#ifndef __VTK_WRAP__
  /**
   * The map as a filter of this module has built it; none for null.
   */
  void Take(std::shared_ptr<const glue::BuiltSurface> map);

  /**
   * Build the map of a surface with given properties, as Build().
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

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
 * - field array "Polished" (1 component, optional, at least 1 tuple): whether the triangles were
 *   fitted to points by least squares, see the property Polished.
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
 * DomeHeight PUBLISHED do it as published. The defaults are one map that is continuous and one to
 * one across all edges, and domes that follow the surface's own curvature.
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
}

class VTKFILTERSCONFORMAL_EXPORT vtkCurvedSeamlessMap : public vtkObject
{
public:
  static vtkCurvedSeamlessMap* New();
  vtkTypeMacro(vtkCurvedSeamlessMap, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SeamModes
  {
    PER_TRIANGLE = 0,
    EDGE_MATCHED = 1
  };

  enum DomeHeights
  {
    NONE = 0,
    PUBLISHED = 1,
    SCALED = 2,
    CURVATURE = 3,
    FITTED = 4
  };

  enum PolishedModes
  {
    AUTOMATIC = 0,
    OFF = 1,
    ON = 2
  };

  ///@{
  /**
   * How the maps of neighboring triangles meet. EDGE_MATCHED (default): as one map, continuous
   * across every edge and vertex. PER_TRIANGLE: as published, each for itself, with a jump along
   * the common edge.
   */
  vtkSetClampMacro(SeamMode, int, PER_TRIANGLE, EDGE_MATCHED);
  vtkGetMacro(SeamMode, int);
  void SetSeamModeToPerTriangle() { this->SetSeamMode(PER_TRIANGLE); }
  void SetSeamModeToEdgeMatched() { this->SetSeamMode(EDGE_MATCHED); }
  ///@}

  ///@{
  /**
   * What is raised over the flat triangles. NONE: nothing. PUBLISHED: the domes of the unit sphere,
   * times the model's largest distance from the mean of its points, outwards everywhere. SCALED:
   * the same in proportion to the model's size around the place. CURVATURE (default): PN triangles
   * on the mean normals of the vertices, outwards on ridges and inwards in hollows. FITTED: the
   * same with positions and normals fitted to a cloud of points by least squares.
   */
  vtkSetClampMacro(DomeHeight, int, NONE, FITTED);
  vtkGetMacro(DomeHeight, int);
  void SetDomeHeightToNone() { this->SetDomeHeight(NONE); }
  void SetDomeHeightToPublished() { this->SetDomeHeight(PUBLISHED); }
  void SetDomeHeightToScaled() { this->SetDomeHeight(SCALED); }
  void SetDomeHeightToCurvature() { this->SetDomeHeight(CURVATURE); }
  void SetDomeHeightToFitted() { this->SetDomeHeight(FITTED); }
  ///@}

  ///@{
  /**
   * CURVATURE and FITTED: whether the flat triangles of the mesh were fitted to points by least
   * squares, as vtkConformalSOM does in batch training. If so, the vertices are moved by
   * VertexShift; if not, the surface goes through them. AUTOMATIC (default) reads the field array
   * "Polished" of the mesh, which vtkConformalSOM writes. Without this array the mesh is taken as
   * not polished; there is a warning if it has the connectivity of a geodesic sphere or even
   * triangles, as the meshes of vtkConformalSOM have, since the array may have been lost, for
   * instance in a file.
   */
  vtkSetClampMacro(Polished, int, AUTOMATIC, ON);
  vtkGetMacro(Polished, int);
  void SetPolishedToAutomatic() { this->SetPolished(AUTOMATIC); }
  void SetPolishedToOff() { this->SetPolished(OFF); }
  void SetPolishedToOn() { this->SetPolished(ON); }
  ///@}

  ///@{
  /**
   * CURVATURE and FITTED, for a polished mesh: how far its vertices are moved, as a share of what
   * would keep the volume under the surface. Triangles fitted to points lie in the middle of these,
   * their vertices outside of ridges; curved triangles through the vertices would lie too far out.
   * In [0, 2], or negative (default): the number in the field array "VertexShift" of the mesh,
   * which vtkConformalSOM finds from the points, or 1 where there is none. With 0 the surface goes
   * through the points of the mesh.
   */
  vtkSetClampMacro(VertexShift, double, -1.0, 2.0);
  vtkGetMacro(VertexShift, double);
  ///@}

  ///@{
  /**
   * FITTED: how often the closest points of the cloud's points are looked up and the surface drawn
   * to them. In [0, 100]. Default is 6.
   */
  vtkSetClampMacro(NumberOfFitRounds, int, 0, 100);
  vtkGetMacro(NumberOfFitRounds, int);
  ///@}

  ///@{
  /**
   * FITTED: weight of a smooth surface against a close one, per point of a vertex. In [0, 1000].
   * Default is 0.01; more irons out noise.
   */
  vtkSetClampMacro(FitSmoothness, double, 0.0, 1000.0);
  vtkGetMacro(FitSmoothness, double);
  ///@}

  /**
   * Make the map of a surface by the properties as they are now. The cloud is used by DomeHeight
   * FITTED only. Returns false, with an error and without a map, if the surface has none.
   */
  bool Build(vtkPolyData* surface, vtkPointSet* cloud = nullptr);

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
#endif

protected:
  vtkCurvedSeamlessMap();
  ~vtkCurvedSeamlessMap() override;

private:
  vtkCurvedSeamlessMap(const vtkCurvedSeamlessMap&) = delete;
  void operator=(const vtkCurvedSeamlessMap&) = delete;

  const conformal::CurvedSeamlessSurface& Built() const;

  int SeamMode = EDGE_MATCHED;
  int DomeHeight = CURVATURE;
  int Polished = AUTOMATIC;
  double VertexShift = -1.0;
  int NumberOfFitRounds = 6;
  double FitSmoothness = 0.01;
  std::shared_ptr<const glue::BuiltSurface> Map;
};

#endif

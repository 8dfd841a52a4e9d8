/**
 * @class   vtkSurfaceGeodesics
 * @brief   measure distances along a surface from points, and divide the surface among them
 *
 * Measure geodesic distances: lengths of shortest paths on a surface. Sources are points of the
 * surface from which distances are measured.
 *
 * Input port 0: vtkPolyData, any surface. It may have borders, several parts, thin triangles, and
 * edges of more than two triangles. Polygons and strips are treated as triangles. Triangles with a
 * repeated point are ignored.
 *
 * Input port 1: vtkPointSet, optional. Each of its points adds the nearest point of the surface to
 * the sources, such as points that were picked.
 *
 * Input port 2: vtkPointSet, optional. The nearest point of the surface to each of its points is
 * the start of a path, see output port 2.
 *
 * Other sources are the points where the array SourceArrayName is not 0, and the points of
 * AddSourceId(). NumberOfFarthestPoints adds points that are far from all others, for example for
 * samples that are spread evenly. Connected parts without a source are farther than all others. If
 * there are no sources, there is an error.
 *
 * Output port 0: the input, with point arrays
 * - "GeodesicDistance" (double, 1 component): distance from the nearest source, in units of length;
 *   -1 at points that are not connected with a source, and at points without triangles.
 * - "NearestSource" (idtype, 1 component): point id of the nearest source; -1 where the distance is
 *   -1. Points with the same value are the Voronoi cell of a source.
 *
 * Output port 1: vtkPolyData, the sources as vertices: first those of port 1, then those of
 * AddSourceId(), then those of the array, then the farthest points. Point array "SourceId"
 * (idtype): point id on the surface.
 *
 * Output port 2: vtkPolyData, a polyline for each point of input port 2 that is connected with a
 * source. The path crosses triangles in any direction, and is straight across edges. With Method
 * EXACT, it is a shortest path. Otherwise, it is locally shortest, and the shorter one of two
 * paths: found from the shortest path along edges, and from the path on which "GeodesicDistance"
 * decreases most. Cell arrays "TargetId" and "SourceId" (idtype): point ids of both ends;
 * "PathLength" (double): length. If there are paths, or Method is EXACT, each edge of the surface
 * must have at most two triangles, consistently oriented.
 *
 * With Method HEAT, distances are computed by the heat method (K. Crane, C. Weischedel, M.
 * Wardetzky, "Geodesics in Heat", ACM Transactions on Graphics 32 (2013)) on the intrinsic Delaunay
 * triangulation (M. Fisher et al., "An algorithm for the construction of intrinsic Delaunay
 * triangulations", Computing 81 (2007)). Two systems of equations are factored once for each
 * surface. On a sphere of 100,000 points, the mean error is 0.6 %. A vertex belongs to the nearest
 * source of the neighbor that is next on its path, so that borders of cells are exact to about one
 * edge.
 *
 * With Method EXACT, distances are computed by continuing straight paths across triangles (J. Chen,
 * Y. Han, "Shortest Paths on a Polyhedron" (1990); S.-Q. Xin, G.-J. Wang, "Improving Chen and Han's
 * Algorithm on the Discrete Geodesic Problem", ACM Transactions on Graphics 28 (2009)). They are
 * exact for the surface of flat triangles, except for rounding errors.
 *
 * Paths of Method HEAT are locally shortest by the criterion of N. Sharp, K. Crane, "You Can Find
 * Geodesic Paths in Triangle Meshes by Just Flipping Edges", ACM Transactions on Graphics 39
 * (2020). vtkDijkstraGraphGeodesicPath finds paths along edges, which are longer by several
 * percent.
 *
 * @sa
 * vtkSurfaceShape vtkBodyMap
 */

#ifndef vtkSurfaceGeodesics_h
#define vtkSurfaceGeodesics_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for names
#include <vector> // for ids

class vtkPointSet;

class VTKFILTERSSHAPE_EXPORT vtkSurfaceGeodesics : public vtkPolyDataAlgorithm
{
public:
  /**
   * Methods to measure distances.
   */
  enum MethodType
  {
    HEAT,
    EXACT
  };

  static vtkSurfaceGeodesics* New();
  vtkTypeMacro(vtkSurfaceGeodesics, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Method to measure distances and find paths. HEAT has errors of about 1 percent from
   * one source, and more from many: 3 percent from 100 points on a sphere of 10,242 points, and up
   * to 19 percent at some points. Its cost for each set of sources is low, and proportional to the
   * number of points. If HEAT fails, there is an error, as for corners of 1,000 thin triangles.
   * EXACT has only rounding errors. Its cost is many times higher, and grows faster than the number
   * of points. Default is HEAT.
   *
   * NumberOfFarthestPoints uses HEAT with both methods.
   */
  vtkSetClampMacro(Method, int, HEAT, EXACT);
  vtkGetMacro(Method, int);
  void SetMethodToHeat() { this->SetMethod(HEAT); }
  void SetMethodToExact() { this->SetMethod(EXACT); }
  ///@}

  ///@{
  /**
   * Connect or set the points of input port 1, each of which adds the nearest point of the surface
   * to the sources.
   */
  void SetSourcesConnection(vtkAlgorithmOutput* algOutput);
  void SetSourcesData(vtkPointSet* sources);
  ///@}

  ///@{
  /**
   * Connect or set the points of input port 2, from which paths start.
   */
  void SetTargetsConnection(vtkAlgorithmOutput* algOutput);
  void SetTargetsData(vtkPointSet* targets);
  ///@}

  ///@{
  /**
   * Add the id of a point of the surface to the sources. Default is none.
   */
  void AddSourceId(vtkIdType id);
  void RemoveAllSourceIds();
  int GetNumberOfSourceIds() { return static_cast<int>(this->SourceIds.size()); }
  ///@}

  ///@{
  /**
   * Name of a point array with 1 component. Points where it is not 0 are sources. Default is none.
   */
  vtkSetMacro(SourceArrayName, std::string);
  vtkGetMacro(SourceArrayName, std::string);
  ///@}

  ///@{
  /**
   * Number of points to add to the sources, one after the other: the point of the surface that is
   * farthest from all sources so far. If there is no other source, the first one is the point
   * farthest from the center of the surface. In [0, 100000]. Default is 0.
   */
  vtkSetClampMacro(NumberOfFarthestPoints, int, 0, 100000);
  vtkGetMacro(NumberOfFarthestPoints, int);
  ///@}

  /**
   * Return the sources, output port 1.
   */
  vtkPolyData* GetSources();

  /**
   * Return the paths, output port 2.
   */
  vtkPolyData* GetPaths();

protected:
  vtkSurfaceGeodesics();
  ~vtkSurfaceGeodesics() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceGeodesics(const vtkSurfaceGeodesics&) = delete;
  void operator=(const vtkSurfaceGeodesics&) = delete;

  int Method = HEAT;
  std::vector<vtkIdType> SourceIds;
  std::string SourceArrayName;
  int NumberOfFarthestPoints = 0;
};

#endif

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
 * Other sources are the points where the array SourceArrayName is not 0, and the points of
 * AddSourceId(). NumberOfFarthestPoints adds points that are far from all others, for example for
 * samples that are spread evenly. If there are no sources, there is an error.
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
 * Distances are computed by the heat method (K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in
 * Heat", ACM Transactions on Graphics 32 (2013)) on the intrinsic Delaunay triangulation (M. Fisher
 * et al., "An algorithm for the construction of intrinsic Delaunay triangulations", Computing 81
 * (2007)). Two systems of equations are factored once for each surface. On a sphere of 100,000
 * points, the mean error is 0.6 %. A vertex belongs to the nearest source of the neighbor that is
 * next on its path, so that borders of cells are exact to about one edge.
 *
 * vtkDijkstraGraphGeodesicPath measures paths along edges, which are longer by several percent.
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
  static vtkSurfaceGeodesics* New();
  vtkTypeMacro(vtkSurfaceGeodesics, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

protected:
  vtkSurfaceGeodesics();
  ~vtkSurfaceGeodesics() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceGeodesics(const vtkSurfaceGeodesics&) = delete;
  void operator=(const vtkSurfaceGeodesics&) = delete;

  std::vector<vtkIdType> SourceIds;
  std::string SourceArrayName;
  int NumberOfFarthestPoints = 0;
};

#endif

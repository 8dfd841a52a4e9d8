/**
 * @class   vtkCurvedSeamlessSurface
 * @brief   make a curved seamless surface (CSS), smooth and dense, from a mesh mapped to the sphere
 *
 * Make a smooth, dense, closed surface from a mesh that is mapped to the sphere, such as the output
 * of vtkConformalSOM. The method is the CSS (curved seamless surface) algorithm of section 3 of
 * C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008). The surface has the point arrays
 * "SpherePosition", its map to the sphere, and "Normals".
 *
 * Input port 0: vtkPolyData, a closed surface of genus zero from vtkConformalSOM or any other
 * source. Polygons and strips are cut into triangles. Coincident points of open edges (edges of
 * only one triangle) are merged, triangles are oriented consistently, and isolated points are
 * dropped. Each kind of change causes one warning. The surface has
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. The map must cover the sphere exactly once.
 * - field array "VertexShift" (1 component, optional, at least 1 tuple): shift of the vertices
 *   before the triangles are curved, see the property VertexShift.
 *
 * Input port 1 (optional): vtkPolyData, a dense mesh of the sphere. Positions on the unit sphere
 * are called directions. Each point of this mesh has a direction, in which the surface is
 * evaluated. The output gets the triangles of this mesh. The directions are the point array
 * "SpherePosition" (3 components) or, without this array, the coordinates. Without this input, the
 * property Sampling determines where the surface is evaluated.
 *
 * Input port 2 (optional): vtkPointSet, the point cloud to which the surface is fitted if
 * DomeHeight is FITTED. Points with non-finite coordinates are left out with a warning, and ghost
 * points without a warning.
 *
 * Output port 0: vtkPolyData, the smooth, dense surface, in the coordinates of input port 0, double
 * precision.
 * - point array "SpherePosition" (double, 3 components): position of each point on the unit sphere.
 * - point array "Normals" (double, 3 components): outward unit normals. If DomeHeight is CURVATURE
 *   or FITTED, they are shading normals, which are continuous across the edges of the input's
 *   triangles. Otherwise they are area-weighted means of the triangle normals around each point. If
 *   a mean is 0, the normal of the input's flat triangle is used instead. If this triangle has no
 *   area, SpherePosition is used.
 * - point array "Supported" (double, 1 component), only if input port 0 has this array: the
 *   interpolated values. vtkConformalSOM describes the array.
 * - cell array "Degenerate" (unsigned char): 1 for triangles in a degenerate triangle of input port
 *   0, otherwise 0. NumberOfDegeneratePatches, below, defines degenerate triangles. If Sampling is
 *   NETWORK, the value is 1 for each part of a degenerate triangle. Otherwise it is 1 for each
 *   triangle with at least one point in a degenerate triangle.
 * - field array "NumberOfDegeneratePatches" (vtkIdType): number of degenerate triangles of input
 *   port 0, for which the usual construction of the map or the dome (curved patch, see DomeHeight)
 *   fails. If the number is not 0, there is a warning. A triangle without area in space or on the
 *   sphere is mapped affinely. If DomeHeight is CURVATURE or FITTED, a dome that would fold over is
 *   replaced by the flat triangle. If DomeHeight is PUBLISHED or SCALED, triangles whose normal is
 *   opposite to that of a neighbor are also counted.
 *
 * The surface is computed by steps 1 to 11 of the algorithm in Section 3 of C.-Y. Liou, Y.-T. Kuo,
 * J.-C. Huang, "Conformal self-organizing map on curved seamless surface", Neurocomputing 71
 * (2008). Schwarz-Christoffel maps are conformal maps of triangles, Eqs. 4 and 5. For each flat
 * triangle in space, the algorithm uses a Schwarz-Christoffel map between this triangle and the
 * flat triangle of its corners on the sphere.
 *
 * Implementation note: a dome is the curved patch that replaces a flat triangle. In the published
 * algorithm, the maps of two neighboring triangles differ along their common edge. The published
 * domes do not bring the surface closer to the object. Published maps and domes are available as
 * SeamMode PER_TRIANGLE and DomeHeight PUBLISHED. By default, the map is continuous and one to one
 * across all edges, and domes follow the curvature of the surface. GetMap() returns a map that
 * evaluates the surface in any direction.
 *
 * @sa
 * vtkCurvedSeamlessMap vtkConformalSOM vtkGeodesicSphereSource vtkGenusZeroCheck
 * vtkSphericalTextureMap
 */

#ifndef vtkCurvedSeamlessSurface_h
#define vtkCurvedSeamlessSurface_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkNew.h"                    // for vtkNew
#include "vtkPolyDataAlgorithm.h"

class vtkCurvedSeamlessMap;
class vtkMultiProcessController;
class vtkPointSet;

class VTKFILTERSCONFORMAL_EXPORT vtkCurvedSeamlessSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkCurvedSeamlessSurface* New();
  vtkTypeMacro(vtkCurvedSeamlessSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Set the mesh of the sphere on input port 1, called N^new in the paper. The surface is evaluated
   * in the directions of the points of this mesh. The output gets the triangles of this mesh.
   * Without this mesh, the property Sampling determines the points. If Sampling is NETWORK, the
   * mesh is not used.
   */
  void SetSphereConnection(vtkAlgorithmOutput* output);

  /**
   * Set the dense mesh of the sphere without a pipeline connection.
   */
  void SetSphereData(vtkPolyData* sphere);

  enum Samplings
  {
    AUTOMATIC = 0,
    DIRECTIONS = 1,
    NETWORK = 2
  };

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

  ///@{
  /**
   * Distribution of the points of the output. DIRECTIONS: at the points of the mesh on input port
   * 1; without this mesh, evenly over the sphere. NETWORK: in every triangle of input port 0, so
   * that limbs that are small on the sphere also get points. AUTOMATIC (default): DIRECTIONS if
   * input port 1 has a mesh, or if input port 0 is a geodesic mesh of vtkConformalSOM; otherwise
   * NETWORK.
   *
   * Without a mesh on input port 1, DIRECTIONS evaluates the surface at the points of a geodesic
   * sphere (vtkGeodesicSphereSource) of the given Frequency. NETWORK divides each triangle on the
   * sphere into k x k triangles, where k is given by Subdivisions. In the output, the points of
   * input port 0 are first, followed by points on edges, and then by points inside triangles.
   * NETWORK does not use input port 1.
   */
  vtkSetClampMacro(Sampling, int, AUTOMATIC, NETWORK);
  vtkGetMacro(Sampling, int);
  void SetSamplingToAutomatic() { this->SetSampling(AUTOMATIC); }
  void SetSamplingToDirections() { this->SetSampling(DIRECTIONS); }
  void SetSamplingToNetwork() { this->SetSampling(NETWORK); }
  ///@}

  ///@{
  /**
   * Frequency f of a geodesic sphere (subdivided icosahedron). If Sampling is DIRECTIONS and input
   * port 1 has no mesh, the surface has 10 f^2 + 2 points and 20 f^2 triangles. If Sampling is
   * NETWORK and Subdivisions is 0, the surface has at least 10 f^2 + 2 points. In [1, 1000].
   * Default is 80, which gives 64,002 points.
   *
   * The positions of the input's points on the sphere may themselves form a geodesic sphere. If f
   * is a multiple of the frequency of that sphere, no triangle of the output crosses an edge of the
   * input.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Number k of parts into which each edge of the input's mesh is divided if Sampling is NETWORK. A
   * mesh of N points and 2 N - 4 triangles gives (N - 2) k^2 + 2 points and (2 N - 4) k^2
   * triangles. 0 (default): the smallest k that gives at least 10 f^2 + 2 points, where f is the
   * Frequency. For a mesh of 12,962 points, this is k = 3, which gives 116,642 points. In [0, 100].
   */
  vtkSetClampMacro(Subdivisions, int, 0, 100);
  vtkGetMacro(Subdivisions, int);
  ///@}

  /**
   * Set the point cloud to which the surface is fitted if DomeHeight is FITTED. Other values of
   * DomeHeight do not use the cloud.
   */
  void SetCloudConnection(vtkAlgorithmOutput* output);

  /**
   * Set the point cloud for DomeHeight FITTED without a pipeline connection.
   */
  void SetCloudData(vtkPointSet* cloud);

  ///@{
  /**
   * Controller of the processes that share the point cloud if DomeHeight is FITTED. Each process
   * runs this filter on its own piece of the cloud, which may be empty. The first process that has
   * a surface on input port 0 provides the surface. This surface is fitted to the points of all
   * processes. The result is equal bit by bit for any number of processes. Only the process that
   * provided the surface gets the result; the other processes get an empty surface. All processes
   * get the map. For other values of DomeHeight, each process makes the surface of its own input.
   * Default is the global controller. With null, only the cloud of this process is used.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Continuity of the map across the edges of the input's triangles. EDGE_MATCHED (default): the
   * map is continuous across edges. PER_TRIANGLE: each triangle has a separate map, as in the
   * paper. The maps of two triangles differ along their common edge.
   */
  vtkSetClampMacro(SeamMode, int, PER_TRIANGLE, EDGE_MATCHED);
  vtkGetMacro(SeamMode, int);
  void SetSeamModeToPerTriangle() { this->SetSeamMode(PER_TRIANGLE); }
  void SetSeamModeToEdgeMatched() { this->SetSeamMode(EDGE_MATCHED); }
  ///@}

  ///@{
  /**
   * Shape of the domes, the curved patches that replace the flat triangles. CURVATURE (default):
   * domes follow the normals of the mesh. They bulge outward where the surface is convex, and
   * inward where the surface is concave. FITTED: domes are fitted to the point cloud on input port
   * 2. PUBLISHED and SCALED: domes of the paper, which bulge outward everywhere. NONE: flat
   * triangles.
   *
   * CURVATURE makes PN triangles (curved point-normal triangles) from the mean normals of the
   * vertices. FITTED fits positions and normals of the vertices by least squares. The paper
   * computes the heights of domes on the unit sphere. PUBLISHED multiplies these heights by the
   * largest distance of a point of the mesh from the mean of its points. SCALED multiplies them by
   * the local size of the mesh.
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
   * Factor of a shift of the vertices before the triangles are curved. Use the shift for a mesh
   * that was fitted to points. A value of 1 shifts the vertices so that the curved triangles
   * enclose the same volume as the flat triangles. With 0, the surface passes through the vertices
   * of the mesh. In [-1, 2]. With a negative value (default), the value is read from the mesh's
   * field array "VertexShift", which vtkConformalSOM writes. Without this array, the value is 0.
   *
   * Flat triangles that are fitted by least squares pass through the middle of the points. Where
   * the object is convex, their vertices are therefore outside of the object. Curved triangles
   * through these vertices (CURVATURE and FITTED) would be too far outside. Many file formats do
   * not store the array "VertexShift". If the array is missing and the mesh resembles an output of
   * vtkConformalSOM, there is a warning. The mesh resembles such an output if it has the
   * connectivity of a geodesic sphere, or triangles of equal size. A value of 1 is then usually
   * suitable.
   */
  vtkSetClampMacro(VertexShift, double, -1.0, 2.0);
  vtkGetMacro(VertexShift, double);
  ///@}

  ///@{
  /**
   * Number of rounds of the fit if DomeHeight is FITTED. Each round finds the point of the surface
   * that is closest to each point of the cloud, and then fits the surface. In [0, 100]. Default is
   * 6.
   */
  vtkSetClampMacro(NumberOfFitRounds, int, 0, 100);
  vtkGetMacro(NumberOfFitRounds, int);
  ///@}

  ///@{
  /**
   * Weight of the smoothness term of the fit if DomeHeight is FITTED. The unit is the mean total
   * weight of the cloud's points at one vertex. In [0, 1000]. Default is 0.01. Larger values smooth
   * noise.
   */
  vtkSetClampMacro(FitSmoothness, double, 0.0, 1000.0);
  vtkGetMacro(FitSmoothness, double);
  ///@}

  /**
   * Return the map that evaluates the surface in any direction. The output of the last Update()
   * consists of samples of this map. Before the first Update(), the map is not built.
   */
  vtkCurvedSeamlessMap* GetMap();

  /**
   * Build the map of a surface with the properties of this filter, without running the filter. The
   * filter's inputs are not used. If DomeHeight is FITTED, the cloud is required. Otherwise, the
   * cloud may be null. If the surface is not valid, the map reports an error, and the function
   * returns false.
   */
  bool BuildMap(vtkPolyData* surface, vtkPointSet* cloud, vtkCurvedSeamlessMap* map);

protected:
  vtkCurvedSeamlessSurface();
  ~vtkCurvedSeamlessSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCurvedSeamlessSurface(const vtkCurvedSeamlessSurface&) = delete;
  void operator=(const vtkCurvedSeamlessSurface&) = delete;

  int Sampling = AUTOMATIC;
  int Frequency = 80;
  int Subdivisions = 0;
  int SeamMode = EDGE_MATCHED;
  int DomeHeight = CURVATURE;
  double VertexShift = -1.0;
  int NumberOfFitRounds = 6;
  double FitSmoothness = 0.01;
  vtkMultiProcessController* Controller = nullptr;
  vtkNew<vtkCurvedSeamlessMap> Map;
};

#endif

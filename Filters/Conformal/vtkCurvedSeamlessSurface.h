/**
 * @class   vtkCurvedSeamlessSurface
 * @brief   make a mesh that is mapped to the sphere a smooth, dense surface (CSS)
 *
 * Make a smooth, dense, closed surface from a mesh that is mapped to the sphere, such as the output
 * of vtkConformalSOM, and keep its map. This is the CSS algorithm of section 3 of C.-Y. Liou, Y.-T.
 * Kuo, J.-C. Huang, Neurocomputing 71 (2008). The surface has the point arrays "SpherePosition" and
 * Normals.
 *
 * Input port 0: vtkPolyData, a closed surface of genus zero from vtkConformalSOM or any other
 * source. Polygons and strips are cut into triangles. Coincident points of open edges are merged,
 * triangles are oriented consistently, and isolated points are dropped, each with one warning.
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. The map must cover the sphere exactly once.
 * - field array "VertexShift" (1 component, optional, at least 1 tuple): see the property
 *   VertexShift.
 *
 * Input port 1 (optional): vtkPolyData, a dense mesh of the sphere. The surface is evaluated in the
 * directions of its points and gets its triangles. The directions are the point array
 * "SpherePosition" (3 components), or else the coordinates. Without this input the property
 * Sampling determines where the surface is evaluated.
 *
 * Input port 2 (optional): vtkPointSet, the cloud that DomeHeight FITTED fits the surface to.
 * Points that are not finite are left out with a warning, ghost points silently.
 *
 * Output port 0: vtkPolyData, the surface, in the coordinates of port 0 as doubles.
 * - point array "SpherePosition" (double, 3 components): unit vector of each point.
 * - point array "Normals" (double, 3 components): outward. With DomeHeight CURVATURE and FITTED
 *   they are shading normals, which are continuous across the edges of port 0. Otherwise they are
 *   means of the normals of the triangles around each point, weighted by area. Where a mean is 0,
 *   the normal of the flat triangle is used, or, if that is degenerate, SpherePosition.
 * - point array "Supported" (double, 1 component), if port 0 has it, interpolated.
 * - cell array "Degenerate" (unsigned char): 1 in triangles with a point from a degenerate triangle
 *   of port 0; with Sampling NETWORK in the parts of a degenerate triangle.
 * - field array "NumberOfDegeneratePatches" (vtkIdType): number of triangles of port 0 where the
 *   construction is replaced, with a warning. Triangles degenerate in space or on the sphere are
 *   mapped affinely. With DomeHeight CURVATURE and FITTED, patches that would turn over are
 *   flattened. With PUBLISHED and SCALED, triangles with a neighbor that faces the opposite way use
 *   their own normal.
 *
 * The algorithm is that of Section 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), steps 1 to 11, with
 * Schwarz-Christoffel maps between the flat triangles (Eqs. 4 and 5).
 *
 * Implementation note: the published maps of neighboring triangles differ along the edges of port
 * 0, and the published domes bring the surface no closer to the object. Both are available, as
 * SeamMode PER_TRIANGLE and DomeHeight PUBLISHED. The defaults are one continuous one-to-one map,
 * and domes that follow the surface's own curvature. GetMap() evaluates the surface anywhere.
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
   * A mesh of the sphere, N^new in the paper, input port 1. The surface is evaluated at its points
   * and gets its triangles. Without it Sampling determines the points. Sampling NETWORK does not
   * use it.
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
   * Distribution of the surface's points. DIRECTIONS: evenly over the sphere, or at the points of
   * the mesh on input port 1. NETWORK: in every triangle of the input's mesh, so that limbs that
   * are small on the sphere get points. AUTOMATIC (default): DIRECTIONS if input port 1 has a mesh
   * or the input's mesh is geodesic on the sphere, NETWORK otherwise.
   *
   * Without a mesh on input port 1, DIRECTIONS evaluates the surface at the points of a geodesic
   * sphere of the Frequency. NETWORK cuts every triangle on the sphere into Subdivisions x
   * Subdivisions. The mesh's own points come first, then those on edges, then those inside
   * triangles. NETWORK does not use input port 1. A mesh is geodesic on the sphere if
   * vtkConformalSOM learned it with MeshType GEODESIC.
   */
  vtkSetClampMacro(Sampling, int, AUTOMATIC, NETWORK);
  vtkGetMacro(Sampling, int);
  void SetSamplingToAutomatic() { this->SetSampling(AUTOMATIC); }
  void SetSamplingToDirections() { this->SetSampling(DIRECTIONS); }
  void SetSamplingToNetwork() { this->SetSampling(NETWORK); }
  ///@}

  ///@{
  /**
   * DIRECTIONS: frequency f of the geodesic sphere that is used without a mesh on input port 1. The
   * surface has 10 f^2 + 2 points and 20 f^2 triangles. If f is a multiple of the frequency of the
   * input's mesh, no triangle crosses an edge of that mesh. NETWORK with Subdivisions 0: lower
   * bound of the number of points. In [1, 1000]. Default is 80, which gives 64,002 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * NETWORK: number k of parts into which the edges of the mesh are cut. N points and 2 N - 4
   * triangles become (N - 2) k^2 + 2 points and (2 N - 4) k^2 triangles. 0 (default): the smallest
   * k that gives at least the 10 f^2 + 2 points of the Frequency. For the 12,962 points of a
   * learned mesh this is 3, with 116,642 points. In [0, 100].
   */
  vtkSetClampMacro(Subdivisions, int, 0, 100);
  vtkGetMacro(Subdivisions, int);
  ///@}

  /**
   * The points to which the surface is fitted. DomeHeight FITTED needs them; other modes do not use
   * them.
   */
  void SetCloudConnection(vtkAlgorithmOutput* output);

  /**
   * Set the cloud of DomeHeight FITTED without a pipeline connection.
   */
  void SetCloudData(vtkPointSet* cloud);

  ///@{
  /**
   * Controller of the processes that share the cloud of DomeHeight FITTED. Each process runs this
   * filter on its own piece of the cloud, which may be empty. The surface to be fitted is that of
   * the first process that has one. It is fitted to all points together, with the same bits on any
   * number of processes. That process gets the result and the map; the others get empty arrays.
   * Default is the global controller; null uses a cloud of this process alone. Other values of
   * DomeHeight need no cloud: each process makes the surface of its own input.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Continuity of the map across the edges of the input's triangles. EDGE_MATCHED (default): one
   * continuous map. PER_TRIANGLE: as published, one map per triangle, with a jump along the common
   * edge.
   */
  vtkSetClampMacro(SeamMode, int, PER_TRIANGLE, EDGE_MATCHED);
  vtkGetMacro(SeamMode, int);
  void SetSeamModeToPerTriangle() { this->SetSeamMode(PER_TRIANGLE); }
  void SetSeamModeToEdgeMatched() { this->SetSeamMode(EDGE_MATCHED); }
  ///@}

  ///@{
  /**
   * Shape of the domes that are raised over the flat triangles. CURVATURE (default): domes that
   * follow the mesh's own normals, outwards on ridges and inwards in hollows. FITTED: domes that
   * are fitted to the cloud on input port 2. PUBLISHED and SCALED: domes of the paper, which rise
   * outwards everywhere. NONE: flat triangles.
   *
   * CURVATURE makes PN triangles with the mean normals of the vertices. FITTED fits positions and
   * normals of the vertices by least squares. PUBLISHED scales the domes of the unit sphere by the
   * model's largest distance from the mean of its points. SCALED scales them by the model's local
   * size.
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
   * Shift of the vertices of a mesh that was fitted to points, as a fraction of the shift that
   * would keep its volume, in [0, 2]. With 0 the surface passes through the mesh's points. A
   * negative value (default) uses the mesh's field array "VertexShift", which vtkConformalSOM
   * writes, or 0 without that array.
   *
   * Flat triangles fitted by least squares run through the middle of the points, with their
   * vertices outside of ridges. Curved triangles (CURVATURE and FITTED) through the vertices would
   * lie too far out. A file format may drop the array. There is a warning if the array is missing
   * and the mesh resembles one of vtkConformalSOM (connectivity of a geodesic sphere, or triangles
   * of equal size). A value of 1 is then about right.
   */
  vtkSetClampMacro(VertexShift, double, -1.0, 2.0);
  vtkGetMacro(VertexShift, double);
  ///@}

  ///@{
  /**
   * DomeHeight FITTED: number of rounds. Each round finds the closest points and fits the surface
   * to them. In [0, 100]. Default is 6.
   */
  vtkSetClampMacro(NumberOfFitRounds, int, 0, 100);
  vtkGetMacro(NumberOfFitRounds, int);
  ///@}

  ///@{
  /**
   * DomeHeight FITTED: weight of smoothness against closeness, per point of a vertex. In [0, 1000].
   * Default is 0.01. Larger values smooth noise.
   */
  vtkSetClampMacro(FitSmoothness, double, 0.0, 1000.0);
  vtkGetMacro(FitSmoothness, double);
  ///@}

  /**
   * Return the map from which the last Update() sampled the output. Before the first Update() the
   * map is not built.
   */
  vtkCurvedSeamlessMap* GetMap();

  /**
   * Build the map of a surface with the properties of this filter, without running it. The filter's
   * inputs are not used. The cloud may be null, but DomeHeight FITTED needs it. Returns false, with
   * an error of the map, if the surface is not valid.
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

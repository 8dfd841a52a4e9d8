/**
 * @class   vtkCurvedSeamlessSurface
 * @brief   make a mesh that is mapped to the sphere a smooth, dense surface (CSS)
 *
 * Make a smooth, dense, closed surface of a mesh that is mapped to the sphere, such as the
 * output of vtkConformalSOM, and keep its map: the CSS algorithm of section 3 of C.-Y. Liou,
 * Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008). The surface has the point arrays
 * "SpherePosition" and Normals.
 *
 * Input port 0: vtkPolyData, a closed surface of genus zero, of a vtkConformalSOM or any other
 * origin. Polygons and strips are cut into triangles. Coincident points of open edges are merged,
 * triangles turned to agree with each other, isolated points dropped, each with one warning.
 * - point array "SpherePosition" (3 components, of any length but 0): where on the sphere the point
 *   lies. The map must cover the sphere exactly once.
 * - field array "VertexShift" (1 component, optional, at least 1 tuple): see the property
 *   VertexShift.
 *
 * Input port 1 (optional): vtkPolyData, a dense mesh of the sphere. The surface is evaluated in the
 * directions of its points, taken from the point array "SpherePosition" (3 components) where there
 * is one and from the coordinates otherwise, and is given its triangles. Without it the property
 * Sampling says where the surface is evaluated.
 *
 * Input port 2 (optional): vtkPointSet, the cloud that DomeHeight FITTED fits the surface to.
 * Points that are not finite are left out with a warning, ghost points silently.
 *
 * Output port 0: vtkPolyData, the surface, in the coordinates of port 0 as doubles.
 * - point array "SpherePosition" (double, 3 components): unit vector of each point.
 * - point array "Normals" (double, 3 components): outward. With DomeHeight CURVATURE and FITTED the
 *   surface's normals for shading, which are continuous across the edges of port 0; else the mean
 * of the normals of the triangles around each point, weighted by area. Where there is none it is
 * the normal of the flat triangle the point comes from, or if that is degenerate its
 * SpherePosition.
 * - point array "Supported" (double, 1 component), if port 0 has it, interpolated.
 * - cell array "Degenerate" (unsigned char): 1 in triangles with a point that comes from a
 *   degenerate triangle of port 0; with Sampling NETWORK in those that are cut from one.
 * - field array "NumberOfDegeneratePatches" (vtkIdType): of the triangles of port 0, how many
 *   have no shape in space or on the sphere and are mapped affinely; or with DomeHeight CURVATURE
 *   and FITTED would turn over and are flatter; or with PUBLISHED and SCALED have a neighbor that
 *   faces the opposite way and use their own normal. There is a warning.
 *
 * This is the CSS algorithm of Section 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), steps 1 to 11 with
 * Schwarz-Christoffel maps between the flat triangles (Eqs. 4 and 5).
 *
 * Implementation note: the published maps slip along the edges of port 0, and the published domes
 * bring the surface no closer to the object. Both are kept, as SeamMode PER_TRIANGLE and DomeHeight
 * PUBLISHED. The defaults make one continuous one-to-one map of them, and domes that follow the
 * surface's own curvature. GetMap() evaluates the surface anywhere.
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
   * A mesh of the sphere at whose points the surface is evaluated, and whose triangles it gets:
   * N^new in the paper, input port 1. Without it Sampling determines the points. Sampling NETWORK
   * does not use it.
   */
  void SetSphereConnection(vtkAlgorithmOutput* output);

  /**
   * Set the dense mesh of the sphere without a pipeline.
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
   * Where the surface gets its points. DIRECTIONS: evenly over the sphere, or at the points of the
   * mesh on input port 1. NETWORK: in every triangle of the input's mesh, so that limbs that are
   * small on the sphere get theirs. AUTOMATIC (default): DIRECTIONS where input port 1 has a mesh
   * or the input's mesh lies on the sphere as a geodesic one, NETWORK otherwise.
   *
   * DIRECTIONS without a mesh on input port 1 evaluates the surface at the points of a geodesic
   * sphere of the Frequency. NETWORK cuts every triangle on the sphere into Subdivisions x
   * Subdivisions: the mesh's own points come first, then those on edges, then those inside
   * triangles; input port 1 is not used. A mesh lies on the sphere as a geodesic one if
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
   * DIRECTIONS: frequency f of the geodesic sphere that is used without a mesh on input port 1; the
   * surface has 10 f^2 + 2 points and 20 f^2 triangles. If it is a multiple of the frequency of the
   * input's mesh, no triangle lies across one of its edges. NETWORK with Subdivisions 0: the
   * surface gets at least as many points. In [1, 1000]. Default is 80, which gives 64,002 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * NETWORK: k, the number of parts into which the edges of the mesh are cut; of N points and
   * 2 N - 4 triangles it makes (N - 2) k^2 + 2 points and (2 N - 4) k^2 triangles. 0 (default)
   * takes the least k that gives at least the 10 f^2 + 2 points of the Frequency: 3 for the 12,962
   * points of a learned mesh, which makes 116,642. In [0, 100].
   */
  vtkSetClampMacro(Subdivisions, int, 0, 100);
  vtkGetMacro(Subdivisions, int);
  ///@}

  /**
   * The points that the surface is fitted to. Only for, and needed by, DomeHeight FITTED.
   */
  void SetCloudConnection(vtkAlgorithmOutput* output);

  /**
   * Set the cloud that DomeHeight FITTED fits the surface to without a pipeline.
   */
  void SetCloudData(vtkPointSet* cloud);

  ///@{
  /**
   * The processes that share the cloud of DomeHeight FITTED. Each runs this filter with its own
   * points of the cloud, perhaps none, and asks its inputs for its own piece. The surface to be
   * fitted is that of the first process that has one. It is fitted to all points together, the same
   * to the bit however many processes there are, and that process gets the result; the others get
   * empty arrays, and the map too. Default is the global controller; null for a cloud of this
   * process alone. The other DomeHeights need no cloud, and each process makes the surface of its
   * own input.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * How the maps of neighboring triangles join. EDGE_MATCHED (default): as one continuous map.
   * PER_TRIANGLE: as published, each triangle for itself, with a jump along the common edge.
   */
  vtkSetClampMacro(SeamMode, int, PER_TRIANGLE, EDGE_MATCHED);
  vtkGetMacro(SeamMode, int);
  void SetSeamModeToPerTriangle() { this->SetSeamMode(PER_TRIANGLE); }
  void SetSeamModeToEdgeMatched() { this->SetSeamMode(EDGE_MATCHED); }
  ///@}

  ///@{
  /**
   * What is raised over the flat triangles. CURVATURE (default): a dome that follows the mesh's own
   * normals, outwards on ridges and inwards in hollows. FITTED: one that is fitted to the cloud on
   * input port 2. PUBLISHED and SCALED: the domes of the paper, which rise outwards everywhere.
   * NONE: nothing.
   *
   * CURVATURE makes PN triangles on the mean normals of the vertices; FITTED fits their positions
   * and normals by least squares. PUBLISHED takes the domes of the unit sphere, times the model's
   * largest distance from the mean of its points; SCALED the same in proportion to the model's
   * local size.
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
   * How far the vertices of a mesh that was fitted to points are moved, as a share of what would
   * keep its volume, in [0, 2]. 0 makes the surface go through the mesh's points; a negative value,
   * the default, stands for the field array "VertexShift" of the mesh, which vtkConformalSOM
   * writes, or for 0 where there is none.
   *
   * Flat triangles fitted by least squares lie in the middle of the points, their vertices outside
   * of ridges; curved triangles (CURVATURE and FITTED) through the vertices would lie too far out.
   * Without the array there is a warning if the mesh has the connectivity of a geodesic sphere or
   * even triangles, as the meshes of vtkConformalSOM have, since the array may have been lost, for
   * instance in a file; 1 is then about right.
   */
  vtkSetClampMacro(VertexShift, double, -1.0, 2.0);
  vtkGetMacro(VertexShift, double);
  ///@}

  ///@{
  /**
   * DomeHeight FITTED: how often the closest points are looked up and the surface is drawn to them.
   * In [0, 100]. Default is 6.
   */
  vtkSetClampMacro(NumberOfFitRounds, int, 0, 100);
  vtkGetMacro(NumberOfFitRounds, int);
  ///@}

  ///@{
  /**
   * DomeHeight FITTED: weight of a smooth surface against a close one, per point of a vertex. In
   * [0, 1000]. Default is 0.01; larger values smooth noise.
   */
  vtkSetClampMacro(FitSmoothness, double, 0.0, 1000.0);
  vtkGetMacro(FitSmoothness, double);
  ///@}

  /**
   * The map that the output was sampled from by the last Update(); before, there is none built.
   */
  vtkCurvedSeamlessMap* GetMap();

  /**
   * Build the map of a surface with the properties of this filter, without running it. Its inputs
   * are not used. The cloud may be null; DomeHeight FITTED needs it. Returns false, with an error
   * of the map, if the surface has no map.
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

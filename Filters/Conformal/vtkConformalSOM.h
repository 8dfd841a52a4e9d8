/**
 * @class   vtkConformalSOM
 * @brief   learn a closed mesh with a map to the sphere from scattered points (CSM)
 *
 * Learn a closed triangle mesh, with a one-to-one map to the sphere, from points alone: the
 * conformal self-organizing map of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008).
 * The point array "SpherePosition" of the mesh holds the position of each point on the sphere. The
 * second output is a table of the training history, for a line chart.
 *
 * Input port 0: vtkPointSet, points in any order. Polygons can serve as a starting shape, see
 * StartingShape; other cells are ignored. Points with non-finite coordinates are left out with a
 * warning. Hidden and duplicate ghost points are left out silently.
 *
 * Input port 1, optional: vtkPolyData, a closed mesh of genus zero with the point array
 * "SpherePosition". An adaptive mesh is learned from it instead of from StartingShape; ONLINE
 * learning starts from it instead of from the sphere. Its distance from the center of the points
 * must not exceed 4 times that of the points. For points in a plane it is used only if MeshType is
 * ADAPTIVE.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh through the points, in their coordinates,
 * double precision. An adaptive mesh has NumberOfNeurons points and 2 NumberOfNeurons - 4
 * triangles. A geodesic mesh has 10 f^2 + 2 points and 20 f^2 triangles, with the f that comes
 * nearest to NumberOfNeurons.
 * - point array "SpherePosition" (double, 3 components): position of each point on the unit sphere.
 *   For a geodesic mesh it is the position vector n_i of the neuron; for an adaptive mesh it is a
 *   conformal map. vtkGlobalConformalMap computes other maps, such as one with more area for limbs
 *   (AreaBalance).
 * - point array "Supported" (double, 1 component): 1 where the input has points nearby, decreasing
 *   to 0 over holes of the scan. vtkCurvedSeamlessSurface interpolates it.
 * - point array "StandardError" (double, 1 component), for an adaptive mesh in Batch mode: standard
 *   error of the point along the normal, in the points' unit. It is large where points are few or
 *   noisy, or where the object is rough.
 * - point array "QuantizationError" (double, 1 component): root mean square distance between a
 *   neuron and the input points assigned to it; 0 without points. Of a large cloud, 12 points for
 *   each neuron are used.
 * - field data "AffineRank" (1 value): 3 for a solid cloud, 2 for points in a plane, 1 on a line, 0
 *   for equal points. Below 3 the mesh is valid but flat, and there is a warning.
 * - field data "UnsupportedFraction" (1 value): fraction of the mesh's area without points nearby:
 *   hole fillings, and webs (spurious membranes) between limbs. 0 in Online mode.
 * - field data "UncoveredFraction" (1 value): fraction of the points, weighted by area, that lie
 *   close to each other but far from the mesh.
 * - field data "InvertedFraction" (1 value): fraction of the points, weighted by area, at which
 *   normals or winding numbers show that the mesh faces the wrong way. Points on which two sides of
 *   the mesh lie count, too.
 * - field data "FoldedFraction" (1 value): fraction of the mesh's edges with a bend of more than
 *   150 degrees.
 * - field data "UndersampledFraction" (1 value): fraction of the points, weighted by area, that are
 *   too few for the shape: farther than 2 % of the largest radius from the plane of their eight
 *   nearest neighbors.
 * - field data "LayerDistance" (1 value): distance between two layers of points, as in badly
 *   registered scans, in the points' unit; 0 for one layer.
 * - field data "AreaRatio" (1 value): area of the mesh, divided by that of the surface before the
 *   fit. A value well above 1 means that the mesh is crumpled.
 * - field data "NoiseLevel" (1 value): estimated standard deviation of the noise, in the points'
 *   unit; 0 where detail explains the distances between points and mesh. In Online mode it is 0,
 *   and so are all fractions; AreaRatio is 1. Each bad value causes a warning.
 * - field data "EffectiveDegreesOfFreedom" (1 value): number of free parameters of the fit of an
 *   adaptive mesh: NumberOfNeurons without smoothing, few for a smooth object. 0 if unknown.
 * - field data "StartedFromHull" (1 value): 1 if the mesh was learned from a hull.
 * - field data "StartedFromMesh" (1 value): 1 if the mesh was learned from a mesh: the input's own
 *   polygons or the mesh on input port 1.
 * - field data "HullMethod" (1 value): method of that hull, DISTANCE or WINDING_NUMBERS; 0 without
 *   a hull.
 * - field data "NormalsUsed" (1 value): 1 if winding numbers used normals of the input.
 * - field data "NumberOfStarts" (1 value): number of starts that were tried. The best mesh is kept.
 * - field data "VertexShift" (1 value): fraction by which vtkCurvedSeamlessSurface moves the
 *   vertices so that curved triangles keep the volume of the fitted flat ones; 0 if the mesh was
 *   not fitted.
 * - with DistributeOutput, point and cell arrays "GlobalPointIds" and "GlobalCellIds" (vtkIdType),
 *   the active global ids.
 *
 * Output port 1: vtkTable, on the first process, with one row for each epoch (Online), pass (Batch)
 * or iteration of the fit. Column "Frequency" belongs to the geodesic sphere with about as many
 * triangles. "NeighborhoodRadius" is sigma(t) on the unit sphere, "LearningRate" is alpha(t).
 * "MeanSquareError" is that of the presented points to the mesh; "MeanDisplacement" is that of the
 * neurons. Both are in the unit of training, in which the cloud's largest distance from its
 * centroid is 1.
 *
 * Output port 2: vtkMultiBlockDataSet, empty without GenerateStages: the surfaces that learning
 * goes through, on the first process. The name of a block consists of the number of the start,
 * from 1 and with abandoned starts counted, the start and the stage, such as "1 sphere: level 4"
 * or "2 hull: fit". The last block, "kept", is the result. Each block is a vtkPolyData with the
 * field data "StartNumber", "DefectScore" (above 1 the surface is bad), "UncoveredFraction",
 * "InvertedFraction" and "FoldedFraction"; these are 0 Online.
 *
 * Neurons on a geodesic sphere learn weight vectors in the space of the points (section 2 of the
 * paper, "Conformal self-organizing map on curved seamless surface"). TrainingMode ONLINE is the
 * paper's learning algorithm, one point at a time, with the paper's constants as defaults. BATCH,
 * the default, uses all points at once on a sequence of finer networks and ends with a
 * least-squares fit. It fits more than a hundred times closer in a fraction of the time.
 *
 * ONLINE learns by Eqs. 3 to 5, and the neurons' positions on the sphere are the paper's map. BATCH
 * applies Eq. 3 to all points. A geodesic mesh is learned on all networks, then fitted. An adaptive
 * mesh is learned on coarse networks only, and only for objects without limbs. From there, or from
 * a hull of the points, the surface is alternately remeshed and fitted, then mapped to the sphere
 * conformally. The paper names meshes that grow and swap edges as alternatives to its network.
 *
 * Implementation note: with the paper's constants, learning stops before the neighborhood is as
 * small as a triangle. Documentation/Filters.md has the measurement.
 *
 * Implementation note: E_mis measures distances from the points to the mesh only. A mesh learned
 * from the sphere may span webs between limbs, which E_mis does not detect. An adaptive mesh is
 * checked for webs and, if it has some, learned again from a hull; see StartingShape.
 *
 * @sa
 * vtkGeodesicSphereSource vtkCurvedSeamlessSurface vtkGlobalConformalMap vtkSphericalTextureMap
 * vtkSurfaceMismatch
 */

#ifndef vtkConformalSOM_h
#define vtkConformalSOM_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkMultiProcessController;

class VTKFILTERSCONFORMAL_EXPORT vtkConformalSOM : public vtkPolyDataAlgorithm
{
public:
  static vtkConformalSOM* New();
  vtkTypeMacro(vtkConformalSOM, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MeshTypes
  {
    AUTOMATIC_MESH = 0,
    GEODESIC = 1,
    ADAPTIVE = 2
  };

  enum TrainingModes
  {
    BATCH = 0,
    ONLINE = 1
  };

  enum StartingShapes
  {
    AUTOMATIC = 0,
    SPHERE = 1,
    HULL = 2,
    MESH = 3
  };

  enum HullMethods
  {
    AUTOMATIC_METHOD = 0,
    DISTANCE = 1,
    WINDING_NUMBERS = 2
  };

  enum ReferencePoints
  {
    AUTOMATIC_REFERENCE = 0,
    CONFORMAL = 1,
    WINNER = 2,
    AFFINE = 3
  };

  /**
   * A closed mesh of genus zero with the point array "SpherePosition" to start from, such as an
   * earlier result. Without it, learning starts as specified by StartingShape.
   */
  void SetStartConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  /**
   * Set the optional starting mesh without a pipeline connection.
   */
  void SetStartData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  ///@{
  /**
   * Type of the mesh. GEODESIC: the paper's geodesic sphere with fixed connectivity; its triangles
   * stretch over limbs. ADAPTIVE: nearly equilateral triangles of equal size all over the surface,
   * long limbs included; batch learning only. AUTOMATIC_MESH (default): ADAPTIVE in batch learning,
   * GEODESIC in online learning and for points in a plane.
   *
   * A geodesic mesh is learned from the sphere. Points of an adaptive mesh lie on sharp edges and
   * in corners of the object. Documentation/Fit.md compares both.
   */
  vtkSetClampMacro(MeshType, int, AUTOMATIC_MESH, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToAutomatic() { this->SetMeshType(AUTOMATIC_MESH); }
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * Number of points of the mesh. A geodesic mesh has the nearest number of the form 10 f^2 + 2. In
   * [12, 10000002]. Default is 12,962, which is 10 f^2 + 2 for f = 36.
   *
   * f is the frequency of vtkGeodesicSphereSource. Training needs about 1 KiB of memory per neuron.
   */
  vtkSetClampMacro(NumberOfNeurons, int, 12, 10000002);
  vtkGetMacro(NumberOfNeurons, int);
  ///@}

  ///@{
  /**
   * Training algorithm. BATCH (default): all points at once on a sequence of finer networks, then a
   * least-squares fit; much closer to the points, and faster. ONLINE: the paper's CSM Learning
   * Algorithm, one point at a time.
   */
  vtkSetClampMacro(TrainingMode, int, BATCH, ONLINE);
  vtkGetMacro(TrainingMode, int);
  void SetTrainingModeToBatch() { this->SetTrainingMode(BATCH); }
  void SetTrainingModeToOnline() { this->SetTrainingMode(ONLINE); }
  ///@}

  ///@{
  /**
   * Point array of the input with 1 component, the priority of each point. Online: frequency with
   * which the point is drawn, in the second half of the epochs. Batch: weight of the point. Default
   * is none (or an empty name): equal priority.
   *
   * The paper gives priority to extrusive parts. Negative and non-finite values count as 0, with a
   * warning.
   */
  vtkSetStringMacro(PriorityArrayName);
  vtkGetStringMacro(PriorityArrayName);
  ///@}

  ///@{
  /**
   * Seed of the random choice of points. At least 0. Default is 1. The same input gives the same
   * bits, on any number of threads and processes.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  ///@{
  /**
   * Reference point on the sphere for each sample. CONFORMAL: conformal image of the sample's
   * projection, Eqs. 4 and 5 of the paper. WINNER: a neuron, as in the plain self-organizing map.
   * AFFINE: affine image of the projection. AUTOMATIC_REFERENCE (default): CONFORMAL in online
   * learning, AFFINE in batch learning.
   *
   * With WINNER, online learning uses the winning neuron, r = n_c. Batch learning uses the corner
   * with the largest barycentric weight in the triangle of the projection. In batch learning AFFINE
   * is as close as CONFORMAL in less time. There the property matters only while a mesh is learned
   * from the sphere, not in the fit.
   */
  vtkSetClampMacro(ReferencePoint, int, AUTOMATIC_REFERENCE, AFFINE);
  vtkGetMacro(ReferencePoint, int);
  void SetReferencePointToAutomatic() { this->SetReferencePoint(AUTOMATIC_REFERENCE); }
  void SetReferencePointToConformal() { this->SetReferencePoint(CONFORMAL); }
  void SetReferencePointToWinner() { this->SetReferencePoint(WINNER); }
  void SetReferencePointToAffine() { this->SetReferencePoint(AFFINE); }
  ///@}

  ///@{
  /**
   * Online: number of training epochs. At least 0. Default is 80, as in the paper.
   */
  vtkSetClampMacro(NumberOfEpochs, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfEpochs, int);
  ///@}

  ///@{
  /**
   * Online: number of samples drawn in one epoch. At least 1. Default is 8000, as in the paper.
   */
  vtkSetClampMacro(SamplesPerEpoch, int, 1, VTK_INT_MAX);
  vtkGetMacro(SamplesPerEpoch, int);
  ///@}

  ///@{
  /**
   * Online: the paper's constants sigma_0, tau_1, alpha_0 and tau_2 of the neighborhood and the
   * learning rate. Positive, but alpha_0 in [0, 1). Default is (0.4, 20, 0.01, 60).
   *
   * The neighborhood is h(d) = exp(-d^2 / (2 sigma^2)) with sigma(t) = sigma_0 exp(-t / tau_1), a
   * length on the unit sphere. The learning rate is alpha(t) = alpha_0 exp(-t / tau_2). The time t
   * is the number of the epoch.
   */
  vtkSetVector4Macro(OnlineConstants, double);
  vtkGetVector4Macro(OnlineConstants, double);
  ///@}

  ///@{
  /**
   * Batch: number of least-squares iterations after learning. For an adaptive mesh the number
   * includes iterations before the last remeshing, up to half of all. At least 0. Default is 10.
   */
  vtkSetClampMacro(FitIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(FitIterations, int);
  ///@}

  ///@{
  /**
   * Batch: factor of the smoothness that the fit finds. Not negative. Default is 1. The fit of an
   * adaptive mesh finds by cross-validation how smooth the object is in each part, and how noisy
   * the points are there. The fit of a geodesic mesh has one smoothness, which depends on the
   * noise.
   */
  vtkSetMacro(Smoothness, double);
  vtkGetMacro(Smoothness, double);
  ///@}

  ///@{
  /**
   * Surface from which an adaptive mesh is learned, if input port 1 has no mesh. AUTOMATIC
   * (default): the input's polygons, if they form one closed surface of genus zero through all
   * points; else the sphere. If the mesh then has webs between limbs or hole fillings, or is bad
   * otherwise, it is learned again from a closed hull of the points. SPHERE, HULL, MESH (the
   * input's polygons): always that shape.
   *
   * The best mesh is kept. UncoveredFraction, InvertedFraction and FoldedFraction measure how bad a
   * mesh is. A geodesic mesh is learned from the sphere; HULL and MESH are errors then. With
   * MeshType AUTOMATIC_MESH, points in a plane are always learned from the sphere.
   *
   * Where vertices of the polygons are sparse, additional samples are drawn from the polygons. With
   * MESH, polygons that do not form a closed surface of genus zero are an error. Points of no
   * polygon are left out with a warning. With AUTOMATIC, polygons of any other kind only orient the
   * points, see HullMethod. Among several processes, polygons are used only if one process has all
   * of the input. If several processes have points, MESH is an error, and AUTOMATIC gives a
   * warning.
   *
   * Small webs are visible only in the fitted mesh. If more than 0.1 % of its area has no points
   * nearby, the mesh is learned again from a hull, which doubles the time.
   */
  vtkSetClampMacro(StartingShape, int, AUTOMATIC, MESH);
  vtkGetMacro(StartingShape, int);
  void SetStartingShapeToAutomatic() { this->SetStartingShape(AUTOMATIC); }
  void SetStartingShapeToSphere() { this->SetStartingShape(SPHERE); }
  void SetStartingShapeToHull() { this->SetStartingShape(HULL); }
  void SetStartingShapeToMesh() { this->SetStartingShape(MESH); }
  ///@}

  ///@{
  /**
   * Batch: classifier of inside and outside for a hull to learn from, as Method of
   * vtkGenusZeroHull. DISTANCE, or WINDING_NUMBERS for scans with large holes, hidden sides or
   * noise. AUTOMATIC_METHOD (default): as AUTOMATIC of that filter. A bad adaptive mesh is then
   * learned again from the other hull, and the better mesh is kept.
   *
   * Winding numbers use the consistently oriented normals of the input's polygons, if most of its
   * points belong to a polygon. Otherwise they use its active normals. Without any, or where
   * normals contradict each other about the inside, normals are estimated.
   */
  vtkSetClampMacro(HullMethod, int, AUTOMATIC_METHOD, WINDING_NUMBERS);
  vtkGetMacro(HullMethod, int);
  void SetHullMethodToAutomatic() { this->SetHullMethod(AUTOMATIC_METHOD); }
  void SetHullMethodToDistance() { this->SetHullMethod(DISTANCE); }
  void SetHullMethodToWindingNumbers() { this->SetHullMethod(WINDING_NUMBERS); }
  ///@}

  ///@{
  /**
   * Whether output port 2 has the surfaces that learning goes through: the start, each level or
   * turn, the fit, and the result, each with its quality. Use it for figures, and to find the cause
   * of a bad result. Default is off.
   *
   * Each stage is evaluated, which takes some tenths of a second, and kept in memory.
   */
  vtkSetMacro(GenerateStages, bool);
  vtkGetMacro(GenerateStages, bool);
  vtkBooleanMacro(GenerateStages, bool);
  ///@}

  ///@{
  /**
   * Controller of the processes that share the points. Each process runs this filter on its own
   * piece of the points, which may be empty. The surface is that of all points together, with the
   * same bits on any number of processes. Default is the global controller; null uses the points of
   * this process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Whether to give each process a piece of the surface: a range of its triangles, with their
   * points and with global ids. Default is off: the first process gets the whole surface, the
   * others get empty arrays.
   */
  vtkSetMacro(DistributeOutput, bool);
  vtkGetMacro(DistributeOutput, bool);
  vtkBooleanMacro(DistributeOutput, bool);
  ///@}

protected:
  vtkConformalSOM();
  ~vtkConformalSOM() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConformalSOM(const vtkConformalSOM&) = delete;
  void operator=(const vtkConformalSOM&) = delete;

  int MeshType = AUTOMATIC_MESH;
  int NumberOfNeurons = 12962;
  int TrainingMode = BATCH;
  char* PriorityArrayName = nullptr;
  int RandomSeed = 1;
  int ReferencePoint = AUTOMATIC_REFERENCE;
  int NumberOfEpochs = 80;
  int SamplesPerEpoch = 8000;
  double OnlineConstants[4] = { 0.4, 20.0, 0.01, 60.0 };
  int FitIterations = 10;
  double Smoothness = 1.0;
  int StartingShape = AUTOMATIC;
  int HullMethod = AUTOMATIC_METHOD;
  bool GenerateStages = false;
  vtkMultiProcessController* Controller = nullptr;
  bool DistributeOutput = false;
};

#endif

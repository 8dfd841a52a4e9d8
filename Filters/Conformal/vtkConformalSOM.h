/**
 * @class   vtkConformalSOM
 * @brief   learn a closed mesh with a map to the sphere from scattered points (CSM)
 *
 * Learn a closed triangle mesh, with a one-to-one map to the sphere, from nothing but points:
 * the conformal self-organizing map of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71
 * (2008). The point array "SpherePosition" of the mesh has the position of each point on the
 * sphere. The second output is a table of how learning went, for a line chart.
 *
 * Input port 0: vtkPointSet, any points in any order. Cells are ignored, but for polygons: learning
 * may start from them, see StartingShape. Points that are not finite are left out with a warning,
 * hidden or duplicate ghost points silently.
 *
 * Input port 1, optional: vtkPolyData, a closed mesh of genus zero with the point array
 * "SpherePosition", from which an adaptive mesh is learned instead of StartingShape, or from which
 * ONLINE learning starts instead of the sphere. It must reach
 * no farther from the middle of the points than 4 times as far as they do. Not used for points in a
 * plane, unless MeshType is ADAPTIVE.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh through the points, in their coordinates,
 * double precision: NumberOfNeurons points and 2 NumberOfNeurons - 4 triangles, or, if it is
 * geodesic, 10 f^2 + 2 points and 20 f^2 triangles with the f that comes nearest to
 * NumberOfNeurons.
 * - point array "SpherePosition" (double, 3 components): position of each point on the unit sphere.
 *   Of a geodesic mesh the position vector n_i of the neuron; of an adaptive mesh that of a
 * conformal map. vtkGlobalConformalMap makes other maps, such as one with more area for limbs
 * (AreaBalance).
 * - point array "Supported" (double, 1 component): 1 where the input has points nearby, falling to
 *   0 over holes of the scan. vtkCurvedSeamlessSurface interpolates it.
 * - point array "StandardError" (double, 1 component), of an adaptive mesh in Batch mode: standard
 *   error of the point along the normal, in the points' unit. Large where points are few or noisy,
 *   or where the object is rough.
 * - point array "QuantizationError" (double, 1 component), with GenerateErrorScalars: root mean
 *   square distance between a neuron and the input points it stands for.
 * - field data "AffineRank" (1 value): 3 for a solid cloud, 2 for points in a plane, 1 on a line, 0
 *   for equal points; below 3 the mesh is right but flat, and there is a warning.
 * - field data "UnsupportedFraction" (1 value): share of the mesh's area without points where some
 *   are due: a hole filling, or a web between limbs. 0 in Online mode.
 * - field data "UncoveredFraction" (1 value): share of the points that lie apart from the mesh, but
 *   not from each other: the mesh does not reach them. A point counts by the area it stands for.
 * - field data "InvertedFraction" (1 value): share of the points, by area too, at which the mesh
 *   faces the wrong way, by their normals or by winding numbers; or where two of its sides lie on
 * the same points.
 * - field data "FoldedFraction" (1 value): share of the mesh's edges that are bent by more than 150
 *   degrees.
 * - field data "UndersampledFraction" (1 value): share of the points, by area, farther than 2 % of
 *   the largest radius from the plane of their eight nearest neighbors: they are too few for the
 *   shape.
 * - field data "LayerDistance" (1 value): distance between two layers that the points lie on, as in
 *   scans that are not registered well, in the points' unit; 0 for one layer.
 * - field data "AreaRatio" (1 value): area of the mesh, over that of the surface before the fit.
 * Well above 1 the mesh has crumpled.
 * - field data "NoiseLevel" (1 value): standard deviation of the noise that was found, in the
 *   points' unit; 0 where detail explains the distances between points and mesh. In Online mode,
 *   this and the fractions are 0, and AreaRatio is 1. There is a warning for each that is bad.
 * - field data "EffectiveDegreesOfFreedom" (1 value): number of free parameters of an adaptive mesh
 *   that was fitted: that of its points if nothing is smoothed, few for a smooth object. 0 where it
 *   is not known.
 * - field data "StartedFromHull" (1 value): whether the mesh was learned from a hull.
 * - field data "StartedFromMesh" (1 value): whether the mesh was learned from a mesh, the input's
 * own polygons or the mesh on input port 1.
 * - field data "HullMethod" (1 value): DISTANCE or WINDING_NUMBERS, the method of that hull; 0
 * without a hull.
 * - field data "NormalsUsed" (1 value): whether winding numbers used normals of the input.
 * - field data "NumberOfStarts" (1 value): number of starts that were learned from; the best mesh
 * is kept.
 * - field data "VertexShift" (1 value): share by which vtkCurvedSeamlessSurface moves the vertices
 * so that curved triangles keep the volume of the fitted flat ones; 0 if the mesh was not fitted.
 * - with DistributeOutput, point and cell arrays "GlobalPointIds" and "GlobalCellIds" (vtkIdType),
 *   the active global ids.
 *
 * Output port 1: vtkTable, on the first process, one row for each epoch (Online), pass (Batch) or
 * iteration of the fit: "Frequency" of the geodesic sphere with about as many triangles,
 * "NeighborhoodRadius" sigma(t) on the unit sphere, "LearningRate" alpha(t), "MeanSquareError" of
 * the points presented, to the mesh, and "MeanDisplacement" of the neurons; both in the unit of
 * training, in which the cloud's largest distance from its centroid is 1.
 *
 * The conformal self-organizing map of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), section 2: neurons on
 * a geodesic sphere learn weight vectors in the space of the points. TrainingMode ONLINE is the
 * paper's learning algorithm, one point at a time, with the paper's constants as defaults. BATCH,
 * the default, takes all points at a time on ever finer networks and ends with a least-squares fit:
 * it fits more than a hundred times closer in a fraction of the time.
 *
 * ONLINE learns by Eqs. 3 to 5, and the neurons' positions on the sphere are the paper's map. BATCH
 * learns by Eq. 3 over all points. A geodesic mesh is learned on all networks, then fitted. An
 * adaptive mesh is learned on coarse networks only, and only for objects without limbs; from there,
 * or from a hull of the points, the surface is remeshed and fitted in turns, and mapped to the
 * sphere conformally. The paper names meshes that grow and swap edges as alternatives to its
 * network.
 *
 * Implementation note: taken literally the paper's constants stop learning before the neighborhood
 * is as small as a triangle; Documentation/Filters.md has the measurement.
 *
 * Implementation note: E_mis measures from the points to the mesh only, and a mesh learned from the
 * sphere may span webs between limbs that E_mis does not show. For an adaptive mesh they are found,
 * and it is learned anew from a hull; see StartingShape.
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
   * earlier result. Without it learning starts as StartingShape states.
   */
  void SetStartConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  /**
   * Set the optional mesh to start from without a pipeline.
   */
  void SetStartData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  ///@{
  /**
   * Type of the mesh. GEODESIC: the paper's geodesic sphere, whose triangles keep their neighbors,
   * so that they stretch over limbs. ADAPTIVE: triangles of one size all over the surface, nearly
   * equilateral on long limbs too; batch learning only. AUTOMATIC_MESH (default): ADAPTIVE in batch
   * learning, GEODESIC in online learning and for points in a plane.
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
   * BATCH (default): all points at a time on ever finer lattices, then a least-squares fit; much
   * closer to the points, and faster. ONLINE: the paper's CSM Learning Algorithm, one point at a
   * time.
   */
  vtkSetClampMacro(TrainingMode, int, BATCH, ONLINE);
  vtkGetMacro(TrainingMode, int);
  void SetTrainingModeToBatch() { this->SetTrainingMode(BATCH); }
  void SetTrainingModeToOnline() { this->SetTrainingMode(ONLINE); }
  ///@}

  ///@{
  /**
   * Point array of the input with 1 component, the priority of each point: how often it is drawn
   * (Online, in the second half of the epochs) or how much it weighs (Batch). Default is none,
   * which an empty name means too: equal priority.
   *
   * The paper gives priority to extrusive parts. Negative and non-finite values count as 0, with a
   * warning.
   */
  vtkSetStringMacro(PriorityArrayName);
  vtkGetStringMacro(PriorityArrayName);
  ///@}

  ///@{
  /**
   * Seed of the choice of points. At least 0. Default is 1. The same input gives the same bits, on
   * any number of threads and processes.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  ///@{
  /**
   * Which point of the sphere a pattern stands for. CONFORMAL: the conformal image of its
   * projection, Eqs. 4 and 5 of the paper. WINNER: a neuron, which is the plain self-organizing
   * map. AFFINE: the affine image of the projection. AUTOMATIC_REFERENCE (default): CONFORMAL in
   * online learning, AFFINE in batch learning.
   *
   * The neuron is the winning one, r = n_c, in online learning; in batch learning it is the corner
   * with the largest barycentric weight of the triangle that the pattern is projected on. In batch
   * learning AFFINE is as close as CONFORMAL in less time. There the property counts while a mesh
   * is learned from the sphere, not in the fit.
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
   * Online: patterns drawn in one epoch. At least 1. Default is 8000, as in the paper.
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
   * length on the unit sphere; the learning rate is alpha(t) = alpha_0 exp(-t / tau_2); t counts
   * epochs.
   */
  vtkSetVector4Macro(OnlineConstants, double);
  vtkGetVector4Macro(OnlineConstants, double);
  ///@}

  ///@{
  /**
   * Batch: least-squares iterations over the points after learning; of an adaptive mesh, with those
   * before the last remeshing, which are up to half of them. At least 0. Default is 10.
   */
  vtkSetClampMacro(FitIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(FitIterations, int);
  ///@}

  ///@{
  /**
   * Batch: factor of the smoothness that the fit chooses. Not negative. Default is 1. The fit of
   * an adaptive mesh finds by cross-validation how smooth the object is in each place, and how
   * noisy the points are there; that of a geodesic mesh has one smoothness, from the noise.
   */
  vtkSetMacro(Smoothness, double);
  vtkGetMacro(Smoothness, double);
  ///@}

  ///@{
  /**
   * Surface from which an adaptive mesh is learned, if there is no mesh on input port 1. AUTOMATIC
   * (default): the input's own polygons, if they are one closed surface of genus zero of all
   * points; else the sphere, and anew from a closed hull of the points where the sphere leads to
   * webs between limbs, to hole fillings, or to a bad mesh. SPHERE, HULL or MESH, the input's
   * polygons: always from that.
   *
   * The best mesh is kept; UncoveredFraction, InvertedFraction and FoldedFraction are what is bad
   * of one. A geodesic mesh is learned from the sphere, and HULL or MESH is an error then. With
   * MeshType AUTOMATIC_MESH, points in a plane are always learned from the sphere.
   *
   * Where vertices of the polygons are sparse, points on these are learned from too. With MESH it
   * is an error if the polygons are not a closed surface of genus zero, and points that none of
   * them has are left out with a warning. With AUTOMATIC other polygons only orient the points, see
   * HullMethod. Of several processes, one must have all of the input for its polygons to be used:
   * with MESH it is an error if several have points, with AUTOMATIC there is a warning.
   *
   * Small webs show only in the fitted mesh. Where more than 0.1 % of its area has no points
   * nearby, it is learned anew from a hull, which takes as long again.
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
   * Batch: how a hull to learn from classifies inside and outside, as Method of vtkGenusZeroHull:
   * by DISTANCE, or by WINDING_NUMBERS, for scans with large holes, hidden sides or noise.
   * AUTOMATIC_METHOD (default): as AUTOMATIC there; a bad adaptive mesh is learned anew from the
   * other hull, and the better one is kept.
   *
   * Winding numbers use the normals of the input's polygons, oriented consistently, if most of its
   * points are of one; else its active normals; else, and where these do not agree on what is
   * inside, they find them.
   */
  vtkSetClampMacro(HullMethod, int, AUTOMATIC_METHOD, WINDING_NUMBERS);
  vtkGetMacro(HullMethod, int);
  void SetHullMethodToAutomatic() { this->SetHullMethod(AUTOMATIC_METHOD); }
  void SetHullMethodToDistance() { this->SetHullMethod(DISTANCE); }
  void SetHullMethodToWindingNumbers() { this->SetHullMethod(WINDING_NUMBERS); }
  ///@}

  ///@{
  /**
   * Whether to add the point array "QuantizationError": root mean square distance of each point of
   * the mesh to the input points that it stands for. Default is off.
   */
  vtkSetMacro(GenerateErrorScalars, bool);
  vtkGetMacro(GenerateErrorScalars, bool);
  vtkBooleanMacro(GenerateErrorScalars, bool);
  ///@}

  ///@{
  /**
   * The processes that share the points. Each runs this filter with its own points, perhaps none,
   * and asks its inputs for its own piece; the surface is that of all points together, to the bit,
   * however many processes there are. Default is the global controller; null for points of this
   * process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Whether each process gets a piece of the surface: a run of its triangles, with the points they
   * use and with global ids. Default is off: the first process gets all of it, the others empty
   * arrays.
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
  bool GenerateErrorScalars = false;
  vtkMultiProcessController* Controller = nullptr;
  bool DistributeOutput = false;
};

#endif

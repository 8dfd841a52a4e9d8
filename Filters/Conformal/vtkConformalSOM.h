/**
 * @class   vtkConformalSOM
 * @brief   learn a closed mesh with a map to the sphere from scattered points (CSM)
 *
 * Input port 0: vtkPointSet, any points in any order. Cells are ignored, but for the polygons of
 * a vtkPolyData: learning may start from them, see StartingShape. Points that are not finite are
 * left out with a warning, hidden or duplicate ghost points silently.
 *
 * Input port 1, optional: vtkPolyData, a closed mesh of genus zero with the point array
 * "SpherePosition", from which learning starts instead of the sphere or a hull. It must lie where
 * the points do: reach no farther from their middle than 4 times as far as they do.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh through the points, in their coordinates,
 * double precision: 10 f^2 + 2 points and 20 f^2 triangles, f being the Frequency; with Lattice
 * Adaptive, NumberOfNeurons points and 2 NumberOfNeurons - 4 triangles.
 * - point array "SpherePosition" (double, 3 components): where each point lies on the unit sphere,
 *   as SphereMap says: the neuron's position vector n_i, or its place in a conformal map of the
 * mesh.
 * - point array "Supported" (double, 1 component): 1 where the input has points nearby, falling to
 * 0 over what nobody saw, as the lid over a hole. vtkCurvedSeamlessSurface carries it on.
 * - point array "QuantizationError" (double, 1 component), with GenerateErrorScalars: root mean
 *   square distance between a neuron and the input points it stands for.
 * - field data "CloudDimension" (1 value): 3 for a solid cloud, 2 for points in a plane, 1 on a
 * line, 0 for equal points; below 3 the mesh is right but flat, and a warning says so.
 * - field data "UnsupportedFraction" (1 value): share of the mesh's area that has no points where
 *   some are due; a lid over a hole in the scan, or a web between limbs. 0 in Online mode.
 * - field data "UnmetFraction" (1 value): share of the points that lie apart from the mesh, but not
 *   from each other: the mesh does not reach them. A point counts by the area that it stands for.
 * - field data "InvertedFraction" (1 value): share of the points, by area too, at which the mesh
 * faces the wrong way, by their normals or by winding numbers; or where two of its sides lie on the
 * same points.
 * - field data "FoldedFraction" (1 value): share of the mesh's edges that are bent by more than 150
 *   degrees.
 * - field data "UnresolvedFraction" (1 value): share of the points, by area, farther than 2 % of
 * the largest radius from the plane of their eight nearest others: they are too few for the shape.
 * - field data "LayerDistance" (1 value): how far apart two layers are that the points lie on, such
 *   as scans that are not registered well, in the points' unit; 0 for one layer.
 * - field data "AreaRatio" (1 value): area of the mesh, over that of the surface that was polished
 *   at first, from the sphere, the hull or the mesh to start from. Well above 1 it has crumpled.
 * - field data "NoiseLevel" (1 value): standard deviation of the noise that was found, in the
 * points' unit; 0 where detail explains what the mesh leaves of the points. All of these are 0
 * (AreaRatio: 1) in Online mode, and a warning tells of what is wrong.
 * - field data "StartedFromHull" (1 value): whether Batch took the hull.
 * - field data "StartedFromMesh" (1 value): whether learning started from a mesh, the input's own
 *   or that on input port 1.
 * - field data "HullIndicator" (1 value): what told the inside of that hull, 0 the distance, 1
 * winding numbers.
 * - field data "NormalsUsed" (1 value): whether winding numbers used normals of the input.
 * - field data "NumberOfStarts" (1 value): how often Batch began to learn; the best mesh is kept.
 * - field data "Polished" (1 value): whether the triangles were fitted to the points by least
 *   squares: Batch, unless NumberOfPolishRounds is 0.
 * - with DistributeOutput, point and cell arrays "GlobalPointIds" and "GlobalCellIds" (vtkIdType),
 *   the active global ids.
 *
 * Output port 1: vtkTable, on the first process, one row for each epoch (Online) or pass (Batch):
 * "Frequency" of the lattice trained (of the geodesic one of about as many triangles, if Adaptive),
 * "NeighborhoodRadius" sigma(t) on the unit sphere,
 * "LearningRate" alpha(t), "MeanSquareError" of the points presented, to the mesh, and
 * "MeanDisplacement" of the neurons; both in the unit of training, in which the cloud's largest
 * distance from its centroid is 1.
 *
 * The conformal self-organizing map of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), section 2: neurons on
 * a geodesic sphere learn weight vectors in the space of the points. TrainingMode Online is the
 * paper's learning algorithm, one point at a time, with the paper's constants as defaults. Batch,
 * the default, takes all points at a time on ever finer lattices and ends with a least-squares
 * polish: it fits more than a hundred times closer in a fraction of the time.
 *
 * What is learned, polished and mapped: Online learns by Eqs. 3 to 5, and the neurons' places on
 * the sphere are the paper's map. Batch learns by Eq. 3 over all points, then polishes. With
 * Lattice Adaptive that is done on a coarse lattice, and only for objects without limbs; from
 * there, or from a hull of the points, the surface is remeshed and polished in turns, and mapped to
 * the sphere conformally. The paper names meshes that grow and swap edges as alternatives to its
 * lattice.
 *
 * Implementation note: taken literally the paper's constants stop learning before the neighborhood
 * is as small as a triangle; Documentation/Filters.md has the measurement.
 *
 * Implementation note: E_mis looks from the points to the mesh only, and a map learned from the
 * sphere may span webs between limbs that E_mis does not see. Batch sees them and starts anew from
 * a hull of the points; see StartingShape. Online does not.
 *
 * @sa
 * vtkGeodesicSphereSource vtkCurvedSeamlessSurface vtkSphericalTextureMap vtkSurfaceMismatch
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

  enum TrainingModes
  {
    ONLINE = 0,
    BATCH = 1
  };

  enum StartingShapes
  {
    AUTOMATIC = 0,
    SPHERE = 1,
    HULL = 2,
    MESH = 3
  };

  enum HullIndicators
  {
    DISTANCE = 0,
    WINDING_NUMBERS = 1,
    AUTOMATIC_INDICATOR = 2
  };

  enum Lattices
  {
    GEODESIC = 0,
    ADAPTIVE = 1,
    AUTOMATIC_LATTICE = 2
  };

  enum SphereMaps
  {
    LATTICE = 0,
    CONFORMAL_MAP = 1,
    BALANCED = 2
  };

  enum ReferencePoints
  {
    CONFORMAL = 0,
    WINNER = 1,
    AFFINE = 2,
    AUTOMATIC_REFERENCE = 3
  };

  /**
   * The optional mesh to start from, input port 1.
   */
  void SetStartConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  /**
   * The same, as data.
   */
  void SetStartData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  ///@{
  /**
   * What the network is. GEODESIC: the paper's, a geodesic sphere of which each triangle
   * keeps its neighbors wherever it comes to lie. ADAPTIVE: triangles of one size all over the
   * surface, nearly equilateral on long limbs too; Batch only. It starts as
   * StartingShape says, on a coarse lattice, or from the mesh on input port 1. Points come to lie
   * on sharp edges and in corners of the object. AUTOMATIC_LATTICE (default): ADAPTIVE in Batch
   * mode, GEODESIC, as fine, in Online mode and for points in a plane. Documentation/Fit.md
   * compares them.
   */
  vtkSetClampMacro(Lattice, int, GEODESIC, AUTOMATIC_LATTICE);
  vtkGetMacro(Lattice, int);
  void SetLatticeToAutomatic() { this->SetLattice(AUTOMATIC_LATTICE); }
  void SetLatticeToGeodesic() { this->SetLattice(GEODESIC); }
  void SetLatticeToAdaptive() { this->SetLattice(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * Frequency f of the geodesic sphere that is the network; an adaptive network has as many neurons
   * as that, unless NumberOfNeurons is set. In [1, 1000]. Default is 36, which gives 12,962 neurons
   * and 25,920 triangles. Training takes about 1 KiB a neuron.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * How many points the mesh has if the network is adaptive; ignored if it is geodesic. In [12,
   * 10000002]; 0 stands for as many as a geodesic sphere of the Frequency has, 10 f^2 + 2, which is
   * the default: 12,962.
   */
  void SetNumberOfNeurons(int number);
  int GetNumberOfNeurons();
  ///@}

  ///@{
  /**
   * Where the array "SpherePosition" has the points of the mesh. LATTICE (default): where the
   * geodesic sphere has its neurons; an adaptive network has no such places, and gets the conformal
   * map. CONFORMAL_MAP: in a conformal map of the learned mesh, as vtkGlobalConformalMap makes it:
   * angles are kept, and limbs get little of the sphere. Limbs longer than about five times their
   * girth have no room in double precision; they get more than that, and a warning gives the mean
   * quasi-conformal error (1 if conformal). BALANCED: in one that trades angles for areas, see
   * AreaBalance.
   */
  vtkSetClampMacro(SphereMap, int, LATTICE, BALANCED);
  vtkGetMacro(SphereMap, int);
  void SetSphereMapToLattice() { this->SetSphereMap(LATTICE); }
  void SetSphereMapToConformal() { this->SetSphereMap(CONFORMAL_MAP); }
  void SetSphereMapToBalanced() { this->SetSphereMap(BALANCED); }
  ///@}

  ///@{
  /**
   * SphereMap BALANCED: from conformal, 0, to nearly equal in area, 1, as AreaBalance of
   * vtkGlobalConformalMap. In [0, 1]. Default is 0.5.
   */
  vtkSetClampMacro(AreaBalance, double, 0.0, 1.0);
  vtkGetMacro(AreaBalance, double);
  ///@}

  ///@{
  /**
   * BATCH (default) for the multi-resolution batch learning, ONLINE for the paper's CSM Learning
   * Algorithm step by step.
   */
  vtkSetClampMacro(TrainingMode, int, ONLINE, BATCH);
  vtkGetMacro(TrainingMode, int);
  void SetTrainingModeToOnline() { this->SetTrainingMode(ONLINE); }
  void SetTrainingModeToBatch() { this->SetTrainingMode(BATCH); }
  ///@}

  ///@{
  /**
   * Name of a point array of the input with 1 component, the priority of each point: how often it
   * is drawn (Online, in the second half of the epochs) or how much it weighs (Batch). The paper
   * gives priority to extrusive parts.
   * Negative and non-finite values count as 0, with a warning. Default is none, which an empty name
   * means too: equal priority.
   */
  vtkSetStringMacro(PriorityArrayName);
  vtkGetStringMacro(PriorityArrayName);
  ///@}

  ///@{
  /**
   * Seed of the choice of points. In [0, VTK_INT_MAX]. Default is 1. The same input gives the same
   * bits, on any number of threads and processes.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  ///@{
  /**
   * Which point r of the sphere a pattern stands for. CONFORMAL: the conformal image of its
   * projection, Eqs. 4 and 5. WINNER: a neuron, which is the plain self-organizing map the paper
   * compares with; Online the winning one, r = n_c, in Batch the corner of the triangle that the
   * pattern is projected on with the largest barycentric weight. AFFINE: the affine image of the
   * projection. AUTOMATIC_REFERENCE (default): CONFORMAL in Online mode, AFFINE in Batch mode,
   * which there comes as close in less time. In Batch mode it counts while a lattice is learned
   * from the sphere, not in the polish and not from a hull or a mesh.
   */
  vtkSetClampMacro(ReferencePoint, int, CONFORMAL, AUTOMATIC_REFERENCE);
  vtkGetMacro(ReferencePoint, int);
  void SetReferencePointToConformal() { this->SetReferencePoint(CONFORMAL); }
  void SetReferencePointToWinner() { this->SetReferencePoint(WINNER); }
  void SetReferencePointToAffine() { this->SetReferencePoint(AFFINE); }
  void SetReferencePointToAutomatic() { this->SetReferencePoint(AUTOMATIC_REFERENCE); }
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
   * Online: sigma_0 of the neighborhood h(d) = exp(-d^2 / (2 sigma^2)), with
   * sigma(t) = sigma_0 exp(-t / tau_1), a length on the unit sphere. Positive. Default is 0.4.
   */
  vtkSetMacro(InitialNeighborhoodRadius, double);
  vtkGetMacro(InitialNeighborhoodRadius, double);
  ///@}

  ///@{
  /**
   * Online: tau_1, in epochs. Positive. Default is 20.
   */
  vtkSetMacro(NeighborhoodTimeConstant, double);
  vtkGetMacro(NeighborhoodTimeConstant, double);
  ///@}

  ///@{
  /**
   * Online: alpha_0 of the learning rate alpha(t) = alpha_0 exp(-t / tau_2). In [0, 1). Default is
   * 0.01.
   */
  vtkSetMacro(InitialLearningRate, double);
  vtkGetMacro(InitialLearningRate, double);
  ///@}

  ///@{
  /**
   * Online: tau_2, in epochs. Positive. Default is 60.
   */
  vtkSetMacro(LearningRateTimeConstant, double);
  vtkGetMacro(LearningRateTimeConstant, double);
  ///@}

  ///@{
  /**
   * Batch: learning passes on each lattice, from coarse to fine, the neighborhood narrower from
   * pass to pass. At least 0. Default is 5.
   */
  vtkSetClampMacro(PassesPerLevel, int, 0, VTK_INT_MAX);
  vtkGetMacro(PassesPerLevel, int);
  ///@}

  ///@{
  /**
   * Batch: patterns that a pass takes for each neuron, at most all there are. In [1, 10000].
   * Default is 12.
   */
  vtkSetClampMacro(SamplesPerNeuron, int, 1, 10000);
  vtkGetMacro(SamplesPerNeuron, int);
  ///@}

  ///@{
  /**
   * Batch: least-squares rounds over all points after learning; of an adaptive network, with those
   * before the last remeshing, which are up to half of them. At least 0. Default is 10.
   */
  vtkSetClampMacro(NumberOfPolishRounds, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfPolishRounds, int);
  ///@}

  ///@{
  /**
   * Batch: weight of the Laplacian in the polish, for each point of a neuron. Not negative. Default
   * is 0.01; larger values smooth noise. Noise that is found in the points adds to it.
   */
  vtkSetMacro(Smoothness, double);
  vtkGetMacro(Smoothness, double);
  ///@}

  ///@{
  /**
   * Batch: whether points count in the polish in proportion to their distance from the mesh, within
   * limits, so that tips and edges are met that a plain least-squares fit cuts off. Default is on.
   */
  vtkSetMacro(AutomaticPriority, bool);
  vtkGetMacro(AutomaticPriority, bool);
  vtkBooleanMacro(AutomaticPriority, bool);
  ///@}

  ///@{
  /**
   * Batch: where learning starts if there is no mesh on input port 1. AUTOMATIC (default): from the
   * input's own polygons, if they are one closed surface of genus zero of which all points are
   * vertices, whose mesh is kept unless it is bad (see UnmetFraction, InvertedFraction,
   * FoldedFraction) and another start does better; else from the unit sphere, as in the paper;
   * where the mesh so learned has parts without points, webs between limbs or lids over holes, or
   * triangles stretched over limbs (a fifth of them obtuse), anew from a closed hull of the points
   * that is mapped to the sphere. SPHERE, HULL or MESH, the input's polygons: always from that.
   *
   * Where vertices of the polygons are sparse, points on these are learned from too. With MESH it
   * is an error if the polygons are not a closed surface of genus zero, and points that none of
   * them has are left out with a warning. With AUTOMATIC other polygons only
   * orient the points, see HullIndicator. A surface that winds too much to be mapped, as that of a
   * long thin curve does, is an error with HULL, and with MESH and a geodesic lattice; with
   * AUTOMATIC the mesh learned from the sphere is kept. Of several processes, one must have all of
   * the input for its polygons to be used: with MESH it is an error if several have points, with
   * AUTOMATIC a warning says so.
   *
   * An adaptive network's hull or mesh is remeshed instead of mapped, so any will do; and since the
   * coarse lattice from which it starts otherwise misses small webs, it is learned anew from a hull
   * where more than 0.1 % of the polished mesh's area has no points nearby, which takes as long
   * again.
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
   * Batch: how the hull, if learning starts from one, tells inside from outside, as the property
   * Indicator of vtkGenusZeroHull. AUTOMATIC_INDICATOR (default): as AUTOMATIC there; and where the
   * mesh of an adaptive lattice turns out bad, it is learned anew from the other hull, and the
   * better one is kept. DISTANCE or WINDING_NUMBERS: always by that. Winding numbers are for scans
   * with large holes, hidden sides or noise; they use the normals of the input's polygons, turned
   * to agree with their neighbors, if most of its points are of one; else its active normals; else,
   * and where these do not agree on what is inside, they find them.
   */
  vtkSetClampMacro(HullIndicator, int, DISTANCE, AUTOMATIC_INDICATOR);
  vtkGetMacro(HullIndicator, int);
  void SetHullIndicatorToDistance() { this->SetHullIndicator(DISTANCE); }
  void SetHullIndicatorToWindingNumbers() { this->SetHullIndicator(WINDING_NUMBERS); }
  void SetHullIndicatorToAutomatic() { this->SetHullIndicator(AUTOMATIC_INDICATOR); }
  ///@}

  ///@{
  /**
   * Whether to add the point array "QuantizationError". Default is off.
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

  int Lattice = AUTOMATIC_LATTICE;
  int Frequency = 36;
  int NumberOfNeurons = 0; // as the Frequency says
  int SphereMap = LATTICE;
  double AreaBalance = 0.5;
  int TrainingMode = BATCH;
  char* PriorityArrayName = nullptr;
  int RandomSeed = 1;
  int ReferencePoint = AUTOMATIC_REFERENCE;
  int NumberOfEpochs = 80;
  int SamplesPerEpoch = 8000;
  double InitialNeighborhoodRadius = 0.4;
  double NeighborhoodTimeConstant = 20.0;
  double InitialLearningRate = 0.01;
  double LearningRateTimeConstant = 60.0;
  int PassesPerLevel = 5;
  int SamplesPerNeuron = 12;
  int NumberOfPolishRounds = 10;
  double Smoothness = 0.01;
  bool AutomaticPriority = true;
  int StartingShape = AUTOMATIC;
  int HullIndicator = AUTOMATIC_INDICATOR;
  bool GenerateErrorScalars = false;
  vtkMultiProcessController* Controller = nullptr;
  bool DistributeOutput = false;
};

#endif

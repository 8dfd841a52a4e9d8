/**
 * @class   vtkConformalSOM
 * @brief   learn a closed mesh with a map to the sphere from scattered points (CSM)
 *
 * Learn a closed triangle mesh, with a one-to-one map to the sphere, from nothing but points:
 * the conformal self-organizing map of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71
 * (2008). The mesh has 10 f^2 + 2 points and 20 f^2 triangles, f being the Frequency; its point
 * array "SpherePosition" states where each point lies on the sphere. Its second output is a
 * table of how learning went, for a line chart.
 *
 * Input port 0: vtkPointSet, any points in any order. Cells are ignored, but for polygons: learning
 * may start from them, see StartingShape. Points that are not finite are left out with a warning,
 * hidden or duplicate ghost points silently.
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
   * A closed mesh of genus zero with the point array "SpherePosition" to start from, such as an
   * earlier result. Without it learning starts as StartingShape states.
   */
  void SetStartConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  /**
   * The same, as data.
   */
  void SetStartData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  ///@{
  /**
   * What the network is. GEODESIC: the paper's, a geodesic sphere whose triangles keep their
   * neighbors. ADAPTIVE: triangles of one size all over the surface, nearly equilateral on long
   * limbs too; batch learning only. AUTOMATIC_LATTICE (default): ADAPTIVE in batch learning,
   * GEODESIC in online learning and for points in a plane.
   *
   * An adaptive network starts as StartingShape states, on a coarse lattice, or from the mesh on
   * input port 1. Its points come to lie on sharp edges and in corners of the object.
   * Documentation/Fit.md compares both.
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
   * geodesic sphere has its neurons; an adaptive network gets the conformal map. CONFORMAL_MAP: in
   * a conformal map of the learned mesh, which keeps angles. BALANCED: in one that trades angles
   * for areas, see AreaBalance.
   *
   * The conformal map is that of vtkGlobalConformalMap, in which limbs get little of the sphere.
   * Limbs longer than about five times their girth have no room in double precision; they get more
   * than that, and a warning gives the mean quasi-conformal error (1 if conformal).
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
   * BATCH (default): all points at a time on ever finer lattices, then a least-squares fit; much
   * closer to the points, and faster. ONLINE: the paper's CSM Learning Algorithm, one point at a
   * time.
   */
  vtkSetClampMacro(TrainingMode, int, ONLINE, BATCH);
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
   * learning AFFINE comes as close as CONFORMAL in less time. There the property counts while a
   * lattice is learned from the sphere, not in the polish and not from a hull or a mesh.
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
   * Online: width of the neighborhood at the start, sigma_0 in the paper: a length on the unit
   * sphere. Positive. Default is 0.4.
   *
   * The neighborhood is h(d) = exp(-d^2 / (2 sigma^2)), with sigma(t) = sigma_0 exp(-t / tau_1).
   */
  vtkSetMacro(InitialNeighborhoodRadius, double);
  vtkGetMacro(InitialNeighborhoodRadius, double);
  ///@}

  ///@{
  /**
   * Online: epochs in which the width of the neighborhood shrinks by the factor e, tau_1 in the
   * paper. Positive. Default is 20.
   */
  vtkSetMacro(NeighborhoodTimeConstant, double);
  vtkGetMacro(NeighborhoodTimeConstant, double);
  ///@}

  ///@{
  /**
   * Online: learning rate at the start, alpha_0 in the paper: alpha(t) = alpha_0 exp(-t / tau_2).
   * In [0, 1). Default is 0.01.
   */
  vtkSetMacro(InitialLearningRate, double);
  vtkGetMacro(InitialLearningRate, double);
  ///@}

  ///@{
  /**
   * Online: epochs in which the learning rate falls by the factor e, tau_2 in the paper. Positive.
   * Default is 60.
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
   * input's own polygons where they are a closed surface of genus zero of all of its points; else
   * from the sphere, and anew from a closed hull of the points where the sphere leads to webs
   * between limbs or lids over holes. SPHERE, HULL or MESH, the input's polygons: always from that.
   *
   * With AUTOMATIC the mesh learned from the polygons is kept unless it is bad (see UnmetFraction,
   * InvertedFraction, FoldedFraction) and another start does better. A mesh learned from the unit
   * sphere, as in the paper, is replaced if it has parts without points, which are webs or lids, or
   * triangles stretched over limbs (a fifth of them obtuse). The hull is mapped to the sphere.
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
   * Batch: how inside and outside of the hull, if learning starts from one, are classified, as
   * Indicator of vtkGenusZeroHull: by DISTANCE, or by WINDING_NUMBERS, for scans with large holes,
   * hidden sides or noise. AUTOMATIC_INDICATOR (default): as AUTOMATIC there; a bad mesh of an
   * adaptive lattice is learned anew from the other hull, and the better one is kept.
   *
   * Winding numbers use the normals of the input's polygons, oriented to agree with their
   * neighbors, if most of its points are of one; else its active normals; else, and where these do
   * not agree on what is inside, they find them.
   */
  vtkSetClampMacro(HullIndicator, int, DISTANCE, AUTOMATIC_INDICATOR);
  vtkGetMacro(HullIndicator, int);
  void SetHullIndicatorToDistance() { this->SetHullIndicator(DISTANCE); }
  void SetHullIndicatorToWindingNumbers() { this->SetHullIndicator(WINDING_NUMBERS); }
  void SetHullIndicatorToAutomatic() { this->SetHullIndicator(AUTOMATIC_INDICATOR); }
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

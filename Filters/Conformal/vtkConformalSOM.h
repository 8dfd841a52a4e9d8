/**
 * @class   vtkConformalSOM
 * @brief   learn a closed mesh with a map to the sphere (conformal SOM, CSM) from scattered points
 *
 * Learn a closed triangle mesh with a one-to-one map to the sphere. The input needs neither
 * triangles nor normals. The method is the conformal self-organizing map (CSM) of the paper by
 * C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, Neurocomputing 71 (2008). The point array "SpherePosition" of
 * the mesh holds the position of each point on the sphere. The second output is a table of the
 * training history, for a line chart.
 *
 * Input port 0: vtkPointSet, points in any sequence. Polygons can serve as the surface from which
 * learning starts, see StartingShape. Other cells are ignored. Points with non-finite coordinates
 * are left out with a warning. Hidden and duplicate ghost points are left out silently.
 *
 * If the input has the array "ScannerPosition" (3 components), nothing is inside of the object
 * between a scanner and the points that it has measured. The array is a point array with the
 * position of each point's scanner, or a field array with one position for all points. A position
 * that is not finite is unknown. Without the array, nothing is known about scanners.
 * vtkE57Reader, vtkPCDReader and vtkStanfordScansReader write the array.
 *
 * Input port 1, optional: vtkPolyData, a closed mesh of genus zero with the point array
 * "SpherePosition". If this mesh is present, an adaptive mesh (see MeshType) is learned from this
 * mesh, and StartingShape is ignored. If TrainingMode is ONLINE, learning also starts from this
 * mesh, not from the sphere. If TrainingMode is BATCH and MeshType is GEODESIC, this input is an
 * error. Let R be the largest distance of an input point from the center of the input points. No
 * coordinate of this mesh, relative to that center, may exceed 4 R in magnitude. If all input
 * points lie in a plane, this mesh is used only if MeshType is ADAPTIVE.
 *
 * Output port 0: vtkPolyData, a triangle mesh through the points, in the coordinates of the input,
 * double precision. The mesh is closed, or ends where the points end, see Border. The points of the
 * mesh are the neurons of the self-organizing map. An adaptive mesh (triangles of equal size) has N
 * points and 2 N - 4 triangles, where N is NumberOfNeurons. A geodesic mesh (triangles of a
 * subdivided icosahedron) has 10 f^2 + 2 points and 20 f^2 triangles. The integer f is chosen so
 * that the number of points is nearest to NumberOfNeurons.
 * - point array "SpherePosition" (double, 3 components): position of each point on the unit sphere.
 *   For a geodesic mesh, it is the vector n_i of the paper: the fixed position of neuron i on the
 *   geodesic sphere. For an adaptive mesh, it is the image of the point under a conformal map.
 *   vtkGlobalConformalMap computes other maps. For example, its property AreaBalance gives more
 *   area to limbs, the long, thin parts of the object. If the mesh has a border, the map covers
 *   the hemisphere z >= 0, with the longest border at z = 0, see vtkGlobalConformalMap.
 * - point array "Supported" (double, 1 component): 1 if a point of the input is nearby, on the same
 *   side of the mesh, and 0 if all points are far. Let s be the spacing of the points near the
 *   vertex. The value is 1 up to a distance of about 2.2 s, 0.5 at 2.8 s, and 0 beyond 3.3 s. The
 *   filter vtkCurvedSeamlessSurface interpolates this array for its output.
 * - point array "StandardError" (double, 1 component): standard error of the vertex along the
 *   normal, in the unit of the coordinates. It is large where points are few or noisy, or where the
 *   object is rough. Only an adaptive mesh learned with TrainingMode BATCH has this array.
 * - point array "QuantizationError" (double, 1 component): root mean square distance between a
 *   neuron and the input points assigned to this neuron; 0 if no points are assigned. If the input
 *   has more than 12 points for each neuron, only a selection of 12 points for each neuron is used.
 * - point arrays of AddPatternArray (type and components of the array of the input): learned values
 *   of the points of the mesh.
 * - field data "AffineRank" (1 value): dimension of the space that the points span. The value is 3
 *   in general, 2 for points in a plane, 1 for points on a line, and 0 for equal points. If the
 *   value is below 3, the mesh is valid but flat, and there is a warning.
 * - field data "UnsupportedFraction" (1 value): fraction of the mesh's area without input points
 *   nearby. This area consists of hole fillings, and of webs (spurious membranes) between limbs. If
 *   TrainingMode is ONLINE, the value is 0.
 * - field data "NumberOfHandles" (1 value): number of handles of the mesh, see the property Genus.
 *   If the value is above 0, the mesh has no "SpherePosition", and no field data of the map.
 * - field data "NumberOfBorders" (1 value): number of borders of the mesh; 0 if the mesh is closed,
 *   see the property Border.
 * - field data "OpenFraction" (1 value): fraction of the area of the closed mesh that was removed
 *   beyond the borders; 0 if the mesh is closed.
 * - field data "NumberOfGroundPoints" (1 value): number of points that were left out as the ground
 *   and what else stands on it, see the property RemoveGround.
 * - field data "NumberOfOtherLayerPoints" (1 value): number of points that were left out as the
 *   other layer of a shell, see the property Side.
 * - field data "NumberOfOutliers" (1 value): number of points that were left out before learning,
 *   because they are far from all others, or off the surface that their neighbors form. Points are
 *   left out only if at least 0.5 % are far from all others.
 * - field data "UncoveredFraction" (1 value): fraction of the input points that are far from the
 *   mesh. Each point is weighted by the surface area that it represents. Outliers, which are far
 *   from all other points, are not counted.
 * - field data "InvertedFraction" (1 value): fraction of the input points, weighted by area, at
 *   which the inner side of the mesh faces outward. The test uses normals of the points, or winding
 *   numbers. A winding number is about 1 at positions enclosed by the points, and 0 outside. Points
 *   at which two layers of the mesh with opposite normals coincide are also counted.
 * - field data "FoldedFraction" (1 value): fraction of the mesh's edges at which the normals of the
 *   two triangles differ by more than 150 degrees.
 * - field data "UndersampledFraction" (1 value): fraction of the input points, weighted by area, in
 *   regions with too few points to define the shape. Let R be the largest distance of a point from
 *   the centroid. A point is counted if its distance from the plane of its eight nearest neighbors
 *   is more than 0.02 R and more than four standard deviations of the noise. Above 0.015, there is
 * a warning: thin parts can be missing, and narrow gaps closed.
 * - field data "LayerDistance" (1 value): distance between two layers of input points, as in badly
 *   registered scans, in the unit of the coordinates; 0 if the points form one layer.
 * - field data "MeanQuasiConformalError" and "MaximumQuasiConformalError" (1 value each): mean over
 *   the area of the mesh, and maximum over its triangles, of the ratio of the largest to the
 *   smallest stretch by the map to the sphere, see vtkConformalDistortion. 1 for a conformal map.
 *   If the mean is above 1.3, or the maximum above 100, there is a warning. Slivers (triangles with
 *   a smallest angle below about 6 degrees) are removed from the mesh before the map is computed.
 * - field data "SelfIntersections" (1 value): number of pairs of triangles of an adaptive mesh that
 *   cross each other and have no common vertex. The mesh is smoothed where triangles cross, so that
 *   the value is usually 0.
 * - field data "AreaRatio" (1 value): area of the mesh, divided by the area of the surface before
 *   the least-squares fit (last step of BATCH learning). A value well above 1 means that the mesh
 *   is crumpled.
 * - field data "NoiseLevel" (1 value): estimated standard deviation of the noise, in the unit of
 *   the coordinates. The value is 0 if details of the object explain the distances between points
 *   and mesh. If TrainingMode is ONLINE, NoiseLevel and all fractions are 0, and AreaRatio is 1. If
 *   one of the fractions, LayerDistance or NoiseLevel is too large, there is a warning.
 * - field data "EffectiveDegreesOfFreedom" (1 value): number of free parameters of the fit of an
 *   adaptive mesh. Without smoothing, the value is the number of vertices. For a smooth object, the
 *   value is small. If the number is unknown, the value is 0.
 * - field data "StartedFromHull" (1 value): 1 if the mesh was learned from a hull, a closed surface
 *   around the points (vtkGenusZeroHull).
 * - field data "StartedFromMesh" (1 value): 1 if the mesh was learned from the polygons of the
 *   input or from the mesh on input port 1.
 * - field data "HullMethod" (1 value): value of the property HullMethod by which the hull was made,
 *   DISTANCE or WINDING_NUMBERS; 0 if there was no hull.
 * - field data "NormalsUsed" (1 value): 1 if the winding numbers for the hull were computed with
 *   normals of the input.
 * - field data "NumberOfStarts" (1 value): number of surfaces from which learning was started:
 *   sphere, hull or mesh. The best result is kept.
 * - field data "VertexShift" (1 value): suitable value of the property VertexShift of
 *   vtkCurvedSeamlessSurface. That filter shifts the vertices before it replaces the flat triangles
 *   by curved triangles. The value is the factor of the shift. With 1, the curved triangles enclose
 *   the same volume as the flat triangles. The value is 0 if the mesh was not fitted.
 * - point array "GlobalPointIds" and cell array "GlobalCellIds" (vtkIdType), only with
 *   DistributeOutput: the active global ids.
 *
 * Output port 1: vtkTable, on the first process. ONLINE learning makes one row for each epoch
 * (NumberOfEpochs). BATCH learning makes one row for each pass over the points, and one row for
 * each iteration of the least-squares fit. Column "Frequency" is an integer f: a geodesic mesh with
 * 20 f^2 triangles has about as many triangles as the mesh. "NeighborhoodRadius" is sigma(t), and
 * "LearningRate" is alpha(t); the property OnlineConstants defines these functions.
 * "MeanSquareError" is the mean square distance between the mesh and the points that were used in
 * the epoch, pass or iteration. "MeanDisplacement" is the mean distance by which the neurons moved.
 * With ONLINE, "MeanSquareError" contains the values of AddPatternArray.
 * In "MeanSquareError" and "MeanDisplacement", the unit of length is the largest distance of an
 * input point from the centroid of the points.
 *
 * Output port 2: vtkMultiBlockDataSet, the intermediate surfaces of learning, on the first process.
 * The output is empty if GenerateStages is off. A start is a surface from which learning begins.
 * Starts are counted from 1. Starts from which learning was stopped early are also counted. The
 * name of a block consists of the number of the start, the name of the start, and the stage, such
 * as "1 sphere: level 4" or "2 hull: fit". The last block, "kept", is the result. Each block is a
 * vtkPolyData with the field data "StartNumber", "DefectScore", "UncoveredFraction",
 * "InvertedFraction" and "FoldedFraction". For the DefectScore, each of these three fractions is
 * divided by its largest acceptable value. The score is the largest of the three quotients. A
 * surface with a score above 1 is bad. If TrainingMode is ONLINE, the score and the fractions are
 * 0.
 *
 * Neurons are the vertices of a network on the sphere. Each neuron learns a weight vector, its
 * position in the space of the points (section 2 of the paper, "Conformal self-organizing map on
 * curved seamless surface"). TrainingMode ONLINE is the paper's learning algorithm, which uses one
 * point at a time. The defaults are the paper's constants. BATCH, the default, uses all points at
 * once on a sequence of networks, from coarse to fine, and ends with a least-squares fit. With
 * BATCH, the mean square distance between the points and the mesh is more than a hundred times
 * smaller than with ONLINE. BATCH is also faster.
 *
 * ONLINE learns by Eqs. 3 to 5 of the paper. With ONLINE, the positions of the neurons on the
 * sphere are the map of the paper. BATCH applies Eq. 3, which moves neurons towards a point, to all
 * points at once. For a geodesic mesh, BATCH learns on the whole sequence of networks, and then
 * fits the finest network to the points. For an adaptive mesh, BATCH first makes a coarse mesh. If
 * the object has no limbs, the coarse mesh is learned on the coarse networks of the sequence.
 * Otherwise, the coarse mesh is usually a hull, a closed surface around the points. The coarse mesh
 * is then alternately remeshed and fitted. Finally, the resulting mesh is mapped to the sphere
 * conformally. The paper suggests growing meshes and edge swaps as alternatives to its fixed
 * network.
 *
 * Implementation note: with the paper's constants, ONLINE learning ends while the neighborhood
 * radius sigma(t) is still larger than a triangle. Documentation/Filters.md has the measurement.
 *
 * Implementation note: the paper's mismatch error E_mis measures distances from the points to the
 * mesh only. A mesh that is learned from the sphere may have webs (spurious membranes) between
 * limbs. E_mis does not detect webs. An adaptive mesh is checked for webs. If there are webs, the
 * mesh is learned again from a hull, see StartingShape.
 *
 * @sa
 * vtkGeodesicSphereSource vtkCurvedSeamlessSurface vtkGlobalConformalMap vtkSphericalTextureMap
 * vtkSurfaceMismatch
 */

#ifndef vtkConformalSOM_h
#define vtkConformalSOM_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string>  // for names of arrays
#include <utility> // for pairs
#include <vector>  // for lists of arrays

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

  enum Genera
  {
    ZERO = 0,
    AS_FOUND = 1
  };

  enum Borders
  {
    AUTOMATIC_BORDER = 0,
    CLOSED = 1,
    OPEN = 2
  };

  enum GroundRemovals
  {
    AUTOMATIC_GROUND = 0,
    GROUND_OFF = 1,
    GROUND_ON = 2
  };

  enum Sides
  {
    OUTER_SIDE = 0,
    INNER_SIDE = 1,
    BOTH_SIDES = 2
  };

  enum ReferencePoints
  {
    AUTOMATIC_REFERENCE = 0,
    CONFORMAL = 1,
    WINNER = 2,
    AFFINE = 3
  };

  /**
   * A closed mesh of genus zero from which learning starts, with the point array "SpherePosition",
   * such as an earlier result. Without this mesh, learning starts as specified by StartingShape.
   */
  void SetStartConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  /**
   * Set the optional mesh from which learning starts, without a pipeline connection.
   */
  void SetStartData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  ///@{
  /**
   * Type of the mesh. GEODESIC: the paper's geodesic sphere, a subdivided icosahedron. Its
   * triangles become long and large on limbs (long, thin parts). ADAPTIVE: nearly equilateral
   * triangles of equal size on the whole surface, including long limbs. ADAPTIVE requires batch
   * learning. AUTOMATIC_MESH (default): ADAPTIVE in batch learning, GEODESIC in online learning and
   * for points in a plane.
   *
   * In batch learning, a geodesic mesh is always learned from the sphere. An adaptive mesh has
   * points on sharp edges and corners of the object. Documentation/Fit.md compares both types.
   */
  vtkSetClampMacro(MeshType, int, AUTOMATIC_MESH, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToAutomatic() { this->SetMeshType(AUTOMATIC_MESH); }
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * Number of points of the mesh. 0 (default): the number is chosen automatically. Otherwise, the
   * number must be in [12, 10000002]. A geodesic mesh has the nearest number of the form 10 f^2 + 2
   * with an integer f.
   *
   * The automatic number is 12,962 (f = 36), except for an adaptive mesh (see MeshType) learned
   * from fewer than 38,886 points. For such points, the number depends on the number of points and
   * their noise. Without noise, the mesh has 1.5 times as many points as the input, but at most
   * 12,962. With noise, every fifth point is left out, and meshes are learned from the others.
   * Their distances from the points that were left out determine the number. The automatic number
   * is also 12,962 if learning starts from the polygons of the input, see StartingShape.
   *
   * The integer f is the frequency of vtkGeodesicSphereSource. Training needs about 1 KiB of memory
   * for each point of the mesh.
   */
  vtkSetClampMacro(NumberOfNeurons, int, 0, 10000002);
  vtkGetMacro(NumberOfNeurons, int);
  ///@}

  ///@{
  /**
   * Training algorithm. BATCH (default): learn from all points at once on a sequence of finer and
   * finer networks, then fit the mesh by least squares. The result is much closer to the points,
   * and learning is faster. ONLINE: the paper's CSM Learning Algorithm, which uses one point at a
   * time.
   */
  vtkSetClampMacro(TrainingMode, int, BATCH, ONLINE);
  vtkGetMacro(TrainingMode, int);
  void SetTrainingModeToBatch() { this->SetTrainingMode(BATCH); }
  void SetTrainingModeToOnline() { this->SetTrainingMode(ONLINE); }
  ///@}

  ///@{
  /**
   * Name of a point array of the input with 1 component, the priority of each point. In online
   * learning, the priority is the relative frequency with which the point is drawn in the second
   * half of the epochs. In batch learning, the priority is the weight of the point. Default is none
   * (or an empty name): all points have equal priority.
   *
   * The paper gives a higher priority to protruding parts of the object. Negative and non-finite
   * values count as 0, with a warning.
   */
  vtkSetStringMacro(PriorityArrayName);
  vtkGetStringMacro(PriorityArrayName);
  ///@}

  ///@{
  /**
   * Add a point array of the input whose values are learned with the coordinates, such as colors.
   * The arguments are the name of the array and its weight, in (0, 1000]. The learned values are a
   * point array of the mesh with the same name and type. Integer arrays with 1 component are
   * labels, which are not averaged; at most 64 different labels. Default is none.
   *
   * Each component of an array of numbers is shifted to the middle of its range. The array is then
   * divided by half of the largest range, so that its values are in [-1, 1], as the coordinates in
   * learning. With the weight 1, a change over the whole range thus counts as much as a distance
   * from one side of the object to the other. A label is a dimension of its own: the weight at
   * points with this label, and 0 at other points.
   *
   * In online learning, patterns and weight vectors of neurons have the coordinates and these
   * values. The winner, the projection onto the mesh and the update (Eqs. 3 to 5 of the paper) are
   * those of all dimensions. In batch learning, the shape is learned from the coordinates. Points
   * of the mesh then move along the surface, so that its edges follow steps of the values: the
   * input's points are projected in all dimensions. The values of the mesh are finally fitted by
   * least squares. With a larger weight, edges follow steps more closely, and the mesh is farther
   * from the points. 0.1 is suitable for colors.
   *
   * Points with a value that is not finite are left out with a warning. With several processes, all
   * processes with points must have the arrays.
   */
  void AddPatternArray(const char* name, double weight);
  void RemoveAllPatternArrays();
  int GetNumberOfPatternArrays() { return static_cast<int>(this->PatternArrays.size()); }
  ///@}

  ///@{
  /**
   * Seed of the random choice of points. At least 0. Default is 1. With equal input, properties and
   * seed, the output is equal bit by bit, for any number of threads and processes.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  ///@{
  /**
   * Reference point: the point of the sphere that corresponds to an input point during learning.
   * The input point is first projected onto the mesh. CONFORMAL: image of the projected point under
   * a conformal map of its triangle, Eqs. 4 and 5 of the paper. AFFINE: image under an affine map
   * of the triangle. WINNER: position of a neuron, as in the plain self-organizing map.
   * AUTOMATIC_REFERENCE (default): CONFORMAL in online learning, AFFINE in batch learning.
   *
   * With WINNER, online learning uses the position n_c of the winning neuron, the neuron nearest to
   * the input point. Batch learning uses the position of one corner of the triangle that contains
   * the projected point: the corner with the largest barycentric weight. In batch learning, AFFINE
   * gives a mesh as close to the points as CONFORMAL, in less time. Batch learning uses this
   * property only while a mesh is learned from the sphere, not in the fit.
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
   * Number of training epochs in online learning. At least 0. Default is 80, as in the paper.
   */
  vtkSetClampMacro(NumberOfEpochs, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfEpochs, int);
  ///@}

  ///@{
  /**
   * Number of points drawn at random in one epoch of online learning. At least 1. Default is 8000,
   * as in the paper.
   */
  vtkSetClampMacro(SamplesPerEpoch, int, 1, VTK_INT_MAX);
  vtkGetMacro(SamplesPerEpoch, int);
  ///@}

  ///@{
  /**
   * Constants of online learning in the paper (sigma_0, tau_1, alpha_0, tau_2). sigma_0 and tau_1
   * define the size of the neighborhood, the part of the sphere whose neurons learn from one point.
   * alpha_0 and tau_2 define the learning rate. alpha_0 is in [0, 1), and the others are positive.
   * Default is (0.4, 20, 0.01, 60).
   *
   * Let t be the number of the epoch, and d a distance on the unit sphere. The neighborhood
   * function is h(d) = exp(-d^2 / (2 sigma(t)^2)) with sigma(t) = sigma_0 exp(-t / tau_1). The
   * learning rate is alpha(t) = alpha_0 exp(-t / tau_2).
   */
  vtkSetVector4Macro(OnlineConstants, double);
  vtkGetVector4Macro(OnlineConstants, double);
  ///@}

  ///@{
  /**
   * Number of iterations of the least-squares fit after batch learning. The fit moves the vertices
   * of the mesh towards the points. For an adaptive mesh, up to half of these iterations are done
   * before the last remeshing. At least 0. Default is 10.
   */
  vtkSetClampMacro(FitIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(FitIterations, int);
  ///@}

  ///@{
  /**
   * Factor by which the least-squares fit of batch learning multiplies the smoothness that it
   * finds. At least 0. Default is 1. For an adaptive mesh, the fit finds by cross-validation, in
   * each part, how smooth the object is and how noisy the points are. For a geodesic mesh, the
   * smoothness is the same everywhere, and increases with the noise.
   */
  vtkSetMacro(Smoothness, double);
  vtkGetMacro(Smoothness, double);
  ///@}

  ///@{
  /**
   * Surface from which an adaptive mesh is learned, if input port 1 has no mesh. SPHERE: the unit
   * sphere. HULL: a closed hull around the points. MESH: the input's polygons. AUTOMATIC (default):
   * the input's polygons if they form one closed surface of genus zero through all points,
   * otherwise the sphere. If the learned mesh has webs (spurious membranes) between limbs, fillings
   * of holes, or other defects, it is learned again from a hull.
   *
   * If several meshes are learned, the best mesh is kept. The field data "UncoveredFraction",
   * "InvertedFraction" and "FoldedFraction" measure the defects of a mesh. For a geodesic mesh,
   * HULL and MESH are errors. If all points lie in a plane and MeshType is AUTOMATIC_MESH, learning
   * starts from the sphere.
   *
   * Where vertices of the polygons are sparse, additional points are sampled from the polygons.
   * With MESH, it is an error if the polygons do not form a closed surface of genus zero. Points
   * that belong to no polygon are left out with a warning. With AUTOMATIC, polygons that do not
   * form a closed surface of genus zero only provide normals, see HullMethod. With several
   * processes, polygons are used only if one process has all points. If the points are spread over
   * several processes, MESH is an error, and AUTOMATIC gives a warning.
   *
   * Small webs can be detected only in the fitted mesh. With AUTOMATIC, the mesh is learned again
   * from a hull if more than 0.1 % of the fitted mesh's area has no points nearby. The second
   * learning doubles the time.
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
   * Method by which the hull of the points is made, if batch learning starts from a hull. The
   * method determines which positions in space are inside of the points. DISTANCE: by the distance
   * to the points. WINDING_NUMBERS: by winding numbers (about 1 inside, 0 outside), for scans with
   * large holes, hidden sides or noise. AUTOMATIC_METHOD (default): by the distance, or by winding
   * numbers if the result by distance seems wrong. If the adaptive mesh is bad, it is also learned
   * from the hull by the other method, and the better mesh is kept.
   *
   * With fewer than two points for each neuron, AUTOMATIC_METHOD also learns from the other hull if
   * the map to the sphere is not conformal: between sparse points, a hull can be cracked across
   * thin parts, which are then joined by a thread.
   *
   * The methods are those of the property Method of vtkGenusZeroHull. If most points of the input
   * belong to a polygon, winding numbers use the normals of the polygons, consistently oriented.
   * Otherwise they use the active normals of the input. If there are no normals, or if normals
   * contradict each other, normals are estimated from the points.
   */
  vtkSetClampMacro(HullMethod, int, AUTOMATIC_METHOD, WINDING_NUMBERS);
  vtkGetMacro(HullMethod, int);
  void SetHullMethodToAutomatic() { this->SetHullMethod(AUTOMATIC_METHOD); }
  void SetHullMethodToDistance() { this->SetHullMethod(DISTANCE); }
  void SetHullMethodToWindingNumbers() { this->SetHullMethod(WINDING_NUMBERS); }
  ///@}

  ///@{
  /**
   * Genus (number of handles) of the mesh. ZERO (default): the mesh has no handles, and a map to
   * the sphere. AS_FOUND: an adaptive mesh keeps the handles of the object, such as that of a mug.
   * If it has handles, the mesh is closed, whatever the Border, and has no array "SpherePosition".
   * Filters that need a map to the sphere report an error. A mesh with one handle is mapped to a
   * flat torus by vtkGlobalConformalMap.
   *
   * AS_FOUND needs an adaptive mesh, see MeshType, that is not learned from the sphere, see
   * StartingShape. Learning starts from a hull, as vtkGenusZeroHull makes it. Handles are kept if
   * the handle and its opening are wider than about twice an edge of the mesh, than 5 % of the
   * largest distance of a point from the middle of the points, and than 4 times the distance
   * between neighboring points. "NumberOfHandles" is the result. If a handle is missing, use more
   * neurons. If noise or sparse points make handles that the object does not have, use fewer
   * neurons.
   */
  vtkSetClampMacro(Genus, int, ZERO, AS_FOUND);
  vtkGetMacro(Genus, int);
  void SetGenusToZero() { this->SetGenus(ZERO); }
  void SetGenusToAsFound() { this->SetGenus(AS_FOUND); }
  ///@}

  ///@{
  /**
   * Whether the mesh has a border. CLOSED: the mesh is closed; parts without points are filled.
   * OPEN: the mesh is a sheet, which ends where the points end, with a smooth border. The largest
   * part without points is left open. For other parts, see HoleSize. AUTOMATIC_BORDER (default):
   * OPEN, with a warning, if the largest part without points has more than 22 % of the area of the
   * closed mesh, as in a scan from one side. Otherwise CLOSED.
   *
   * OPEN needs an adaptive mesh, see MeshType. A closed mesh is learned first. It is then cut along
   * border curves: smoothing splines that are fitted to the outermost points. If the sheet consists
   * of several parts, the largest is kept, with a warning. If the polygons of the input form a
   * closed surface from which learning starts, the mesh is CLOSED with AUTOMATIC_BORDER and OPEN.
   * It is also CLOSED if the points have no hole, lie in one plane, or are too few. With OPEN, a
   * warning says that there is no border.
   */
  vtkSetClampMacro(Border, int, AUTOMATIC_BORDER, OPEN);
  vtkGetMacro(Border, int);
  void SetBorderToAutomatic() { this->SetBorder(AUTOMATIC_BORDER); }
  void SetBorderToClosed() { this->SetBorder(CLOSED); }
  void SetBorderToOpen() { this->SetBorder(OPEN); }
  ///@}

  ///@{
  /**
   * Radius of the largest holes that are filled if the mesh has a border, in the unit of the
   * coordinates. Parts without points that reach farther from their center are left open. At least
   * 0. With 0 (default), parts with less than a tenth of the area of the largest part are filled.
   * If the mesh is closed, all parts are filled.
   */
  vtkSetMacro(HoleSize, double);
  vtkGetMacro(HoleSize, double);
  ///@}

  ///@{
  /**
   * Whether the ground under the object is left out: a floor, a table, or a wall, and other objects
   * on it. AUTOMATIC_GROUND (default): if there is a plane with a tenth of the points or more, no
   * points below it, and 40 % or more of its area on three or four sides of the object, and if the
   * object is high enough to be no relief. A flat side of the object, or a plinth, is not a ground.
   * GROUND_OFF: never. GROUND_ON: the largest plane of the points is left out.
   *
   * AUTOMATIC_GROUND requires at least 500 points. GROUND_ON requires at least 50 points, and a
   * plane with at least 5 % of them. Otherwise, no points are left out, and GROUND_ON gives a
   * warning.
   *
   * The object is the largest connected part above the plane. If points are left out, there is a
   * warning, and the field data "NumberOfGroundPoints" has their number.
   */
  vtkSetClampMacro(RemoveGround, int, AUTOMATIC_GROUND, GROUND_ON);
  vtkGetMacro(RemoveGround, int);
  void SetRemoveGroundToAutomatic() { this->SetRemoveGround(AUTOMATIC_GROUND); }
  void SetRemoveGroundToOff() { this->SetRemoveGround(GROUND_OFF); }
  void SetRemoveGroundToOn() { this->SetRemoveGround(GROUND_ON); }
  ///@}

  ///@{
  /**
   * Layer that is learned if the points are a shell: two layers of points around a cavity, as in
   * the level set of a volume or the scan of a hollow object. The layers must be farther apart than
   * about 0.03 of the largest radius, and than twice the spacing of the points. A cavity with
   * an opening whose radius is more than about four spacings is a part of the surface, not a layer.
   *
   * OUTER_SIDE (default): the inner layer is left out. INNER_SIDE: the outer layer is left out.
   * BOTH_SIDES: all points are used, and the mesh cannot fit both layers. If points are left out,
   * there is a warning, and the field data "NumberOfOtherLayerPoints" has their number. If there
   * are not two layers, all points are used.
   */
  vtkSetClampMacro(Side, int, OUTER_SIDE, BOTH_SIDES);
  vtkGetMacro(Side, int);
  void SetSideToOuter() { this->SetSide(OUTER_SIDE); }
  void SetSideToInner() { this->SetSide(INNER_SIDE); }
  void SetSideToBoth() { this->SetSide(BOTH_SIDES); }
  ///@}

  ///@{
  /**
   * Whether output port 2 has the intermediate surfaces of learning: the start, each level or turn,
   * the fit, and the result. A level is one network of the sequence of batch learning. A turn is
   * one fit, followed by a remeshing. Each surface has field data about its quality. Use these
   * surfaces for figures, and to find the cause of a bad result. Default is off.
   *
   * Each intermediate surface is kept in memory, and its quality is evaluated. One evaluation costs
   * some tenths of a second.
   */
  vtkSetMacro(GenerateStages, bool);
  vtkGetMacro(GenerateStages, bool);
  vtkBooleanMacro(GenerateStages, bool);
  ///@}

  ///@{
  /**
   * Controller of the processes that share the points. Each process runs this filter on its own
   * piece of the points, which may be empty. The surface is learned from the points of all
   * processes. The result is equal bit by bit for any number of processes. Default is the global
   * controller. With null, only the points of this process are used.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Whether each process gets a piece of the surface: a range of triangles, with their points and
   * with global ids. Default is off: the first process gets the whole surface, and the other
   * processes get an empty surface.
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
  int NumberOfNeurons = 0;
  int TrainingMode = BATCH;
  char* PriorityArrayName = nullptr;
  std::vector<std::pair<std::string, double>> PatternArrays;
  int RandomSeed = 1;
  int ReferencePoint = AUTOMATIC_REFERENCE;
  int NumberOfEpochs = 80;
  int SamplesPerEpoch = 8000;
  double OnlineConstants[4] = { 0.4, 20.0, 0.01, 60.0 };
  int FitIterations = 10;
  double Smoothness = 1.0;
  int StartingShape = AUTOMATIC;
  int HullMethod = AUTOMATIC_METHOD;
  int Genus = ZERO;
  int Border = AUTOMATIC_BORDER;
  double HoleSize = 0.0;
  int RemoveGround = AUTOMATIC_GROUND;
  int Side = OUTER_SIDE;
  bool GenerateStages = false;
  vtkMultiProcessController* Controller = nullptr;
  bool DistributeOutput = false;
};

#endif

/**
 * @class   vtkGenusZeroHull
 * @brief   wrap scattered points into one closed surface without handles
 *
 * Make a closed triangle mesh around the points. It covers holes in the data, and it has no webs
 * (spurious membranes) between limbs. The field data state the size of the largest hole, the number
 * of handles that were cut open, and the number of points that lie outside.
 *
 * Input port 0: vtkPointSet, points in any order. Points that are not finite are left out with a
 * warning, hidden or duplicate ghost points silently. Only WINDING_NUMBERS uses cells and normals,
 * see Method.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh of genus zero around the points, in their
 * coordinates, double precision. Triangles are counter-clockwise seen from outside. With
 * DistributeOutput, point and cell arrays "GlobalPointIds" and "GlobalCellIds" (vtkIdType) are the
 * active global ids. Field data, one value each, lengths in units of the coordinates:
 * - "AffineRank" (idtype): 3 for a solid cloud, 2 for points in a plane, 1 on a line, 0 for equal
 *   points.
 * - "Method" (idtype): classifier that was used, as the property. DISTANCE also if winding numbers
 *   cannot classify: points in a plane, fewer than 20 points, or no node inside.
 * - "NormalsUsed" (idtype): 1 if normals of the input were used to classify.
 * - "KernelWidth" (double): radius over which winding numbers were averaged; larger with noise. 0
 *   for DISTANCE.
 * - "GridSpacing" (double): Spacing, or a multiple of it where the points lie too far apart.
 * - "NumberOfInsideNodes" (idtype): grid nodes inside; for DISTANCE those farther from the points
 *   than the offset. 0 means that the points enclose nothing.
 * - "SolidEulerNumber" (idtype): Euler number of the solid inside the hull before handles were cut:
 *   1 minus the number of handles.
 * - "NumberOfCutNodes" (idtype): grid nodes removed, or added, to open the handles.
 * - "HoleWidth", "HoleDepth" (double): size of the largest hole in the data that was closed.
 *   HoleWidth is the distance from its middle to the nearest point; HoleDepth is the largest such
 *   distance inside, behind the hole. 0 without a hole, and for WINDING_NUMBERS. The closer the two
 *   values, the less certain the inside.
 * - "Leaks" (idtype): 1 if a hole was too wide for persistence to classify inside and outside. The
 *   most likely part was then chosen as inside.
 * - "NumberOfPointsOutside" (idtype): points that the hull does not enclose: outliers, and points
 *   apart from the largest piece.
 * - "NumberOfPointsInside" (idtype): points inside the hull and apart from its surface: inner
 *   parts, and outliers.
 *
 * There is one warning each for the following cases:
 * - The points enclose nothing, or Leaks is 1.
 * - Handles cannot be opened without a cut through the inside of the object or through its points.
 *   The object is not of genus zero, or parts of it touch. Limbs joined only by the offset cause no
 *   warning.
 * - More than 1 of 200 points lie outside.
 * - More than 1 of 200 points lie inside.
 *
 * The hull is an own construction, not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang,
 * "Conformal self-organizing map on curved seamless surface", Neurocomputing 71 (2008)). The
 * paper's method starts from a closed surface of genus zero, which this filter provides without
 * webs between limbs.
 *
 * DISTANCE computes the distance to the points on a grid and extracts the surface at a small
 * offset. Persistence classifies inside and outside: a hole in the data is closed if the space
 * behind it is wider than the hole by the factor Persistence. Limbs closer than twice the offset
 * are joined by it, then separated in the middle between them.
 *
 * WINDING_NUMBERS classifies inside and outside by all points together. The surface passes through
 * the points, or through the middle of their noise. It closes a hole in the data smoothly, as the
 * remaining points imply. Normals are those of the input, or are found by steepest descent (S. Lin
 * and others, 2022 and 2024; see Documentation/references.bib).
 *
 * @sa
 * vtkConformalSOM vtkGenusZeroCheck vtkSurfaceMismatch
 */

#ifndef vtkGenusZeroHull_h
#define vtkGenusZeroHull_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkMultiProcessController;

class VTKFILTERSCONFORMAL_EXPORT vtkGenusZeroHull : public vtkPolyDataAlgorithm
{
public:
  static vtkGenusZeroHull* New();
  vtkTypeMacro(vtkGenusZeroHull, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    AUTOMATIC = 0,
    DISTANCE = 1,
    WINDING_NUMBERS = 2
  };

  ///@{
  /**
   * Classifier of inside and outside. DISTANCE (default): the distance to the points, which closes
   * holes smaller than the space behind them. WINDING_NUMBERS: winding numbers around all points,
   * for scans with large holes, hidden sides or noise. AUTOMATIC: the distance; where its result
   * seems wrong, winding numbers if their result does not.
   *
   * Winding numbers use the normals of the input's polygons, or else its active normals; inward
   * normals are reversed. Normals are estimated from the points if the input has none, or, with a
   * warning, if they contradict each other about the inside. With AUTOMATIC, the distance seems
   * wrong in three cases: a hole as wide as the space behind it, handles, or many points left out.
   * Winding numbers are then used if they also find little noise. This test needs about a second
   * more of one thread.
   */
  vtkSetClampMacro(Method, int, AUTOMATIC, WINDING_NUMBERS);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  void SetMethodToDistance() { this->SetMethod(DISTANCE); }
  void SetMethodToWindingNumbers() { this->SetMethod(WINDING_NUMBERS); }
  ///@}

  ///@{
  /**
   * Spacing of the grid, as a fraction of the largest distance of a point from the centroid. Gaps
   * of up to two spacings are closed. Time and memory are proportional to its inverse cubed. In
   * [0.002, 0.2]. Default is 0.016.
   *
   * The grid covers the bounding box of the points and needs 17 bytes per node. By default a sphere
   * needs 2 million nodes, and 8 times as many with half the spacing. More than 268,435,456 nodes
   * (4.6 GB) are an error, which states the smallest possible spacing for these points. For a
   * sphere that is 0.00315; flat or thin objects allow smaller values.
   */
  vtkSetClampMacro(Spacing, double, 0.002, 0.2);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * DISTANCE: distance of the surface from the points, in spacings. WINDING_NUMBERS does not use
   * it, since its surface passes through the points. In [0.9, 10]. Default is 1.
   */
  vtkSetClampMacro(Offset, double, 0.9, 10.0);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * DISTANCE: minimum ratio of the width behind a hole in the data to the width of the hole. Holes
   * with a smaller ratio stay open. In [1.1, 10]. Default is 1.5.
   */
  vtkSetClampMacro(Persistence, double, 1.1, 10.0);
  vtkGetMacro(Persistence, double);
  ///@}

  ///@{
  /**
   * Number of smoothing passes over the final surface. In [0, 1000]. Default is 10.
   */
  vtkSetClampMacro(SmoothingPasses, int, 0, 1000);
  vtkGetMacro(SmoothingPasses, int);
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
  vtkGenusZeroHull();
  ~vtkGenusZeroHull() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGenusZeroHull(const vtkGenusZeroHull&) = delete;
  void operator=(const vtkGenusZeroHull&) = delete;

  int Method = DISTANCE;
  double Spacing = 0.016;
  double Offset = 1.0;
  double Persistence = 1.5;
  int SmoothingPasses = 10;
  vtkMultiProcessController* Controller = nullptr;
  bool DistributeOutput = false;
};

#endif

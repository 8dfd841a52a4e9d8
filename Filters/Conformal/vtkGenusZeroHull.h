/**
 * @class   vtkGenusZeroHull
 * @brief   wrap scattered points into one closed surface without handles
 *
 * Make a closed triangle mesh without handles (like that of a cup) around scattered points. The
 * mesh closes holes in the data. It has no webs (spurious membranes) between limbs, the long, thin
 * parts of the object. The field data hold the size of the largest hole, and the number of points
 * outside of the mesh. Further field data count the handles that were cut. Optionally, the mesh
 * keeps the handles of the object, see Genus.
 *
 * Input port 0: vtkPointSet, points in any sequence. Points with non-finite coordinates are left
 * out with a warning, and hidden or duplicate ghost points without a warning. Cells and normals are
 * used only to compute winding numbers (about 1 inside of the points, 0 outside), see Method. If
 * the input has the array "ScannerPosition" (3 components), the positions between a scanner and its
 * points are outside of a hull by winding numbers. The array is a point array with the position of
 * each point's scanner, or a field array with one position for all points.
 *
 * Output port 0: vtkPolyData, the hull: a closed triangle mesh around the points, of genus zero
 * unless Genus is AS_FOUND, in the coordinates of the input, double precision. Triangles are
 * counter-clockwise seen from outside. The filter classifies each node of a regular grid as inside
 * or outside of the points. The hull is the boundary of the set of inside nodes. If
 * DistributeOutput is on, the point array "GlobalPointIds" and the cell array "GlobalCellIds"
 * (vtkIdType) are the active global ids. Field data (one value each; lengths in units of the
 * coordinates):
 * - "AffineRank" (idtype): dimension of the space that the points span: 3 in general, 2 for points
 *   in a plane, 1 for points on a line, 0 for equal points.
 * - "Method" (idtype): value of the property Method by which this hull was made, DISTANCE or
 *   WINDING_NUMBERS. DISTANCE replaces WINDING_NUMBERS in three cases: all points are in a plane,
 *   there are fewer than 20 points, or no grid node is inside.
 * - "NormalsUsed" (idtype): 1 if the winding numbers were computed with normals of the input.
 * - "KernelWidth" (double): radius over which winding numbers were averaged, which is larger for
 *   noisy points; 0 for DISTANCE.
 * - "GridSpacing" (double): distance between neighboring nodes of the grid. Usually this is the
 *   distance that the property Spacing selects. If the points are too far apart for this grid, the
 *   distance is doubled until the grid is suitable.
 * - "NumberOfInsideNodes" (idtype): number of grid nodes inside. For DISTANCE, only nodes farther
 *   from the points than the Offset are counted. A value of 0 means that the points enclose
 *   nothing.
 * - "SolidEulerNumber" (idtype): Euler number of the solid inside the hull before its handles were
 *   cut: 1 minus the number of handles.
 * - "NumberOfHandles" (idtype): number of handles of the hull; 0 unless Genus is AS_FOUND.
 * - "NumberOfCutNodes" (idtype): number of grid nodes removed from the solid to cut handles, or
 *   added to the solid to fill the openings of handles.
 * - "HoleWidth", "HoleDepth" (double): size of the largest hole in the data that was closed.
 *   HoleWidth is the distance from the middle of the hole to the nearest point, about the radius of
 *   the hole. Each position in the space behind the hole has a distance to the nearest point;
 *   HoleDepth is the largest of these distances. If HoleWidth and HoleDepth are nearly equal, the
 *   classification of that space as inside is uncertain. Both values are 0 if there is no hole, and
 *   for WINDING_NUMBERS.
 * - "Leaks" (idtype): 1 if a hole in the data is about as wide as the space behind it. By the rule
 *   of the property Persistence, almost nothing would then be inside. The filter therefore did not
 *   use this rule, and chose at most one part of space that is likely inside.
 * - "NumberOfPointsOutside" (idtype): number of points outside of the hull and not near it:
 *   outliers, and points apart from the largest connected part of the object.
 * - "NumberOfPointsInside" (idtype): number of points inside the hull and not near its surface:
 *   inner parts of the object, and outliers.
 *
 * There is one warning for each of the following cases:
 * - The points enclose nothing, or Leaks is 1.
 * - A handle can be cut only through the inside of the object or through its points. The object
 *   then has a handle, or parts that touch. There is no warning if the hull joined separate limbs
 *   because they are closer than twice the Offset.
 * - More than 0.5 % of the points are outside of the hull and not near it.
 * - More than 0.5 % of the points are inside the hull and not near its surface.
 *
 * The method of this filter is an own construction of the project. The hull is not part of the
 * paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless
 * surface", Neurocomputing 71 (2008)). The paper's method starts from a closed surface of genus
 * zero. This filter makes such a surface without webs between limbs.
 *
 * DISTANCE computes the distance to the points at each node of a grid. It extracts the surface at a
 * small distance from the points, the Offset. A hole in the data is closed if the space behind the
 * hole is wider than the hole by the factor Persistence. The space behind a closed hole is
 * classified as inside. Limbs closer than twice the Offset are first joined, and then separated in
 * the middle between them.
 *
 * WINDING_NUMBERS computes, at each node of a grid, the winding number of the points with their
 * normals: about 1 inside and 0 outside. The surface passes through the points. If the points are
 * noisy, the surface passes through the middle of the noisy layer. A hole in the data is closed by
 * a smooth continuation of the surface around the hole. Normals are those of the input, or are
 * estimated from the points by steepest descent (S. Lin and others, 2022 and 2024; see
 * Documentation/references.bib).
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

  enum Genera
  {
    ZERO = 0,
    AS_FOUND = 1
  };

  ///@{
  /**
   * Method that classifies space as inside or outside. DISTANCE (default): by the distance to the
   * points, which closes holes smaller than the space behind them. WINDING_NUMBERS: by winding
   * numbers (about 1 inside, 0 outside), for scans with large holes, hidden sides or noise.
   * AUTOMATIC: by the distance. If the result seems wrong, AUTOMATIC uses winding numbers, unless
   * the result of winding numbers also seems wrong.
   *
   * Winding numbers use the normals of the input's polygons, or the active normals if there are no
   * polygons. Inward normals are reversed. If the input has no normals, they are estimated from the
   * points. If the input's normals contradict each other, normals are also estimated, with a
   * warning. With AUTOMATIC, the hull by distance seems wrong in any of these cases:
   * - A hole in the data is about as wide as the space behind the hole ("Leaks" is 1).
   * - The points enclose nothing.
   * - The object has handles.
   * - More than 0.5 % of the points are outside and not near the hull.
   * - The hull is torn: more than four handles were cut, by three or more nodes for each. Sheets
   * that are thinner than the spacing of the points cause this, even if the object has no handles.
   *
   * The hull by winding numbers then replaces the hull by distance under three conditions:
   * - No handles of the object were cut in the hull by winding numbers.
   * - Few points are outside of the hull by winding numbers.
   * - The noise of the points is small. If "Leaks" is 1, this condition is not required.
   *
   * If the hull by distance is torn, and the hull by winding numbers does not replace it or is also
   * torn, AUTOMATIC makes hulls by distance with 1.5, 2 and 3 times Offset. The first of them whose
   * handles are cut by at most eight nodes is the result.
   *
   * The computation of the hull by winding numbers costs one to ten seconds on one thread; noisy
   * points take longest.
   */
  vtkSetClampMacro(Method, int, AUTOMATIC, WINDING_NUMBERS);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  void SetMethodToDistance() { this->SetMethod(DISTANCE); }
  void SetMethodToWindingNumbers() { this->SetMethod(WINDING_NUMBERS); }
  ///@}

  ///@{
  /**
   * Distance between neighboring nodes of the grid, as a fraction of the largest distance of a
   * point from the centroid. Gaps between points of up to two spacings are closed. Time and memory
   * are inversely proportional to the cube of the spacing. In [0.002, 0.2]. Default is 0.016.
   *
   * The grid covers the bounding box of the points and needs 17 bytes per node. By default, a
   * sphere needs 2 million nodes, and 8 times as many with half the spacing. More than 268,435,456
   * nodes (4.6 GB) are an error. The message of the error states the smallest possible spacing for
   * these points. For a sphere, the smallest spacing is 0.00315. Flat or thin objects allow smaller
   * values.
   */
  vtkSetClampMacro(Spacing, double, 0.002, 0.2);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Distance of the surface from the points if Method is DISTANCE, in units of the grid spacing.
   * WINDING_NUMBERS does not use this property, since its surface passes through the points. In
   * [0.9, 10]. Default is 1.
   */
  vtkSetClampMacro(Offset, double, 0.9, 10.0);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * Minimum ratio of the width of the space behind a hole in the data to the width of the hole.
   * Used only if Method is DISTANCE. A hole with a larger ratio is closed. Other holes stay open:
   * the space behind them is outside. In [1.1, 10]. Default is 1.5.
   */
  vtkSetClampMacro(Persistence, double, 1.1, 10.0);
  vtkGetMacro(Persistence, double);
  ///@}

  ///@{
  /**
   * Genus (number of handles) of the hull. ZERO (default): all handles are removed, so that the
   * hull can be mapped to the sphere. AS_FOUND: handles of the object are kept, if they are at
   * least as wide as HandleWidth. A hull with one handle is mapped to a flat torus by
   * vtkGlobalConformalMap. There is no map of a hull with several handles.
   */
  vtkSetClampMacro(Genus, int, ZERO, AS_FOUND);
  vtkGetMacro(Genus, int);
  void SetGenusToZero() { this->SetGenus(ZERO); }
  void SetGenusToAsFound() { this->SetGenus(AS_FOUND); }
  ///@}

  ///@{
  /**
   * Minimum width of a handle that is kept, and of the opening of the handle. The unit is the grid
   * spacing, or the mean distance between neighboring points if it is larger. Used if Genus is
   * AS_FOUND. Thinner handles are cut, and narrower openings are filled. Increase the value if
   * "NumberOfHandles" is larger than the number of handles of the object. Decrease the value, or
   * Spacing, if a handle is missing. In [0, 1000]. Default is 4.
   *
   * The width of a handle is twice the largest distance between the points and a node in its
   * narrowest cross section. The width of an opening is defined in the same way. If Method is
   * DISTANCE, widths below twice the Offset have no effect, since limbs at this distance are
   * joined.
   */
  vtkSetClampMacro(HandleWidth, double, 0.0, 1000.0);
  vtkGetMacro(HandleWidth, double);
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
   * piece of the points, which may be empty. The surface encloses the points of all processes. The
   * result is equal bit by bit for any number of processes. Default is the global controller. With
   * null, only the points of this process are used.
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
  int Genus = ZERO;
  double HandleWidth = 4.0;
  int SmoothingPasses = 10;
  vtkMultiProcessController* Controller = nullptr;
  bool DistributeOutput = false;
};

#endif

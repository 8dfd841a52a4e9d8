/**
 * @class   vtkGenusZeroHull
 * @brief   wrap scattered points into one closed surface without handles
 *
 * Make a closed triangle mesh around the points, across holes in the data and without webs
 * between limbs. The field data state how large the largest hole was, how many handles were cut
 * open, and how many points lie outside.
 *
 * Input port 0: vtkPointSet, any points in any order. Points that are not finite are left out with
 * a warning, hidden or duplicate ghost points silently. Cells and normals are used by
 * WINDING_NUMBERS only, see Method.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh of genus zero around the points, in their
 * coordinates, double precision; triangles are counter-clockwise seen from outside. With
 * DistributeOutput, point and cell arrays "GlobalPointIds" and "GlobalCellIds" (vtkIdType), the
 * active global ids. Field data, one value each, lengths in units of the coordinates:
 * - "AffineRank" (idtype): 3 for a solid cloud, 2 for points in a plane, 1 on a line, 0 for
 * equal points.
 * - "Method" (idtype): what told inside from outside, as the property; DISTANCE also where
 *   winding numbers cannot tell: points in a plane, fewer than 20, or nothing found inside.
 * - "NormalsUsed" (idtype): 1 if normals were given and told what is outside.
 * - "KernelWidth" (double): the radius over which winding numbers were averaged; wider with noise.
 * 0 for DISTANCE.
 * - "GridSpacing" (double): Spacing, or a multiple of it where the points lie too far apart.
 * - "NumberOfInsideNodes" (idtype): grid nodes inside; for DISTANCE those farther from the
 * points than the offset. 0 means that the points enclose nothing.
 * - "SolidEulerNumber" (idtype): of what the hull is the surface of, before handles were cut: 1
 *   minus the number of handles.
 * - "NumberOfCutNodes" (idtype): grid nodes taken away, or added, to open the handles.
 * - "HoleWidth", "HoleDepth" (double): of the largest hole in the data that was closed, the
 * distance from its middle to the nearest point, and the largest such distance inside, behind the
 * hole. 0 where there is none, and for WINDING_NUMBERS. The nearer they are, the less certain is
 * what is inside.
 * - "Leaks" (idtype): 1 if a hole was so wide that persistence did not tell inside from outside,
 * and the most likely part was taken for inside.
 * - "NumberOfPointsOutside" (idtype): points that the hull was not made around: outliers, and what
 *   lies apart from the largest piece.
 * - "NumberOfPointsInside" (idtype): points inside the hull that lie apart from its surface: inner
 *   parts, and outliers.
 *
 * One warning each if the points enclose nothing or Leaks is 1; if handles cannot be opened without
 * a cut through the inside of the object or through its points, so that it is not of genus zero or
 * parts of it touch (limbs that only the offset joined are no reason); if more than 1 of 200 points
 * lie outside; if more than 1 of 200 lie inside.
 *
 * No part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on
 * curved seamless surface", Neurocomputing 71 (2008)), but of use to it: its method starts from a
 * closed surface of genus zero, and this one has no webs between limbs.
 *
 * The distance to the points is found on a grid and the surface taken at a small offset. Inside
 * and outside are told apart by persistence: a hole in the data is closed if what lies behind it is
 * wider than the hole by the factor Persistence. Limbs closer than twice the offset are joined by
 * it, and parted again in the middle between them.
 *
 * With WINDING_NUMBERS all points say at once what is inside, so that a hole in the data is closed
 * by the smooth surface that the rest implies, and the surface goes through the points, amid noise.
 * The normals it needs are those of the input or are found by steepest descent (S. Lin and others,
 * 2022 and 2024; see Documentation/references.bib).
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
   * How inside and outside are classified. DISTANCE (default): by the distance to the points, which
   * closes holes smaller than what is behind them. WINDING_NUMBERS: by winding numbers around all
   * points, for scans with large holes, hidden sides or noise. AUTOMATIC: by the distance; where
   * that seems wrong, by winding numbers if these do not.
   *
   * Winding numbers need normals: those of the input's polygons, else its active normals; inward
   * ones are turned. Where there are none, or where they do not agree on what is inside (with a
   * warning), normals are found from the points. With AUTOMATIC the distance seems wrong with a
   * hole as wide as what is behind it, handles, or many points left out; winding numbers also have
   * to find little noise. That needs about a second of one thread more.
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
   * of two spacings or less are closed. Time and memory grow with its inverse cubed. In [0.002,
   * 0.2]. Default is 0.016.
   *
   * The grid covers the points' bounding box and needs 17 bytes a node: 2 million of them around a
   * sphere by default, 8 times as many with half the spacing. More than 268,435,456 (4.6 GB) are an
   * error, with the smallest spacing that is possible for these points. For a sphere that is
   * 0.00315; the flatter or thinner the object, the smaller it is.
   */
  vtkSetClampMacro(Spacing, double, 0.002, 0.2);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * DISTANCE: distance of the surface from the points, in spacings. WINDING_NUMBERS: not used, the
   * surface goes through the points. In [0.9, 10]. Default is 1.
   */
  vtkSetClampMacro(Offset, double, 0.9, 10.0);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * DISTANCE: how many times wider than a hole in the data what lies behind it must be for the hole
   * to be closed. In [1.1, 10]. Default is 1.5.
   */
  vtkSetClampMacro(Persistence, double, 1.1, 10.0);
  vtkGetMacro(Persistence, double);
  ///@}

  ///@{
  /**
   * Passes of smoothing that the surface gets at the end. In [0, 1000]. Default is 10.
   */
  vtkSetClampMacro(SmoothingPasses, int, 0, 1000);
  vtkGetMacro(SmoothingPasses, int);
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

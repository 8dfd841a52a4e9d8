/**
 * @class   vtkGenusZeroRepair
 * @brief   free a triangle mesh from handles, small holes and other parts, and leave the rest alone
 *
 * Keep the largest part of the mesh, fill its holes, and cut each handle along a short loop around
 * it or through it. The result is a closed surface of genus zero. Remaining triangles are not
 * changed. The second output has the loops; the field data state each repair.
 *
 * Input port 0: vtkPolyData. Polygons and strips are treated as triangles; vertices and lines are
 * ignored.
 *
 * Output port 0: vtkPolyData, the largest part as a closed triangle mesh of genus zero, double
 * precision, triangles counter-clockwise seen from outside. No point is moved. Remaining triangles
 * keep their coordinates, bit by bit, and their order; added triangles follow them. An input that
 * needs no repair is passed unchanged. The output has
 * - cell array "OriginalCellIds" (vtkIdType): the input's cell that the triangle is, or is part of;
 *   -1 for added triangles.
 * - point array "OriginalPointIds" (vtkIdType): the input's point; -1 for added points. Points
 *   along a cut are duplicated.
 * - the input's numeric point arrays. Added points get the mean of the points around them; in
 *   integer arrays of 1 component (labels) they get the most frequent label. A repair removes
 *   "SpherePosition", active normals, texture coordinates, and global and pedigree ids. It also
 *   removes cell arrays; "OriginalCellIds" refers to them.
 *
 * Output port 1: vtkPolyData, a closed polyline for each place of repair, with cell arrays
 * - "LoopType" (vtkIdType): 0 (FILLED_HOLE) a boundary that was filled; 1 (OPEN_HOLE) a boundary
 *   that was too large to be filled; 2 (CUT_HANDLE) a loop around a handle that was cut through; 3
 *   (FILLED_TUNNEL) a loop through a handle whose hole was filled.
 * - "LoopLength" (double): length of the loop.
 * - "LoopAreaFraction" (double): area of the filling, as a fraction of the area of the surface.
 *
 * Field data of port 0 (one value, vtkIdType unless noted):
 * - "IsGenusZero": 1 if the output is a closed surface of genus zero, as in vtkGenusZeroCheck; 0 if
 *   a hole was left.
 * - "EulerNumber": of the output.
 * - "NumberOfHandlesCut", "NumberOfTunnelsFilled": their sum is the number of handles of the input.
 * - "NumberOfBoundariesFilled", "NumberOfBoundariesLeft".
 * - "NumberOfPartsRemoved", "NumberOfTrianglesRemoved", "RemovedAreaFraction" (double): all parts
 *   but the largest.
 * - "NumberOfPointsMerged": coincident points of open edges.
 * - "NumberOfTrianglesTurned": triangles reversed for a consistent orientation.
 * - "NumberOfTrianglesDropped": triangles with a repeated point, and duplicates.
 * - "NumberOfEdgesSeparated": edges of more than two triangles.
 * - "NumberOfTrianglesAdded".
 * - "UntouchedFraction" (double): fraction of the input's triangles that are in the output.
 * - "RepairReport" (string): one line for each repair that was made, and for each that was not.
 *
 * There is one warning each for holes left open, other parts left out, separated edges of more than
 * two triangles, and dropped triangles. A largest part that is not orientable is an error.
 *
 * The repair is not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008)), whose method needs
 * surfaces of genus zero. Every handle has loops around it and loops through it. The mesh is cut
 * along a shortest loop, and both sides of the cut are filled (Wood and others 2004). Loops are
 * found after Eppstein 2003 and Erickson and Whittlesey 2005; see Documentation/references.bib.
 * Both sides have the same positions: programs that merge points by coordinates would join them
 * again.
 *
 * @sa
 * vtkGenusZeroCheck vtkGenusZeroHull vtkGlobalConformalMap vtkFillHolesFilter
 */

#ifndef vtkGenusZeroRepair_h
#define vtkGenusZeroRepair_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkGenusZeroRepair : public vtkPolyDataAlgorithm
{
public:
  static vtkGenusZeroRepair* New();
  vtkTypeMacro(vtkGenusZeroRepair, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of "LoopType".
  enum LoopTypes
  {
    FILLED_HOLE = 0,
    OPEN_HOLE = 1,
    CUT_HANDLE = 2,
    FILLED_TUNNEL = 3
  };

  ///@{
  /**
   * Maximum size of a hole that is filled: area of the filling, as a fraction of the area of the
   * surface. Larger holes stay open, with a warning. In [0, 1]. Default is 0.25.
   */
  vtkSetClampMacro(MaximumHoleArea, double, 0.0, 1.0);
  vtkGetMacro(MaximumHoleArea, double);
  ///@}

protected:
  vtkGenusZeroRepair();
  ~vtkGenusZeroRepair() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGenusZeroRepair(const vtkGenusZeroRepair&) = delete;
  void operator=(const vtkGenusZeroRepair&) = delete;

  double MaximumHoleArea = 0.25;
};

#endif

/**
 * @class   vtkGenusZeroRepair
 * @brief   join overlapping parts of a mesh, and remove handles, small holes and separate parts
 *
 * Repair a triangle mesh so that it is a closed surface of genus zero. The filter replaces closed
 * parts that overlap by their union. It keeps the largest connected part of the mesh and fills its
 * holes. The filter cuts each handle (like that of a cup)
 * along a short loop, which runs around the handle or through its opening. Remaining triangles are
 * not changed. The second output has the loops. The field data report each repair.
 *
 * Input port 0: vtkPolyData. Polygons and strips are treated as triangles; vertices and lines are
 * ignored.
 *
 * Output port 0: vtkPolyData, the largest part as a closed triangle mesh of genus zero, double
 * precision. Triangles are counter-clockwise seen from outside. No point is moved. Remaining
 * triangles keep their coordinates, bit by bit, and their sequence; added triangles follow at the
 * end. Where parts overlap, triangles are split along the curve in which the parts cross. If the
 * input needs no repair, it is passed unchanged. The output has
 * - cell array "OriginalCellIds" (vtkIdType): id of the input's cell that contains the triangle;
 *   -1 for added triangles.
 * - point array "OriginalPointIds" (vtkIdType): id of the input's point; -1 for added points.
 *   Points along a cut are duplicated.
 * - the input's numeric point arrays. An added point gets the mean value of the points around it.
 *   In integer arrays of 1 component (labels), an added point gets the most frequent label around
 *   it. A repair removes "SpherePosition", active normals, texture coordinates, and global and
 *   pedigree ids. A repair also removes cell arrays. Use "OriginalCellIds" to look up their values
 *   in the input.
 *
 * Output port 1: vtkPolyData, one closed polyline for each hole or handle, with cell arrays
 * - "LoopType" (vtkIdType): 0 (FILLED_HOLE) for the boundary of a hole that was filled; 1
 *   (OPEN_HOLE) for the boundary of a hole that was too large to be filled; 2 (CUT_HANDLE) for a
 *   loop around a handle that was cut through; 3 (FILLED_TUNNEL) for a loop around the opening of a
 *   handle; the opening was filled.
 * - "LoopLength" (double): length of the loop.
 * - "LoopAreaFraction" (double): area of the filling, as a fraction of the area of the surface. For
 *   a hole that was left open, the value is the area that a filling would have.
 *
 * Field data of port 0 (one value each, vtkIdType unless noted):
 * - "IsGenusZero": 1 if the output is a closed surface of genus zero, as in vtkGenusZeroCheck; 0 if
 *   a hole was left open.
 * - "EulerNumber": Euler number of the output.
 * - "NumberOfHandlesCut", "NumberOfTunnelsFilled": number of handles that were cut through, and
 *   number of handles whose openings were filled. The sum of the two numbers is the number of
 *   handles of the input's largest part.
 * - "NumberOfBoundariesFilled", "NumberOfBoundariesLeft": numbers of holes that were filled and
 *   that were left open.
 * - "NumberOfPartsJoined": number of closed parts that overlap other parts and were joined with
 *   them.
 * - "NumberOfPartsRemoved", "NumberOfTrianglesRemoved", "RemovedAreaFraction" (double): number of
 *   the removed parts, number of their triangles, and their fraction of the area of the input. All
 *   parts but the largest are removed.
 * - "NumberOfPointsMerged": number of coincident points of open edges (edges of only one triangle)
 *   that were merged.
 * - "NumberOfTrianglesTurned": number of triangles that were reversed for a consistent orientation.
 * - "NumberOfTrianglesDropped": number of dropped triangles: those with a repeated point, and
 *   duplicates.
 * - "NumberOfEdgesSeparated": number of edges that belonged to more than two triangles. Each was
 *   split into edges of at most two triangles.
 * - "NumberOfPointsSeparated": number of points of the largest part whose triangles form several
 *   fans around the point. Each fan got a point at the same place.
 * - "NumberOfTrianglesAdded": number of triangles that fill holes and cuts, and of pieces of
 *   triangles that were split.
 * - "UntouchedFraction" (double): fraction of the input's triangles that are in the output.
 * - "RepairReport" (string): one line for each repair that was made, and for each hole that was
 *   left open.
 *
 * There is one warning each for open holes, removed parts, separated edges and points, and dropped
 * triangles.
 * If the largest part is not orientable, there is an error.
 *
 * The repair is not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008)). The method of the
 * paper needs surfaces of genus zero. Each handle has loops around the handle, and loops through
 * its opening. The mesh is cut along a short loop of either kind, and both sides of the cut are
 * filled (Wood and others 2004). Loops are found by the methods of Eppstein 2003 and of Erickson
 * and Whittlesey 2005; see Documentation/references.bib. Both fillings of a cut have the same
 * positions. A program that merges points by coordinates would therefore join the sides again.
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
   * surface. Larger holes are left open, with a warning. In [0, 1]. Default is 0.25.
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

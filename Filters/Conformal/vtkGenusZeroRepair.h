/**
 * @class   vtkGenusZeroRepair
 * @brief   free a triangle mesh from handles, small holes and other parts, and leave the rest alone
 *
 * Keep the largest part of the mesh, fill its holes, and cut each handle along a short loop
 * around it or through it, so that the result is a closed surface of genus zero. Triangles that
 * are left are not changed. The second output has the loops; the field data state what was done.
 *
 * Input port 0: vtkPolyData. Polygons and strips are treated as triangles; vertices and lines are
 * ignored.
 *
 * Output port 0: vtkPolyData, the largest part of it as a closed triangle mesh of genus zero,
 * triangles counter-clockwise seen from outside, double precision. No point is moved: triangles
 * that are left keep their coordinates to the bit and their order, and come before those that were
 * added. An input that needs no repair is passed as it is. With
 * - cell array "OriginalCellIds" (vtkIdType): the input's cell that the triangle is, or is part of;
 *   -1 for those that were added.
 * - point array "OriginalPointIds" (vtkIdType): the input's point; -1 for those that were added.
 * The points along a cut are there twice.
 * - the input's point arrays of numbers: of points that were added, means of those around; arrays
 *   of integers of 1 component are labels, of which the most frequent is taken. "SpherePosition",
 *   active normals, texture coordinates and global and pedigree ids are left out where there was
 *   something to repair; so are cell arrays, which "OriginalCellIds" finds.
 *
 * Output port 1: vtkPolyData, a closed polyline for each place of repair, with cell arrays
 * - "LoopType" (vtkIdType): 0 (FILLED_HOLE) a boundary that was filled, 1 (OPEN_HOLE) one that was
 *   not since it is too large, 2 (CUT_HANDLE) around a handle, which was cut through there, 3
 *   (FILLED_TUNNEL) through a handle, whose hole was filled there.
 * - "LoopLength" (double); "LoopAreaFraction" (double): area of what fills it, as a share of the
 *   area of the surface.
 *
 * Field data of port 0 (one value, vtkIdType unless noted):
 * - "IsGenusZero": 1 if the output is a closed surface of genus zero, as vtkGenusZeroCheck says;
 *   0 if a hole was left. "EulerNumber": of the output.
 * - "NumberOfHandlesCut", "NumberOfTunnelsFilled": together the number of handles there were.
 * - "NumberOfBoundariesFilled", "NumberOfBoundariesLeft".
 * - "NumberOfPartsRemoved", "NumberOfTrianglesRemoved", "RemovedAreaFraction" (double): of the
 * parts beside the largest.
 * - "NumberOfPointsMerged": coincident points of open edges. "NumberOfTrianglesTurned": to agree
 *   in orientation. "NumberOfTrianglesDropped": with a repeated point, or there twice.
 *   "NumberOfEdgesSeparated": of more than two triangles.
 * - "NumberOfTrianglesAdded"; "UntouchedFraction" (double): share of the input's triangles that are
 *   in the output.
 * - "RepairReport" (string): the same in words, a line for each thing done, and for each not done.
 *
 * One warning each if a hole was left open, if other parts were left out, if edges of more than two
 * triangles had to be separated, or if triangles were dropped. A surface whose largest part is not
 * orientable is an error.
 *
 * Not in the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved
 * seamless surface", Neurocomputing 71 (2008)), but what its surfaces of genus zero come from.
 * Around a handle and through it there are two kinds of loops; the mesh is cut along a shortest one
 * and both sides of the cut are filled (Wood and others 2004; the loops by Eppstein 2003, Erickson
 * and Whittlesey 2005; see Documentation/references.bib). The two sides lie at the same places:
 * programs that merge points by their coordinates would join them again.
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
   * The largest hole that is filled: the area of what fills it, as a share of the area of the
   * surface. Larger ones are left open, with a warning. In [0, 1]. Default is 0.25.
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

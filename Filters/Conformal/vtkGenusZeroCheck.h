/**
 * @class   vtkGenusZeroCheck
 * @brief   check whether a surface is closed, manifold, connected, of genus zero and oriented
 *
 * Check a surface and add the result as field data; the surface itself is not changed. IsGenusZero
 * is 1 if the surface is closed, manifold, connected and without handles. Other field data hold the
 * numbers of boundary edges, components, non-manifold edges and other faults, and the ids of faulty
 * edges, points and cells. GenusZeroReport describes the faults in words. ParaView's spreadsheet
 * view shows these arrays under Field Data.
 *
 * Input port 0: vtkPolyData. Polygons and strips are treated as triangles; vertices and lines are
 * ignored.
 *
 * Output port 0: the input, with field data about its faults.
 *
 * Numbers (vtkIdType, one value each):
 * - "IsGenusZero": 1 if the surface is closed, manifold, connected and of Euler number 2.
 *   Inconsistent orientation, triangles without area and isolated points do not affect this value,
 *   since other filters can repair them.
 * - "EulerNumber": number of vertices minus edges plus triangles, without isolated points.
 * - "NumberOfBoundaryEdges": edges of only one triangle.
 * - "NumberOfBoundaryLoops": connected sets of boundary edges.
 * - "NumberOfNonManifoldEdges": edges of more than two triangles.
 * - "NumberOfNonManifoldVertices": vertices whose triangles form more than one fan (sequence of
 *   triangles in which neighbors share an edge).
 * - "NumberOfComponents": connected parts of the surface.
 * - "NumberOfInconsistentEdges": edges whose two triangles are oriented inconsistently: the edge
 *   has the same direction in both.
 * - "NumberOfDegenerateTriangles": triangles with a repeated point or without area. Triangles with
 *   a repeated point are left out of all other numbers.
 * - "NumberOfIsolatedPoints": points that belong to no triangle.
 * - "NumberOfNonFinitePoints": points with a coordinate that is infinite or not a number.
 * - "IsInsideOut": 1 if the triangles of a closed, consistently oriented surface are clockwise seen
 *   from outside.
 *
 * Ids of the faults (vtkIdType, one tuple for each fault):
 * - "BoundaryEdges", "NonManifoldEdges", "InconsistentEdges" (2 components): point ids.
 * - "NonManifoldVertices", "IsolatedPoints": point ids.
 * - "DegenerateTriangles": cell ids.
 *
 * Report:
 * - "GenusZeroReport" (string): one line about the surface, and one line for each fault.
 *
 * A faulty surface does not cause an error. The filter reports faults in the field data only.
 *
 * @sa
 * vtkCurvedSeamlessSurface vtkConformalDistortion vtkFeatureEdges
 */

#ifndef vtkGenusZeroCheck_h
#define vtkGenusZeroCheck_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkGenusZeroCheck : public vtkPolyDataAlgorithm
{
public:
  static vtkGenusZeroCheck* New();
  vtkTypeMacro(vtkGenusZeroCheck, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGenusZeroCheck() = default;
  ~vtkGenusZeroCheck() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGenusZeroCheck(const vtkGenusZeroCheck&) = delete;
  void operator=(const vtkGenusZeroCheck&) = delete;
};

#endif

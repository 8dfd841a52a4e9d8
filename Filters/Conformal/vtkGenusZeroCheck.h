/**
 * @class   vtkGenusZeroCheck
 * @brief   check whether a surface is closed, manifold, connected, of genus zero and oriented
 *
 * Pass the surface through and add field data: IsGenusZero, the numbers of boundary edges,
 * components, non-manifold edges and other faults, and the ids of faulty edges, points and cells.
 * GenusZeroReport describes the faults in words. A spreadsheet view shows them under Field Data.
 *
 * Input port 0: vtkPolyData. Polygons and strips are treated as triangles; vertices and lines are
 * ignored.
 *
 * Output port 0: the input, with field data about faults and where they are. Figures (vtkIdType,
 * one value):
 * - "IsGenusZero": 1 if the surface is closed, manifold, in one piece and of Euler number 2.
 *   Inconsistent orientation, triangles without area and isolated points can be repaired and do not
 *   count here.
 * - "EulerNumber": vertices - edges + triangles, without isolated points.
 * - "NumberOfBoundaryEdges".
 * - "NumberOfBoundaryLoops": connected sets of boundary edges.
 * - "NumberOfNonManifoldEdges": edges of more than two triangles.
 * - "NumberOfNonManifoldVertices": vertices with more than one fan of triangles.
 * - "NumberOfComponents".
 * - "NumberOfInconsistentEdges": edges with the same direction in both triangles.
 * - "NumberOfDegenerateTriangles": triangles with a repeated point or without area. Triangles with
 *   a repeated point do not count in the other figures.
 * - "NumberOfIsolatedPoints": points of no triangle.
 * - "NumberOfNonFinitePoints".
 * - "IsInsideOut": 1 if the triangles of a closed, consistently oriented surface are clockwise seen
 *   from outside.
 *
 * Positions of the faults (vtkIdType, one tuple per fault):
 * - "BoundaryEdges", "NonManifoldEdges", "InconsistentEdges" (2 components): point ids.
 * - "NonManifoldVertices", "IsolatedPoints": point ids.
 * - "DegenerateTriangles": cell ids.
 *
 * Report:
 * - "GenusZeroReport" (string): one line about the surface, and one line for each fault.
 *
 * A faulty mesh causes no error; the filter reports it in the field data.
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

/**
 * @class   vtkGenusZeroCheck
 * @brief   check whether a surface is closed, manifold, connected, of genus zero and oriented
 *
 * Pass the surface on with field data: IsGenusZero, the numbers of boundary edges, components,
 * non-manifold edges and so on, the ids of faulty edges, points and cells, and all of it in
 * words in GenusZeroReport. A spreadsheet view shows them under Field Data.
 *
 * Input port 0: vtkPolyData. Polygons and strips are treated as triangles; vertices and lines
 * are ignored.
 *
 * Output port 0: the input, with field data that says what is wrong and where. Figures (vtkIdType,
 * one value):
 * - "IsGenusZero": 1 if the surface is closed, manifold, in one piece and of Euler number 2.
 *   Orientation, triangles without area and isolated points are faults that can be repaired and
 *   do not count here.
 * - "EulerNumber": vertices - edges + triangles, without isolated points.
 * - "NumberOfBoundaryEdges", "NumberOfBoundaryLoops" (connected sets of boundary edges),
 *   "NumberOfNonManifoldEdges" (of more than two triangles), "NumberOfNonManifoldVertices" (where
 *   several fans of triangles meet), "NumberOfComponents", "NumberOfInconsistentEdges" (which both
 *   triangles run the same way), "NumberOfDegenerateTriangles" (a repeated point or no area; those
 *   of a repeated point take no part in the other figures), "NumberOfIsolatedPoints" (of no
 *   triangle), "NumberOfNonFinitePoints".
 * - "IsInsideOut": 1 if the triangles of a closed, consistently oriented surface are clockwise
 *   seen from outside.
 *
 * Where (vtkIdType, as many tuples as there are faults):
 * - "BoundaryEdges", "NonManifoldEdges", "InconsistentEdges" (2 components): point ids.
 * - "NonManifoldVertices", "IsolatedPoints": point ids.
 * - "DegenerateTriangles": cell ids.
 *
 * And "GenusZeroReport" (string): the same in words, a line what the surface is and a line for each
 * fault.
 *
 * A bad mesh is no error: to report it is what the filter is for.
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

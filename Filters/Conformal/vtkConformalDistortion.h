/**
 * @class   vtkConformalDistortion
 * @brief   measure the angle and area distortion of a surface's map to the sphere
 *
 * Add the cell arrays AngleDistortion (degrees; 0 means none), AreaDistortion (logarithm; 0 means
 * none) and QuasiConformalError (1 means none). The field data hold their means, and the number of
 * flipped triangles.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components).
 * Polygons and strips are treated as triangles; the value of a polygon is the mean over its
 * triangles.
 *
 * Output port 0: the input, with cell arrays (double, 1 component). Lines, vertices and triangles
 * without area on the surface or the sphere get the value of no distortion.
 * - "AngleDistortion": mean absolute difference between the angles of a triangle on the surface and
 *   on the sphere, in degrees. 0 means none.
 * - "AreaDistortion": logarithm of a triangle's fraction of the sphere's area, divided by its
 *   fraction of the surface's area. 0 means none.
 * - "QuasiConformalError": ratio of the largest to the smallest stretch of lengths. 1 means none.
 *
 * Field data (one value), over the triangles that have an area on both:
 * - "MeanAngleDistortion", "MeanQuasiConformalError" (double).
 * - "AreaDistortionDeviation" (double): standard deviation of AreaDistortion.
 * - "SphereDegree" (double): how often the triangles cover the sphere, 1 for a proper map. Negative
 *   if the triangles are clockwise on the sphere: -1 for a map that mirrors, and for a surface
 *   oriented inward.
 * - "NumberOfFlippedTriangles" (vtkIdType): triangles on the sphere that are flat, or oriented
 *   against most of the sphere's area. 0 for a map that mirrors all of them.
 * - "NumberOfZeroAreaTriangles" (vtkIdType): triangles without area, which are left out.
 *
 * Triangles on the sphere are treated as flat, between the positions of their corners. Sections 2
 * and 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless
 * surface", Neurocomputing 71 (2008), assume that the map to the sphere is conformal. These figures
 * measure to which degree it is.
 *
 * @sa
 * vtkConformalSOM vtkCurvedSeamlessSurface vtkSurfaceMismatch vtkGenusZeroCheck
 */

#ifndef vtkConformalDistortion_h
#define vtkConformalDistortion_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkConformalDistortion : public vtkPolyDataAlgorithm
{
public:
  static vtkConformalDistortion* New();
  vtkTypeMacro(vtkConformalDistortion, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkConformalDistortion() = default;
  ~vtkConformalDistortion() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConformalDistortion(const vtkConformalDistortion&) = delete;
  void operator=(const vtkConformalDistortion&) = delete;
};

#endif

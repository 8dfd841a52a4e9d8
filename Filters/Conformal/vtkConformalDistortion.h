/**
 * @class   vtkConformalDistortion
 * @brief   measure the angle and area distortion of a surface's map to the sphere
 *
 * Measure how much each triangle of a surface is distorted by the surface's map to the sphere. The
 * cell arrays are AngleDistortion (degrees; 0 means none), AreaDistortion (logarithm; 0 means none)
 * and QuasiConformalError (1 means none). The field data hold mean values over the surface, and the
 * number of flipped triangles.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components).
 * Polygons and strips are treated as triangles. The value of a polygon is the mean over its
 * triangles.
 *
 * Output port 0: the input, with cell arrays (double, 1 component). Lines, vertices, and triangles
 * without area on the surface or on the sphere get the value that means no distortion.
 * - "AngleDistortion": mean absolute difference between the angles of a triangle on the surface and
 *   on the sphere, in degrees. 0 means none.
 * - "AreaDistortion": natural logarithm of the ratio a / b. Here a is the triangle's fraction of
 *   the area of the sphere, and b is its fraction of the area of the surface. 0 means none.
 * - "QuasiConformalError": the map scales lengths in the triangle by a factor that depends on the
 *   direction. The value is the largest factor divided by the smallest factor. 1 means none.
 *
 * Field data (one value each), computed over the triangles that have an area both on the surface
 * and on the sphere:
 * - "MeanAngleDistortion", "MeanQuasiConformalError" (double): means of the cell arrays.
 * - "MaximumQuasiConformalError" (double): maximum of "QuasiConformalError".
 * - "AreaDistortionDeviation" (double): standard deviation of AreaDistortion.
 * - "SphereDegree" (double): number of times that the triangles cover the sphere; 1 for a valid
 *   map. The number is negative if the triangles on the sphere are clockwise seen from outside. For
 *   example, the number is -1 for a valid map that reverses the orientation of all triangles. The
 *   number is also -1 for a valid map of a surface whose normals point inward.
 * - "NumberOfFlippedTriangles" (vtkIdType): number of triangles without area on the sphere, plus
 *   the number of reversed triangles. Triangles with one of the two orientations cover the larger
 *   area of the sphere; triangles with the other orientation are counted as reversed. If a map
 *   reverses all triangles, none is counted.
 * - "NumberOfZeroAreaTriangles" (vtkIdType): number of triangles without area on the surface or on
 *   the sphere. These triangles are left out of the means.
 *
 * A triangle on the sphere is treated as the flat triangle between the positions of its corners.
 * Sections 2 and 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved
 * seamless surface", Neurocomputing 71 (2008), assume that the map to the sphere is conformal. The
 * values of this filter measure how far a map is from conformal.
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

/**
 * @class   vtkConformalDistortion
 * @brief   measure the angle and area distortion of a surface's map to the sphere
 *
 * Add the cell arrays AngleDistortion (degrees; 0 means none), AreaDistortion (logarithm; 0
 * means none) and QuasiConformalError (1 means none), and their means in the field data, among
 * them NumberOfFlippedTriangles.
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components).
 * Polygons and strips are treated as triangles; their value is the mean over these.
 *
 * Output port 0: the input, with cell arrays (double, 1 component; lines, vertices and triangles
 * without area on the surface or the sphere get the value of no distortion)
 * - "AngleDistortion": mean difference between the angles of a corner on the surface and on the
 *   sphere, in degrees. 0 means none.
 * - "AreaDistortion": logarithm of the ratio of a triangle's share of the sphere's area to its
 * share of the surface's. 0 means none.
 * - "QuasiConformalError": ratio of the largest to the smallest stretch of lengths. 1 means none.
 *
 * Field data (one value), over the triangles that have an area on both:
 * - "MeanAngleDistortion", "MeanQuasiConformalError" (double).
 * - "AreaDistortionDeviation" (double): standard deviation of AreaDistortion.
 * - "SphereDegree" (double): how often the sphere is covered, 1 for a proper map. Less than 0 if
 *   the triangles run clockwise there: -1 for a map that mirrors, and for a surface wound inward.
 * - "NumberOfFlippedTriangles" (vtkIdType): triangles turned over by the map, against most of the
 *   sphere's area, or flat on the sphere. 0 for a map that mirrors all of them.
 * - "NumberOfZeroAreaTriangles" (vtkIdType): those without area, left out.
 *
 * Triangles on the sphere are taken flat, between the places of their corners. That a map to the
 * sphere is conformal is what sections 2 and 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), build on; these
 * figures say to which degree it is.
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

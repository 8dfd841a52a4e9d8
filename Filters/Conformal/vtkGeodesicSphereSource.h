/**
 * @class   vtkGeodesicSphereSource
 * @brief   make a geodesic sphere, the mesh from which vtkConformalSOM starts
 *
 * Make a geodesic sphere: an icosahedron whose triangles are subdivided and projected onto the unit
 * sphere. Let f be the Frequency. The mesh has 10 f^2 + 2 points and 20 f^2 triangles. The filter
 * vtkConformalSOM learns a surface by moving the points of a geodesic sphere. The coordinates of
 * the points are also stored in the point array "SpherePosition".
 *
 * Output port 0: vtkPolyData, a closed triangle mesh of 10 f^2 + 2 points and 20 f^2 triangles,
 * where f is the Frequency. Points lie on the unit sphere around the origin. Triangles are
 * counter-clockwise seen from outside. Point 0 is the north pole (0, 0, 1).
 * - point array "SpherePosition" (double, 3 components): the point itself, as a unit vector.
 * - point array "Normals" (double, 3 components): outward unit normals, equal to "SpherePosition".
 *
 * The mesh defines the neurons (points) and their neighbors (edges) in the conformal
 * self-organizing map, Eqs. 1 and 2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008). A second geodesic
 * sphere, usually of higher Frequency than the network of neurons, defines the directions in which
 * vtkCurvedSeamlessSurface samples a surface.
 *
 * @sa
 * vtkConformalSOM vtkCurvedSeamlessSurface
 */

#ifndef vtkGeodesicSphereSource_h
#define vtkGeodesicSphereSource_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkGeodesicSphereSource : public vtkPolyDataAlgorithm
{
public:
  static vtkGeodesicSphereSource* New();
  vtkTypeMacro(vtkGeodesicSphereSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of parts into which each edge of the icosahedron is divided, called f in the paper. In
   * [1, 1000]. Default is 36, which gives 12,962 points and 25,920 triangles.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

protected:
  vtkGeodesicSphereSource();
  ~vtkGeodesicSphereSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGeodesicSphereSource(const vtkGeodesicSphereSource&) = delete;
  void operator=(const vtkGeodesicSphereSource&) = delete;

  int Frequency = 36;
};

#endif

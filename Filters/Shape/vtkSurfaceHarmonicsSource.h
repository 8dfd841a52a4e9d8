/**
 * @class   vtkSurfaceHarmonicsSource
 * @brief   make a surface from a table of its spherical harmonics
 *
 * Make a closed surface from a table of coefficients of spherical harmonics, such as the second
 * output of vtkSurfaceHarmonics. Spherical harmonics are functions on the sphere with finer and
 * finer waves as their degree increases.
 *
 * Input port 0: vtkTable, the coefficients. Columns "Degree", "Order", "X", "Y" and "Z" define the
 * surface, and other numeric columns become point arrays. The table has one row for each harmonic,
 * in any sequence. Degrees are 0 to L, with L at most 1024.
 * - columns "Degree", "Order": degree l, and order m from -l to l.
 * - columns "X", "Y", "Z": coefficients of the coordinates.
 * - other numeric columns: coefficients of point arrays. Columns of text are ignored.
 *
 * Output port 0: vtkPolyData, the surface, with the triangles of a geodesic sphere (subdivided
 * icosahedron) of the given Frequency. Coordinates of the points are the sum of coefficients times
 * harmonics, up to ReconstructionDegree. Triangles are counter-clockwise seen from outside the
 * surface.
 * - point array "SpherePosition" (double, 3 components): the points of the geodesic sphere.
 * - one point array (double, 1 component) for each other numeric column, with the name of the
 *   column.
 *
 * The class vtkSurfaceHarmonics makes tables of this kind. The documentation of that class defines
 * the harmonics.
 *
 * @sa
 * vtkSurfaceHarmonics vtkGeodesicSphereSource
 */

#ifndef vtkSurfaceHarmonicsSource_h
#define vtkSurfaceHarmonicsSource_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSSHAPE_EXPORT vtkSurfaceHarmonicsSource : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceHarmonicsSource* New();
  vtkTypeMacro(vtkSurfaceHarmonicsSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Frequency f of the geodesic sphere (vtkGeodesicSphereSource), which has 10 f^2 + 2 points. In
   * [1, 1000]. Default is 36: 12,962 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Maximum degree of the harmonics from which the surface is made. Values above the largest degree
   * in the table have the effect of that degree. In [0, 1024]. Default is 1024: all harmonics.
   */
  vtkSetClampMacro(ReconstructionDegree, int, 0, 1024);
  vtkGetMacro(ReconstructionDegree, int);
  ///@}

protected:
  vtkSurfaceHarmonicsSource() = default;
  ~vtkSurfaceHarmonicsSource() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceHarmonicsSource(const vtkSurfaceHarmonicsSource&) = delete;
  void operator=(const vtkSurfaceHarmonicsSource&) = delete;

  int Frequency = 36;
  int ReconstructionDegree = 1024;
};

#endif

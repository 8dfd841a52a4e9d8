/**
 * @class   vtkSurfaceHarmonicsSource
 * @brief   make a surface from a table of its spherical harmonics
 *
 * Make a closed surface from a table of coefficients, such as the second output of
 * vtkSurfaceHarmonics.
 *
 * Input port 0: vtkTable, the coefficients: columns "Degree", "Order", "X", "Y" and "Z"; other
 * numeric columns become point arrays. The table has one row for each harmonic of degrees 0 to L,
 * at most 1024, in any order:
 * - columns "Degree", "Order": l, and m from -l to l.
 * - columns "X", "Y", "Z": coefficients of the coordinates.
 * - any other numeric columns: coefficients of point arrays. Columns of text are left out.
 *
 * Output port 0: vtkPolyData, a geodesic sphere of Frequency whose points are the sum of the
 * harmonics up to ReconstructionDegree. Triangles are counter-clockwise seen from outside the
 * surface.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - a point array (double, 1 component) for each other column, with its name.
 *
 * vtkSurfaceHarmonics makes such tables and defines the harmonics.
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
   * Frequency f of the geodesic sphere, for 10 f^2 + 2 points. In [1, 1000]. Default is 36: 12,962
   * points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Maximum degree of the harmonics in the surface; values above that of the table mean the latter.
   * In [0, 1024]. Default is 1024: all.
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

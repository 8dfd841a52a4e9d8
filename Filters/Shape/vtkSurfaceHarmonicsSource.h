/**
 * @class   vtkSurfaceHarmonicsSource
 * @brief   a surface from its spherical harmonics
 *
 * Input port 0: vtkTable with a row for each harmonic of degrees 0 to L, at most 1024, in any
 * order:
 * - columns "Degree", "Order": l, and m from -l to l.
 * - columns "X", "Y", "Z": coefficients of the coordinates.
 * - any other columns of numbers: coefficients of point arrays. Columns of text are left out.
 *
 * Output port 0: vtkPolyData, a geodesic sphere of Frequency put to where the harmonics up to
 * ReconstructionDegree have it; triangles counter-clockwise seen from outside the surface.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - a point array (double, 1 component) of each other column, by its name.
 *
 * vtkSurfaceHarmonics makes such tables and says which harmonics they are of.
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
   * f, for 10 f^2 + 2 points, in [1, 1000]. Default is 36: 12,962 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * The highest degree that the surface is made of, in [0, 1024]; no more than the table has are
   * there. Default is 1024: all of them.
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

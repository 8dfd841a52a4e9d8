/**
 * @class   vtkSphericalResample
 * @brief   carry point arrays from one surface to another by their maps to the sphere
 *
 * Transfer the point arrays of one surface to another: points at the same position of the sphere
 * correspond. Numbers and colors are averaged; labels (arrays of integers with 1 component) and
 * masks are voted on. Both surfaces have the point array "SpherePosition", and their maps must
 * correspond, as after vtkSphericalAlignment.
 *
 * Input port 0: vtkPolyData, the target: the surface that gets the arrays, with the point array
 * "SpherePosition" or points that lie on a sphere around the origin. Polygons and strips are cut
 * into triangles.
 *
 * Input port 1: vtkPolyData, the source: the surface that has the arrays. Both surfaces have
 * - point array "SpherePosition" (3 components, of any length but 0, float or double): position of
 *   the point on the sphere. Equal positions correspond. Surfaces must be closed, and maps must
 *   cover the sphere once. With BARYCENTRIC this does not apply to the target, which may be without
 *   triangles. Without the array, points that lie on a sphere around the origin (within a
 *   thousandth of its radius, as in files of radius 100) are the map themselves.
 *
 * Output port 0: the target, with every numeric point array of the source that has a name. Target
 * arrays of equal name are replaced. "SpherePosition", active normals and texture coordinates,
 * ghosts, and global and pedigree ids of the source are not transferred.
 * - arrays of integers with 1 component are labels or masks: each point gets the label of the
 *   largest total weight, or the smallest label of several.
 * - all other arrays are numbers: each point gets their weighted mean in the array's own type,
 *   rounded for integers such as colors. Values that are not finite are ignored; points without
 *   finite values get 0, with one warning.
 * - point array "ResampleMask" (unsigned char, 1 component), with MaskArrayName: 1 where there are
 *   values; 0, with values of 0, where all contributing points of the source are masked.
 *
 * The same input gives the same bits on any number of threads.
 *
 * Weights are those of Connectome Workbench: BARYCENTRIC is its BARYCENTRIC, and AREA_ADAPTIVE is
 * its ADAP_BARY_AREA with the two surfaces as its area surfaces. Labels are those of its
 * -label-resample.
 *
 * Folds of the source's map cause a warning: values are discontinuous there.
 *
 * @sa
 * vtkSphericalAlignment vtkSphericalMorph vtkConsistentRemesh
 */

#ifndef vtkSphericalResample_h
#define vtkSphericalResample_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for MaskArrayName

class vtkAlgorithmOutput;

class VTKFILTERSCORRESPONDENCE_EXPORT vtkSphericalResample : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalResample* New();
  vtkTypeMacro(vtkSphericalResample, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    BARYCENTRIC = 0,
    AREA_ADAPTIVE = 1
  };

  ///@{
  /**
   * Interpolation. AREA_ADAPTIVE (default): each point of the source contributes by the area around
   * it, so that none is skipped; where the target is finer, it interpolates. BARYCENTRIC:
   * barycentric coordinates in the source's triangle around the target's point; where the target is
   * coarser, points of the source are skipped.
   */
  vtkSetClampMacro(Method, int, BARYCENTRIC, AREA_ADAPTIVE);
  vtkGetMacro(Method, int);
  void SetMethodToBarycentric() { this->SetMethod(BARYCENTRIC); }
  void SetMethodToAreaAdaptive() { this->SetMethod(AREA_ADAPTIVE); }
  ///@}

  ///@{
  /**
   * Name of a point array of the source with 1 component. Points with the value 0, such as those of
   * a medial wall, are ignored. Default is empty: all points are used.
   */
  vtkSetMacro(MaskArrayName, std::string);
  vtkGetMacro(MaskArrayName, std::string);
  ///@}

  ///@{
  /**
   * The surface that has the arrays, with the point array "SpherePosition" or points that lie on a
   * sphere around the origin.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* source);
  ///@}

protected:
  vtkSphericalResample();
  ~vtkSphericalResample() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalResample(const vtkSphericalResample&) = delete;
  void operator=(const vtkSphericalResample&) = delete;

  int Method = AREA_ADAPTIVE;
  std::string MaskArrayName;
};

#endif

/**
 * @class   vtkSphericalResample
 * @brief   transfer point arrays from one surface to another by their maps to the sphere
 *
 * Transfer the point arrays of one surface, the source, to another surface, the target. The point
 * array "SpherePosition" is the position of each point on the sphere. Points of the two surfaces
 * with the same position correspond. The maps must be aligned, as after vtkSphericalAlignment.
 * Numbers and colors are averaged. For labels and masks (integer arrays with 1 component), the
 * value with the largest total weight is used.
 *
 * Input port 0: vtkPolyData, the target: the surface that gets the arrays. This surface has the
 * point array "SpherePosition", or its points are on a sphere around the origin. Polygons and
 * strips are cut into triangles.
 *
 * Input port 1: vtkPolyData, the source: the surface that has the arrays. Both surfaces have
 * - point array "SpherePosition" (3 components, of any length but 0, float or double): position of
 *   the point on the sphere. Points with equal positions correspond. The surface must be closed,
 *   and the map must cover the sphere once. If Method is BARYCENTRIC, the target need not be
 *   closed, and may have no triangles. Without this array, the coordinates of the points are used
 *   as positions. In this case, all points must be on a sphere around the origin, within a
 *   thousandth of its radius.
 *
 * Output port 0: the target, with every named numeric point array of the source. Arrays of the
 * target that have the name of a transferred array are replaced. The source's "SpherePosition",
 * active normals and texture coordinates, ghost array, and global and pedigree ids are not
 * transferred.
 * - integer arrays with 1 component are labels or masks. Each point gets the label with the largest
 *   total weight. If several labels have the largest weight, the smallest label is used.
 * - all other arrays are numbers. Each point gets the weighted mean in the type of the array;
 *   integers such as colors are rounded. Values that are not finite are ignored. A point without
 *   finite values gets 0, and there is one warning for all such points.
 * - point array "ResampleMask" (unsigned char, 1 component), only with MaskArrayName: 1 for points
 *   that have values. If the mask excludes all source points that would contribute, ResampleMask
 *   and the transferred values are 0.
 *
 * The output is equal bit by bit for any number of threads.
 *
 * Weights are those of Connectome Workbench, a program for brain surfaces. Method BARYCENTRIC is
 * equal to BARYCENTRIC of Workbench. Method AREA_ADAPTIVE is equal to ADAP_BARY_AREA of Workbench,
 * with areas computed from these two surfaces. Labels are equal to those of the Workbench command
 * -label-resample.
 *
 * If the source's map has folds, there is a warning, since values are discontinuous at folds.
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
   * Method of interpolation. BARYCENTRIC: a point of the target gets the values at the corners of
   * the source's triangle around it, weighted by barycentric coordinates. Where the target is
   * coarser than the source, some source points are not used. AREA_ADAPTIVE (default): each point
   * of the source contributes in proportion to the area around it, so that all source points are
   * used. Where the target is finer than the source, AREA_ADAPTIVE interpolates like BARYCENTRIC.
   */
  vtkSetClampMacro(Method, int, BARYCENTRIC, AREA_ADAPTIVE);
  vtkGetMacro(Method, int);
  void SetMethodToBarycentric() { this->SetMethod(BARYCENTRIC); }
  void SetMethodToAreaAdaptive() { this->SetMethod(AREA_ADAPTIVE); }
  ///@}

  ///@{
  /**
   * Name of a mask, a point array of the source with 1 component. Points of the source with the
   * value 0 are ignored. An example is the medial wall of a brain surface, which is not cortex.
   * Default is empty: all points are used.
   */
  vtkSetMacro(MaskArrayName, std::string);
  vtkGetMacro(MaskArrayName, std::string);
  ///@}

  ///@{
  /**
   * Set the source: the surface that has the arrays. This surface has the point array
   * "SpherePosition", or its points are on a sphere around the origin.
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

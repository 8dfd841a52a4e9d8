/**
 * @class   vtkSphericalResample
 * @brief   carry point arrays from one surface to another by their maps to the sphere
 *
 * Input port 0: vtkPolyData, the target: the surface that gets the arrays. Input port 1:
 * vtkPolyData, the source: the surface that has them. Polygons and strips are cut into triangles.
 * Both have
 * - point array "SpherePosition" (3 components, of any length but 0, float or double): where on the
 *   sphere the point lies. What lies at the same place corresponds. Surfaces must be closed and the
 *   maps cover the sphere once; of a target with BARYCENTRIC neither counts, nor need there be
 *   triangles. A surface
 *   without the array whose points lie on a sphere around the origin (within a thousandth of its
 *   radius, as those in files of radius 100) is its own map.
 *
 * Output port 0: the target, with every point array of the source that has a name and numbers:
 * - an array of integers with 1 component is one of labels (or a mask): each point gets the label
 *   of the largest total weight, of several the smallest;
 * - all others are numbers: each point gets their weighted mean in the array's own type, rounded if
 *   that is one of integers, as colors are.
 * Target arrays of equal name are replaced. "SpherePosition", the active normals and texture
 * coordinates, ghosts, global and pedigree ids of the source are not carried. Numbers that are not
 * finite do not count; points for which none is left get 0, with one warning. The same input gives
 * the same bits on any number of threads.
 * - point array "ResampleMask" (unsigned char, 1 component), with MaskArrayName: 1 where there are
 *   values, 0 where all points of the source that count are masked and the values are 0.
 *
 * Weights are those of Connectome Workbench: of BARYCENTRIC its BARYCENTRIC, of AREA_ADAPTIVE its
 * ADAP_BARY_AREA with the two surfaces as its area surfaces; labels as its -label-resample.
 *
 * Folds of the source's map are told of in a warning: values jump there.
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
   * What a point is made of. BARYCENTRIC: the three points of the source around it, by barycentric
   * coordinates; where the target is coarser, others are passed over. AREA_ADAPTIVE (default): all
   * points of the source, each by the area around it, so that nothing is passed over; where the
   * target is finer it interpolates.
   */
  vtkSetClampMacro(Method, int, BARYCENTRIC, AREA_ADAPTIVE);
  vtkGetMacro(Method, int);
  void SetMethodToBarycentric() { this->SetMethod(BARYCENTRIC); }
  void SetMethodToAreaAdaptive() { this->SetMethod(AREA_ADAPTIVE); }
  ///@}

  ///@{
  /**
   * Name of a point array of the source, of 1 component: points where it is 0 do not count, as
   * those of a medial wall. Default is empty: all count.
   */
  vtkSetMacro(MaskArrayName, std::string);
  vtkGetMacro(MaskArrayName, std::string);
  ///@}

  ///@{
  /**
   * The surface that has the arrays, input port 1.
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

/**
 * @class   vtkSphericalAlignment
 * @brief   align one surface's map to the sphere with another one's
 *
 * Input port 0: vtkPolyData, the surface whose map is moved. Input port 1: vtkPolyData, the surface
 * whose map it is to agree with. Both with the point array "SpherePosition" (3 components).
 *
 * Output port 0: the input of port 0, with
 * - point array "SpherePosition" (double, 3 components): the same map, moved.
 *
 * Field data (double):
 * - "AlignmentError" (one value): root mean square distance on the unit sphere that is left between
 *   what corresponds.
 * - "AlignmentCenter" (3 components): the point of the unit ball that was moved to its center, the
 *   zero vector for a rotation.
 * - "AlignmentRotation" (9 components): the rotation after that, row by row.
 *
 * Landmarks, pairs of points, define what corresponds. Without any, the surfaces must lie over
 * each other in space, as a scan and a mesh learned from it do: each point then corresponds to the
 * nearest point of the other surface, and points weigh as much as the area around them.
 *
 * Conformal maps to the sphere are given up to a Moebius transform: with it, any three points can
 * be brought to any three places. That freedom is why maps in the sense of sections 2 and 4.1 of
 * C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless surface",
 * Neurocomputing 71 (2008), can only be compared after an alignment.
 *
 * @sa
 * vtkGlobalConformalMap vtkConformalSOM
 */

#ifndef vtkSphericalAlignment_h
#define vtkSphericalAlignment_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <utility> // for pairs of points
#include <vector>  // for Landmarks

class VTKFILTERSCORRESPONDENCE_EXPORT vtkSphericalAlignment : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalAlignment* New();
  vtkTypeMacro(vtkSphericalAlignment, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Transforms
  {
    ROTATION = 0,
    MOEBIUS = 1
  };

  ///@{
  /**
   * What may be done to the map: a ROTATION, which keeps angles and areas, or a MOEBIUS transform,
   * which keeps angles. Default is ROTATION.
   */
  vtkSetClampMacro(Transform, int, ROTATION, MOEBIUS);
  vtkGetMacro(Transform, int);
  void SetTransformToRotation() { this->SetTransform(ROTATION); }
  void SetTransformToMoebius() { this->SetTransform(MOEBIUS); }
  ///@}

  ///@{
  /**
   * Pairs of points that are to come to the same place: a point of port 0 and one of port 1. Two or
   * more for a rotation, three or more for a Moebius transform; none to use the surfaces
   * themselves. Default is none.
   */
  void AddLandmark(vtkIdType pointId, vtkIdType referencePointId);
  void RemoveAllLandmarks();
  int GetNumberOfLandmarks() { return static_cast<int>(this->Landmarks.size()); }
  ///@}

  ///@{
  /**
   * The surface whose map is agreed with, input port 1.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* output);
  void SetReferenceData(vtkPolyData* reference);
  ///@}

protected:
  vtkSphericalAlignment();
  ~vtkSphericalAlignment() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalAlignment(const vtkSphericalAlignment&) = delete;
  void operator=(const vtkSphericalAlignment&) = delete;

  int Transform = ROTATION;
  std::vector<std::pair<vtkIdType, vtkIdType>> Landmarks;
};

#endif

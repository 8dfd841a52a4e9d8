/**
 * @class   vtkSphericalAlignment
 * @brief   align one surface's map to the sphere with another one's
 *
 * Transform a surface's map, the point array "SpherePosition", for the best agreement with the map
 * of a reference. Corresponding points are pairs of landmarks, or, if the two surfaces overlap in
 * space, nearest points. The field array AlignmentError is the remaining distance.
 *
 * Input port 0: vtkPolyData, the surface whose map is transformed, with the point array
 * "SpherePosition" (3 components).
 *
 * Input port 1: vtkPolyData, the reference surface, with the same array.
 *
 * Output port 0: the input of port 0, with
 * - point array "SpherePosition" (double, 3 components): the transformed map.
 *
 * Field data (double):
 * - "AlignmentError" (one value): root mean square distance that remains between corresponding
 *   points, on the unit sphere.
 * - "AlignmentCenter" (3 components): the point of the unit ball that was moved to its center; the
 *   zero vector for a rotation.
 * - "AlignmentRotation" (9 components): the rotation that follows, row by row.
 *
 * Landmarks, pairs of points, define the correspondence. Without landmarks the surfaces must
 * overlap in space, as a scan and a mesh learned from it do. Each point then corresponds to the
 * nearest point of the other surface, weighted by the area around it.
 *
 * Conformal maps to the sphere are unique up to a Moebius transform, which can move any three
 * points to any three positions. Maps in the sense of sections 2 and 4.1 of C.-Y. Liou, Y.-T. Kuo,
 * J.-C. Huang, "Conformal self-organizing map on curved seamless surface", Neurocomputing 71
 * (2008), are therefore comparable only after an alignment.
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
   * Type of the transform of the map. ROTATION (default) preserves angles and areas. MOEBIUS
   * preserves angles.
   */
  vtkSetClampMacro(Transform, int, ROTATION, MOEBIUS);
  vtkGetMacro(Transform, int);
  void SetTransformToRotation() { this->SetTransform(ROTATION); }
  void SetTransformToMoebius() { this->SetTransform(MOEBIUS); }
  ///@}

  ///@{
  /**
   * Add a pair of corresponding point ids: one of the surface and one of the reference. A rotation
   * needs at least two pairs, a Moebius transform at least three. Default is none: nearest points
   * correspond.
   */
  void AddLandmark(vtkIdType pointId, vtkIdType referencePointId);
  void RemoveAllLandmarks();
  int GetNumberOfLandmarks() { return static_cast<int>(this->Landmarks.size()); }
  ///@}

  ///@{
  /**
   * The reference surface, with the point array "SpherePosition".
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

/**
 * @class   vtkSphericalAlignment
 * @brief   align the sphere map of one surface with the sphere map of another surface
 *
 * A surface is mapped to the sphere by the point array "SpherePosition". Rotate or transform this
 * map so that it agrees best with the map of a reference surface. Landmarks are given pairs of
 * corresponding points. Without landmarks, each point corresponds to the nearest point of the other
 * surface, and the two surfaces must overlap in space. The field array AlignmentError is the
 * remaining distance between corresponding points.
 *
 * Input port 0: vtkPolyData, the surface whose map is transformed, with the point array
 * "SpherePosition" (3 components).
 *
 * Input port 1: vtkPolyData, the reference surface, with the point array "SpherePosition".
 *
 * Output port 0: the input of port 0, with
 * - point array "SpherePosition" (double, 3 components): the transformed map.
 *
 * Field data (double):
 * - "AlignmentError" (one value): root mean square distance between corresponding points on the
 *   unit sphere, after the transform.
 * - "AlignmentCenter" (3 components): the point of the unit ball that the Moebius transform (see
 *   below) moves to the center. For a rotation, this is the zero vector.
 * - "AlignmentRotation" (9 components): the rotation as a matrix, row by row. It is applied after
 *   the move to the center.
 *
 * A landmark consists of one point of each surface. Without landmarks, each point is weighted by
 * the area around the point. Surfaces that overlap in space are, for example, a scan and a mesh
 * learned from this scan.
 *
 * A Moebius transform is a conformal map of the sphere to itself. A conformal map of a surface to
 * the sphere is unique up to a Moebius transform. A Moebius transform can move any three points to
 * any three positions. Two maps of one surface can therefore differ by a Moebius transform. This
 * holds for the maps in sections 2 and 4.1 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008). To compare two maps,
 * align them first. Sheets (surfaces with a border) are rejected: their maps are hemispheres, whose
 * border would not remain on the equator.
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
   * Type of the transform of the map. ROTATION (default): a rotation, which preserves angles and
   * areas. MOEBIUS: a Moebius transform, which preserves angles only.
   */
  vtkSetClampMacro(Transform, int, ROTATION, MOEBIUS);
  vtkGetMacro(Transform, int);
  void SetTransformToRotation() { this->SetTransform(ROTATION); }
  void SetTransformToMoebius() { this->SetTransform(MOEBIUS); }
  ///@}

  ///@{
  /**
   * Add a pair of corresponding points: the id of a point of the surface, and the id of a point of
   * the reference. A rotation needs at least two pairs, and a Moebius transform at least three.
   * Default is none: nearest points correspond.
   */
  void AddLandmark(vtkIdType pointId, vtkIdType referencePointId);
  void RemoveAllLandmarks();
  int GetNumberOfLandmarks() { return static_cast<int>(this->Landmarks.size()); }
  ///@}

  ///@{
  /**
   * Set the reference surface, which has the point array "SpherePosition".
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

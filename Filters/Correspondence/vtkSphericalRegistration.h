/**
 * @class   vtkSphericalRegistration
 * @brief   deform a surface's map to the sphere until it corresponds to another one's
 *
 * Deform a surface's map, the point array "SpherePosition", so that corresponding points of both
 * surfaces have the same position on the sphere. Correspondence comes from landmarks, point arrays,
 * or the surfaces' own shape. No triangle of the map folds. The arrays TargetCellId, TargetPointIds
 * and TargetBarycentric hold the corresponding point of each point.
 *
 * Input port 0: vtkPolyData, the moving surface: closed, of genus zero, with the point array
 * "SpherePosition" (3 components), a map that covers the sphere once without folds.
 *
 * Input port 1: vtkPolyData, the fixed surface, with the same requirements.
 *
 * Output port 0: the input of port 0, with
 * - point array "SpherePosition" (double, 3 components): the deformed map. Points of both surfaces
 *   at the same position of the sphere correspond.
 * - point array "TargetPointIds" (idtype, 3 components): corners of the triangle of the fixed
 *   surface that contains the corresponding point.
 * - point array "TargetBarycentric" (double, 3 components): weights of these corners, at least 0
 *   and of sum 1.
 * - point array "TargetCellId" (idtype, 1 component): the cell of the fixed surface.
 *
 * Field data:
 * - "RegistrationStretch" (1 double): symmetric Dirichlet energy of the map between the surfaces,
 *   scaled to equal area: 1 if they are isometric.
 * - "LandmarkError" (1 double): largest distance between corresponding landmarks that remains on
 *   the unit sphere.
 * - "FeatureAgreement" (2 double): mean correlation of the features before and after.
 * - "NumberOfFolds" (1 idtype): flipped triangles of the map, by exact arithmetic.
 *
 * Without landmarks the filter compares features that it computes from the surfaces: mean geodesic
 * distance, nearby area at two scales, mean curvature at two scales. Point arrays added by
 * AddFeature() are further features. Several rotations with the best agreement are deformed. The
 * result with the least stretch, the best agreement and the closest fit after a rotation in space
 * is kept. Mirror images are never tried. Two or more landmarks determine the rotation; one
 * landmark adds to the criteria.
 *
 * Landmarks are matched as closely as the map allows without folds. A warning states how many are
 * not matched.
 *
 * @sa
 * vtkSphericalAlignment vtkSphericalMorph vtkSphericalResample
 */

#ifndef vtkSphericalRegistration_h
#define vtkSphericalRegistration_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <array>   // for LandmarkPoints
#include <string>  // for Features
#include <utility> // for pairs
#include <vector>  // for lists

class VTKFILTERSCORRESPONDENCE_EXPORT vtkSphericalRegistration : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalRegistration* New();
  vtkTypeMacro(vtkSphericalRegistration, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum TransformSpaces
  {
    ROTATION = 0,
    MOEBIUS = 1,
    DIFFEOMORPHIC = 2
  };

  ///@{
  /**
   * Type of the transform of the map. ROTATION preserves angles and areas. MOEBIUS preserves
   * angles. DIFFEOMORPHIC (default) is any deformation without folds.
   */
  vtkSetClampMacro(SpaceOfTransforms, int, ROTATION, DIFFEOMORPHIC);
  vtkGetMacro(SpaceOfTransforms, int);
  void SetSpaceOfTransformsToRotation() { this->SetSpaceOfTransforms(ROTATION); }
  void SetSpaceOfTransformsToMoebius() { this->SetSpaceOfTransforms(MOEBIUS); }
  void SetSpaceOfTransformsToDiffeomorphic() { this->SetSpaceOfTransforms(DIFFEOMORPHIC); }
  ///@}

  ///@{
  /**
   * Weight of the features that the filter computes itself; 0 disables them. In [0, 1000]. Default
   * is 1.
   */
  vtkSetClampMacro(ShapeWeight, double, 0.0, 1000.0);
  vtkGetMacro(ShapeWeight, double);
  ///@}

  ///@{
  /**
   * Weight of the stretch between the surfaces against that of the features. In [0.001, 1000].
   * Default is 1.
   */
  vtkSetClampMacro(StretchWeight, double, 0.001, 1000.0);
  vtkGetMacro(StretchWeight, double);
  ///@}

  ///@{
  /**
   * Frequency f of the finest geodesic sphere that is deformed, with 10 f^2 + 2 vertices. Time is
   * proportional to f^2. In [8, 128]. Default is 16.
   */
  vtkSetClampMacro(Frequency, int, 8, 128);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Add a pair of corresponding point ids: one of the moving and one of the fixed surface. Default
   * is none.
   */
  void AddLandmark(vtkIdType pointId, vtkIdType fixedPointId);
  void RemoveAllLandmarks();
  int GetNumberOfLandmarks() { return static_cast<int>(this->Landmarks.size()); }
  ///@}

  ///@{
  /**
   * Add a pair of corresponding positions, such as picked ones: one near the moving and one near
   * the fixed surface. The nearest points of the surfaces are used. Default is none.
   */
  void AddLandmarkPosition(
    double x, double y, double z, double fixedX, double fixedY, double fixedZ);
  void RemoveAllLandmarkPositions();
  int GetNumberOfLandmarkPositions() { return static_cast<int>(this->Positions.size()); }
  ///@}

  ///@{
  /**
   * Add a point array of 1 component of both surfaces as a feature to match, with a weight. The
   * weight is finite and at least 0; that of the stretch is StretchWeight. Each array is shifted
   * and scaled to mean 0 and variance 1 over its surface. Default is none.
   */
  void AddFeature(const char* name, double weight);
  void RemoveAllFeatures();
  int GetNumberOfFeatures() { return static_cast<int>(this->Features.size()); }
  ///@}

  ///@{
  /**
   * The fixed surface: closed, of genus zero, with the point array "SpherePosition".
   */
  void SetFixedConnection(vtkAlgorithmOutput* output);
  void SetFixedData(vtkPolyData* fixed);
  ///@}

protected:
  vtkSphericalRegistration();
  ~vtkSphericalRegistration() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalRegistration(const vtkSphericalRegistration&) = delete;
  void operator=(const vtkSphericalRegistration&) = delete;

  int SpaceOfTransforms = DIFFEOMORPHIC;
  double ShapeWeight = 1.0;
  double StretchWeight = 1.0;
  int Frequency = 16;
  std::vector<std::pair<vtkIdType, vtkIdType>> Landmarks;
  std::vector<std::array<double, 6>> Positions;
  std::vector<std::pair<std::string, double>> Features;
};

#endif

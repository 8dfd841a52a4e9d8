/**
 * @class   vtkSphericalRegistration
 * @brief   deform a surface's map to the sphere until it corresponds to another one's
 *
 * Input port 0: vtkPolyData, the moving surface. Input port 1: vtkPolyData, the fixed surface. Both
 * closed, of genus zero, with the point array "SpherePosition" (3 components): a map that covers
 * the sphere once without folds.
 *
 * Output port 0: the input of port 0, with
 * - point array "SpherePosition" (double, 3 components): the map, deformed so that points of both
 *   surfaces at the same place of the sphere correspond.
 * - point array "TargetPointIds" (idtype, 3 components): corners of the triangle of the fixed
 * surface in which the corresponding point lies, and "TargetBarycentric" (double, 3 components):
 * their weights, at least 0 and of sum 1.
 * - point array "TargetCellId" (idtype, 1 component): the cell of the fixed surface.
 *
 * Field data:
 * - "RegistrationStretch" (1 double): symmetric Dirichlet energy of the map between the surfaces,
 *   scaled to one area: 1 if they are isometric.
 * - "LandmarkError" (1 double): largest distance on the unit sphere that is left at a landmark.
 * - "FeatureAgreement" (2 double): mean correlation of the features before and after.
 * - "NumberOfFolds" (1 idtype): triangles of the map that are flipped, by exact arithmetic.
 *
 * Without landmarks the filter compares features of the surfaces' own: mean geodesic distance, area
 * nearby at two scales, mean curvature at two scales; and point arrays named by AddFeature(). The
 * best of many rotations are deformed, and the one is taken that stretches least, agrees most and
 * lies most alike after a rotation in space. Mirror images are never tried. Two or more landmarks
 * fix the rotation; one adds to the choice.
 *
 * Landmarks are met as far as the map allows without folds; a warning says how many are not.
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
   * What may be done to the map: a ROTATION, which keeps its angles and areas, a MOEBIUS transform,
   * which keeps its angles, or any DIFFEOMORPHIC deformation. Default is DIFFEOMORPHIC.
   */
  vtkSetClampMacro(SpaceOfTransforms, int, ROTATION, DIFFEOMORPHIC);
  vtkGetMacro(SpaceOfTransforms, int);
  void SetSpaceOfTransformsToRotation() { this->SetSpaceOfTransforms(ROTATION); }
  void SetSpaceOfTransformsToMoebius() { this->SetSpaceOfTransforms(MOEBIUS); }
  void SetSpaceOfTransformsToDiffeomorphic() { this->SetSpaceOfTransforms(DIFFEOMORPHIC); }
  ///@}

  ///@{
  /**
   * Weight of the features that the filter computes itself, in [0, 1000]; 0 does without them.
   * Default is 1.
   */
  vtkSetClampMacro(ShapeWeight, double, 0.0, 1000.0);
  vtkGetMacro(ShapeWeight, double);
  ///@}

  ///@{
  /**
   * Weight of the stretch between the surfaces against that of features, in [0.001, 1000]. Default
   * is 1.
   */
  vtkSetClampMacro(StretchWeight, double, 0.001, 1000.0);
  vtkGetMacro(StretchWeight, double);
  ///@}

  ///@{
  /**
   * Frequency f of the finest geodesic sphere that is deformed, of 10 f^2 + 2 vertices, in [8,
   * 128]. Time grows with its square. Default is 16.
   */
  vtkSetClampMacro(Frequency, int, 8, 128);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Pairs of points that correspond: ids of a point of port 0 and one of port 1. Default is none.
   */
  void AddLandmark(vtkIdType pointId, vtkIdType fixedPointId);
  void RemoveAllLandmarks();
  int GetNumberOfLandmarks() { return static_cast<int>(this->Landmarks.size()); }
  ///@}

  ///@{
  /**
   * Pairs of positions that correspond, one near the moving and one near the fixed surface, as they
   * are picked on a screen: the nearest points of the surfaces are taken. Default is none.
   */
  void AddLandmarkPosition(
    double x, double y, double z, double fixedX, double fixedY, double fixedZ);
  void RemoveAllLandmarkPositions();
  int GetNumberOfLandmarkPositions() { return static_cast<int>(this->Positions.size()); }
  ///@}

  ///@{
  /**
   * Point arrays of 1 component that both surfaces have and that are to agree, with a weight,
   * finite and at least 0; that of the stretch is 1. Each is shifted and scaled to mean 0 and
   * variance 1 over its surface. Default is none.
   */
  void AddFeature(const char* name, double weight);
  void RemoveAllFeatures();
  int GetNumberOfFeatures() { return static_cast<int>(this->Features.size()); }
  ///@}

  ///@{
  /**
   * The fixed surface, input port 1.
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

/**
 * @class   vtkSphericalRegistration
 * @brief   deform the sphere map of one surface until it corresponds to the sphere map of another
 *
 * A surface is mapped to the sphere by its point array "SpherePosition". Deform this map until
 * corresponding points of the surface and of a second, fixed surface have the same position on the
 * sphere. Corresponding points are found by landmarks (given pairs of points), by point arrays, or
 * by the shape of both surfaces. No triangle of the map folds. The arrays TargetCellId,
 * TargetPointIds and TargetBarycentric hold, for each point, the corresponding point of the fixed
 * surface.
 *
 * Input port 0: vtkPolyData, the moving surface, whose map is deformed: closed, of genus zero, with
 * the point array "SpherePosition" (3 components). This map must cover the sphere once without
 * folds.
 *
 * Input port 1: vtkPolyData, the fixed surface: closed, of genus zero, with the point array
 * "SpherePosition" (3 components). The map of this surface must also cover the sphere once without
 * folds.
 *
 * Output port 0: the input of port 0, with
 * - point array "SpherePosition" (double, 3 components): the deformed map. Points of both surfaces
 *   correspond if they have the same position on the sphere.
 * - point array "TargetPointIds" (idtype, 3 components): ids of the corners of the triangle of the
 *   fixed surface that contains the corresponding point.
 * - point array "TargetBarycentric" (double, 3 components): barycentric coordinates of the
 *   corresponding point in this triangle, at least 0 and of sum 1.
 * - point array "TargetCellId" (idtype, 1 component): id of the cell of the fixed surface that
 *   contains the corresponding point.
 *
 * Field data:
 * - "RegistrationStretch" (1 double): symmetric Dirichlet energy of the map between the surfaces,
 *   after both are scaled to equal area. The energy measures stretch. It is 1 if the surfaces are
 *   isometric, and larger otherwise. The energy is computed from the map of the output.
 * - "LandmarkError" (1 double): largest distance on the unit sphere between two corresponding
 *   landmarks, after the registration.
 * - "FeatureAgreement" (2 double): agreement of the features, which are described below. For each
 *   feature, the correlation between the two surfaces is computed. The value is the weighted mean
 *   of these correlations. The first value is computed from the map of the input, and the second
 *   value from the map of the output.
 * - "NumberOfFolds" (1 idtype): number of flipped triangles of the deformed map, by exact
 *   arithmetic.
 * - "Ambiguous" (1 idtype): 1 if two correspondences are about equally good, such as head and tail
 *   of similar shape. Otherwise 0.
 *
 * Output port 1: vtkPolyData, empty unless the correspondence is ambiguous. Otherwise the input of
 * port 0 with the map of the second best correspondence, and with the arrays of port 0.
 *
 * A feature is a number at each point of both surfaces. Corresponding points should have equal
 * features. The filter computes five features of each point. The first is the mean distance along
 * the surface to all other points. Two features are the area of the surface near the point, at two
 * scales. The last two are the mean curvature near the point, at two scales. Point arrays added by
 * AddFeature() are further features.
 *
 * The filter first rotates the map. It selects several rotations for which the features agree best,
 * and landmarks are near their targets. The rotated maps are then deformed. The deformation
 * minimizes an energy, the sum of stretch, disagreement of features, and distances between
 * corresponding landmarks. With two or more landmarks, the distances along the surface to the
 * landmarks are also features, so that landmarks move other points, too. The result with the lowest
 * score is kept. The score is the energy times the difference of the shapes after the best rotation
 * in space. If another correspondence has a similar score, both surfaces are also registered in the
 * opposite direction. If scores are still similar, the result is ambiguous, and a warning is
 * issued. Mirrored maps are never tried.
 *
 * Landmarks are matched as closely as the map allows without folds. If some landmarks are not
 * matched, the moving surface is mapped to the sphere again with an AreaBalance of 0.25, then 0.4,
 * then 0.1, see vtkGlobalConformalMap, and the registration is repeated until all are matched. If
 * some landmarks are still not matched, a warning states their number. With MOEBIUS, folded
 * triangles are repaired, if possible.
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
   * Type of the transform of the map. ROTATION: a rotation, which preserves angles and areas.
   * MOEBIUS: a Moebius transform (conformal map of the sphere to itself), which preserves angles.
   * DIFFEOMORPHIC (default): any smooth deformation without folds.
   */
  vtkSetClampMacro(SpaceOfTransforms, int, ROTATION, DIFFEOMORPHIC);
  vtkGetMacro(SpaceOfTransforms, int);
  void SetSpaceOfTransformsToRotation() { this->SetSpaceOfTransforms(ROTATION); }
  void SetSpaceOfTransformsToMoebius() { this->SetSpaceOfTransforms(MOEBIUS); }
  void SetSpaceOfTransformsToDiffeomorphic() { this->SetSpaceOfTransforms(DIFFEOMORPHIC); }
  ///@}

  ///@{
  /**
   * Weight of the features that the filter computes from the shape of the surfaces. 0 disables
   * these features. In [0, 1000]. Default is 1.
   *
   * These features are the mean distance to other points along the surface, the nearby area, and
   * the mean curvature.
   */
  vtkSetClampMacro(ShapeWeight, double, 0.0, 1000.0);
  vtkGetMacro(ShapeWeight, double);
  ///@}

  ///@{
  /**
   * Weight of the stretch of the map between the surfaces, relative to the weights of the features.
   * In [0.001, 1000]. Default is 1.
   */
  vtkSetClampMacro(StretchWeight, double, 0.001, 1000.0);
  vtkGetMacro(StretchWeight, double);
  ///@}

  ///@{
  /**
   * Resolution of the deformation. The deformation is computed at the vertices of geodesic spheres,
   * from coarse to fine. This property is the frequency f of the finest sphere, which has 10 f^2 +
   * 2 vertices. Time is proportional to f^2. In [8, 128]. Default is 16.
   */
  vtkSetClampMacro(Frequency, int, 8, 128);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Add a landmark, a pair of corresponding points: the id of a point of the moving surface, and
   * the id of a point of the fixed surface. Default is none.
   */
  void AddLandmark(vtkIdType pointId, vtkIdType fixedPointId);
  void RemoveAllLandmarks();
  int GetNumberOfLandmarks() { return static_cast<int>(this->Landmarks.size()); }
  ///@}

  ///@{
  /**
   * Add a landmark by a pair of corresponding positions, such as picked positions: one near the
   * moving surface, and one near the fixed surface. The nearest points of the surfaces are used. A
   * position that is farther from all points than 5 percent of the diagonal of the surface's
   * bounding box is refused. Default is none.
   */
  void AddLandmarkPosition(
    double x, double y, double z, double fixedX, double fixedY, double fixedZ);
  void RemoveAllLandmarkPositions();
  int GetNumberOfLandmarkPositions() { return static_cast<int>(this->Positions.size()); }
  ///@}

  ///@{
  /**
   * Add a feature, a number at each point that should be equal at corresponding points. The
   * arguments are the name of a point array with 1 component, which both surfaces have, and a
   * weight. The weight is finite and at least 0, and is relative to StretchWeight, the weight of
   * the stretch. On each surface, the values of the array are shifted and scaled to mean 0 and
   * variance 1. Default is none.
   */
  void AddFeature(const char* name, double weight);
  void RemoveAllFeatures();
  int GetNumberOfFeatures() { return static_cast<int>(this->Features.size()); }
  ///@}

  ///@{
  /**
   * Set the fixed surface: closed, of genus zero, with the point array "SpherePosition".
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

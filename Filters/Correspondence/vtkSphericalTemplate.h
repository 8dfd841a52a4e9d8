/**
 * @class   vtkSphericalTemplate
 * @brief   register several mapped surfaces with their mean, so that all of them correspond
 *
 * Several surfaces are mapped to the sphere by their point arrays "SpherePosition". Deform these
 * maps until corresponding points of all surfaces have the same position on the sphere. In several
 * rounds, each surface is registered with the mean of all surfaces, as in vtkSphericalRegistration.
 * A registration deforms the map of a surface until it corresponds to the map of the mean. The
 * second output is the mean surface.
 *
 * Input port 0 (repeatable): vtkPolyData, the surfaces, as separate inputs or as blocks of
 * composite data. All surfaces are closed, of genus zero, in one coordinate system, with the point
 * array "SpherePosition". Each surface has
 * - point array "SpherePosition" (3 components): a map that covers the sphere once without folds.
 *
 * Output port 0: vtkMultiBlockDataSet with one block for each surface, in the sequence of the
 * inputs, with the names of the input's blocks. A block is the input surface, with
 * - point array "SpherePosition" (double, 3 components): the deformed map. Points of two surfaces
 *   correspond if they have the same position on the sphere.
 * - field data "RegistrationStretch", "LandmarkError", "FeatureAgreement", "NumberOfFolds" and
 *   "Ambiguous": quality of the last registration with the mean, as described in
 *   vtkSphericalRegistration.
 *
 * Output port 1: vtkPolyData, the mean of the aligned surfaces (property Alignment). It has about
 * 10 f^2 + 2 points, where f is MeanFrequency. Sides of its triangles have about equal lengths on
 * the surfaces. Rotations and stretches of triangles are averaged, as by MeanType RIGID_MEAN of
 * vtkConsistentRemesh, so that limbs in different poses keep their size. The position and
 * orientation of the mean surface are those of the start, an input surface that the filter selects
 * as described below.
 * - point array "SpherePosition" (double, 3 components): position of each point on the sphere.
 * - field data "TemplateChange" (double, one value per round; absent without rounds): change of the
 *   mean in the round. The change is the root mean square distance between corresponding points of
 *   the mean and the previous mean. The unit is the root mean square distance of the points from
 *   their centroid.
 * - field data "TemplateStart" (idtype, 1 value): number of the input surface that was the start,
 *   counted from 0.
 *
 * First, all surfaces are registered with the first surface. The surface whose shape is closest to
 * the mean of the registered shapes becomes the start. Next, all surfaces are registered with the
 * start. Each round then registers all surfaces with the mean positions and mean features of the
 * previous round. A feature is a number at each point. Corresponding points should have equal
 * features. Landmarks, which are given corresponding points, are used in all registrations.
 *
 * Some registrations are ambiguous: two correspondences are about equally good, such as head and
 * tail of similar shape. Up to three other surfaces decide. The ambiguous surface is registered
 * with each of them. The correspondence that agrees with the majority is used. If the majority is
 * not clear, the surface remains ambiguous, and a warning is issued.
 *
 * If the surfaces are in another sequence, the start may be another surface, see the field data
 * "TemplateStart". If the start is the same surface, results for different sequences differ only by
 * rounding. The output is equal bit by bit for any number of threads.
 *
 * An empty block of the input gives an empty block of the output, with a warning. Blocks that are
 * null are left out.
 *
 * For principal components, and for a mean with the point arrays of the surfaces, apply
 * vtkConsistentRemesh to output port 0.
 *
 * @sa
 * vtkSphericalRegistration vtkConsistentRemesh vtkSphericalMorph
 */

#ifndef vtkSphericalTemplate_h
#define vtkSphericalTemplate_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for Features

class vtkPolyData;

class VTKFILTERSCORRESPONDENCE_EXPORT vtkSphericalTemplate : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkSphericalTemplate* New();
  vtkTypeMacro(vtkSphericalTemplate, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Alignments
  {
    NONE = 0,
    RIGID = 1,
    SIMILARITY = 2
  };

  ///@{
  /**
   * Maximum number of rounds of registration with the mean. With 0, all surfaces are registered
   * with the start, an input surface that the filter selects. Each round costs one registration per
   * surface. In [0, 100]. Default is 4.
   */
  vtkSetClampMacro(MaximumNumberOfRounds, int, 0, 100);
  vtkGetMacro(MaximumNumberOfRounds, int);
  ///@}

  ///@{
  /**
   * The rounds end when the change of the mean in a round is below this value. The change is the
   * root mean square distance between corresponding points of the old and the new mean. The unit is
   * the root mean square distance of the points from their centroid. In [0, 1]. Default is 0.01.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Differences between the shapes that are removed before their mean is computed. NONE: no
   * differences are removed. RIGID (default): position and orientation. SIMILARITY: position,
   * orientation and size.
   */
  vtkSetClampMacro(Alignment, int, NONE, SIMILARITY);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToRigid() { this->SetAlignment(RIGID); }
  void SetAlignmentToSimilarity() { this->SetAlignment(SIMILARITY); }
  ///@}

  ///@{
  /**
   * Frequency f of a geodesic sphere, a subdivided icosahedron with 10 f^2 + 2 points. In the
   * rounds, the mean has the triangles of this sphere. The mean surface of the output has as many
   * points, up to 2 percent. In [8, 1000]. Default is 45: 20,252 points.
   */
  vtkSetClampMacro(MeanFrequency, int, 8, 1000);
  vtkGetMacro(MeanFrequency, int);
  ///@}

  ///@{
  /**
   * Weight of the features that the filter computes from the shape of the surfaces, as in
   * vtkSphericalRegistration. 0 disables these features. In [0, 1000]. Default is 1.
   */
  vtkSetClampMacro(ShapeWeight, double, 0.0, 1000.0);
  vtkGetMacro(ShapeWeight, double);
  ///@}

  ///@{
  /**
   * Weight of the stretch of the maps between the surfaces, as in vtkSphericalRegistration. The
   * weight is relative to the weights of the features. In [0.001, 1000]. Default is 1.
   */
  vtkSetClampMacro(StretchWeight, double, 0.001, 1000.0);
  vtkGetMacro(StretchWeight, double);
  ///@}

  ///@{
  /**
   * Resolution of the deformation. The deformation is computed at the vertices of geodesic spheres,
   * from coarse to fine, as in vtkSphericalRegistration. This property is the frequency of the
   * finest sphere. In [8, 128]. Default is 16.
   */
  vtkSetClampMacro(Frequency, int, 8, 128);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Name of a point array with 1 component that marks landmarks. The value of a landmark is a
   * number above 0, and all other points have the value 0. Landmarks with the same number
   * correspond. Every surface must have the same numbers, each at exactly one point. Default is
   * empty: no landmarks.
   */
  vtkSetMacro(LandmarkArrayName, std::string);
  vtkGetMacro(LandmarkArrayName, std::string);
  ///@}

  ///@{
  /**
   * Add a feature, a number at each point that should be equal at corresponding points. The
   * arguments are the name of a point array with 1 component, which all surfaces have, and a
   * weight, as in vtkSphericalRegistration. Default is none.
   */
  void AddFeature(const char* name, double weight);
  void RemoveAllFeatures();
  int GetNumberOfFeatures() { return static_cast<int>(this->Features.size()); }
  ///@}

  /**
   * Return the mean surface, output port 1.
   */
  vtkPolyData* GetMeanSurface();

protected:
  vtkSphericalTemplate();
  ~vtkSphericalTemplate() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalTemplate(const vtkSphericalTemplate&) = delete;
  void operator=(const vtkSphericalTemplate&) = delete;

  int MaximumNumberOfRounds = 4;
  double Tolerance = 0.01;
  int Alignment = RIGID;
  int MeanFrequency = 45;
  double ShapeWeight = 1.0;
  double StretchWeight = 1.0;
  int Frequency = 16;
  std::string LandmarkArrayName;
  std::vector<std::pair<std::string, double>> Features;
};

#endif

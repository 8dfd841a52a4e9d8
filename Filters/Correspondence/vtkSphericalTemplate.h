/**
 * @class   vtkSphericalTemplate
 * @brief   register many mapped surfaces with their mean, so that all of them correspond
 *
 * Deform the maps of all surfaces, their point arrays "SpherePosition", so that corresponding
 * points of all surfaces have the same position on the sphere. Each surface is registered with the
 * mean of all surfaces, in several rounds. The second output is the mean surface.
 *
 * Input port 0 (repeatable): vtkPolyData, the surfaces, one by one or as blocks of composite data:
 * closed, of genus zero, in one coordinate system, with the point array "SpherePosition". Each
 * surface has
 * - point array "SpherePosition" (3 components): a map that covers the sphere once without folds.
 *
 * Output port 0: vtkMultiBlockDataSet with one block for each surface, in their order, with the
 * names of the input's blocks. A block is the input surface, with
 * - point array "SpherePosition" (double, 3 components): the deformed map. Points of all surfaces
 *   at the same position of the sphere correspond.
 * - field data "RegistrationStretch", "LandmarkError", "FeatureAgreement" and "NumberOfFolds", as
 *   in vtkSphericalRegistration, of the registration with the mean.
 *
 * Output port 1: vtkPolyData, the mean surface after Alignment of the surfaces, with 10 f^2 + 2
 * points, where f is MeanFrequency. It lies where the start does.
 * - point array "SpherePosition" (double, 3 components): the directions, uniform over the sphere.
 * - field data "TemplateChange" (double, one value per round; absent without rounds): rms distance
 *   between the mean's points and those of the round before, divided by the rms radius.
 * - field data "TemplateStart" (idtype, 1 value): number of the surface that was the start.
 *
 * First, all surfaces are registered with the first surface; the surface closest to the mean of
 * their shapes becomes the start. Next, all surfaces are registered with the start, as in
 * vtkSphericalRegistration. Each round then registers all surfaces with the mean positions and mean
 * features of the round before. Landmarks, if any, are used in each step.
 *
 * The order of the surfaces affects only the last digits, unless it changes the start, see
 * TemplateStart. The same input gives the same bits on any number of threads.
 *
 * Empty blocks stay empty, with a warning; missing blocks are left out.
 *
 * The mean has the mesh of a geodesic sphere. vtkConsistentRemesh, applied to output port 0,
 * computes a mean that is dense where the surfaces are large, with modes and the surfaces' arrays.
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
   * Maximum number of rounds; with 0 all surfaces are registered with the start only. Each round
   * costs one registration per surface. In [0, 100]. Default is 4.
   */
  vtkSetClampMacro(MaximumNumberOfRounds, int, 0, 100);
  vtkGetMacro(MaximumNumberOfRounds, int);
  ///@}

  ///@{
  /**
   * Change of the mean that ends the rounds: rms distance divided by the rms radius. In [0, 1].
   * Default is 0.01.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Transforms that are removed from the shapes before their mean is computed. NONE: none. RIGID
   * (default): position and orientation. SIMILARITY: position, orientation and size.
   */
  vtkSetClampMacro(Alignment, int, NONE, SIMILARITY);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToRigid() { this->SetAlignment(RIGID); }
  void SetAlignmentToSimilarity() { this->SetAlignment(SIMILARITY); }
  ///@}

  ///@{
  /**
   * Frequency f of the mean's geodesic sphere, with 10 f^2 + 2 points. In [8, 1000]. Default is 45:
   * 20,252 points.
   */
  vtkSetClampMacro(MeanFrequency, int, 8, 1000);
  vtkGetMacro(MeanFrequency, int);
  ///@}

  ///@{
  /**
   * Weight of the features that the filter computes itself, as in vtkSphericalRegistration; 0
   * disables them. In [0, 1000]. Default is 1.
   */
  vtkSetClampMacro(ShapeWeight, double, 0.0, 1000.0);
  vtkGetMacro(ShapeWeight, double);
  ///@}

  ///@{
  /**
   * Weight of the stretch against that of the features, as in vtkSphericalRegistration. In [0.001,
   * 1000]. Default is 1.
   */
  vtkSetClampMacro(StretchWeight, double, 0.001, 1000.0);
  vtkGetMacro(StretchWeight, double);
  ///@}

  ///@{
  /**
   * Frequency of the finest geodesic sphere that is deformed, as in vtkSphericalRegistration. In
   * [8, 128]. Default is 16.
   */
  vtkSetClampMacro(Frequency, int, 8, 128);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Name of a point array of 1 component that marks landmarks. Points with the same number above 0
   * correspond; points with 0 are no landmarks. Every surface must have the same numbers, each at
   * one point. Default is empty: no landmarks.
   */
  vtkSetMacro(LandmarkArrayName, std::string);
  vtkGetMacro(LandmarkArrayName, std::string);
  ///@}

  ///@{
  /**
   * Add a point array of 1 component of all surfaces as a feature to match, with a weight, as in
   * vtkSphericalRegistration. Default is none.
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

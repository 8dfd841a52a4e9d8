/**
 * @class   vtkSphericalTemplate
 * @brief   register many mapped surfaces with their mean, so that all of them correspond
 *
 * Input port 0 (repeatable): vtkPolyData, or composite data of them: one surface or more, closed,
 * of genus zero, in one space, each with
 * - point array "SpherePosition" (3 components): a map that covers the sphere once without folds.
 *
 * Output port 0: vtkMultiBlockDataSet, a block for each surface in their order, with the names of
 * the input's blocks: the surface as it is, but for
 * - point array "SpherePosition" (double, 3 components): the map, deformed so that points of all
 *   surfaces at the same place of the sphere correspond.
 * - field data "RegistrationStretch", "LandmarkError", "FeatureAgreement" and "NumberOfFolds" as
 *   vtkSphericalRegistration has them, of the registration with the mean.
 *
 * Output port 1: vtkPolyData, the mean surface, after the surfaces were brought together by
 * Alignment: 10 f^2 + 2 points, f being MeanFrequency. It lies where the start does.
 * - point array "SpherePosition" (double, 3 components): the directions, evenly over the sphere.
 * - field data "TemplateChange" (double, a value for each round; absent without any): rms distance
 *   of the mean's points from those of the round before, over its rms radius.
 * - field data "TemplateStart" (idtype, 1 value): number of the surface that was the start.
 *
 * All surfaces are registered with the first one, and the one that is closest to the mean of their
 * shapes is the start. All are registered with the start, as vtkSphericalRegistration does it, then
 * in each round with the mean of the round before, of positions and of features. Landmarks, if
 * there are some, are met in each of these steps.
 *
 * The order of the surfaces counts only where it makes another one the start, which TemplateStart
 * tells, and in the last digits. The same input gives the same bits on any number of threads.
 *
 * Empty blocks stay empty, with a warning; blocks that are not there are left out.
 *
 * The mean is on a geodesic sphere. vtkConsistentRemesh makes of output port 0 a mean that is dense
 * where the surfaces are large, with modes and the surfaces' arrays.
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
   * Largest number of rounds, in [0, 100]; with 0 all are registered with the start only. Each
   * takes as long as registering every surface once. Default is 4.
   */
  vtkSetClampMacro(MaximumNumberOfRounds, int, 0, 100);
  vtkGetMacro(MaximumNumberOfRounds, int);
  ///@}

  ///@{
  /**
   * Change of the mean with which rounds end, in [0, 1]: rms distance over the rms radius. Default
   * is 0.01.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * What is taken out of the shapes before their mean is taken. NONE: nothing. RIGID (default):
   * where they lie and how they are turned. SIMILARITY: their size, too.
   */
  vtkSetClampMacro(Alignment, int, NONE, SIMILARITY);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToRigid() { this->SetAlignment(RIGID); }
  void SetAlignmentToSimilarity() { this->SetAlignment(SIMILARITY); }
  ///@}

  ///@{
  /**
   * Frequency f of the mean's geodesic sphere, of 10 f^2 + 2 points, in [8, 1000]. Default is 45:
   * 20,252 points.
   */
  vtkSetClampMacro(MeanFrequency, int, 8, 1000);
  vtkGetMacro(MeanFrequency, int);
  ///@}

  ///@{
  /**
   * As in vtkSphericalRegistration: weight of the features that the filter computes itself, in
   * [0, 1000]. Default is 1.
   */
  vtkSetClampMacro(ShapeWeight, double, 0.0, 1000.0);
  vtkGetMacro(ShapeWeight, double);
  ///@}

  ///@{
  /**
   * As in vtkSphericalRegistration: weight of the stretch against that of features, in
   * [0.001, 1000]. Default is 1.
   */
  vtkSetClampMacro(StretchWeight, double, 0.001, 1000.0);
  vtkGetMacro(StretchWeight, double);
  ///@}

  ///@{
  /**
   * As in vtkSphericalRegistration: frequency of the finest geodesic sphere that is deformed, in
   * [8, 128]. Default is 16.
   */
  vtkSetClampMacro(Frequency, int, 8, 128);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Name of a point array of 1 component that marks landmarks: points of all surfaces with the same
   * number above 0 correspond, points with 0 are none. Every surface must have the same numbers,
   * each at one point. Default is empty: there are none.
   */
  vtkSetMacro(LandmarkArrayName, std::string);
  vtkGetMacro(LandmarkArrayName, std::string);
  ///@}

  ///@{
  /**
   * Point arrays of 1 component that all surfaces have and that are to agree, with a weight, as in
   * vtkSphericalRegistration. Default is none.
   */
  void AddFeature(const char* name, double weight);
  void RemoveAllFeatures();
  int GetNumberOfFeatures() { return static_cast<int>(this->Features.size()); }
  ///@}

  /**
   * The mean surface, output port 1.
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

/**
 * @class   vtkSphericalTimeSeries
 * @brief   make the maps of the time steps of a moving body correspond, and compute its motion
 *
 * A body that moves and deforms is given by a surface for each time step. Each surface is mapped to
 * the sphere by its point array "SpherePosition". Deform these maps until each point of the body
 * has the same position on the sphere at all times. Velocities and strain rates of the surface are
 * computed from these maps.
 *
 * Input port 0 (repeatable): vtkPolyData, the surfaces. Either one input with time steps, or
 * separate inputs or blocks of composite data, one for each time step. An input with time steps can
 * also be composite data with a single surface at each time. All surfaces are closed, of genus
 * zero, in one coordinate system. Each surface has
 * - point array "SpherePosition" (3 components): a map that covers the sphere once without folds.
 *
 * Output port 0: vtkPolyData with time steps, the surface at the requested time. Times of separate
 * inputs and of blocks are the multiples 0, 1, 2, ... of TimeInterval. Blocks are counted when the
 * filter that makes them has run: before, the output has one time step. Between two time steps, the
 * output is the earlier surface with positions that are interpolated to the requested time. The
 * output has
 * - point array "SpherePosition" (double, 3 components): the deformed map.
 * - point array "Velocity" (double, 3 components): velocity at fixed position on the sphere, in
 *   units of length per time. Velocities and rates are central differences between the previous and
 *   the next time step; one-sided at the first and the last. Between two time steps, they are the
 *   differences of both. If there is only one time step, these arrays are 0.
 * - point array "NormalVelocity" (double, 1 component): component along the outward normal.
 * - point array "TangentialVelocity" (double, 3 components): component along the surface.
 * - point array "AreaRate" (double, 1 component): relative growth of areas per time.
 * - point array "ShearRate" (double, 1 component): half of the difference of the principal strain
 *   rates.
 * - field data "RegistrationStretch", "LandmarkError", "FeatureAgreement", "NumberOfFolds" and
 *   "Ambiguous": quality of the last registration, as described in vtkSphericalRegistration. The
 *   last registration is that with the surface of ReferenceStep, or that with the neighbor in time
 *   if NumberOfSweeps is 0.
 * - field data "IsInterpolated" (idtype, 1 value): 1 if the output is not a surface of the input.
 *
 * Output port 1: vtkTable, a row for each time step of the input:
 * - "Time" (double).
 * - "State" (string): "reference", "registered" or "skipped".
 * - "RelativeArea" and "RelativeVolume" (double): area and volume of the surface, divided by those
 *   of the surface of ReferenceStep.
 * - "RelativeDisplacement" (double): mean distance to the same position on the sphere at the
 * previous time step, in units of the square root of the area; 0 for the first.
 * - "RegistrationStretch" (double), "NumberOfFolds" (idtype), "MeanAreaRate" and "MeanShearRate"
 *   (double): quality and motion as on port 0. Means are weighted by area.
 * - "MeanNormalSpeed" and "MeanTangentialSpeed" (double): means of the magnitudes of
 *   "NormalVelocity" and "TangentialVelocity".
 * Numbers of skipped time steps are 0.
 *
 * A surface that is empty or cannot be used, or a block that is a null pointer, is skipped, with a
 * warning that contains its number. At its time, the output is interpolated. If the surface of
 * ReferenceStep cannot be used, there is an error.
 *
 * Each surface is registered with its neighbor in time, starting from ReferenceStep. All time steps
 * share one space, and bodies move smoothly: corresponding points should be near the positions that
 * are expected from the motion so far. Shape alone cannot determine a rotation of a body about its
 * own axis. After the first pass, NumberOfSweeps passes register each surface again, with positions
 * that are interpolated in time between both neighbors. They then register each surface with that
 * of ReferenceStep, starting from its present map, so that small errors of many registrations do
 * not add up.
 *
 * Registrations are kept. If a run was stopped, or if surfaces are added at the end, the next run
 * computes only what is missing. The output is equal bit by bit for any number of threads.
 *
 * The method is not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008)).
 *
 * @sa
 * vtkSphericalRegistration vtkSphericalTemplate vtkGlobalConformalMap
 */

#ifndef vtkSphericalTimeSeries_h
#define vtkSphericalTimeSeries_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>  // for the time steps
#include <string>  // for names
#include <utility> // for Features
#include <vector>  // for Features

class vtkTable;

class VTKFILTERSCORRESPONDENCE_EXPORT vtkSphericalTimeSeries : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalTimeSeries* New();
  vtkTypeMacro(vtkSphericalTimeSeries, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of the time step whose map does not change, counted from 0. Choose a time step with a
   * map that you know, or one in the middle of the motion. In [0, 1000000]. Default is 0.
   */
  vtkSetClampMacro(ReferenceStep, int, 0, 1000000);
  vtkGetMacro(ReferenceStep, int);
  ///@}

  ///@{
  /**
   * Time between two separate inputs or blocks, such as the seconds between two frames of a film.
   * The unit of time of velocities and rates is that of this value. Not used for an input with time
   * steps, which has its own times. In [1e-9, 1e9]. Default is 1.
   */
  vtkSetClampMacro(TimeInterval, double, 1e-9, 1e9);
  vtkGetMacro(TimeInterval, double);
  ///@}

  ///@{
  /**
   * Weight of the squared distances between the positions of corresponding points and their
   * expected positions. Increase it if the body moves little between two time steps. Decrease it if
   * the body moves far, and its shape shows the correspondence. The unit of length is the square
   * root of the area divided by 4 pi. In [0, 1000]. Default is 10.
   */
  vtkSetClampMacro(PositionWeight, double, 0.0, 1000.0);
  vtkGetMacro(PositionWeight, double);
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
   * Weight of the stretch of the maps between the surfaces, as in vtkSphericalRegistration. In
   * [0.001, 1000]. Default is 1.
   */
  vtkSetClampMacro(StretchWeight, double, 0.001, 1000.0);
  vtkGetMacro(StretchWeight, double);
  ///@}

  ///@{
  /**
   * Resolution of the deformation: frequency of the finest geodesic sphere, as in
   * vtkSphericalRegistration. In [8, 128]. Default is 16.
   */
  vtkSetClampMacro(Frequency, int, 8, 128);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Number of passes over all time steps after the first pass. A pass takes about as long as the
   * first one. With 0, small errors add up over time. In [0, 10]. Default is 1.
   */
  vtkSetClampMacro(NumberOfSweeps, int, 0, 10);
  vtkGetMacro(NumberOfSweeps, int);
  ///@}

  ///@{
  /**
   * Name of a point array with 1 component that marks landmarks. The value of a landmark is a
   * number above 0, and all other points have the value 0. Landmarks with the same number
   * correspond. Surfaces without the array have no landmarks. Default is empty: no landmarks.
   */
  vtkSetMacro(LandmarkArrayName, std::string);
  vtkGetMacro(LandmarkArrayName, std::string);
  ///@}

  ///@{
  /**
   * Add a feature, a number at each point that should be equal at corresponding points, such as the
   * brightness of cells. The arguments are the name of a point array with 1 component, which all
   * surfaces have, and a weight, as in vtkSphericalRegistration. Features show motion along the
   * surface that its shape does not show, such as the rotation of a round body. Default is none.
   */
  void AddFeature(const char* name, double weight);
  void RemoveAllFeatures();
  int GetNumberOfFeatures() { return static_cast<int>(this->Features.size()); }
  ///@}

  /**
   * Return the table of time steps, output port 1.
   */
  vtkTable* GetTable();

protected:
  vtkSphericalTimeSeries();
  ~vtkSphericalTimeSeries() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalTimeSeries(const vtkSphericalTimeSeries&) = delete;
  void operator=(const vtkSphericalTimeSeries&) = delete;

  class Series;

  int ReferenceStep = 0;
  double TimeInterval = 1.0;
  double PositionWeight = 10.0;
  double ShapeWeight = 1.0;
  double StretchWeight = 1.0;
  int Frequency = 16;
  int NumberOfSweeps = 1;
  std::string LandmarkArrayName;
  std::vector<std::pair<std::string, double>> Features;
  std::unique_ptr<Series> Kept; // time steps of the last run, and known registrations
};

#endif

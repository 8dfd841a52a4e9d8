/**
 * @class   vtkSurfaceMismatch
 * @brief   measure the distances between a model surface and its reference, in both directions
 *
 * Add the point array Distance to the surface and, as a second output, to the reference. The
 * field data of the surface hold the mean square distances, the mismatch error E_mis of the
 * paper as MeanSquarePointToSurface among them, and the largest.
 *
 * Input port 0: vtkPolyData, the model, a surface. Polygons and strips are treated as triangles.
 *
 * Input port 1: vtkPolyData, the reference, a surface or a cloud of points. Distances to a
 * reference without polygons are those to its nearest point. All points of the reference count as
 * data, also those of no polygon.
 *
 * Output port 0: vtkPolyData, the model.
 *
 * Output port 1: vtkPolyData, the reference. Each with
 * - point array "Distance" (double, 1 component): distance of the point to the other, in units of
 *   the coordinates.
 *
 * Field data of output port 0 (double, one value), in the unit of length chosen by LengthUnit:
 * - "MeanSquarePointToSurface": mean square distance of the reference's points to the model's
 *   surface, the mismatch error E_mis of the paper.
 * - "MeanSquarePointToVertex": the same to the model's nearest vertex.
 * - "MeanSquareSurfaceToPoint": mean square distance of samples spread evenly over the model's area
 *   to the reference. A model that spans a gap between two limbs has a small E_mis all the same;
 *   it is here, and in the next two, that it shows.
 * - "HausdorffDistance": the largest distance found from either side.
 * - "WebFraction": share of the model's area that is farther than 0.02 from the reference.
 * - "LengthUnit": the length, in units of the coordinates, that counts as 1.
 *
 * Of several processes (Controller) each has its own points of the reference, perhaps none, and of
 * the model all, a piece, or nothing: what all have is the model, and what all have the reference.
 * Figures are the same on all processes, to the bit whatever the number of processes; "Distance" is
 * that of the process's own points. A cloud stays where it is; a reference with triangles is
 * gathered on each process, and so is the model.
 *
 * E_mis is defined in section 4.1 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing
 * map on curved seamless surface", Neurocomputing 71 (2008).
 *
 * @sa
 * vtkConformalSOM vtkCurvedSeamlessSurface vtkConformalDistortion
 * vtkHausdorffDistancePointSetFilter
 */

#ifndef vtkSurfaceMismatch_h
#define vtkSurfaceMismatch_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkMultiProcessController;

class VTKFILTERSCONFORMAL_EXPORT vtkSurfaceMismatch : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceMismatch* New();
  vtkTypeMacro(vtkSurfaceMismatch, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum LengthUnits
  {
    MAX_RADIUS = 0,
    HALF_DIAGONAL = 1,
    NONE = 2
  };

  ///@{
  /**
   * The length that counts as 1 in the figures: the largest distance of a reference point from the
   * centroid of them all (MAX_RADIUS), half the diagonal of the reference's bounding box
   * (HALF_DIAGONAL), or 1 in the coordinates (NONE). Default is MAX_RADIUS.
   */
  vtkSetClampMacro(LengthUnit, int, MAX_RADIUS, NONE);
  vtkGetMacro(LengthUnit, int);
  void SetLengthUnitToMaxRadius() { this->SetLengthUnit(MAX_RADIUS); }
  void SetLengthUnitToHalfDiagonal() { this->SetLengthUnit(HALF_DIAGONAL); }
  void SetLengthUnitToNone() { this->SetLengthUnit(NONE); }
  ///@}

  ///@{
  /**
   * Samples of the model's surface from which the distance to the reference is measured. In
   * [1, 100000000]. Default is 60,000.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 100000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Seed of the samples' places. At least 0. Default is 1.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  ///@{
  /**
   * The surface or cloud of points that the model is compared with.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* output);
  void SetReferenceData(vtkPolyData* reference);
  ///@}

  ///@{
  /**
   * The processes that share the model and the reference. Each runs this filter and asks its inputs
   * for its own piece. Default is the global controller; null for points of this process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkSurfaceMismatch();
  ~vtkSurfaceMismatch() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceMismatch(const vtkSurfaceMismatch&) = delete;
  void operator=(const vtkSurfaceMismatch&) = delete;

  int LengthUnit = MAX_RADIUS;
  int NumberOfSamples = 60000;
  int RandomSeed = 1;
  vtkMultiProcessController* Controller = nullptr;
};

#endif

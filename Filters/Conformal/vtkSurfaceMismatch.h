/**
 * @class   vtkSurfaceMismatch
 * @brief   measure the distances between a model surface and its reference, in both directions
 *
 * Add the point array Distance to the surface and, as a second output, to the reference. The field
 * data of the surface hold the mean square distances and the largest distance.
 * MeanSquarePointToSurface is the mismatch error E_mis of the paper.
 *
 * Input port 0: vtkPolyData, the model, a surface. Polygons and strips are treated as triangles.
 *
 * Input port 1: vtkPolyData, the reference, a surface or a cloud of points. Distances to a
 * reference without polygons are those to its nearest point. All points of the reference are used,
 * including points of no polygon.
 *
 * Output port 0: vtkPolyData, the model.
 *
 * Output port 1: vtkPolyData, the reference. Both outputs have
 * - point array "Distance" (double, 1 component): distance from the point to the other surface or
 *   cloud, in units of the coordinates.
 *
 * Field data of output port 0 (double, one value), in the unit of length chosen by LengthUnit:
 * - "MeanSquarePointToSurface": mean square distance from the reference's points to the model's
 *   surface, the mismatch error E_mis of the paper.
 * - "MeanSquarePointToVertex": mean square distance from the reference's points to the model's
 *   nearest vertex.
 * - "MeanSquareSurfaceToPoint": mean square distance from samples, uniform over the model's area,
 *   to the reference. A model that spans a gap between two limbs can have a small E_mis; this value
 *   and the next two detect it.
 * - "HausdorffDistance": the largest distance in either direction.
 * - "WebFraction": fraction of the model's area that is farther than 0.02 from the reference.
 * - "LengthUnit": the length that counts as 1, in units of the coordinates.
 *
 * With several processes (Controller), each has its own points of the reference, perhaps none. Of
 * the model each has all, a piece, or nothing. Model and reference are the union over all
 * processes. The figures are equal on all processes, with the same bits on any number of processes.
 * "Distance" belongs to the process's own points. Points of a cloud are not moved between
 * processes; the model, and a reference with triangles, are gathered on each process.
 *
 * Section 4.1 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved
 * seamless surface", Neurocomputing 71 (2008), defines E_mis.
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
   * Unit of length of the figures. MAX_RADIUS (default): the largest distance of a reference point
   * from the centroid of all reference points. HALF_DIAGONAL: half the diagonal of the reference's
   * bounding box. NONE: the unit of the coordinates.
   */
  vtkSetClampMacro(LengthUnit, int, MAX_RADIUS, NONE);
  vtkGetMacro(LengthUnit, int);
  void SetLengthUnitToMaxRadius() { this->SetLengthUnit(MAX_RADIUS); }
  void SetLengthUnitToHalfDiagonal() { this->SetLengthUnit(HALF_DIAGONAL); }
  void SetLengthUnitToNone() { this->SetLengthUnit(NONE); }
  ///@}

  ///@{
  /**
   * Number of samples of the model's surface for the distances to the reference. In [1, 100000000].
   * Default is 60,000.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 100000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Seed of the random positions of the samples. At least 0. Default is 1.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  ///@{
  /**
   * The surface or cloud of points with which the model is compared.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* output);
  void SetReferenceData(vtkPolyData* reference);
  ///@}

  ///@{
  /**
   * Controller of the processes that share the model and the reference. Each process runs this
   * filter on its own piece. Default is the global controller; null uses the points of this process
   * alone.
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

/**
 * @class   vtkSurfaceMismatch
 * @brief   measure the distances between a model surface and its reference, in both directions
 *
 * Measure the distance of each point of a surface, the model, from a reference, and of each point
 * of the reference from the model. Both outputs have the distances as the point array Distance. The
 * field data of the first output hold mean square distances and the largest distance. The field
 * data array MeanSquarePointToSurface is the mismatch error E_mis of Liou, Kuo and Huang (2008).
 *
 * Input port 0: vtkPolyData, the model, a surface. Polygons and strips are treated as triangles.
 *
 * Input port 1: vtkPolyData, the reference, a surface or a cloud of points. If the reference has no
 * polygons, distances to the reference are distances to its nearest point. All points of the
 * reference are used, including points that belong to no polygon.
 *
 * Output port 0: vtkPolyData, the model.
 *
 * Output port 1: vtkPolyData, the reference. Both outputs have
 * - point array "Distance" (double, 1 component): distance from a point of the model to the
 *   reference, or from a point of the reference to the model, in units of the coordinates.
 *
 * Field data of output port 0 (double, one value each). The property LengthUnit selects the unit of
 * the distances. Squared distances have the squared unit.
 * - "MeanSquarePointToSurface": mean square distance from the reference's points to the model's
 *   surface, the mismatch error E_mis of the paper cited below.
 * - "MeanSquarePointToVertex": mean square distance from the reference's points to the model's
 *   nearest vertex.
 * - "MeanSquareSurfaceToPoint": mean square distance from random samples of the model, uniform over
 *   its area, to the reference. This value, "HausdorffDistance" and "WebFraction" detect webs,
 *   parts of the model that span a gap between two limbs. E_mis does not detect webs.
 * - "HausdorffDistance": the largest of all distances from model to reference and from reference to
 *   model.
 * - "RootMeanSquareNormalAngle": root mean square angle between the normals of model and reference,
 *   in degrees, from 0 to 90. At each random sample of the model, the normal of the model's
 *   triangle is compared with the normal of the reference's closest triangle. If the reference has
 *   no polygons, this array does not exist.
 * - "RootMeanSquareCurvatureError": root mean square difference of the mean curvatures of model and
 *   reference. At up to 6000 of the random samples, the mean curvature is averaged over a disk of
 *   each surface, see the property CurvatureRadius. A curvature of 1 is that of a sphere of the
 *   radius LengthUnit. The value is in units of 1 / LengthUnit. Before, border points with equal
 *   coordinates are merged, and triangles are oriented consistently. If the reference has no
 *   polygons, this array does not exist.
 * - "WebFraction": fraction of the model's area that is farther from the reference than 0.02. This
 *   distance is in the unit selected by the property LengthUnit.
 * - "LengthUnit": length of the unit that the property LengthUnit selects, in units of the
 *   coordinates.
 *
 * With several processes (Controller), each process has a piece of the reference, which may be
 * empty. Each process has the whole model, a piece, or nothing. The complete model is the union of
 * its pieces on all processes, and the complete reference is the union of its pieces. The field
 * data are equal on all processes, and equal bit by bit for any number of processes. On each
 * process, the array "Distance" contains the distances of the local points only. If the reference
 * is a cloud, its points remain on their process. The model, and a reference with triangles, are
 * copied to all processes.
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
   * Unit of the distances in the field data. MAX_RADIUS (default): the largest distance of a
   * reference point from the centroid of all reference points. HALF_DIAGONAL: half the diagonal of
   * the reference's bounding box. NONE: the unit of the coordinates.
   */
  vtkSetClampMacro(LengthUnit, int, MAX_RADIUS, NONE);
  vtkGetMacro(LengthUnit, int);
  void SetLengthUnitToMaxRadius() { this->SetLengthUnit(MAX_RADIUS); }
  void SetLengthUnitToHalfDiagonal() { this->SetLengthUnit(HALF_DIAGONAL); }
  void SetLengthUnitToNone() { this->SetLengthUnit(NONE); }
  ///@}

  ///@{
  /**
   * Number of random samples on the model's surface from which distances to the reference are
   * measured. In [1, 100000000]. Default is 60,000.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 100000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Seed of the random positions of the samples on the model's surface. At least 0. Default is 1.
   */
  vtkSetClampMacro(RandomSeed, int, 0, VTK_INT_MAX);
  vtkGetMacro(RandomSeed, int);
  ///@}

  ///@{
  /**
   * Radius of the disks over which mean curvatures are averaged, as a fraction of half the diagonal
   * of the reference's bounding box. A disk consists of connected triangles. If the radius is
   * smaller than the triangles, the value of a disk is that of one triangle. In [0, 0.5]. Default
   * is 0.03.
   */
  vtkSetClampMacro(CurvatureRadius, double, 0.0, 0.5);
  vtkGetMacro(CurvatureRadius, double);
  ///@}

  ///@{
  /**
   * Set the reference: the surface or cloud of points with which the model is compared.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* output);
  void SetReferenceData(vtkPolyData* reference);
  ///@}

  ///@{
  /**
   * Controller of the processes that share the model and the reference. Each process runs this
   * filter on its own pieces. Default is the global controller. With null, only the model and the
   * reference of this process are used.
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
  double CurvatureRadius = 0.03;
  vtkMultiProcessController* Controller = nullptr;
};

#endif

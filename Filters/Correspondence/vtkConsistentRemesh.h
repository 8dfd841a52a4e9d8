/**
 * @class   vtkConsistentRemesh
 * @brief   put mapped surfaces on one mesh, with their mean shape and principal components
 *
 * Resample surfaces with the point array "SpherePosition" at the same points of the sphere, with
 * the same triangles. Points at the same position of the sphere correspond. The second output is
 * the mean shape with its principal components.
 *
 * Input port 0 (repeatable): vtkPolyData, the surfaces, one by one or as blocks of composite data,
 * with the point array "SpherePosition". Polygons and strips are cut into triangles. Each surface
 * has
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. Equal positions correspond. The surface must be closed, and the map must cover the
 *   sphere exactly once. Either all maps mirror their surfaces, or none.
 *
 * Output port 0: vtkMultiBlockDataSet with one block for each surface, in their order, with the
 * names of the input's blocks. A block is a vtkPolyData with the points of that surface, in place,
 * in directions shared by all blocks. The polygons of all blocks are identical.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - the point arrays of the surface, interpolated as in vtkSphericalResample.
 * - field data "MeanSquarePointToSurface" (double): mean square distance from the surface's points
 *   to the block, in squares of the surface's largest radius, as in vtkSurfaceMismatch.
 * - field data "ShapeScores" (double, one component per mode; absent without modes): number of
 *   standard deviations of each mode between the shape and the mean.
 *
 * Output port 1: vtkPolyData, the mean shape on the same mesh, after Alignment of the surfaces; it
 * lies where the first surface does.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - point arrays "ShapeMode1", "ShapeMode2" and so on (double, 3 components): the displacement by
 *   one standard deviation of a principal component. If all modes are kept, the aligned shape is
 *   the mean points plus the sum of scores times modes.
 * - the point arrays that all surfaces have: the mean of numbers, the most frequent label.
 * - field data "ExplainedVariance" (double, one value per mode; absent without modes): fraction of
 *   the variance.
 *
 * Points are weighted by the area around them, in the mean over the surfaces. The result therefore
 * does not depend on where the mesh is dense. The same input gives the same bits on any number of
 * threads.
 *
 * Implementation note: generalized Procrustes alignment after J. C. Gower, Psychometrika 40 (1975).
 *
 * @sa
 * vtkSphericalAlignment vtkSphericalMorph vtkSphericalResample vtkSurfaceMismatch
 */

#ifndef vtkConsistentRemesh_h
#define vtkConsistentRemesh_h

#include "vtkFiltersCorrespondenceModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

class vtkPolyData;

class VTKFILTERSCORRESPONDENCE_EXPORT vtkConsistentRemesh : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkConsistentRemesh* New();
  vtkTypeMacro(vtkConsistentRemesh, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MeshTypes
  {
    GEODESIC = 0,
    ADAPTIVE = 1
  };

  enum Alignments
  {
    NONE = 0,
    RIGID = 1,
    SIMILARITY = 2
  };

  ///@{
  /**
   * Type of the mesh of the sphere. ADAPTIVE (default): points are uniform over the surfaces, as in
   * vtkAdaptiveSphere, and dense where any surface needs it. GEODESIC: points are uniform over the
   * sphere.
   */
  vtkSetClampMacro(MeshType, int, GEODESIC, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * GEODESIC: frequency f, for 10 f^2 + 2 points. In [1, 10000]. Default is 45: 20,252 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 10000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * ADAPTIVE: number of points, reached within 2 percent. In [500, 100000000]. Default is 20,000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Transforms that are removed from the shapes before they are compared. NONE: none. RIGID
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
   * Number of principal components to keep, largest first. There are fewer of them than surfaces.
   * In [0, 1000]. Default is 10.
   */
  vtkSetClampMacro(NumberOfModes, int, 0, 1000);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  /**
   * Return the mean shape, output port 1.
   */
  vtkPolyData* GetMeanShape();

protected:
  vtkConsistentRemesh();
  ~vtkConsistentRemesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConsistentRemesh(const vtkConsistentRemesh&) = delete;
  void operator=(const vtkConsistentRemesh&) = delete;

  int MeshType = ADAPTIVE;
  int Frequency = 45;
  int NumberOfPoints = 20000;
  int Alignment = RIGID;
  int NumberOfModes = 10;
};

#endif

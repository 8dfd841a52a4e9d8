/**
 * @class   vtkConsistentRemesh
 * @brief   put mapped surfaces on one mesh, with their mean shape and principal components
 *
 * Give surfaces with the point array "SpherePosition" the same points of the sphere and the same
 * triangles: points at the same position of the sphere correspond. The second output is their mean
 * shape with its principal components.
 *
 * Input port 0 (repeatable): vtkPolyData, the surfaces, one by one or as blocks of composite data,
 * with the point array "SpherePosition". Polygons and strips are cut into triangles. Each has
 * - point array "SpherePosition" (3 components, of any length but 0): where on the sphere the point
 *   lies. What lies at the same place corresponds. The surface must be closed and the map cover the
 *   sphere exactly once; all maps must mirror their surfaces, or none.
 *
 * Output port 0: vtkMultiBlockDataSet, a block for each surface in their order, with the names of
 * the input's blocks: a vtkPolyData of the points of that surface in directions that all blocks
 * share, where it was. The polygons of all blocks are the same to the bit.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - the point arrays of the surface, interpolated (vtkSphericalResample says which).
 * - field data "MeanSquarePointToSurface" (double): of the surface's points to the block, in
 *   squares of the surface's largest radius, as vtkSurfaceMismatch has it.
 * - field data "ShapeScores" (double, as many components as there are modes; absent without any):
 *   how many standard deviations of each mode the shape is from the mean.
 *
 * Output port 1: vtkPolyData, the mean shape on the same mesh, after the surfaces were brought
 * together by Alignment; it lies where the first one does.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - point arrays "ShapeMode1", "ShapeMode2" and so on (double, 3 components): the displacement by
 *   one standard deviation of a principal component. Points plus the sum of scores times modes are
 *   the aligned shape, if all modes are kept.
 * - the point arrays that all surfaces have: the mean of numbers, the most frequent label.
 * - field data "ExplainedVariance" (double, a value for each mode; absent without any): the share
 *   of the variance.
 *
 * Points count by the area around them, in the mean over the surfaces, so that it does not matter
 * where the mesh is dense. The same input gives the same bits on any number of threads.
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
   * The mesh of the sphere. ADAPTIVE (default): points lie evenly over the surfaces, as in
   * vtkAdaptiveSphere, dense where one of them asks for it. GEODESIC: evenly over the sphere.
   */
  vtkSetClampMacro(MeshType, int, GEODESIC, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * GEODESIC: f, for 10 f^2 + 2 points, in [1, 10000]. Default is 45: 20,252 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 10000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * ADAPTIVE: number of points, met within 2 percent, in [500, 100000000]. Default is 20,000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * What is taken out of the shapes before they are compared. NONE: nothing. RIGID (default): where
   * they lie and how they are turned. SIMILARITY: their size, too.
   */
  vtkSetClampMacro(Alignment, int, NONE, SIMILARITY);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToRigid() { this->SetAlignment(RIGID); }
  void SetAlignmentToSimilarity() { this->SetAlignment(SIMILARITY); }
  ///@}

  ///@{
  /**
   * Number of principal components, in [0, 1000]: the largest, of which there are fewer than
   * surfaces. Default is 10.
   */
  vtkSetClampMacro(NumberOfModes, int, 0, 1000);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  /**
   * The mean shape, output port 1.
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

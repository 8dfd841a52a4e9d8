/**
 * @class   vtkConsistentRemesh
 * @brief   put mapped surfaces on one mesh, with their mean shape and principal components
 *
 * Resample several surfaces that are mapped to the sphere, so that all of them have the same
 * triangles and corresponding points. The point array "SpherePosition" is the position of each
 * point on the sphere. Points with the same position correspond. The second output is the mean
 * shape with its principal components, which describe the main differences between the shapes.
 *
 * Input port 0 (repeatable): vtkPolyData, the surfaces, as separate inputs or as blocks of
 * composite data, with the point array "SpherePosition". Polygons and strips are cut into
 * triangles. Each surface has
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. Points with equal positions correspond. The surface must be closed, and the map must
 *   cover the sphere exactly once. Either all maps reverse the orientation of the triangles, or no
 *   map does.
 *
 * Output port 0: vtkMultiBlockDataSet with one block for each surface, in the sequence of the
 * inputs, with the names of the input's blocks. A block is a vtkPolyData. Positions on the unit
 * sphere are called directions. Each block contains, for each direction of a common set, the point
 * of its surface that is mapped to this direction. The polygons of all blocks are identical. The
 * blocks are aligned with the mean shape, see the properties Alignment and AlignBlocks. Point
 * arrays of vectors keep the directions of the input.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - the point arrays of the surface, interpolated at the new points as in vtkSphericalResample.
 * - field data "MeanSquarePointToSurface" (double): mean square distance between the points of the
 *   input surface and the block, as in vtkSurfaceMismatch. The unit of length is the largest
 *   distance of a point of the surface from its centroid.
 * - field data "ShapeScores" (double, one component per mode; absent if there are no modes):
 *   coordinates of the shape along the principal components, called modes. The unit of a coordinate
 *   is the standard deviation of the mode. The linear mean shape has the score 0.
 *
 * Output port 1: vtkPolyData, the mean shape on the same mesh. The mean is computed after the
 * surfaces are aligned (property Alignment). The position and orientation of the mean shape are
 * those of the first surface.
 * - point array "SpherePosition" (double, 3 components): the directions.
 * - point arrays "ShapeMode1" (active vectors), "ShapeMode2" and so on (double, 3 components): the
 *   displacement of each point of the mean shape for one standard deviation of a principal
 *   component. If all modes are kept, each aligned block is the linear mean shape (property
 *   MeanType) plus a sum over the modes: the score of the shape times the mode.
 * - the point arrays that all surfaces have. Each value is the mean over the surfaces. In integer
 *   arrays with 1 component (labels), each value is the most frequent label.
 * - field data "ExplainedVariance" (double, one value per mode; absent if there are no modes):
 *   fraction of the variance of the shapes that the mode explains.
 *
 * For alignment, mean and modes, each point is weighted by the area around it, averaged over the
 * surfaces. Dense regions of the mesh therefore have no larger influence than other regions. The
 * output is equal bit by bit for any number of threads.
 *
 * Implementation note: shapes are aligned by the generalized Procrustes analysis of J. C. Gower,
 * Psychometrika 40 (1975). With MeanType RIGID_MEAN, triangles are averaged as in D. Xu, H. Zhang,
 * Q. Wang, H. Bao, "Poisson shape interpolation", Graphical Models 68 (2006). Rotations are
 * relative to the mean itself, so that the mean hardly depends on the order of the surfaces.
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

  enum MeanTypes
  {
    LINEAR_MEAN = 0,
    RIGID_MEAN = 1
  };

  ///@{
  /**
   * Type of the mesh. ADAPTIVE (default): sides of triangles have about equal lengths on the
   * surfaces, in the root mean square over all surfaces. On one surface, triangles are thin only
   * where its map differs from the maps of the other surfaces. GEODESIC: points are uniform over
   * the sphere.
   */
  vtkSetClampMacro(MeshType, int, GEODESIC, ADAPTIVE);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  void SetMeshTypeToAdaptive() { this->SetMeshType(ADAPTIVE); }
  ///@}

  ///@{
  /**
   * If MeshType is GEODESIC: frequency f of the geodesic sphere, a subdivided icosahedron
   * (vtkGeodesicSphereSource). The sphere has 10 f^2 + 2 points. In [1, 10000]. Default is 45:
   * 20,252 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 10000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Number of points of the mesh if MeshType is ADAPTIVE. The actual number differs by at most 2
   * percent. In [500, 100000000]. Default is 20,000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Differences between the shapes that are removed before mean and principal components are
   * computed. NONE: no differences are removed. RIGID (default): position and orientation.
   * SIMILARITY: position, orientation and size.
   */
  vtkSetClampMacro(Alignment, int, NONE, SIMILARITY);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToRigid() { this->SetAlignment(RIGID); }
  void SetAlignmentToSimilarity() { this->SetAlignment(SIMILARITY); }
  ///@}

  ///@{
  /**
   * Move the blocks of output port 0 to the mean shape, by the transform that Alignment permits.
   * Statistics of the coordinates of the blocks, such as principal components, then describe only
   * shape. If off, the blocks keep the coordinates of the input surfaces. Default is on.
   */
  vtkSetMacro(AlignBlocks, bool);
  vtkGetMacro(AlignBlocks, bool);
  vtkBooleanMacro(AlignBlocks, bool);
  ///@}

  ///@{
  /**
   * Type of the mean shape. LINEAR_MEAN (default): mean position of each point. Each aligned block
   * is this mean plus modes. Parts in different poses, such as legs, become smaller in the mean.
   * RIGID: mean rotation and mean stretch of each triangle, joined by a linear system, as in
   * vtkSphericalMorph. Parts keep their size, and the area of the mean is the mean of the areas.
   */
  vtkSetClampMacro(MeanType, int, LINEAR_MEAN, RIGID_MEAN);
  vtkGetMacro(MeanType, int);
  void SetMeanTypeToLinear() { this->SetMeanType(LINEAR_MEAN); }
  void SetMeanTypeToRigid() { this->SetMeanType(RIGID_MEAN); }
  ///@}

  ///@{
  /**
   * Maximum number of principal components (modes) to keep. The components with the largest
   * variance are kept. There are always fewer components than surfaces. In [0, 1000]. Default is
   * 10.
   */
  vtkSetClampMacro(NumberOfModes, int, 0, 1000);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  /**
   * Return the mean shape, output port 1.
   */
  vtkPolyData* GetMeanSurface();

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
  bool AlignBlocks = true;
  int MeanType = LINEAR_MEAN;
  int NumberOfModes = 10;
};

#endif

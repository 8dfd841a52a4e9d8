/**
 * @class   vtkSurfaceHarmonics
 * @brief   compute the spherical harmonics of a mapped surface and of arrays on it
 *
 * Compute the spherical harmonics of a closed surface that has the point array "SpherePosition",
 * and rebuild the surface from those of low degree. The second output is the table of coefficients,
 * from which vtkSurfaceHarmonicsSource makes surfaces.
 *
 * Input port 0: vtkPolyData, a closed surface with the point array "SpherePosition". Polygons and
 * strips are cut into triangles.
 * - point array "SpherePosition" (3 components, of any length but 0): a map that covers the sphere
 *   once without folds; it may mirror the surface.
 *
 * Input port 1 (optional): vtkTable like that of output port 1, the reference of Alignment.
 *
 * Output port 0: vtkPolyData, the sum of the harmonics up to ReconstructionDegree. With MeshType
 * INPUT it is the input with other points, without its active normals. With GEODESIC it is a
 * geodesic sphere with other points.
 * - point array "SpherePosition" (double, 3 components): map of the input, rotated by Alignment, or
 *   the directions of the geodesic sphere.
 * - each chosen point array (double), rebuilt from its harmonics.
 *
 * Output port 1: vtkTable of (L + 1)^2 rows, where L is the Degree: degrees l from 0 to L, and for
 * each l the orders m from -l to l.
 * - columns "Degree", "Order" (int).
 * - columns "X", "Y", "Z" (double): coefficients of the coordinates, in the unit of the points.
 * - a column for each component of each chosen point array (double), with the array's name; for
 *   several components "name_0", "name_1" and so on.
 *
 * Harmonics are real, orthonormal on the unit sphere, and without the Condon-Shortley phase: Y_lm
 * is P_lm(z) cos(m phi) for m >= 0 and P_l|m|(z) sin(|m| phi) for m < 0. Here z is the third
 * coordinate of SpherePosition, and phi is the angle from its first to its second. A function is
 * the sum of coefficients times harmonics. The coefficient of degree 0 is the function's mean times
 * sqrt(4 pi).
 *
 * Field data of output port 0 (double):
 * - "RootMeanSquareDistance" (1 value): distance between the input's points and their positions by
 *   the harmonics up to ReconstructionDegree. Points are weighted by area; the unit is that of the
 *   points.
 * - "HarmonicPower" (L + 1 values): for each degree, the mean over the sphere of the square of its
 *   part of the coordinates, in the square of that unit. It does not depend on the orientation of
 *   the surface or its map.
 * - "HarmonicPower_" with the name of an array (L + 1 values): power of the array's components.
 * - "ShapeSpectrum" (L + 1 values): square root of the power of each degree, divided by that of
 *   degree 1; 0 for degree 0. It does not depend on position, orientation and size of the surface.
 * - "MapRotation", "SurfaceRotation" (9 components, row by row) and "SurfaceCenter" (3 components):
 *   transforms of Alignment. A point s with map p becomes SurfaceRotation (s - SurfaceCenter) with
 *   map MapRotation p.
 *
 * The coefficients are the least-squares solution over the surface, weighted by area. A surface
 * that consists of harmonics up to L, with a mesh finer than pi / L on the sphere, reproduces its
 * coefficients. How well few harmonics describe a surface depends on the map, since conformal maps
 * shrink limbs. vtkGlobalConformalMap with an AreaBalance of 0.5 is suitable for most surfaces. The
 * same input gives the same bits on any number of threads.
 *
 * Implementation note: the axes of Alignment are those of C. Brechbuehler, G. Gerig, O. Kuebler,
 * "Parametrization of closed surfaces for 3-D shape description", Computer Vision and Image
 * Understanding 61 (1995), and of SPHARM-PDM. Both leave the sign of an axis open.
 *
 * @sa
 * vtkSurfaceHarmonicsSource vtkGlobalConformalMap vtkConsistentRemesh
 */

#ifndef vtkSurfaceHarmonics_h
#define vtkSurfaceHarmonics_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for PointArrays
#include <vector> // for PointArrays

class vtkTable;

class VTKFILTERSSHAPE_EXPORT vtkSurfaceHarmonics : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceHarmonics* New();
  vtkTypeMacro(vtkSurfaceHarmonics, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Alignments
  {
    NONE = 0,
    MAP = 1,
    MAP_AND_SURFACE = 2
  };

  enum MeshTypes
  {
    INPUT = 0,
    GEODESIC = 1
  };

  ///@{
  /**
   * Maximum degree L of the harmonics. In [0, 256]. Default is 20.
   */
  vtkSetClampMacro(Degree, int, 0, 256);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{
  /**
   * Maximum degree of the harmonics in output port 0; values above Degree mean Degree. In [0, 256].
   * Default is 256: all.
   */
  vtkSetClampMacro(ReconstructionDegree, int, 0, 256);
  vtkGetMacro(ReconstructionDegree, int);
  ///@}

  ///@{
  /**
   * Mesh of output port 0. INPUT (default): that of the input. GEODESIC: a geodesic sphere of
   * Frequency, with triangles counter-clockwise seen from outside the surface.
   */
  vtkSetClampMacro(MeshType, int, INPUT, GEODESIC);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToInput() { this->SetMeshType(INPUT); }
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  ///@}

  ///@{
  /**
   * GEODESIC: frequency f, for 10 f^2 + 2 points. In [1, 1000]. Default is 36: 12,962 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Rotation to a common frame, in which coefficients can be compared, by the ellipsoid of the
   * harmonics of degree 1. NONE (default): no rotation. MAP: rotate the map so that the longest,
   * middle and shortest axis of the ellipsoid are mapped to the x, y and z axis. MAP_AND_SURFACE:
   * also rotate the surface so that the axes lie on x, y and z, and move the ellipsoid's center to
   * the origin.
   *
   * Four rotations align the axes. With a reference, the rotation with the highest correlation
   * between surface and reference is chosen, and the axes are matched to those of the reference.
   * The direction of axes whose lengths differ by less than a tenth is then searched as well.
   * Without a reference, the longest and the middle axis point to where the surface extends
   * farther, by the third moment over the sphere.
   */
  vtkSetClampMacro(Alignment, int, NONE, MAP_AND_SURFACE);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToMap() { this->SetAlignment(MAP); }
  void SetAlignmentToMapAndSurface() { this->SetAlignment(MAP_AND_SURFACE); }
  ///@}

  ///@{
  /**
   * Add a point array of numbers whose harmonics are computed, too. Default is none.
   */
  void AddPointArray(const char* name);
  void RemoveAllPointArrays();
  int GetNumberOfPointArrays() { return static_cast<int>(this->PointArrays.size()); }
  ///@}

  ///@{
  /**
   * The coefficients of another surface, which determine the signs of the axes of Alignment.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* output);
  void SetReferenceData(vtkTable* reference);
  ///@}

  /**
   * Return the table of coefficients, output port 1.
   */
  vtkTable* GetCoefficients();

protected:
  vtkSurfaceHarmonics();
  ~vtkSurfaceHarmonics() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceHarmonics(const vtkSurfaceHarmonics&) = delete;
  void operator=(const vtkSurfaceHarmonics&) = delete;

  int Degree = 20;
  int ReconstructionDegree = 256;
  int MeshType = INPUT;
  int Frequency = 36;
  int Alignment = NONE;
  std::vector<std::string> PointArrays;
};

#endif

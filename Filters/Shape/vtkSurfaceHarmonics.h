/**
 * @class   vtkSurfaceHarmonics
 * @brief   compute the spherical harmonics of a mapped surface and of arrays on it
 *
 * Describe a closed surface that has the point array "SpherePosition" by spherical harmonics,
 * and rebuild it from those of low degree. The second output is the table of coefficients, from
 * which vtkSurfaceHarmonicsSource makes surfaces.
 *
 * Input port 0: vtkPolyData, a closed surface with the point array "SpherePosition". Polygons and
 * strips are cut into triangles.
 * - point array "SpherePosition" (3 components, of any length but 0): its map to the sphere, which
 *   covers the sphere once without folds, or mirrors the surface so.
 *
 * Input port 1 (optional): vtkTable as of output port 1, the reference of Alignment.
 *
 * Output port 0: vtkPolyData, the surface that the harmonics up to ReconstructionDegree make: the
 * input with other points (MeshType INPUT; its active normals are left out), or a geodesic sphere
 * (GEODESIC).
 * - point array "SpherePosition" (double, 3 components): of the input, turned by Alignment, or the
 *   directions of the geodesic sphere.
 * - each chosen point array (double), rebuilt likewise.
 *
 * Output port 1: vtkTable of (L + 1)^2 rows, L being the Degree: degrees from 0 to L, and for each
 * l the orders m from -l to l.
 * - columns "Degree", "Order" (int).
 * - columns "X", "Y", "Z" (double): coefficients of the coordinates, in the unit of the points.
 * - a column of each component of each chosen point array (double): of its name, or with more than
 *   one component of "name_0", "name_1" and so on.
 *
 * Harmonics are real, orthonormal on the unit sphere, and without the Condon-Shortley phase: Y_lm
 * is P_lm(z) cos(m phi) for m >= 0 and P_l|m|(z) sin(|m| phi) for m < 0, z being the third
 * coordinate of SpherePosition and phi the angle from its first to its second. A function is the
 * sum of coefficients times harmonics; that of degree 0 is its mean times sqrt(4 pi).
 *
 * Field data of output port 0 (double):
 * - "RootMeanSquareDistance" (1 value): of the input's points from where the harmonics up to
 *   ReconstructionDegree put them, points counting by the area around them; in the unit of the
 *   points.
 * - "HarmonicPower" (L + 1 values): for each degree, the mean over the sphere of the square of its
 *   part of the coordinates, in the square of that unit. It does not depend on how the surface or
 *   its map is turned. "HarmonicPower_" with the name of an array: the same of its components.
 * - "ShapeSpectrum" (L + 1 values): the root of the power of each degree over that of degree 1, 0
 *   for degree 0: does not depend on where the surface is nor on its size either.
 * - "MapRotation", "SurfaceRotation" (9 components, row by row) and "SurfaceCenter" (3 components):
 *   what Alignment did. A point s that was mapped to p is at SurfaceRotation (s - SurfaceCenter),
 * and mapped to MapRotation p.
 *
 * The coefficients are the solution of least squares over the surface by area: a surface that is
 * made of harmonics up to L, and whose mesh is finer than pi / L on the sphere, gives its
 * coefficients back. How well few harmonics describe a surface depends on the map. Conformal maps
 * shrink limbs to nothing; vtkGlobalConformalMap with an AreaBalance of 0.5 serves most surfaces.
 * The same input gives the same bits on any number of threads.
 *
 * Implementation note: the axes of Alignment are those of C. Brechbuehler, G. Gerig, O. Kuebler,
 * "Parametrization of closed surfaces for 3-D shape description", Computer Vision and Image
 * Understanding 61 (1995), and of SPHARM-PDM, which leaves open to which end of an axis its
 * positive direction points.
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
   * The highest degree of the harmonics, L, in [0, 256]. Default is 20.
   */
  vtkSetClampMacro(Degree, int, 0, 256);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{
  /**
   * The highest degree that output port 0 is made of, in [0, 256]; no more than Degree are there.
   * Default is 256: all of them.
   */
  vtkSetClampMacro(ReconstructionDegree, int, 0, 256);
  vtkGetMacro(ReconstructionDegree, int);
  ///@}

  ///@{
  /**
   * The mesh of output port 0. INPUT (default): that of the input. GEODESIC: a geodesic sphere of
   * Frequency, its triangles counter-clockwise seen from outside the surface.
   */
  vtkSetClampMacro(MeshType, int, INPUT, GEODESIC);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToInput() { this->SetMeshType(INPUT); }
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  ///@}

  ///@{
  /**
   * GEODESIC: f, for 10 f^2 + 2 points, in [1, 1000]. Default is 36: 12,962 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * What is turned to where coefficients can be compared, by the ellipsoid that the harmonics of
   * degree 1 are. MAP: the map to the sphere, so that the longest, middle and shortest axis of that
   * ellipsoid are mapped to the x, y and z axis. MAP_AND_SURFACE: the surface as well, so that the
   * axes lie there too, and the center of the ellipsoid is the origin. NONE (default): nothing.
   *
   * Four rotations do that. With a reference, the one after which the surface correlates best with
   * it is taken, and axes come upon those of the reference; of axes that differ in length by less
   * than a tenth the direction is searched as well. Without one, the longest and the middle axis
   * point to where the surface reaches farther, by the third moment over the sphere.
   */
  vtkSetClampMacro(Alignment, int, NONE, MAP_AND_SURFACE);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToMap() { this->SetAlignment(MAP); }
  void SetAlignmentToMapAndSurface() { this->SetAlignment(MAP_AND_SURFACE); }
  ///@}

  ///@{
  /**
   * Point arrays of numbers whose harmonics are wanted too. Default is none.
   */
  void AddPointArray(const char* name);
  void RemoveAllPointArrays();
  int GetNumberOfPointArrays() { return static_cast<int>(this->PointArrays.size()); }
  ///@}

  ///@{
  /**
   * The coefficients of another surface, by which Alignment decides which way axes point.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* output);
  void SetReferenceData(vtkTable* reference);
  ///@}

  /**
   * The table of coefficients, output port 1.
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

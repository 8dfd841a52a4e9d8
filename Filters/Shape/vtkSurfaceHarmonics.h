/**
 * @class   vtkSurfaceHarmonics
 * @brief   compute the spherical harmonics of a mapped surface and of arrays on it
 *
 * Spherical harmonics are functions on the sphere with finer and finer waves as their degree
 * increases. This filter describes the points of a closed surface as sums of spherical harmonics.
 * The filter computes the coefficients of the sums, and rebuilds the surface from the harmonics of
 * low degree. The surface must be mapped to the sphere, and have the point array "SpherePosition".
 * The second output is the table of coefficients. The class vtkSurfaceHarmonicsSource makes
 * surfaces from this table.
 *
 * Input port 0: vtkPolyData, a closed surface with the point array "SpherePosition". Polygons and
 * strips are cut into triangles.
 * - point array "SpherePosition" (3 components, of any length but 0): a map that covers the sphere
 *   once without folds. The map is also valid if it reverses the orientation of all triangles.
 *
 * Input port 1 (optional): vtkTable, the coefficients of a reference surface, as on output port 1.
 * The property Alignment uses the reference.
 *
 * Output port 0: vtkPolyData, the sum of the harmonics up to ReconstructionDegree. If MeshType is
 * INPUT, the output is the input with new coordinates of the points, and without its active
 * normals. If MeshType is GEODESIC, the output has the triangles of a geodesic sphere, a subdivided
 * icosahedron.
 * - point array "SpherePosition" (double, 3 components): the map of the input, rotated according to
 *   Alignment. If MeshType is GEODESIC: the points of the geodesic sphere.
 * - each point array that was added by AddPointArray() (double), rebuilt from its harmonics.
 *
 * Output port 1: vtkTable, the coefficients. Let L be the Degree. The table has (L + 1)^2 rows: for
 * each degree l from 0 to L, the orders m from -l to l.
 * - columns "Degree", "Order" (int).
 * - columns "X", "Y", "Z" (double): coefficients of the coordinates, in the unit of the input's
 *   coordinates.
 * - one column (double) for each component of each point array that was added. The column of an
 *   array with 1 component has the name of the array. With several components, the columns are
 *   "name_0", "name_1" and so on.
 *
 * Let (x, y, z) be a point of the unit sphere, with phi = atan2(y, x), and P_lm the normalized
 * associated Legendre functions. The harmonic Y_lm is P_lm(z) cos(m phi) for m >= 0, and P_l|m|(z)
 * sin(|m| phi) for m < 0. Harmonics are real, orthonormal on the unit sphere, and without the
 * Condon-Shortley phase. A function on the sphere is the sum of coefficients times harmonics. The
 * coefficient of degree 0 is the function's mean times sqrt(4 pi).
 *
 * Field data of output port 0 (double):
 * - "RootMeanSquareDistance" (1 value): root mean square distance between the points of the input
 *   and the points rebuilt from the harmonics up to ReconstructionDegree. Points are weighted by
 *   area. The unit is that of the coordinates.
 * - "HarmonicPower" (L + 1 values): power of each degree l. Let p be the sum of the coefficients
 *   times the harmonics of degree l, a vector at each point of the sphere. The power is the mean of
 *   |p|^2 over the sphere, in the squared unit of the coordinates. The power does not depend on the
 *   orientation of the surface or of its map.
 * - "HarmonicPower_NAME" (L + 1 values): power of each degree of the point array NAME, added over
 *   its components.
 * - "ShapeSpectrum" (L + 1 values): square root of the power of each degree, divided by the square
 *   root of the power of degree 1; 0 for degree 0. The spectrum does not depend on position,
 *   orientation and size of the surface.
 * - "MapRotation", "SurfaceRotation" (9 components, matrices row by row) and "SurfaceCenter" (3
 *   components): the transforms that Alignment applied. A point s of the surface with the position
 *   p on the sphere moves to SurfaceRotation (s - SurfaceCenter). Its position on the sphere
 *   becomes MapRotation p.
 * - "AxisEndMargin" (1 value): how clearly Alignment without a reference chose the ends of the
 *   axes, in [0, 4]. If the value is below about 0.02, another mesh of the same surface may give
 *   other ends. The value is 0 with a reference, or without Alignment.
 *
 * The coefficients are a least-squares solution over the points of the surface, weighted by area.
 * Suppose that a surface is a sum of harmonics up to degree L, and that its edges on the sphere are
 * shorter than pi / L. The filter then computes the coefficients of this sum. In a conformal map,
 * limbs (long, thin parts) are small on the sphere, and need harmonics of high degree. For most
 * surfaces, the map of vtkGlobalConformalMap with an AreaBalance of 0.5 is suitable. The output is
 * equal bit by bit for any number of threads.
 *
 * Implementation note: the axes of Alignment are those of C. Brechbuehler, G. Gerig, O. Kuebler,
 * "Parametrization of closed surfaces for 3-D shape description", Computer Vision and Image
 * Understanding 61 (1995), and of SPHARM-PDM. In these methods, the signs of the axes are
 * undefined.
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
   * Maximum degree of the harmonics from which output port 0 is rebuilt. Values above the property
   * Degree have the effect of Degree. In [0, 256]. Default is 256: all harmonics.
   */
  vtkSetClampMacro(ReconstructionDegree, int, 0, 256);
  vtkGetMacro(ReconstructionDegree, int);
  ///@}

  ///@{
  /**
   * Mesh of output port 0. INPUT (default): the mesh of the input. GEODESIC: the mesh of a geodesic
   * sphere with the given Frequency; triangles are counter-clockwise seen from outside the surface.
   */
  vtkSetClampMacro(MeshType, int, INPUT, GEODESIC);
  vtkGetMacro(MeshType, int);
  void SetMeshTypeToInput() { this->SetMeshType(INPUT); }
  void SetMeshTypeToGeodesic() { this->SetMeshType(GEODESIC); }
  ///@}

  ///@{
  /**
   * If MeshType is GEODESIC: frequency f of the geodesic sphere (vtkGeodesicSphereSource), which
   * has 10 f^2 + 2 points. In [1, 1000]. Default is 36: 12,962 points.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Alignment to common axes, so that coefficients of different surfaces can be compared. The
   * common axes are those of the ellipsoid that the harmonics of degree 1 define. NONE (default):
   * no alignment. MAP: rotate the map so that the longest, middle and shortest axis of the
   * ellipsoid are mapped to the x, y and z axis. MAP_AND_SURFACE: also rotate the surface so that
   * these axes become x, y and z, and move the ellipsoid's center to the origin.
   *
   * Four rotations align the axes, since the signs of two axes are free. With a reference, the axes
   * of the surface's ellipsoid are matched to those of the reference's ellipsoid. Of the four
   * rotations, the one with the highest correlation between surface and reference is chosen. If the
   * lengths of two axes differ by less than a tenth, rotations about the third axis are also tried.
   * Without a reference, the axes point to the sides on which the surface extends farther. The
   * skewness along an axis is the integral of the cubed coordinate over the area of the surface,
   * divided by the integral of its absolute value. Of the four rotations, the one with the largest
   * sum of the skewness along the three axes is chosen. Field data "AxisEndMargin" is the
   * difference of this sum from that of the next rotation.
   */
  vtkSetClampMacro(Alignment, int, NONE, MAP_AND_SURFACE);
  vtkGetMacro(Alignment, int);
  void SetAlignmentToNone() { this->SetAlignment(NONE); }
  void SetAlignmentToMap() { this->SetAlignment(MAP); }
  void SetAlignmentToMapAndSurface() { this->SetAlignment(MAP_AND_SURFACE); }
  ///@}

  ///@{
  /**
   * Add the name of a numeric point array whose harmonics are also computed. Default is none.
   */
  void AddPointArray(const char* name);
  void RemoveAllPointArrays();
  int GetNumberOfPointArrays() { return static_cast<int>(this->PointArrays.size()); }
  ///@}

  ///@{
  /**
   * Set the coefficients of a reference surface, with which the property Alignment aligns this
   * surface.
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

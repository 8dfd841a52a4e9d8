/**
 * @class   vtkGlobalConformalMap
 * @brief   map a closed surface to the sphere, conformally and without folds
 *
 * Give every point of a closed triangle mesh without handles its position on the sphere, the point
 * array "SpherePosition", so that angles are preserved. The paper compares its method with such
 * maps. The field data state whether the map has converged and the number of flipped triangles.
 *
 * Input port 0: vtkPolyData, a closed surface without handles. Polygons and strips are treated as
 * triangles. Coincident points of open edges are merged, triangles are oriented consistently, and
 * points of no triangle are dropped, each with a warning.
 *
 * Output port 0: the input, or, if it had to be repaired, its triangles, with
 * - point array "SpherePosition" (double, 3 components): position of the point on the unit sphere.
 *
 * Field data (one value):
 * - "Energy" (double): harmonic energy of the map. 4 pi means conformal.
 * - "NumberOfIterations" (vtkIdType): number of steps of GUYAU, or of linear solves of ROBUST.
 * - "Converged" (vtkIdType): 1 if no triangle is flipped. GUYAU must also end both phases by
 *   Tolerance, without infinite string constants.
 * - "NumberOfFlippedTriangles" (vtkIdType): flipped and flat triangles, by exact arithmetic.
 * - "SphereMapTier" (vtkIdType): steps that ROBUST needed. 0: linear equations. 1: also local
 *   unfolding of triangles. 2: insertion of the vertices one by one, which never folds. Tier 2
 *   serves AreaBalance, and conformal maps with triangles too small for double precision.
 * - "NumberOfNegativeStringConstants" (vtkIdType): edges with opposite angles that add up to more
 *   than 180 degrees.
 * - "NumberOfInfiniteStringConstants" (vtkIdType): edges of triangles without area.
 *
 * Section 4.1 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved
 * seamless surface", Neurocomputing 71 (2008), compares its method with the global conformal
 * parameterization of X. Gu, S.-T. Yau. GUYAU is that procedure, with the failures that the paper
 * shows. Obtuse triangles cause negative string constants and folds; triangles without area cause
 * infinite string constants. ROBUST maps every surface one to one.
 *
 * A conformal map is unique up to a Moebius transform. ROBUST moves the mean of the surface,
 * weighted by area, to the sphere's center. It then rotates the sphere for the best agreement with
 * the directions from the surface's middle.
 *
 * @note Limbs shrink exponentially in a conformal map. Keep SpherePosition in double precision. In
 * programs that convert the map to float, triangles seem flipped that are not.
 *
 * @sa
 * vtkConformalDistortion vtkCurvedSeamlessSurface vtkSphericalAlignment vtkConformalSOM
 */

#ifndef vtkGlobalConformalMap_h
#define vtkGlobalConformalMap_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkGlobalConformalMap : public vtkPolyDataAlgorithm
{
public:
  static vtkGlobalConformalMap* New();
  vtkTypeMacro(vtkGlobalConformalMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    ROBUST = 0,
    GUYAU = 1
  };

  ///@{
  /**
   * Algorithm of the map. ROBUST (default): without folds, for every surface. GUYAU: as Gu and Yau
   * published it, which folds at obtuse triangles.
   */
  vtkSetClampMacro(Method, int, ROBUST, GUYAU);
  vtkGetMacro(Method, int);
  void SetMethodToRobust() { this->SetMethod(ROBUST); }
  void SetMethodToGuYau() { this->SetMethod(GUYAU); }
  ///@}

  ///@{
  /**
   * ROBUST only: trade-off between conformal (0) and nearly equal in area (1). Values in between
   * trade angles for areas, so that limbs keep their fraction of the sphere. In [0, 1]. Default is
   * 0.
   */
  vtkSetClampMacro(AreaBalance, double, 0.0, 1.0);
  vtkGetMacro(AreaBalance, double);
  ///@}

  ///@{
  /**
   * GUYAU only: maximum number of steps of each phase. At least 0. Default is 5000.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * GUYAU only: relative change of the energy in one step that ends a phase. In [0, 1]. Default is
   * 1e-7.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkGlobalConformalMap() = default;
  ~vtkGlobalConformalMap() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGlobalConformalMap(const vtkGlobalConformalMap&) = delete;
  void operator=(const vtkGlobalConformalMap&) = delete;

  int Method = ROBUST;
  double AreaBalance = 0.0;
  int MaximumNumberOfIterations = 5000;
  double Tolerance = 1e-7;
};

#endif

/**
 * @class   vtkGlobalConformalMap
 * @brief   map a closed surface to the sphere, conformally and without folds
 *
 * Give every point of a closed triangle mesh without handles its position on the sphere, the point
 * array "SpherePosition", so that angles are kept: what the method of the paper is compared with.
 * The field data state whether the map is finished and folds nowhere.
 *
 * Input port 0: vtkPolyData, a closed surface without handles. Polygons and strips are treated as
 * triangles. Coincident points of open edges are merged, triangles turned and points of no triangle
 * dropped, each with a warning.
 *
 * Output port 0: the input, or, if it had to be repaired, its triangles; with
 * - point array "SpherePosition" (double, 3 components): the point's place on the unit sphere.
 *
 * Field data (one value):
 * - "Energy" (double): harmonic energy of the map. 4 pi means conformal.
 * - "NumberOfIterations" (vtkIdType): steps of GUYAU; linear solves of ROBUST.
 * - "Converged" (vtkIdType): 1 if no triangle is flipped and, for GUYAU, both phases ended by
 *   Tolerance and no string constant is infinite.
 * - "NumberOfFlippedTriangles" (vtkIdType): by exact arithmetic, flat ones included.
 * - "SphereMapTier" (vtkIdType): what ROBUST had to do. 0: solve linear equations. 1: also unfold
 *   triangles in places. 2: insert the vertices one by one, which never folds, since areas were
 *   asked for, or a conformal map would have triangles too small for numbers.
 * - "NumberOfNegativeStringConstants" (vtkIdType): edges whose opposite angles add up to more than
 *   180 degrees.
 * - "NumberOfInfiniteStringConstants" (vtkIdType): edges of triangles without area.
 *
 * The global conformal parameterization of X. Gu, S.-T. Yau is what section 4.1 of C.-Y. Liou,
 * Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless surface",
 * Neurocomputing 71 (2008), is compared with. GUYAU is that procedure, with the failures the paper
 * shows: obtuse triangles give negative string constants and folds, triangles without area infinite
 * ones. ROBUST maps every surface one to one.
 *
 * A conformal map is given up to a Moebius transform. ROBUST moves the mean of the surface,
 * weighted by area, to the sphere's center, and turns the sphere to where it agrees best with the
 * directions from the surface's middle.
 *
 * @note
 * Limbs shrink exponentially in a conformal map. Keep SpherePosition in double precision; programs
 * that look at the map as float see flipped triangles that are not there.
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
   * How the map is made. ROBUST (default): without folds, whatever the surface. GUYAU: as Gu and
   * Yau published it, which folds at obtuse triangles.
   */
  vtkSetClampMacro(Method, int, ROBUST, GUYAU);
  vtkGetMacro(Method, int);
  void SetMethodToRobust() { this->SetMethod(ROBUST); }
  void SetMethodToGuYau() { this->SetMethod(GUYAU); }
  ///@}

  ///@{
  /**
   * ROBUST only: from conformal, 0, to nearly equal in area, 1. In between angles are given up for
   * areas step by step, so that limbs keep their share of the sphere. Default is 0.
   */
  vtkSetClampMacro(AreaBalance, double, 0.0, 1.0);
  vtkGetMacro(AreaBalance, double);
  ///@}

  ///@{
  /**
   * GUYAU only: steps of each phase at most. At least 0. Default is 5000.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * GUYAU only: relative change of the energy in a step at which a phase ends. At least 0. Default
   * is 1e-7.
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

/**
 * @class   vtkGlobalConformalMap
 * @brief   map a closed surface to the sphere, conformally and without folds
 *
 * Compute, for each point of a closed triangle mesh without handles, a position on the unit sphere,
 * so that angles of triangles are preserved. The positions are the point array "SpherePosition".
 * The field data state whether the computation has converged, and the number of flipped triangles.
 * A surface with one handle is mapped to a flat torus instead, by the array "TorusPosition".
 *
 * Input port 0: vtkPolyData, a closed surface without handles or with one handle (genus 1), or a
 * sheet: a connected surface with a border and without handles. Polygons and strips are treated as
 * triangles. Coincident points of open edges (edges of only one triangle) are merged, triangles are
 * oriented consistently, and points that belong to no triangle are dropped. Each kind of change
 * causes a warning.
 *
 * Output port 0: the input, or only its triangles if one of the changes above was made, with
 * - point array "SpherePosition" (double, 3 components): position of the point on the unit sphere;
 * not of a surface of genus 1.
 * - point array "DiskPosition" (double, 2 components), only of a sheet: position of the point in
 * the unit disk, by a conformal map. Points on the border have length 1.
 * - point array "TorusPosition" (double, 2 components), only of a surface of genus 1: position of
 * the point on a flat torus, in [0, 1), as fractions of the two periods.
 *
 * A sheet is mapped to the hemisphere z >= 0, with its border exactly on the equator. If there are
 * several borders, this is the longest; others are mapped as holes inside, and there is a warning.
 * The conformal map of the sheet glued to its mirror image is symmetric; only the half of the sheet
 * is computed. "DiskPosition" is the stereographic projection of this hemisphere. The direction x
 * in the disk is the direction x of the sheet, seen from its front. Sheets are mapped only by
 * Method ROBUST with AreaBalance 0. Filters for closed surfaces, such as vtkSphericalRegistration,
 * reject sheets. Sheets that are longer than about nine times their width can have flipped
 * triangles, with a warning, and much longer sheets cause an error: toward their ends, triangles
 * of the map become too small for double precision. A triangle whose three corners are on the
 * longest border, such as an ear (a triangle with two edges of the border), has no area on the
 * sphere. There is a warning. Remove ears, or flip or split their inner edges.
 *
 * A flat torus is a parallelogram whose opposite sides are identified. Its sides are the periods.
 * The conformal map of a surface of genus 1 is linear in two harmonic one-forms (X. Gu, S.-T. Yau,
 * 2003). The first period is the shortest possible. Seen from outside, the map preserves
 * orientation. Point 0 of the surface is at position (0, 0). Further field data of a surface of
 * genus 1:
 * - "TorusModulus" (double, 2 components): real and imaginary part of the modulus tau, the second
 *   period divided by the first, as complex numbers. The real part is in (-1/2, 1/2], and the
 *   absolute value is at least 1. Two surfaces of genus 1 have a conformal map to each other only
 * if their moduli are equal.
 * - "MeanQuasiConformalError" (double): mean of the quasi-conformal error over the triangles, see
 *   vtkConformalDistortion; 1 for a conformal map.
 * - "QuasiConformalError95" (double): error that 95 % of the triangles do not exceed.
 * There is a warning if a triangle is flipped, or if the mean error is above 1.5. Surfaces of genus
 * 1 are mapped only by Method ROBUST with AreaBalance 0. For their texture coordinates, use
 * vtkTorusTextureMap. Other filters need a map to the sphere, and reject them. Surfaces of genus 2
 * or more are not mapped; vtkGenusZeroRepair removes handles.
 *
 * The harmonic energy measures how far a map is from conformal. It is half the sum over all edges
 * of a weight times the squared length of the edge on the sphere. The weight, called the string
 * constant, is half the sum of the cotangents of the two angles opposite to the edge. Field data
 * (one value each):
 * - "Energy" (double): harmonic energy of the map. The energy of a conformal map tends to 4 pi for
 *   fine meshes (2 pi for that of a sheet, 1 for that to a torus of area 1), and that of other maps
 *   to larger values. Flat triangles are smaller than those on the sphere, so that the energy of a
 *   map of a coarse mesh is below 4 pi.
 * - "NumberOfIterations" (vtkIdType): number of steps if Method is GUYAU, or number of linear
 *   solves if Method is ROBUST.
 * - "Converged" (vtkIdType): 1 if no triangle is flipped. If Method is GUYAU, two more conditions
 *   must hold: both phases of the computation have reached the Tolerance, and no string constant is
 *   infinite.
 * - "NumberOfFlippedTriangles" (vtkIdType): number of triangles that are flipped or have no area on
 *   the sphere, by exact arithmetic; of a sheet, in the disk.
 * - "SphereMapTier" (vtkIdType), not of a surface of genus 1: number of the algorithm with which
 * Method ROBUST succeeded. 0: linear equations were sufficient. 1: folded triangles were also
 * repaired locally. 2: vertices were inserted one by one without folds. Algorithm 2 is used if
 * AreaBalance is above 0, or if triangles of the conformal map are too small for double precision.
 * - "NumberOfNegativeStringConstants" (vtkIdType): number of edges whose opposite angles add up to
 *   more than 180 degrees.
 * - "NumberOfInfiniteStringConstants" (vtkIdType): number of edges of triangles without area.
 *
 * Section 4.1 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved
 * seamless surface", Neurocomputing 71 (2008), compares its method with the global conformal
 * parameterization of X. Gu, S.-T. Yau. Method GUYAU is the parameterization of Gu and Yau. As
 * shown in the paper, its maps can have folds. Obtuse triangles can cause negative string
 * constants, and thus folds. Triangles without area cause infinite string constants, which GUYAU
 * ignores. Method ROBUST maps every closed surface without handles one to one.
 *
 * A conformal map is unique up to a Moebius transform, a conformal map of the sphere to itself.
 * ROBUST chooses the transform so that the mean of the sphere positions, weighted by area on the
 * surface, is the center of the sphere. ROBUST then rotates the sphere. After the rotation, the
 * position of a point on the sphere agrees as well as possible with its direction from the middle
 * of the surface.
 *
 * @note In a conformal map, a limb becomes exponentially smaller with its length. Keep
 * SpherePosition in double precision. If a program converts the map to float, triangles that are
 * not flipped may appear flipped.
 *
 * @sa
 * vtkConformalDistortion vtkCurvedSeamlessSurface vtkSphericalAlignment vtkConformalSOM
 * vtkTorusTextureMap
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
   * Algorithm that computes the map. ROBUST (default): an algorithm without folds for every closed
   * surface without handles. GUYAU: the algorithm published by Gu and Yau. Near obtuse triangles,
   * this algorithm can fold triangles.
   */
  vtkSetClampMacro(Method, int, ROBUST, GUYAU);
  vtkGetMacro(Method, int);
  void SetMethodToRobust() { this->SetMethod(ROBUST); }
  void SetMethodToGuYau() { this->SetMethod(GUYAU); }
  ///@}

  ///@{
  /**
   * Trade-off between a conformal map (0) and a map that nearly preserves areas (1). Used only by
   * ROBUST. With larger values, limbs get a larger part of the sphere, but angles are distorted
   * more. In [0, 1]. Default is 0.
   */
  vtkSetClampMacro(AreaBalance, double, 0.0, 1.0);
  vtkGetMacro(AreaBalance, double);
  ///@}

  ///@{
  /**
   * Maximum number of steps in each of the two phases of GUYAU. At least 0. Default is 5000.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Threshold for the relative change of the energy in one step of GUYAU. A phase ends when the
   * change is below this value. In [0, 1]. Default is 1e-7.
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

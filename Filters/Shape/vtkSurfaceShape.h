/**
 * @class   vtkSurfaceShape
 * @brief   measure the curvatures of a closed surface and the depth of its folds
 *
 * Measure the shape of a closed surface at each point. The filter adds the point arrays
 * MeanCurvature (positive where the surface is convex), GaussianCurvature, and SulcalDepth
 * (positive in folds, negative on ridges).
 *
 * Input port 0: vtkPolyData, a closed surface without handles; a map to the sphere is not needed.
 * Polygons and strips are treated as triangles. Coincident points of open edges (edges of only one
 * triangle) are merged, triangles are oriented consistently, and points that belong to no triangle
 * are dropped. Each kind of change causes a warning.
 *
 * Output port 0: the input, or only its triangles if one of the changes above was made, with point
 * arrays (double)
 * - "MeanCurvature", in units of 1 / length: positive where the surface is convex; 1 / r on a
 *   sphere of radius r. The program Connectome Workbench uses the same sign. The program FreeSurfer
 *   uses the opposite sign in its files "curv".
 * - "GaussianCurvature", in units of 1 / area: positive on domes and in pits, negative on saddles.
 * - "SulcalDepth", in units of length: positive in folds and negative on ridges. "sulc" of
 *   FreeSurfer, a program for brain surfaces, has the same sign. The mean of SulcalDepth over the
 *   surface is 0.
 *
 * Curvatures are integrals over edges and vertices (D. Cohen-Steiner, J.-M. Morvan, "Restricted
 * Delaunay triangulations and normal cycle", SoCG 2003). The integral for a vertex is divided by
 * the area of the vertex. This area is about the part of the surface that is nearer to this vertex
 * than to other vertices. The result is smoothed over the length CurvatureScale.
 *
 * "SulcalDepth" is the depth potential of M. Boucher, S. Whitesides, A. Evans, "Depth potential
 * function for folding pattern representation, registration and analysis", Medical Image Analysis
 * 13 (2009). Let H be the mean curvature, and s the length that DepthScale defines. The depth
 * potential is the solution u of the equation u / s^2 - Laplacian u = 2 (mean of H - H). In shallow
 * folds, u is approximately the height of the surrounding surface above the point. In deep folds
 * with steep walls, u increases with the length of the wall. The depth potential differs from two
 * other measures of depth: FreeSurfer's average convexity, and the distance to a hull.
 *
 * The class vtkSphericalRegistration computes features from the mean curvature at fixed scales. To
 * register by mean curvature at other scales, add the arrays of this filter as features by
 * AddFeature() of that class.
 *
 * These measures are not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008)).
 *
 * @sa
 * vtkSphericalRegistration vtkSphericalResample vtkGIFTIWriter vtkFreeSurferWriter
 */

#ifndef vtkSurfaceShape_h
#define vtkSurfaceShape_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSSHAPE_EXPORT vtkSurfaceShape : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceShape* New();
  vtkTypeMacro(vtkSurfaceShape, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Approximate length over which curvatures are smoothed, as a fraction of the square root of the
   * surface's area. With 0, curvatures are not smoothed. In [0, 1]. Default is 0.01: 3 mm on a
   * brain hemisphere of 900 square centimeters.
   */
  vtkSetClampMacro(CurvatureScale, double, 0.0, 1.0);
  vtkGetMacro(CurvatureScale, double);
  ///@}

  ///@{
  /**
   * Distance over which heights are compared for SulcalDepth, as a fraction of the square root of
   * the surface's area. Folds much wider than this distance are not detected. In [0.001, 1].
   * Default is 0.03: 9 mm on a brain hemisphere of 900 square centimeters, about the width of its
   * folds.
   */
  vtkSetClampMacro(DepthScale, double, 0.001, 1.0);
  vtkGetMacro(DepthScale, double);
  ///@}

protected:
  vtkSurfaceShape() = default;
  ~vtkSurfaceShape() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceShape(const vtkSurfaceShape&) = delete;
  void operator=(const vtkSurfaceShape&) = delete;

  double CurvatureScale = 0.01;
  double DepthScale = 0.03;
};

#endif

/**
 * @class   vtkSurfaceShape
 * @brief   measure the curvatures of a closed surface and the depth of its folds
 *
 * Add the point arrays MeanCurvature (positive where the surface bulges out), GaussianCurvature,
 * and SulcalDepth (positive in folds, negative on ridges).
 *
 * Input port 0: vtkPolyData, a closed surface without handles; a map to the sphere is not needed.
 * Polygons and strips are treated as triangles. Coincident points of open edges are merged,
 * triangles are oriented consistently, and points of no triangle are dropped, each with a warning.
 *
 * Output port 0: the input, or, if it had to be repaired, its triangles, with point arrays (double)
 * - "MeanCurvature", per length: positive where the surface bulges out, 1 / r on a sphere of radius
 *   r. Connectome Workbench uses the same sign; FreeSurfer's "curv" has the opposite sign.
 * - "GaussianCurvature", per area: positive on domes and in pits, negative on saddles.
 * - "SulcalDepth", a length: positive in folds and negative on ridges, as FreeSurfer's "sulc". Its
 *   mean over the surface is 0.
 *
 * Curvatures are integrals over edges and vertices (D. Cohen-Steiner, J.-M. Morvan, "Restricted
 * Delaunay triangulations and normal cycle", SoCG 2003). They are divided by the area that is
 * nearest to each vertex, and smoothed over CurvatureScale.
 *
 * "SulcalDepth" is the depth potential of M. Boucher, S. Whitesides, A. Evans, "Depth potential
 * function for folding pattern representation, registration and analysis", Medical Image Analysis
 * 13 (2009). It is the solution u of u / s^2 - Laplacian u = 2 (mean of H - H) with the mean
 * curvature H and s from DepthScale. In shallow folds it is about the height of the surroundings
 * above the point. Along the steep walls of deep folds it grows with the length of the wall. It is
 * neither FreeSurfer's average convexity nor a distance to a hull.
 *
 * vtkSphericalRegistration computes features from the mean curvature, too. Pass these arrays to it
 * to register by other scales.
 *
 * The measures are not part of the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
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
   * surface's area; 0 disables smoothing. In [0, 1]. Default is 0.01: 3 mm on a hemisphere of 900
   * square centimeters.
   */
  vtkSetClampMacro(CurvatureScale, double, 0.0, 1.0);
  vtkGetMacro(CurvatureScale, double);
  ///@}

  ///@{
  /**
   * Distance over which heights are compared for SulcalDepth, as a fraction of the square root of
   * the surface's area. Much wider folds are not detected. In [0.001, 1]. Default is 0.1.
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
  double DepthScale = 0.1;
};

#endif

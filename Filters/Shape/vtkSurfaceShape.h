/**
 * @class   vtkSurfaceShape
 * @brief   curvatures of a closed surface, and how deep its folds are
 *
 * Input port 0: vtkPolyData, a closed surface without handles, mapped to the sphere or not.
 * Polygons and strips are treated as triangles. Coincident points of open edges are merged,
 * triangles turned and points of no triangle dropped, each with a warning.
 *
 * Output port 0: the input, or, if it had to be repaired, its triangles; with point arrays (double)
 * - "MeanCurvature", per length: above 0 where the surface bulges out, 1 / r on a sphere of radius
 *   r. Connectome Workbench has this sign, FreeSurfer's "curv" the other one.
 * - "GaussianCurvature", per area: above 0 on domes and in pits, below 0 on saddles.
 * - "SulcalDepth", a length: above 0 in folds and below 0 on ridges, as FreeSurfer's "sulc"; its
 * mean over the surface is 0.
 *
 * Curvatures are integrals over the edges and the vertices (D. Cohen-Steiner, J.-M. Morvan,
 * "Restricted Delaunay triangulations and normal cycle", SoCG 2003), divided by the area that is
 * nearest to each vertex, and smoothed over CurvatureScale. "SulcalDepth" is the depth potential of
 * M. Boucher, S. Whitesides, A. Evans, "Depth potential function for folding pattern
 * representation, registration and analysis", Medical Image Analysis 13 (2009), the solution u of
 * u / s^2 - Laplacian u = 2 (mean of H - H) with the mean curvature H and s from DepthScale: about
 * the height of the surroundings above the point, where folds are shallow; along the steep walls of
 * deep ones it grows with the way along the wall. It is not FreeSurfer's average convexity, nor a
 * distance to a hull.
 *
 * vtkSphericalRegistration has features of the same mean curvature of its own; hand it these arrays
 * to register by what you chose.
 *
 * Not in the paper (C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved
 * seamless surface", Neurocomputing 71 (2008)).
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
   * About how far curvatures are smoothed, as a part of the square root of the surface's area; 0
   * smooths nothing. In [0, 1]. Default is 0.01: 3 mm on a hemisphere of 900 square centimeters.
   */
  vtkSetClampMacro(CurvatureScale, double, 0.0, 1.0);
  vtkGetMacro(CurvatureScale, double);
  ///@}

  ///@{
  /**
   * The distance, as a part of the square root of the surface's area, over which heights are
   * compared for SulcalDepth: folds that are much wider than that are not seen. In [0.001, 1].
   * Default is 0.1.
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

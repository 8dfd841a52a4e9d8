/**
 * @class   vtkSphericalTextureMap
 * @brief   lay an image on a surface by way of the sphere, from a chosen view
 *
 * Input port 0: vtkPolyData, a surface with the point array "SpherePosition" (3 components).
 * Polygons and strips are looked at as triangles.
 *
 * Output port 0: the input, with point arrays
 * - "Texture Coordinates" (float, 2 components): s to the right and t upwards in the image, clamped
 *   to [0, 1] and finite everywhere; the active texture coordinates.
 * - "OutsideImage" (unsigned char, 1 component): 1 where they had to be clamped, since the image
 *   does not reach there.
 *
 * and field data (double, 3 components, one unit vector)
 * - "SpherePole": the place on the sphere where the middle of the image lies.
 * - "SphereUp", "SphereRight": directions on the sphere there, towards the top and the right edge
 * of the image.
 *
 * The view of the model chooses the pole, the image goes to the sphere by stereographic projection
 * and from the sphere to the surface: section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008). The projection is
 * conformal and most regular near the pole.
 *
 * Implementation note: the paper leaves open how a view chooses the pole and how the image is
 * turned. Here the pole is the point met first by a viewer looking along the line through the
 * centroid of the surface's area (or, should that line miss the surface, its farthest point that
 * way). The image stands upright for the viewer and is not mirrored, in the mean over a cap of an
 * eighth of FieldOfView around the pole.
 *
 * @sa
 * vtkCurvedSeamlessSurface vtkConformalSOM vtkTextureMapToSphere
 */

#ifndef vtkSphericalTextureMap_h
#define vtkSphericalTextureMap_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkSphericalTextureMap : public vtkPolyDataAlgorithm
{
public:
  static vtkSphericalTextureMap* New();
  vtkTypeMacro(vtkSphericalTextureMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Direction from the model to the viewer, in the coordinates of the model. Of any length, but not
   * zero. Default is (0, 0, 1).
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * Direction in the coordinates of the model that the viewer sees as up. Of any length, but not
   * zero, and not parallel to ViewDirection. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Degrees of the sphere from one side to the other of the circle inscribed in the image. 180 lays
   * that circle on the equator, so that the image covers a hemisphere and a little more in its
   * corners. In [0.001, 340]. Default is 180.
   */
  vtkSetClampMacro(FieldOfView, double, 0.001, 340.0);
  vtkGetMacro(FieldOfView, double);
  ///@}

protected:
  vtkSphericalTextureMap() = default;
  ~vtkSphericalTextureMap() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSphericalTextureMap(const vtkSphericalTextureMap&) = delete;
  void operator=(const vtkSphericalTextureMap&) = delete;

  double ViewDirection[3] = { 0.0, 0.0, 1.0 };
  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  double FieldOfView = 180.0;
};

#endif

/**
 * @class   vtkAdaptiveSphere
 * @brief   make a mesh of the sphere that is dense where a surface or a picture needs it
 *
 * Make a closed mesh of the unit sphere with a given number of points. Points are dense where a
 * surface that is mapped to the sphere needs them, and no angle is below 28 degrees. Connect the
 * mesh as the Sphere of a vtkCurvedSeamlessSurface to control where the surface gets its points.
 *
 * Input port 0: vtkPolyData, a surface with a map to the sphere. Polygons and strips are cut into
 * triangles.
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. The map must cover the sphere exactly once.
 * - a point or cell array of 1 component with the name DensityArrayName, with Density ARRAY.
 * - field data of vtkSphericalTextureMap (optional), with Density IMAGE: how the image is laid on
 *   the sphere. Without them the image is one of longitude and latitude, with its middle in
 *   direction (0, 0, 1) and its top edge towards (0, 1, 0).
 *
 * Input port 1 (optional): vtkImageData, one slice of point scalars with any number of components.
 * Density IMAGE needs it.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh of the unit sphere around the origin. It has
 * NumberOfPoints points within 2 percent; its triangles are counter-clockwise seen from outside. No
 * angle is below 28 degrees for any density. The same input gives the same bits on any number of
 * threads.
 * - point array "SpherePosition" (double, 3 components): the point itself, as a unit vector.
 *
 * On input port 1 of vtkCurvedSeamlessSurface, the mesh gives the directions in which a surface is
 * sampled. It is N^new of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on
 * curved seamless surface", Neurocomputing 71 (2008). The paper suggests dense vertices in an area
 * with fine texture. The mesh is independent of the triangles of the surface.
 *
 * Implementation note: Delaunay refinement after L. P. Chew, "Guaranteed-quality mesh generation
 * for curved surfaces", Symposium on Computational Geometry (1993). The triangle that is largest
 * relative to the wanted density is refined first, until the number is reached. A final smoothing
 * keeps the bound of the angles.
 *
 * @sa
 * vtkCurvedSeamlessSurface vtkGeodesicSphereSource vtkSphericalTextureMap
 */

#ifndef vtkAdaptiveSphere_h
#define vtkAdaptiveSphere_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for DensityArrayName

class vtkAlgorithmOutput;
class vtkImageData;

class VTKFILTERSCONFORMAL_EXPORT vtkAdaptiveSphere : public vtkPolyDataAlgorithm
{
public:
  static vtkAdaptiveSphere* New();
  vtkTypeMacro(vtkAdaptiveSphere, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Densities
  {
    AREA = 0,
    CURVATURE = 1,
    ARRAY = 2,
    IMAGE = 3
  };

  ///@{
  /**
   * Density of the points. AREA (default): uniform over the surface. CURVATURE: half of the points
   * in proportion to the curvature of the surface. ARRAY: in proportion to an array, as points per
   * area of the surface; only ratios matter. IMAGE: half of the points in proportion to the
   * gradient of the picture on input port 1.
   *
   * AREA is inversely proportional to the area scale of the map. CURVATURE and IMAGE distribute the
   * other half of the points uniformly over the surface. Curvature is measured by the sum of the
   * absolute principal curvatures. The gradient of the picture is taken with respect to the
   * direction on the sphere.
   */
  vtkSetClampMacro(Density, int, AREA, IMAGE);
  vtkGetMacro(Density, int);
  void SetDensityToArea() { this->SetDensity(AREA); }
  void SetDensityToCurvature() { this->SetDensity(CURVATURE); }
  void SetDensityToArray() { this->SetDensity(ARRAY); }
  void SetDensityToImage() { this->SetDensity(IMAGE); }
  ///@}

  ///@{
  /**
   * ARRAY: name of a point array, or else of a cell array, with 1 component. Values must be finite
   * and not negative, with at least one above 0. Where the value is 0 there are as few points as
   * the angles allow. Default is empty.
   */
  vtkSetMacro(DensityArrayName, std::string);
  vtkGetMacro(DensityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Number of points of the mesh, reached within 2 percent. In [500, 100000000]. Default is 64,002,
   * as many as a geodesic sphere of frequency 80.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  /**
   * The picture of Density IMAGE: one slice.
   */
  void SetImageConnection(vtkAlgorithmOutput* output);

  /**
   * Set the picture of Density IMAGE without a pipeline connection.
   */
  void SetImageData(vtkImageData* image);

protected:
  vtkAdaptiveSphere();
  ~vtkAdaptiveSphere() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAdaptiveSphere(const vtkAdaptiveSphere&) = delete;
  void operator=(const vtkAdaptiveSphere&) = delete;

  int Density = AREA;
  std::string DensityArrayName;
  int NumberOfPoints = 64002;
};

#endif

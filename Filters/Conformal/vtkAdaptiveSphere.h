/**
 * @class   vtkAdaptiveSphere
 * @brief   make a mesh of the sphere that is dense where a surface or a picture needs it
 *
 * Make a closed triangle mesh of the unit sphere with a given number of points. The density of the
 * points is defined by a surface that is mapped to the sphere, or by a picture, see Density. No
 * angle of a triangle is below 28 degrees. The filter vtkCurvedSeamlessSurface makes a smooth
 * surface. To control where that filter places the points of the surface, connect this mesh to the
 * input Sphere of that filter.
 *
 * Input port 0: vtkPolyData, a surface with a map to the sphere. Polygons and strips are cut into
 * triangles.
 * - point array "SpherePosition" (3 components, of any length but 0): position of the point on the
 *   sphere. The map must cover the sphere exactly once.
 * - point or cell array (1 component) whose name is the value of DensityArrayName; required if
 *   Density is ARRAY.
 * - field data of vtkSphericalTextureMap (optional), used if Density is IMAGE: placement of the
 *   picture on the sphere. Without these field data, the columns of the picture are longitudes, and
 *   its rows are latitudes. The middle of the picture is then in direction (0, 0, 1), and its top
 *   edge is towards (0, 1, 0).
 *
 * Input port 1 (optional): vtkImageData, the picture: one slice of point scalars with any number of
 * components. The picture is required if Density is IMAGE.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh of the unit sphere around the origin. The
 * number of points differs from NumberOfPoints by at most 2 percent. Triangles are
 * counter-clockwise seen from outside. No angle is below 28 degrees for any density. The output is
 * equal bit by bit for any number of threads.
 * - point array "SpherePosition" (double, 3 components): the point itself, as a unit vector.
 *
 * If this mesh is connected to input port 1 of vtkCurvedSeamlessSurface, its points are the
 * directions in which that filter samples a surface. C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), call a mesh for this
 * purpose N^new. They suggest dense vertices in an area with fine texture. The surface on input
 * port 0 affects this mesh only by the density.
 *
 * Implementation note: the mesh is made by the Delaunay refinement of L. P. Chew,
 * "Guaranteed-quality mesh generation for curved surfaces", Symposium on Computational Geometry
 * (1993). The density defines a required size of the triangles at each position. Each step divides
 * the triangle whose ratio of actual size to required size is largest. Refinement ends when the
 * number of points is reached. The final smoothing keeps all angles at 28 degrees or more.
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
   * Density of the points. AREA (default): uniform over the surface on input port 0. CURVATURE:
   * half of the points are distributed in proportion to the curvature of the surface. ARRAY: the
   * number of points per area of the surface is proportional to the array that DensityArrayName
   * names. IMAGE: half of the points are distributed in proportion to the gradient of the picture
   * on input port 1.
   *
   * With AREA, the density on the sphere is inversely proportional to the factor by which the map
   * from the surface to the sphere enlarges areas. CURVATURE and IMAGE distribute the other half of
   * the points uniformly over the surface. Curvature is the sum of the absolute principal
   * curvatures. The gradient of the picture is the change of its values per length on the sphere.
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
   * Name of the array of densities, with 1 component. Used only if Density is ARRAY. If there is no
   * point array of this name, the cell array of this name is used. Values must be finite and at
   * least 0, with at least one above 0. Where the value is 0, the mesh has only the points that are
   * needed to keep angles at 28 degrees or more. Default is empty.
   */
  vtkSetMacro(DensityArrayName, std::string);
  vtkGetMacro(DensityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Number of points of the mesh. The actual number differs by at most 2 percent. In [500,
   * 100000000]. Default is 64,002, the number of points of a geodesic sphere
   * (vtkGeodesicSphereSource) of frequency 80.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  /**
   * Set the picture for Density IMAGE: one slice of point scalars.
   */
  void SetImageConnection(vtkAlgorithmOutput* output);

  /**
   * Set the picture for Density IMAGE without a pipeline connection.
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

/**
 * @class   vtkAdaptiveSphere
 * @brief   make a mesh of the sphere that is dense where a surface or a picture needs it
 *
 * A closed mesh of the unit sphere with as many points as wanted, close to each other where a
 * surface that is mapped to the sphere needs them, with no angle below 28 degrees. As the Sphere
 * of a vtkCurvedSeamlessSurface it determines where the surface gets its points.
 *
 * Input port 0: vtkPolyData, a surface with a map to the sphere. Polygons and strips are cut into
 * triangles.
 * - point array "SpherePosition" (3 components, of any length but 0): where on the sphere the point
 *   lies. The map must cover the sphere exactly once.
 * - a point or cell array of 1 component named by DensityArrayName, with Density ARRAY.
 * - the field data of vtkSphericalTextureMap (optional), with Density IMAGE: how the image lies on
 *   the sphere. Without them it is one of longitude and latitude around the directions (0, 0, 1),
 *   its middle, and (0, 1, 0), its top edge.
 *
 * Input port 1 (optional): vtkImageData, one slice of point scalars with any number of components.
 * Needed by Density IMAGE.
 *
 * Output port 0: vtkPolyData, a closed triangle mesh of the unit sphere around the origin, of
 * NumberOfPoints points within 2 percent, triangles counter-clockwise seen from outside. No angle
 * is below 28 degrees, whatever the density. The same input gives the same bits on any number of
 * threads.
 * - point array "SpherePosition" (double, 3 components): the point itself, as a unit vector.
 *
 * On input port 1 of vtkCurvedSeamlessSurface it says where a surface is sampled: N^new of
 * C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless surface",
 * Neurocomputing 71 (2008), which suggests dense vertices in an area with fine texture. It needs no
 * relation to the triangles of the surface.
 *
 * Implementation note: Delaunay refinement after L. P. Chew, "Guaranteed-quality mesh generation
 * for curved surfaces", Symposium on Computational Geometry (1993), by the largest triangle for its
 * place first, until the number is reached; then smoothing that keeps the bound of the angles.
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
   * Where points are dense. AREA (default): evenly over the surface. CURVATURE: half of them by how
   * much the surface bends. ARRAY: by an array of points for an area of the surface, of which only
   * the ratios count. IMAGE: half of them by the change of the picture on input port 1.
   *
   * AREA is in inverse proportion to what the map leaves of the surface's area. CURVATURE and IMAGE
   * spread the other half evenly over the surface; what bends is measured by the sum of the
   * absolute principal curvatures, the picture's change is that with the direction.
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
   * ARRAY: name of a point array, or else of a cell array, of 1 component, finite and not negative,
   * not 0 everywhere. Where it is 0 there are as few points as the angles allow. Default is empty.
   */
  vtkSetMacro(DensityArrayName, std::string);
  vtkGetMacro(DensityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Number of points that the mesh is to have; it has them within 2 percent. In [500, 100000000].
   * Default is 64,002, as many as a geodesic sphere of frequency 80.
   */
  vtkSetClampMacro(NumberOfPoints, int, 500, 100000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  /**
   * The picture of Density IMAGE: one slice.
   */
  void SetImageConnection(vtkAlgorithmOutput* output);

  /**
   * The picture without a pipeline.
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

/**
 * @class   vtkCurvedSeamlessSurface
 * @brief   smooth closed surface over a mesh that is mapped to the sphere (CSS)
 *
 * Input port 0: vtkPolyData, a closed surface of genus zero, of a vtkConformalSOM or any other
 * origin. Polygons and strips are cut into triangles. Coincident points of open edges are merged,
 * triangles turned to agree with each other, isolated points dropped, each with one warning.
 * - point array "SpherePosition" (3 components, of any length but 0): where on the sphere the point
 *   lies. The map must cover the sphere just once.
 *
 * Input port 1 (optional): vtkPolyData, a dense mesh of the sphere. The surface is evaluated in the
 * directions of its points, taken from the point array "SpherePosition" (3 components) where there
 * is one and from the coordinates otherwise, and is given its triangles. Without it a geodesic
 * sphere of the Frequency below is used.
 *
 * Output port 0: vtkPolyData, the surface, in the coordinates of port 0 as doubles.
 * - point array "SpherePosition" (double, 3 components): unit vector of each point.
 * - point array "Normals" (double, 3 components): mean of the normals of the triangles around each
 *   point, weighted by area. A point of no triangle has the normal of the flat triangle it comes
 *   from, or if that is degenerate its SpherePosition.
 * - cell array "Degenerate" (unsigned char): 1 in triangles with a point that comes from a
 *   degenerate triangle of port 0.
 * - field array "NumberOfDegenerateTriangles" (vtkIdType): of the triangles of port 0, how many
 * have no shape in space or on the sphere, or a neighbor that faces the opposite way. The
 * construction is undefined there and replaced by an affine map, or by the triangle's own normal; a
 * warning tells.
 *
 * This is the CSS algorithm of Section 3 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal
 * self-organizing map on curved seamless surface", Neurocomputing 71 (2008), steps 1 to 11 with
 * Schwarz-Christoffel maps between the flat triangles (Eqs. 4 and 5) and the domes of the unit
 * sphere (Eq. 12).
 *
 * Implementation note: the heights of the domes are multiplied by the model's largest distance from
 * the mean of its points, so that the model may have any unit and place.
 *
 * @warning
 * As published, each point of the surface is found by itself and the mesh has no gaps, but the map
 * from the sphere slips along the edges of port 0 where neighboring triangles differ in shape.
 *
 * @sa
 * vtkConformalSOM vtkGeodesicSphereSource vtkGenusZeroCheck vtkSphericalTextureMap
 */

#ifndef vtkCurvedSeamlessSurface_h
#define vtkCurvedSeamlessSurface_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSCONFORMAL_EXPORT vtkCurvedSeamlessSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkCurvedSeamlessSurface* New();
  vtkTypeMacro(vtkCurvedSeamlessSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The dense mesh of the sphere, N^new in the paper: input port 1.
   */
  void SetSphereConnection(vtkAlgorithmOutput* output);

  /**
   * The dense mesh of the sphere without a pipeline.
   */
  void SetSphereData(vtkPolyData* sphere);

  ///@{
  /**
   * Frequency f of the geodesic sphere that is used where port 1 has no input: the surface has
   * 10 f^2 + 2 points and 20 f^2 triangles. In [1, 1000]. Default is 80, which gives 64,002 points.
   * In a multiple of the frequency of the mesh on port 0 no triangle lies across one of its edges.
   */
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

protected:
  vtkCurvedSeamlessSurface();
  ~vtkCurvedSeamlessSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCurvedSeamlessSurface(const vtkCurvedSeamlessSurface&) = delete;
  void operator=(const vtkCurvedSeamlessSurface&) = delete;

  int Frequency = 80;
};

#endif

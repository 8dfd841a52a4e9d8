/**
 * @class   vtkSurfaceNormalMap
 * @brief   compute a normal map, which shows the details of a surface on one of fewer triangles
 *
 * Compute a normal map for a surface of few triangles: an image with the normals of a detailed
 * surface. Programs that draw the surface use these normals for light, so that the surface looks
 * almost like the detailed one.
 *
 * Input port 0: vtkPolyData, the surface of few triangles, an output of vtkSphericalTextureMap:
 * with the point array "SpherePosition" (3 components), active texture coordinates, and the field
 * data of that filter. Set SplitSeam of that filter on, with a Projection of the whole sphere, such
 * as OCTAHEDRAL. Active point normals (3 components) are required.
 *
 * Input port 1: vtkPolyData, the detailed surface, such as an output of vtkCurvedSeamlessSurface
 * with more points. Polygons and strips are treated as triangles. Without active point normals, the
 * mean normals of the triangles are used.
 *
 * Output port 0: vtkImageData of ImageSize pixels. The coordinates of a pixel are the texture
 * coordinates (s, t) of its middle.
 * - active scalars "NormalMap" (unsigned char, 3 components): the normal (x, y, z) as 127.5 (x +
 * 1), 127.5 (y + 1), 127.5 (z + 1), rounded. x is along the tangent, towards increasing s; y is
 *   towards increasing t; z is along the normal of the surface. This is the convention of OpenGL
 *   and glTF. Where the map to the sphere has a hole: (128, 128, 255).
 *
 * Output port 1: vtkPolyData, the surface of input port 0, with the point array
 * - "Tangents" (float, 3 components), active: unit vectors perpendicular to the normals. They are
 *   those of the method MikkTSpace (M. S. Mikkelsen, "Simulation of wrinkled surfaces revisited",
 *   2008), so that the image also fits programs that compute the tangents themselves.
 *
 * To draw the surface in VTK, set the image as the normal texture of vtkProperty
 * (SetNormalTexture), with SetInterpolationToPBR. vtkTexturedSurfaceWriter writes both outputs as
 * glTF.
 *
 * Normal maps are introduced in J. Cohen, M. Olano, D. Manocha, "Appearance-preserving
 * simplification", SIGGRAPH (1998). Documentation/SphericalCoordinates.md compares pictures of
 * surfaces with and without normal maps.
 *
 * @sa
 * vtkSphericalTextureMap vtkSphericalTextureImage vtkTexturedSurfaceWriter vtkPolyDataTangents
 */

#ifndef vtkSurfaceNormalMap_h
#define vtkSurfaceNormalMap_h

#include "vtkFiltersShapeModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class vtkAlgorithmOutput;
class vtkPolyData;

class VTKFILTERSSHAPE_EXPORT vtkSurfaceNormalMap : public vtkImageAlgorithm
{
public:
  static vtkSurfaceNormalMap* New();
  vtkTypeMacro(vtkSurfaceNormalMap, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the detailed surface, whose normals the image shows.
   */
  void SetDetailConnection(vtkAlgorithmOutput* algOutput);
  void SetDetailData(vtkPolyData* detail);
  ///@}

  /**
   * Return the surface with its tangents: output port 1.
   */
  vtkPolyData* GetSurface();

  ///@{
  /**
   * Width and height of the image in pixels, at least (1, 1). For square pixels, set equal numbers.
   * The number of pixels must fit into an int. Default is (1024, 1024).
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

protected:
  vtkSurfaceNormalMap();
  ~vtkSurfaceNormalMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSurfaceNormalMap(const vtkSurfaceNormalMap&) = delete;
  void operator=(const vtkSurfaceNormalMap&) = delete;

  int ImageSize[2] = { 1024, 1024 };
};

#endif

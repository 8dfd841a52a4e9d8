/**
 * @class   vtkSphericalTextureImage
 * @brief   bake colors or arrays of a surface into an image of the sphere
 *
 * Make an image that, seen through the texture coordinates of vtkSphericalTextureMap, looks like
 * the surface: save it as PNG and load it as a Texture. Its point array OutsideSurface is 1
 * where the map to the sphere has a hole.
 *
 * Input port 0: vtkPolyData, an output of vtkSphericalTextureMap, whose field data say how the
 * image lies on the sphere, with the point array "SpherePosition" (3 components). Seams may be
 * split or not. Polygons and strips are treated as triangles.
 *
 * Input port 1, optional: vtkPointSet, what the values are taken from instead: where it is a
 * vtkPolyData with triangles, from the point of these closest to the point of the surface, else
 * from the closest point. So an image can hold all the colors of a scan whose mesh was learned
 * with far fewer points.
 *
 * Output port 0: vtkImageData of ImageSize pixels. The coordinates of a pixel are the (s, t) of its
 * middle.
 * - point array of the same name, type and components as the one baked, the active scalars; whole
 *   numbers are rounded.
 * - point array "OutsideSurface" (unsigned char, 1 component): 1 where the map to the sphere has a
 *   hole; values are 0 there.
 *
 * Of several processes (Controller) each has its own points of the source, perhaps none, and the
 * first that has a surface has all of it. Each gets the whole image, whose pixels have the values
 * of the closest of all points, to the bit whatever the number of processes. A cloud stays where it
 * is, triangles are gathered on each process. Without a source each process bakes its own surface.
 *
 * Seen through the texture coordinates of vtkSphericalTextureMap the image is the surface's own
 * look. At the seams it is padded as wide as TextureMargin of vtkSphericalTextureMap allows, with
 * what the sphere has beyond them.
 *
 * The inverse of the texture mapping of section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang,
 * "Conformal self-organizing map on curved seamless surface", Neurocomputing 71 (2008).
 *
 * Implementation note: a pixel shows the point of the surface whose place on the sphere lies in the
 * direction of the pixel's middle. Where many vertices share a pixel the image has no room for
 * them.
 *
 * @sa
 * vtkSphericalTextureMap vtkTexturedSurfaceWriter
 */

#ifndef vtkSphericalTextureImage_h
#define vtkSphericalTextureImage_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for ArrayName

class vtkAlgorithmOutput;
class vtkMultiProcessController;
class vtkPointSet;

class VTKFILTERSCONFORMAL_EXPORT vtkSphericalTextureImage : public vtkImageAlgorithm
{
public:
  static vtkSphericalTextureImage* New();
  vtkTypeMacro(vtkSphericalTextureImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What the values are taken from instead, at the closest point: for example the colored scan that
   * the surface was learned from. Without it they are those of the surface.
   */
  void SetSourceConnection(vtkAlgorithmOutput* algOutput);
  void SetSourceData(vtkPointSet* source);
  ///@}

  ///@{
  /**
   * The processes that share the source. Each runs this filter and asks its inputs for its own
   * piece. Default is the global controller; null for a source of this process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Point array to bake. Empty (default) for the active scalars, such as the colors of a scan.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Pixels across and up. Square pixels on the sphere's equator come of 2 : 1 for
   * LONGITUDE_LATITUDE, 3 : 2 for CUBE_MAP, whose faces then are squares, and 1 : 1 else. At least
   * (1, 1), no more pixels than an int counts. Default is (1024, 1024).
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

protected:
  vtkSphericalTextureImage();
  ~vtkSphericalTextureImage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSphericalTextureImage(const vtkSphericalTextureImage&) = delete;
  void operator=(const vtkSphericalTextureImage&) = delete;

  std::string ArrayName;
  int ImageSize[2] = { 1024, 1024 };
  vtkMultiProcessController* Controller = nullptr;
};

#endif

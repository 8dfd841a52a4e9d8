/**
 * @class   vtkSphericalTextureImage
 * @brief   bake colors or other point data of a surface into an image of the sphere
 *
 * Make an image from the colors or another point array of a surface. With the texture coordinates
 * that vtkSphericalTextureMap computes, this image is a texture that shows the values on the
 * surface. Save the image as PNG, and load it as a Texture. The point array OutsideSurface of the
 * image is 1 where the map to the sphere has a hole.
 *
 * Input port 0: vtkPolyData, an output of vtkSphericalTextureMap with the point array
 * "SpherePosition" (3 components). Its field data define the placement of the image on the sphere.
 * The surface may be cut along seams (SplitSeam). Polygons and strips are treated as triangles.
 *
 * Input port 1, optional: vtkPointSet, the source of the values. Without this input, the values are
 * those of the surface. Each pixel shows a point of the surface. The pixel gets the value of the
 * source at the position closest to this point. If the source is a vtkPolyData with triangles, this
 * is a position on the triangles, otherwise one of the points. The image can thus show all colors
 * of a scan on a mesh with far fewer points.
 *
 * Output port 0: vtkImageData of ImageSize pixels. The coordinates of a pixel are the texture
 * coordinates (s, t) of its middle.
 * - active scalars: the baked point array, with the same name, type and number of components.
 *   Integers are rounded.
 * - point array "OutsideSurface" (unsigned char, 1 component): 1 where the map to the sphere has a
 *   hole, otherwise 0. In holes, the baked values are 0.
 *
 * With several processes (Controller), each process has a piece of the source, which may be empty.
 * The surface is that of the first process with a surface. This process must have the whole
 * surface. Each process gets the whole image. The image is equal bit by bit for any number of
 * processes. The points of a source without triangles remain on their process; triangles of a
 * source are gathered on each process. Without a source, each process bakes its local surface.
 *
 * At each seam, the image is padded with the values from the other side of the seam. The width of
 * the padding is the Margin of vtkSphericalTextureMap.
 *
 * The filter inverts the texture mapping of section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang,
 * "Conformal self-organizing map on curved seamless surface", Neurocomputing 71 (2008).
 *
 * Implementation note: a pixel shows the point of the surface whose position on the sphere is in
 * the direction of the pixel's middle. If many vertices fall into one pixel, the image undersamples
 * the surface.
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
   * Set the source of the values, such as the colored scan from which the surface was learned. Each
   * pixel shows a point of the surface, and gets the value of the source at the position closest to
   * this point. Without this input, the values are those of the surface.
   */
  void SetSourceConnection(vtkAlgorithmOutput* algOutput);
  void SetSourceData(vtkPointSet* source);
  ///@}

  ///@{
  /**
   * Controller of the processes that share the source. Each process runs this filter on its own
   * piece of the source. Default is the global controller. With null, only the source on this
   * process is used.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Name of the point array to bake. Empty (default) selects the active scalars, such as the colors
   * of a scan.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels. For square pixels on the sphere's equator, choose a
   * ratio of 2 : 1 for LONGITUDE_LATITUDE, 3 : 2 for CUBE_MAP (square faces), and 1 : 1 for other
   * projections. At least (1, 1). The number of pixels must fit into an int. Default is (1024,
   * 1024).
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

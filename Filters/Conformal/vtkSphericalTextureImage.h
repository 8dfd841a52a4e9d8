/**
 * @class   vtkSphericalTextureImage
 * @brief   bake colors or arrays of a surface into an image of the sphere
 *
 * Make an image that looks like the surface when applied with the texture coordinates of
 * vtkSphericalTextureMap. Save it as PNG and load it as a Texture. Its point array OutsideSurface
 * is 1 where the map to the sphere has a hole.
 *
 * Input port 0: vtkPolyData, an output of vtkSphericalTextureMap with the point array
 * "SpherePosition" (3 components). Its field data define how the image is laid on the sphere. Seams
 * may be split. Polygons and strips are treated as triangles.
 *
 * Input port 1, optional: vtkPointSet, a source of the values in place of the surface. From a
 * vtkPolyData with triangles, the value at the closest point of its triangles is used, otherwise
 * that of the closest point. An image can thus hold all colors of a scan whose mesh was learned
 * with far fewer points.
 *
 * Output port 0: vtkImageData of ImageSize pixels. The coordinates of a pixel are the (s, t) of its
 * middle.
 * - the baked point array, as active scalars with the same name, type and components. Integers are
 *   rounded.
 * - point array "OutsideSurface" (unsigned char, 1 component): 1 where the map to the sphere has a
 *   hole; values are 0 there.
 *
 * With several processes (Controller), each has its own points of the source, perhaps none. The
 * first process that has a surface must have all of it. Each process gets the whole image. A pixel
 * has the value of the closest of all points, with the same bits on any number of processes. Points
 * of a cloud are not moved between processes; triangles are gathered on each process. Without a
 * source, each process bakes its own surface.
 *
 * At the seams the image is padded with values from beyond them, as wide as TextureMargin of
 * vtkSphericalTextureMap allows.
 *
 * The image inverts the texture mapping of section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang,
 * "Conformal self-organizing map on curved seamless surface", Neurocomputing 71 (2008).
 *
 * Implementation note: a pixel shows the point of the surface whose position on the sphere lies in
 * the direction of the pixel's middle. Where many vertices share a pixel, the image undersamples
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
   * Source of the values, sampled at the closest point, such as the colored scan from which the
   * surface was learned. Without it the surface is the source.
   */
  void SetSourceConnection(vtkAlgorithmOutput* algOutput);
  void SetSourceData(vtkPointSet* source);
  ///@}

  ///@{
  /**
   * Controller of the processes that share the source. Each process runs this filter on its own
   * piece. Default is the global controller; null uses the source of this process alone.
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
   * ratio of 2 : 1 for LONGITUDE_LATITUDE, 3 : 2 for CUBE_MAP (square faces), and 1 : 1 otherwise.
   * At least (1, 1); the number of pixels must fit into an int. Default is (1024, 1024).
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

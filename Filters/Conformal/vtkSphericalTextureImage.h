/**
 * @class   vtkSphericalTextureImage
 * @brief   bake colors or other point data of a surface into an image of the sphere
 *
 * Make an image from the colors or another point array of a surface. The filter
 * vtkSphericalTextureMap computes texture coordinates of the surface. With these texture
 * coordinates, the image is a texture that shows the values on the surface. Save the image as PNG,
 * and load it as a Texture. The point array OutsideSurface of the image is 1 where the map to the
 * sphere has a hole: no triangle of the surface is mapped there.
 *
 * Input port 0: vtkPolyData, an output of vtkSphericalTextureMap with the point array
 * "SpherePosition" (3 components). The field data of that filter define the placement of the image
 * on the sphere. The surface can be cut along seams, by the property SplitSeam of that filter.
 * Polygons and strips are treated as triangles.
 *
 * Input port 1, optional: vtkPointSet, the source of the values. Without this input, the values are
 * those of the surface. Each pixel shows a point of the surface. By default, the pixel gets the
 * value of the source at the position closest to this point; see Sampling. If the source is a
 * vtkPolyData with triangles, this position is on the triangles. Otherwise, it is one of the
 * source's points. The image can thus show all colors of a scan, even if the mesh has far fewer
 * points than the scan.
 *
 * Output port 0: vtkImageData of ImageSize pixels. The coordinates of a pixel are the texture
 * coordinates (s, t) of its middle.
 * - active scalars: the baked point array, with the same name, type and number of components.
 *   Integers of 1 component are labels, unless Sampling is AVERAGE: a pixel has the label of the
 *   nearest corner of its triangle. Other integers, such as colors, are rounded.
 * - point array "OutsideSurface" (unsigned char, 1 component): 1 where the map to the sphere has a
 *   hole, otherwise 0. In holes, the baked values are 0.
 *
 * With several processes (Controller), each process has a piece of the source, which may be empty.
 * If several processes have a surface, the surface of the first process is used. This process must
 * have the whole surface. Each process gets the whole image. The image is equal bit by bit for any
 * number of processes. If the source has no triangles, its points remain on their process.
 * Otherwise, its triangles are copied to all processes. Without a source, each process bakes its
 * local surface.
 *
 * At each seam, the image has a margin with the values from the other side of the seam. The
 * property Margin of vtkSphericalTextureMap is the width of this margin.
 *
 * The filter inverts the texture mapping of section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang,
 * "Conformal self-organizing map on curved seamless surface", Neurocomputing 71 (2008).
 *
 * Implementation note: a pixel shows the point of the surface whose position on the sphere is in
 * the direction of the pixel's middle. If many vertices are mapped into one pixel, the image loses
 * details of the surface.
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

  /**
   * Methods to compute the value of a pixel.
   */
  enum Samplings
  {
    CLOSEST = 0,
    AVERAGE = 1
  };

  ///@{
  /**
   * Method to compute the value of a pixel. CLOSEST (default): the value of the source at the
   * position closest to the point that the middle of the pixel shows. Values of points without
   * triangles, such as labels, are not mixed. AVERAGE: the mean of the source's values in the part
   * of the surface that the pixel shows, with weights that decrease smoothly from the middle. Where
   * the source has few points, the mean includes points beyond the pixel, so that gaps are filled
   * smoothly. Without triangles, the mean is that of at most 64 points, the nearest to the middle.
   * Use AVERAGE for colors and measurements.
   *
   * With AVERAGE and several processes, the source is copied to all processes.
   */
  vtkSetClampMacro(Sampling, int, CLOSEST, AVERAGE);
  vtkGetMacro(Sampling, int);
  void SetSamplingToClosest() { this->SetSampling(CLOSEST); }
  void SetSamplingToAverage() { this->SetSampling(AVERAGE); }
  ///@}

  /**
   * Update the inputs, and set ImageSize to the size at which the image shows the details of the
   * source. For 95 percent of the source's points, the image has at least pixelsPerPoint pixels for
   * each point. Without a source, the points of the surface are used. The height is a multiple of
   * 64 in [64, 4096]. The density of the points is that on this process. An error is reported if
   * the inputs are unsuitable; ImageSize does not change then.
   */
  void FitImageSize(double pixelsPerPoint = 4.0);

  ///@{
  /**
   * Width and height of the image in pixels. For square pixels, choose the ratio of width to height
   * by the Projection of vtkSphericalTextureMap. The ratio is 2 : 1 for LONGITUDE_LATITUDE, 3 : 2
   * for CUBE_MAP, and 1 : 1 for other projections. At least (1, 1). The number of pixels must fit
   * into an int. Default is (1024, 1024).
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
  int Sampling = CLOSEST;
  int ImageSize[2] = { 1024, 1024 };
  vtkMultiProcessController* Controller = nullptr;
};

#endif

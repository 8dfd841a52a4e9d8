/**
 * @class   vtkSphericalTextureBlend
 * @brief   blend a picture of the front and one of the back into an image of the sphere
 *
 * Blend two pictures of an object into one image of the sphere. The image is a texture for the
 * texture coordinates that vtkSphericalTextureMap computes. Set the Projection of that filter to
 * one that covers the whole sphere: LONGITUDE_LATITUDE, OCTAHEDRAL or CUBE_MAP. The middle of the
 * front picture is on the side of the surface that faces the ViewDirection of that filter. The
 * pictures fade into each other in a band around the equator between front and back.
 *
 * Input port 0: vtkPolyData, an output of vtkSphericalTextureMap with the point array
 * "SpherePosition" (3 components). The field data of that filter define the placement of the image
 * on the sphere.
 *
 * Input port 1: vtkImageData, the front picture: one slice, scalars of any type and number of
 * components. The middle of the picture is at the direction "SpherePole" in the surface's field
 * data. The top of the picture is towards "SphereUp".
 *
 * Input port 2: vtkImageData, the back picture: one slice, with the same number of components as
 * the front picture.
 *
 * Output port 0: vtkImageData of ImageSize pixels. The coordinates of a pixel are the texture
 * coordinates (s, t) of its middle.
 * - active scalars: the blended pixels, with the name, type and number of components of the front
 *   picture. Integers are rounded.
 *
 * Each picture is mapped to its side of the surface by stereographic projection, section 4.2 of
 * C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on curved seamless surface",
 * Neurocomputing 71 (2008). The pole of a picture is the point of the sphere at its middle. The
 * pictures fade into each other around a curve, whose points have equal distances from both poles.
 * If the poles are opposite, this curve is the equator between them.
 *
 * Implementation note: the paper uses one picture. Here a second picture covers the part of the
 * sphere that the first picture does not show, and the border between the pictures.
 *
 * @sa
 * vtkSphericalTextureMap vtkSphericalTextureImage
 */

#ifndef vtkSphericalTextureBlend_h
#define vtkSphericalTextureBlend_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class vtkAlgorithmOutput;
class vtkImageData;

class VTKFILTERSCONFORMAL_EXPORT vtkSphericalTextureBlend : public vtkImageAlgorithm
{
public:
  static vtkSphericalTextureBlend* New();
  vtkTypeMacro(vtkSphericalTextureBlend, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the pictures of the front and of the back: one slice each, with equal numbers of
   * components.
   */
  void SetFrontConnection(vtkAlgorithmOutput* algOutput);
  void SetFrontData(vtkImageData* front);
  void SetBackConnection(vtkAlgorithmOutput* algOutput);
  void SetBackData(vtkImageData* back);
  ///@}

  ///@{
  /**
   * Direction from the model to the viewer of the back picture, in the coordinates of the model.
   * The vector may have any length but 0. Default is (0, 0, -1).
   */
  vtkSetVector3Macro(BackViewDirection, double);
  vtkGetVector3Macro(BackViewDirection, double);
  ///@}

  ///@{
  /**
   * Direction that is up in the back picture, in the coordinates of the model. The vector may have
   * any length but 0, and must not be parallel to BackViewDirection. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(BackViewUp, double);
  vtkGetVector3Macro(BackViewUp, double);
  ///@}

  ///@{
  /**
   * Angle on the sphere, in degrees, that the inscribed circle of each picture covers. If this
   * angle is at least 180 plus BlendAngle, each picture covers the whole band in which the pictures
   * fade into each other. In [0.001, 340]. Default is 210.
   */
  vtkSetClampMacro(FieldOfView, double, 0.001, 340.0);
  vtkGetMacro(FieldOfView, double);
  ///@}

  ///@{
  /**
   * Width of the band in which the pictures fade into each other, as an angle on the sphere, in
   * degrees. In [0, 180]. Default is 30.
   */
  vtkSetClampMacro(BlendAngle, double, 0.0, 180.0);
  vtkGetMacro(BlendAngle, double);
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels. At least (1, 1); the number of pixels must fit into an
   * int. Default is (1024, 1024).
   */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

protected:
  vtkSphericalTextureBlend();
  ~vtkSphericalTextureBlend() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSphericalTextureBlend(const vtkSphericalTextureBlend&) = delete;
  void operator=(const vtkSphericalTextureBlend&) = delete;

  double BackViewDirection[3] = { 0.0, 0.0, -1.0 };
  double BackViewUp[3] = { 0.0, 1.0, 0.0 };
  double FieldOfView = 210.0;
  double BlendAngle = 30.0;
  int ImageSize[2] = { 1024, 1024 };
};

#endif

/**
 * @class   vtkSphericalTextureBlend
 * @brief   blend a picture of the front and one of the back into an image of the sphere
 *
 * Make one image of two pictures, for the texture coordinates of vtkSphericalTextureMap in a
 * projection that holds all of the sphere (any but STEREOGRAPHIC). The front picture lies where
 * that filter's view meets the surface; over the equator between front and back the one fades
 * into the other.
 *
 * Input port 0: vtkPolyData, an output of vtkSphericalTextureMap, whose field data say how the
 * image lies on the sphere, with the point array "SpherePosition" (3 components).
 *
 * Input port 1: vtkImageData, the front picture: one slice, scalars of any type and number of
 * components. Its middle lies at the surface's "SpherePole", its top towards "SphereUp".
 *
 * Input port 2: vtkImageData, the back picture, with as many components.
 *
 * Output port 0: vtkImageData of ImageSize pixels. The coordinates of a pixel are the (s, t) of its
 * middle.
 * - the blended pixels, of the front picture's name, type and components, as active scalars; whole
 *   numbers are rounded.
 *
 * Seen through the surface's texture coordinates, which should hold all of the sphere (any
 * projection but STEREOGRAPHIC), each picture is laid on its side of the surface by stereographic
 * projection, section 4.2 of C.-Y. Liou, Y.-T. Kuo, J.-C. Huang, "Conformal self-organizing map on
 * curved seamless surface", Neurocomputing 71 (2008). Over the equator between the two poles the
 * one fades into the other.
 *
 * Implementation note: the paper has one picture. Its border, and all behind it, is left to the
 * other picture here.
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
   * The pictures of the front and of the back: one slice each, with equally many components.
   */
  void SetFrontConnection(vtkAlgorithmOutput* algOutput);
  void SetFrontData(vtkImageData* front);
  void SetBackConnection(vtkAlgorithmOutput* algOutput);
  void SetBackData(vtkImageData* back);
  ///@}

  ///@{
  /**
   * Direction from the model to the viewer of the back picture, in the coordinates of the model. Of
   * any length, but not zero. Default is (0, 0, -1).
   */
  vtkSetVector3Macro(BackViewDirection, double);
  vtkGetVector3Macro(BackViewDirection, double);
  ///@}

  ///@{
  /**
   * Direction that is up for the viewer of the back picture. Of any length, but not zero, and not
   * parallel to BackViewDirection. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(BackViewUp, double);
  vtkGetVector3Macro(BackViewUp, double);
  ///@}

  ///@{
  /**
   * Degrees of the sphere across the circle inscribed in each picture. 180 plus BlendAngle just
   * covers what is to be blended. In [0.001, 340]. Default is 210.
   */
  vtkSetClampMacro(FieldOfView, double, 0.001, 340.0);
  vtkGetMacro(FieldOfView, double);
  ///@}

  ///@{
  /**
   * Degrees of the sphere over which the pictures fade into each other. In [0, 180]. Default is 30.
   */
  vtkSetClampMacro(BlendAngle, double, 0.0, 180.0);
  vtkGetMacro(BlendAngle, double);
  ///@}

  ///@{
  /**
   * Pixels across and up. At least (1, 1), no more pixels than an int counts. Default is (1024,
   * 1024).
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

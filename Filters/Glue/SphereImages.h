// Images of the sphere: store the parameters of the projection in field data, and read and write
// pixels.
#ifndef GlueSphereImages_h
#define GlueSphereImages_h

#include "Texture/PictureDensity.h"        // for Picture
#include "Texture/SphereProjection.h"      // for SphereImage
#include "Texture/SphericalTextureImage.h" // for PixelSink

#include "vtkNew.h" // for marks

#include <string> // for the name of an array

class vtkDataArray;
class vtkFieldData;
class vtkImageData;
class vtkInformation;
class vtkPointSet;
class vtkUnsignedCharArray;

namespace glue
{
/// Add the parameters of an image's projection as field data: "SpherePole", "SphereUp",
/// "SphereRight", "TextureProjection", "TextureFieldOfView", "TextureScale" and "TextureMargin".
void AddSphereImage(vtkFieldData* data, const conformal::SphereImage& image);

/// Read the parameters of an image's projection from field data.
/// @throws std::invalid_argument if an array of AddSphereImage() is missing or invalid
conformal::SphereImage ToSphereImage(vtkFieldData* data);

/// Set the extent, origin and spacing of an image in the pipeline information. The position of each
/// pixel is the texture coordinate (s, t) of its center.
/// @throws std::invalid_argument if the image has no pixels, or more than an int can count
void SetImageInformation(vtkInformation* info, const int size[2]);

/// Set the extent, origin and spacing of an image in the pipeline information. The pixels fill a
/// rectangle with lower left corner (x, y).
void SetImageInformation(
  vtkInformation* info, const int size[2], double x, double y, double width, double height);

/// Allocate an image by the pipeline information of SetImageInformation(). Its pixels get the name,
/// type and number of components of the array `like`.
vtkDataArray* AllocatePixels(vtkImageData* image, vtkInformation* info, vtkDataArray* like);

/// Copy the pixels of an image that has one slice.
/// @param[in] pixels  point array of the image
conformal::Picture ToPicture(vtkImageData* image, vtkDataArray* pixels);

/// Allocate the array "OutsideSurface" for an image, with one mark for each pixel. PixelPainter()
/// sets the marks.
vtkNew<vtkUnsignedCharArray> MakeHoles(vtkImageData* image);

/// Return whether values written to an array must be rounded to integers.
bool HoldsWholeNumbers(vtkDataArray* array);

/// Return a point array by its name, or the active scalars if the name is empty.
/// @throws std::invalid_argument if the array does not exist
vtkDataArray* ArrayToBake(vtkPointSet* data, const std::string& name);

/// Return a function that writes the interpolated value of each pixel to `pixels`. Where a pixel
/// shows no surface, it writes 0 and sets the mark in `holes`. All three arrays must outlive the
/// function.
conformal::PixelSink PixelPainter(
  vtkDataArray* values, vtkDataArray* pixels, vtkUnsignedCharArray* holes);
}

#endif

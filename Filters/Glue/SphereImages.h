// Images of the sphere: their projections as field data of a surface, and their pixels.
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
/// Add the projection of an image as field data: "SpherePole", "SphereUp", "SphereRight",
/// "TextureProjection", "TextureFieldOfView", "TextureScale" and "TextureMargin".
void AddSphereImage(vtkFieldData* data, const conformal::SphereImage& image);

/// Read the projection of an image from field data.
/// @throws std::invalid_argument if an array of AddSphereImage() is missing or invalid
conformal::SphereImage ToSphereImage(vtkFieldData* data);

/// Announce an image whose pixel coordinates are the (s, t) of the pixel centers.
/// @throws std::invalid_argument if it has no pixels, or more than an int can count
void SetImageInformation(vtkInformation* info, const int size[2]);

/// Announce an image whose pixels fill a rectangle with its lower left corner at (x, y).
void SetImageInformation(
  vtkInformation* info, const int size[2], double x, double y, double width, double height);

/// Allocate the pixels of an announced image, with the name, type and components of an array.
vtkDataArray* AllocatePixels(vtkImageData* image, vtkInformation* info, vtkDataArray* like);

/// Copy the pixels of an image of one slice.
/// @param[in] pixels  point array of the image
conformal::Picture ToPicture(vtkImageData* image, vtkDataArray* pixels);

/// Make the array "OutsideSurface" of an image, a mark for each pixel that shows no surface.
vtkNew<vtkUnsignedCharArray> MakeHoles(vtkImageData* image);

/// Return whether values of an array must be rounded to integers.
bool HoldsWholeNumbers(vtkDataArray* array);

/// Return a point array by its name, or the active scalars if the name is empty.
/// @throws std::invalid_argument if the array does not exist
vtkDataArray* ArrayToBake(vtkPointSet* data, const std::string& name);

/// Return a sink that writes the values shown by pixels, or 0 and a mark for pixels without
/// surface. All three arrays must outlive it.
conformal::PixelSink PixelPainter(
  vtkDataArray* values, vtkDataArray* pixels, vtkUnsignedCharArray* holes);
}

#endif

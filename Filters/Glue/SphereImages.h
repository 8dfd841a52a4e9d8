// Images of the sphere: how they lie there, as field data of a surface, and their pixels.
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
/// "SpherePole", "SphereUp", "SphereRight", "TextureProjection", "TextureFieldOfView",
/// "TextureScale" and "TextureMargin".
void AddSphereImage(vtkFieldData* data, const conformal::SphereImage& image);

/// The same read back.
/// @throws std::invalid_argument if one of them is missing or not as AddSphereImage writes it
conformal::SphereImage ToSphereImage(vtkFieldData* data);

/// Announce an image whose pixels' coordinates are the (s, t) of their middles.
/// @throws std::invalid_argument if it has no pixels, or more than an int counts
void SetImageInformation(vtkInformation* info, const int size[2]);

/// The same for pixels that fill a rectangle with its lower left corner at (x, y).
void SetImageInformation(
  vtkInformation* info, const int size[2], double x, double y, double width, double height);

/// Give the image as announced pixels of the name, type and components of an array.
vtkDataArray* AllocatePixels(vtkImageData* image, vtkInformation* info, vtkDataArray* like);

/// Copy the pixels of an image of one slice.
/// @param[in] pixels  point array of the image
conformal::Picture ToPicture(vtkImageData* image, vtkDataArray* pixels);

/// Make the array "OutsideSurface" of an image, a mark for each pixel that shows no surface.
vtkNew<vtkUnsignedCharArray> MakeHoles(vtkImageData* image);

/// Whether values have to be rounded.
bool HoldsWholeNumbers(vtkDataArray* array);

/// A point array by its name, or the active scalars if that is empty.
/// @throws std::invalid_argument if there is none
vtkDataArray* ArrayToBake(vtkPointSet* data, const std::string& name);

/// Writes the values of the places that pixels show, or 0 and a mark where they show none. All
/// three must outlive it.
conformal::PixelSink PixelPainter(
  vtkDataArray* values, vtkDataArray* pixels, vtkUnsignedCharArray* holes);
}

#endif

// Read and write images of the sphere. A surface is mapped to the sphere. Each pixel belongs to one
// point of the sphere, and shows the surface point that is mapped there. The parameters of the
// projection from the sphere to the image are stored in field data.
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
class vtkPolyData;
class vtkUnsignedCharArray;

namespace glue
{
/// Add the parameters of an image's projection as field data: "SpherePole", "SphereUp",
/// "SphereRight", "TextureProjection", "TextureFieldOfView", "TextureScale" and "TextureMargin".
void AddSphereImage(vtkFieldData* data, const conformal::SphereImage& image);

/// Read the parameters of an image's projection from field data that AddSphereImage() wrote.
/// @throws std::invalid_argument if an array is missing or invalid
conformal::SphereImage ToSphereImage(vtkFieldData* data);

/// Name of the point array of the sphere positions by which vtkSphericalTextureMap places a
/// picture, if they differ from "SpherePosition".
inline const char* TexturePositionName()
{
  return "TexturePosition";
}

/// Name of the field data with the AreaBalance by which the array "TexturePosition" was computed.
inline const char* TextureAreaBalanceName()
{
  return "TextureAreaBalance";
}

/// Test whether the point array of this name holds places on a map of the surface, or ids of points
/// or cells, which cannot be averaged. Arrays are "SpherePosition" and those that are computed from
/// a map by vtkSphericalTextureMap, vtkGlobalConformalMap, vtkBodyMap, vtkSphericalRegistration and
/// vtkGenusZeroRepair.
bool HoldsPlaces(const std::string& name);

/// Set "SpherePosition" of a surface to another map. Arrays that were computed from the earlier map
/// are removed: places of pictures, longitudes and latitudes, and corresponding points of another
/// surface. Texture coordinates are preserved, since a picture stays where it is on the surface.
/// Distortions are preserved, too, since a rotation of the map does not change them. For a Moebius
/// transform, call RemoveAreaDistortions(), and for other changes RemoveDistortions().
void ReplaceSpherePositions(vtkPolyData* surface, const conformal::Points& positions);

/// Remove the distortions of an earlier map: cell arrays and field data of vtkConformalDistortion,
/// and field data of vtkConformalSOM and vtkGlobalConformalMap.
void RemoveDistortions(vtkPolyData* surface);

/// Remove the distortions of area of an earlier map. Those of angles are preserved.
void RemoveAreaDistortions(vtkPolyData* surface);

/// Return the sphere positions by which a picture is placed on a surface: a copy of the point array
/// "TexturePosition", or, without this array, of "SpherePosition". The copied vectors are
/// normalized to unit length.
/// @throws std::invalid_argument if the array is missing or does not have 3 components, or if a
///   vector is zero or not finite
conformal::Points ToTexturePositions(vtkPolyData* surface);

/// Set the extent, origin and spacing of an image in the pipeline information. The image fills the
/// unit square. The center of each pixel is at its texture coordinates (s, t).
/// @param[in] size  width and height in pixels
/// @throws std::invalid_argument if the image has no pixels, or more than 2147483647
void SetImageInformation(vtkInformation* info, const int size[2]);

/// Set the extent, origin and spacing of an image in the pipeline information. The pixels fill a
/// rectangle with lower left corner (x, y), and the given width and height.
/// @param[in] size  width and height in pixels
/// @throws std::invalid_argument if the image has no pixels, or more than 2147483647
void SetImageInformation(
  vtkInformation* info, const int size[2], double x, double y, double width, double height);

/// Allocate an image with the extent, origin and spacing of the pipeline information
/// (SetImageInformation()). The pixels get the name, type and number of components of the array
/// `like`.
/// @return the array of pixels
vtkDataArray* AllocatePixels(vtkImageData* image, vtkInformation* info, vtkDataArray* like);

/// Copy the pixels of an image with a single slice.
/// @param[in] pixels  point array of the image: the pixels to copy
conformal::Picture ToPicture(vtkImageData* image, vtkDataArray* pixels);

/// Allocate the array "OutsideSurface" of an image: one mark for each pixel. A mark is 1 if the
/// pixel shows no point of the surface, else 0. The marks are set by the function that
/// PixelPainter() returns.
vtkNew<vtkUnsignedCharArray> MakeHoles(vtkImageData* image);

/// Return whether an array contains integers. If so, values must be rounded before they are written
/// to the array.
bool HoldsWholeNumbers(vtkDataArray* array);

/// Test whether the point array of this name holds longitudes of vtkBodyMap, in [0, 360).
bool HoldsLongitudes(const std::string& name);

/// Return whether an array contains labels: integers, with 1 component. Means of labels have no
/// meaning.
bool HoldsLabels(vtkDataArray* array);

/// Return the point array with the given name. If the name is empty, return the active scalars.
/// @throws std::invalid_argument if the array does not exist
vtkDataArray* ArrayToBake(vtkPointSet* data, const std::string& name);

/// Return a function that writes pixels of an image. For each pixel, the function interpolates
/// `values` at the surface point that the pixel shows. A label (HoldsLabels()) is that of the
/// nearest corner of the triangle. Longitudes (HoldsLongitudes()) are interpolated across 0. The
/// result is written to `pixels`. If the
/// pixel shows no surface point, the function writes 0 to `pixels`, and 1 to `holes`. The three
/// arrays must outlive the function.
conformal::PixelSink PixelPainter(
  vtkDataArray* values, vtkDataArray* pixels, vtkUnsignedCharArray* holes);
}

#endif

// Write what plane maps of a surface need besides their pixels.
#ifndef GlueMapImages_h
#define GlueMapImages_h

#include "Body/MapImage.h" // for MapImage

#include <vector> // for areas

class vtkImageData;

namespace glue
{
/// Check the properties ImageSize and CentralLongitude of a map.
/// @throws std::invalid_argument if the image has no pixels, or the longitude is not finite
void RequireMap(const conformal::MapImage& map);

/// Add the point array "AreaScale": the areas that pixels show, over their mean. Add the field data
/// "AreaScaleRange": two scales, between which the pixels show 90 percent of the area of the
/// surface.
/// @param[in] areas  area of each pixel, 0 outside of the map
void AddAreaScales(vtkImageData* image, std::vector<double> areas);

/// If the map is that of a capsule, add the field data "CapsuleAspect", and set the origin and
/// spacing of the image to those of the map.
void AddCapsule(vtkImageData* image, const conformal::MapImage& map);
}

#endif

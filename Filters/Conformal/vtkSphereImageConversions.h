// How an image lies on the sphere, as field data of a surface.
#ifndef vtkSphereImageConversions_h
#define vtkSphereImageConversions_h

#include "SphereProjection.h" // for SphereImage

class vtkFieldData;

namespace vtkConformalConversions
{
/// "SpherePole", "SphereUp", "SphereRight", "TextureProjection", "TextureFieldOfView",
/// "TextureScale" and "TextureMargin".
void AddSphereImage(vtkFieldData* data, const conformal::SphereImage& image);

/// The same read back.
/// @throws std::invalid_argument if one of them is missing or not as AddSphereImage writes it
conformal::SphereImage ToSphereImage(vtkFieldData* data);
}

#endif

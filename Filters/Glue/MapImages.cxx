#include "Glue/MapImages.h"

#include "Body/MapAreas.h"
#include "Glue/Arrays.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace glue
{
//------------------------------------------------------------------------------
void RequireMap(const conformal::MapImage& map)
{
  if (map.Grid.Width < 1 || map.Grid.Height < 1)
  {
    throw std::invalid_argument("ImageSize must be at least (1, 1)");
  }
  if (!std::isfinite(map.CentralLongitude))
  {
    throw std::invalid_argument("CentralLongitude must be finite");
  }
}

//------------------------------------------------------------------------------
void AddAreaScales(vtkImageData* image, std::vector<double> areas)
{
  const conformal::PixelAreas compared = conformal::comparePixelAreas(std::move(areas));
  AddNumbers(image->GetPointData(), "AreaScale", compared.Scales);
  const double range[] = { compared.Low, compared.High };
  AddTuple(image->GetFieldData(), "AreaScaleRange", range, 2);
}

//------------------------------------------------------------------------------
void AddCapsule(vtkImageData* image, const conformal::MapImage& map)
{
  if (map.Projection != conformal::MapProjection::Capsule)
  {
    return;
  }
  const conformal::Vector2 half = map.halfSize();
  const double across = 2.0 * half[0] / double(map.Grid.Width),
               up = 2.0 * half[1] / double(map.Grid.Height);
  image->SetOrigin(0.5 * across - half[0], 0.5 * up - half[1], 0.0);
  image->SetSpacing(across, up, across);
  AddNumber(image->GetFieldData(), "CapsuleAspect", map.CapsuleAspect);
}
}

#include "Bytes/ColorList.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace conformal
{
//------------------------------------------------------------------------------
void ColorList::add(const double* color, std::size_t components)
{
  for (std::size_t c = 0; c < 4; ++c)
  {
    const double value = c < components ? color[c] : -1.0;
    if (c < components && !(value >= 0.0 && value <= 255.0))
    {
      this->Input.fail(ParseCode::Malformed,
        "found " + std::to_string(value) + " in a color, expected 0 to 255 or 0 to 1");
    }
    this->Values.push_back(static_cast<float>(value));
    this->Maximum = std::max(this->Maximum, this->Values.back());
  }
  this->Components = std::max(this->Components, components);
  this->HasAny = true;
}

//------------------------------------------------------------------------------
void ColorList::addMissing()
{
  this->Values.insert(this->Values.end(), 4, -1.0F);
}

//------------------------------------------------------------------------------
NamedArray ColorList::take()
{
  const float scale = this->Maximum > 1.0F ? 1.0F : 255.0F;
  NamedArray colors;
  colors.Name = this->Components == 4 ? "RGBA" : "RGB";
  colors.Type = ScalarType::UInt8;
  colors.Components = this->Components;
  colors.Values.resize(this->Values.size() / 4 * this->Components);
  for (std::size_t i = 0; i < colors.Values.size(); ++i)
  {
    const float value = this->Values[i / this->Components * 4 + i % this->Components];
    colors.Values[i] = value < 0.0F ? 255 : static_cast<unsigned char>(std::lround(value * scale));
  }
  return colors;
}
}

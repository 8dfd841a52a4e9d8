#include "Harmonics/LegendreFunctions.h"

#include <array>
#include <cmath>

namespace conformal
{
namespace
{
// Values below 2^Tiny are multiplied by 2^Step, repeatedly until they are above 2^Tiny.
constexpr double Tiny = -900.0;
constexpr double Step = 512.0;

// Values P_mm at the heights of a block, and the number of multiplications by 2^Step for each
// height.
struct Sector
{
  LegendreLane Values;
  std::array<int, LegendreLanes> Scales{};
  bool IsScaled = false;

  Sector(int order, double logSector, const LegendreLane& logRadii)
  {
    for (int i = 0; i < LegendreLanes; ++i)
    {
      double exponent = order == 0 ? logSector : logSector + order * logRadii[i];
      if (exponent < Tiny && std::isfinite(exponent))
      {
        this->Scales[i] = static_cast<int>(std::ceil((Tiny - exponent) / Step));
        this->IsScaled = true;
        exponent += Step * this->Scales[i];
      }
      this->Values[i] = std::exp2(exponent);
    }
  }
};

// Where scaled values have become large, undo one multiplication by 2^Step.
void rescale(Sector& sector, LegendreLane& before)
{
  static const double large = std::exp2(Tiny + Step + 88.0), back = std::exp2(-Step);
  sector.IsScaled = false;
  for (int i = 0; i < LegendreLanes; ++i)
  {
    if (sector.Scales[i] > 0 && std::abs(sector.Values[i]) > large)
    {
      sector.Values[i] *= back;
      before[i] *= back;
      --sector.Scales[i];
    }
    sector.IsScaled = sector.IsScaled || sector.Scales[i] > 0;
  }
}
}

//------------------------------------------------------------------------------
LegendreFunctions::LegendreFunctions(int degree)
{
  double product = 1.0; // (2 m - 1)!! / (2 m)!!, by which P_mm is normalized
  for (int m = 0; m <= degree; ++m)
  {
    product *= m == 0 ? 1.0 : 1.0 - 0.5 / m;
    const double twice = m == 0 ? 1.0 : 2.0;
    this->LogSectors.push_back(0.5 * std::log2(twice * (2.0 * m + 1.0) / (4.0 * Pi) * product));
  }
}

//------------------------------------------------------------------------------
void LegendreFunctions::evaluate(
  int order, const LegendreLane& heights, const LegendreLane& logRadii, LegendreBlock& values) const
{
  const double m = order;
  Sector current(order, this->LogSectors[order], logRadii);
  LegendreLane before = LegendreLane::Zero();
  double factorBefore = 1.0;
  for (int degree = order; degree <= this->degree(); ++degree)
  {
    if (degree > order)
    {
      const double l = degree;
      const double factor = std::sqrt((4.0 * l * l - 1.0) / ((l - m) * (l + m)));
      const double share = 1.0 / factorBefore;
      const LegendreLane next = factor * (heights * current.Values - share * before);
      before = current.Values;
      current.Values = next;
      factorBefore = factor;
    }
    auto column = values.col(degree - order).array();
    if (!current.IsScaled)
    {
      column = current.Values;
      continue;
    }
    rescale(current, before);
    for (int i = 0; i < LegendreLanes; ++i)
    {
      // Values that are still scaled are below 2^-812, and are set to 0.
      column[i] = current.Scales[i] > 0 ? 0.0 : current.Values[i];
    }
  }
}
}

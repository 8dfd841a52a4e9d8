#include "Texture/Lemniscate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace conformal
{
namespace
{
using Complex = std::complex<double>;

// Compute Carlson's integral of the first kind for z = 1, by duplication.
Complex carlsonRF(Complex x, Complex y)
{
  Complex z = 1.0, mean, dx, dy, dz;
  constexpr int maximum = 30;
  for (int i = 0; i < maximum; ++i)
  {
    mean = (x + y + z) / 3.0;
    dx = 1.0 - x / mean;
    dy = 1.0 - y / mean;
    dz = 1.0 - z / mean;
    constexpr double near = 1e-3; // the series below has order seven
    if (std::max({ std::abs(dx), std::abs(dy), std::abs(dz) }) < near)
    {
      break;
    }
    const Complex a = std::sqrt(x), b = std::sqrt(y), c = std::sqrt(z);
    const Complex sum = a * b + b * c + c * a;
    x = 0.25 * (x + sum);
    y = 0.25 * (y + sum);
    z = 0.25 * (z + sum);
  }
  const Complex second = dx * dy - dz * dz, third = dx * dy * dz;
  return (1.0 - second / 10.0 + third / 14.0 + second * second / 24.0 -
           3.0 * second * third / 44.0) /
    std::sqrt(mean);
}

}

//------------------------------------------------------------------------------
Complex lemniscateArcsine(const Complex& s)
{
  return s * carlsonRF(1.0 - s * s, 1.0 + s * s);
}

namespace
{
// Coefficients c of sl z = sum of c[k] z^(4 k + 1), from sl'' = -2 sl^3.
std::array<double, 10> seriesOfSine()
{
  std::array<double, 10> c = { 1.0 };
  for (std::size_t k = 1; k < c.size(); ++k)
  {
    double cube = 0.0; // coefficient of the cube of the lower powers
    for (std::size_t a = 0; a < k; ++a)
    {
      for (std::size_t b = 0; a + b < k; ++b)
      {
        cube += c[a] * c[b] * c[k - 1 - a - b];
      }
    }
    const auto n = static_cast<double>(k);
    c[k] = -2.0 * cube / (4.0 * n * (4.0 * n + 1.0));
  }
  return c;
}

}

//------------------------------------------------------------------------------
// Ten terms of the series suffice at half the position. Then the formula for the double argument is
// applied.
Complex lemniscateSine(const Complex& z)
{
  static const std::array<double, 10> series = seriesOfSine();
  const Complex half = 0.5 * z, square = half * half, fourth = square * square;
  Complex sum = 0.0;
  for (std::size_t k = series.size(); k-- > 0;)
  {
    sum = sum * fourth + series[k];
  }
  const Complex s = half * sum, power = s * s * s * s;
  return 2.0 * s * std::sqrt(1.0 - power) / (1.0 + power);
}
}

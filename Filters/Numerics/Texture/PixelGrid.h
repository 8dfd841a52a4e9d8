/// Convert between the pixels of an image and its texture coordinates (s, t).

#ifndef ConformalPixelGrid_h
#define ConformalPixelGrid_h

#include "Base/Types.h"
#include "Texture/SphereProjection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace conformal
{
/// Four pixels nearest to a position, and their weights for interpolation.
struct PixelMix
{
  std::array<Index, 4> Pixels;
  std::array<double, 4> Weights; ///< weights of the pixels, at least 0; the sum is 1
};

/// Grid of pixels, stored in rows from bottom to top. The center of the pixel in column i and row j
/// has the texture coordinates ((i + 1/2) / Width, (j + 1/2) / Height).
struct PixelGrid
{
  Index Width = 0;
  Index Height = 0;

  Index size() const { return this->Width * this->Height; }
  /// Return the texture coordinates of the center of a pixel.
  Vector2 middleOf(Index pixel) const
  {
    const Index column = pixel % this->Width, row = pixel / this->Width;
    return { (static_cast<double>(column) + 0.5) / static_cast<double>(this->Width),
      (static_cast<double>(row) + 0.5) / static_cast<double>(this->Height) };
  }
  /// Compute the weights of bilinear interpolation at texture coordinates. The corners of the valid
  /// rectangle are the centers of the corner pixels. Positions outside of this rectangle are
  /// clamped to it.
  PixelMix mixAt(const Vector2& st) const
  {
    const auto along = [](double x, Index size)
    {
      const double place =
        std::clamp(x * static_cast<double>(size) - 0.5, 0.0, static_cast<double>(size) - 1.0);
      const auto first = std::min(static_cast<Index>(place), std::max<Index>(size - 2, 0));
      return std::pair(first, place - static_cast<double>(first));
    };
    const auto [i, u] = along(st[0], this->Width);
    const auto [j, v] = along(st[1], this->Height);
    const Index right = std::min(i + 1, this->Width - 1), above = std::min(j + 1, this->Height - 1);
    return { { j * this->Width + i, j * this->Width + right, above * this->Width + i,
               above * this->Width + right },
      { (1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v } };
  }
};
}

#endif

#include "Page/PagePicture.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
// Old pixels that a new pixel covers along one side. First is the first old pixel. Shares are the
// covered fractions of the new pixel.
struct Cover
{
  std::size_t First = 0;
  std::vector<double> Shares;
};

std::vector<Cover> coversOf(std::size_t before, std::size_t after)
{
  const double size = static_cast<double>(before) / static_cast<double>(after);
  std::vector<Cover> covers(after);
  for (std::size_t i = 0; i < after; ++i)
  {
    const double begin = size * static_cast<double>(i);
    const double end = std::min(begin + size, static_cast<double>(before));
    covers[i].First = std::min(static_cast<std::size_t>(begin), before - 1);
    for (std::size_t k = covers[i].First; k < before; ++k)
    {
      const double low = std::max(begin, static_cast<double>(k));
      const double high = std::min(end, static_cast<double>(k + 1));
      if (k > covers[i].First && high <= low)
      {
        break;
      }
      covers[i].Shares.push_back(std::max(high - low, 0.0) / size);
    }
  }
  return covers;
}

std::size_t shrunkSize(std::size_t size, double ratio)
{
  return std::max<std::size_t>(
    1, static_cast<std::size_t>(std::round(static_cast<double>(size) * ratio)));
}
}

//------------------------------------------------------------------------------
PagePicture shrunkPicture(const unsigned char* pixels, std::size_t width, std::size_t height,
  std::size_t components, std::size_t maximumSize)
{
  const double ratio =
    std::min(1.0, static_cast<double>(maximumSize) / static_cast<double>(std::max(width, height)));
  PagePicture result;
  result.Width = shrunkSize(width, ratio);
  result.Height = shrunkSize(height, ratio);
  const std::vector<Cover> columns = coversOf(width, result.Width);
  const std::vector<Cover> rows = coversOf(height, result.Height);
  result.Pixels.reserve(3 * result.Width * result.Height);
  std::vector<double> row(3 * width);
  for (const Cover& vertical : rows)
  {
    std::fill(row.begin(), row.end(), 0.0);
    for (std::size_t k = 0; k < vertical.Shares.size(); ++k)
    {
      const unsigned char* old = pixels + (vertical.First + k) * width * components;
      for (std::size_t x = 0; x < width; ++x)
      {
        for (std::size_t c = 0; c < 3; ++c)
        {
          row[3 * x + c] += vertical.Shares[k] * old[x * components + c];
        }
      }
    }
    for (const Cover& horizontal : columns)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        double sum = 0.0;
        for (std::size_t k = 0; k < horizontal.Shares.size(); ++k)
        {
          sum += horizontal.Shares[k] * row[3 * (horizontal.First + k) + c];
        }
        result.Pixels.push_back(
          static_cast<unsigned char>(std::clamp(std::round(sum), 0.0, 255.0)));
      }
    }
  }
  return result;
}
}

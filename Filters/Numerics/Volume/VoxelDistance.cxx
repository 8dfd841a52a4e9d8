#include "Volume/VoxelDistance.h"

#include "Base/Steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace conformal
{
namespace
{
constexpr float Infinite = std::numeric_limits<float>::infinity();

// Replace f by the lower envelope of the parabolas f(q) + (x - q)^2, at the whole numbers x.
class Envelope
{
public:
  explicit Envelope(Index length)
    : Apex(length)
    , Border(length + 1)
    , Copy(length)
  {
  }

  void apply(float* f, Index step)
  {
    const auto length = static_cast<Index>(this->Copy.size());
    Index last = -1;
    for (Index q = 0; q < length; ++q)
    {
      this->Copy[q] = f[q * step];
      if (this->Copy[q] < Infinite)
      {
        last = this->add(q, last);
      }
    }
    Index parabola = 0;
    for (Index x = 0; x < length && last >= 0; ++x)
    {
      while (parabola < last && this->Border[parabola + 1] < static_cast<double>(x))
      {
        ++parabola;
      }
      const auto apart = static_cast<double>(x - this->Apex[parabola]);
      f[x * step] = static_cast<float>(apart * apart + this->Copy[this->Apex[parabola]]);
    }
  }

private:
  // Add the parabola with apex q to the envelope of `last` + 1 parabolas; return its place.
  Index add(Index q, Index last)
  {
    const auto height = [&](Index p)
    { return this->Copy[p] + static_cast<double>(p) * static_cast<double>(p); };
    double border = -std::numeric_limits<double>::infinity();
    while (last >= 0)
    {
      const Index p = this->Apex[last];
      border = (height(q) - height(p)) / (2.0 * static_cast<double>(q - p));
      if (border > this->Border[last])
      {
        break;
      }
      --last;
      border = -std::numeric_limits<double>::infinity();
    }
    this->Apex[++last] = q;
    this->Border[last] = border;
    return last;
  }

  std::vector<Index> Apex;
  std::vector<double> Border; ///< where each parabola of the envelope begins
  std::vector<float> Copy;
};
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> farFrom(const std::array<Index, 3>& size,
  const std::vector<std::uint8_t>& set, double radius, const Run& run)
{
  const auto number = static_cast<Index>(set.size());
  constexpr Index voxelsOfBlock = Index(1) << 14;
  const double share = radius > 0.0 ? 1.0 : 0.0;
  Steps steps(run, { 0.2, share, share, share, 0.2 }); // set, three axes, result
  std::vector<float> squares(set.size());
  forBlocksReporting(steps.next(), number, voxelsOfBlock,
    [&](Index begin, Index end)
    {
      std::transform(set.data() + begin, set.data() + end, squares.data() + begin,
        [](std::uint8_t isIn) { return isIn ? 0.0F : Infinite; });
    });
  for (int axis = 0; axis < 3; ++axis)
  {
    const Run along = steps.next();
    if (!(radius > 0.0))
    {
      continue;
    }
    const Index length = size[axis], step = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
    constexpr Index linesOfBlock = 64;
    forBlocksReporting(along, number / std::max<Index>(length, 1), linesOfBlock,
      [&](Index begin, Index end)
      {
        Envelope envelope(length);
        for (Index line = begin; line < end; ++line)
        {
          envelope.apply(squares.data() + (line / step) * step * length + line % step, step);
        }
      });
  }
  std::vector<std::uint8_t> far(set.size());
  forBlocksReporting(steps.next(), number, voxelsOfBlock,
    [&](Index begin, Index end)
    {
      std::transform(squares.data() + begin, squares.data() + end, far.data() + begin,
        [&](float square) { return static_cast<std::uint8_t>(square > radius * radius); });
    });
  return far;
}
}

// Make clouds and threads for the benchmarks.
#ifndef BenchmarkFixtures_h
#define BenchmarkFixtures_h

#include "Base/Random.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <thread>
#include <vector>

namespace fixtures
{
/// Return random points of a closed surface like a head: an ellipsoid with smooth bumps.
inline conformal::Points bumpyCloud(conformal::Index size, conformal::Random& random)
{
  conformal::Points points(size, 3);
  for (conformal::Index i = 0; i < size; ++i)
  {
    const double z = 2.0 * random.uniform() - 1.0, angle = 8.0 * std::atan(1.0) * random.uniform();
    const double r = std::sqrt(1.0 - z * z);
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    const double radius =
      1.0 + 0.1 * std::sin(5.0 * x) * std::cos(4.0 * y) + 0.05 * std::sin(9.0 * z);
    points.row(i) << 0.8 * radius * x, 0.9 * radius * y, 1.1 * radius * z;
  }
  return points;
}

inline conformal::Points bumpyCloud(conformal::Index size)
{
  conformal::Random random(1);
  return bumpyCloud(size, random);
}

/// Return a run with `count` threads. Each thread runs the next block when its last block is
/// finished.
inline conformal::Run threads(int count)
{
  return { [count](conformal::Index blocks, const std::function<void(conformal::Index)>& body)
    {
      std::atomic<conformal::Index> next{ 0 };
      const auto work = [&]()
      {
        for (conformal::Index block = next++; block < blocks; block = next++)
        {
          body(block);
        }
      };
      std::vector<std::thread> helpers;
      for (int k = 1; k < count; ++k)
      {
        helpers.emplace_back(work);
      }
      work();
      for (std::thread& helper : helpers)
      {
        helper.join();
      }
    } };
}
}

#endif

/// What tests lend to the core: threads in an odd order, watchers that check what they hear.

#ifndef ConformalTestRuns_h
#define ConformalTestRuns_h

#include "Base/Run.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace runs
{
/// Two threads, each from its last block to its first: nothing may depend on who comes first.
inline conformal::Run backwards()
{
  return { [](conformal::Index count, const std::function<void(conformal::Index)>& body)
    {
      const auto every = [&](conformal::Index last)
      {
        for (conformal::Index i = last; i >= 0; i -= 2)
        {
          body(i);
        }
      };
      std::thread other(every, count - 1);
      every(count - 2);
      other.join();
    } };
}

/// Told to stop when as much is done.
inline conformal::Run stoppingAt(double fraction)
{
  return { {}, [fraction](double done) { return done < fraction; } };
}

/// Expects progress that never falls and stays within [0, 1].
class Watch
{
public:
  conformal::Run run()
  {
    return { {},
      [this](double fraction)
      {
        EXPECT_GE(fraction, this->last());
        EXPECT_LE(fraction, 1.0);
        this->Fractions.push_back(fraction);
        return true;
      } };
  }

  /// 0 before the first report.
  double last() const { return this->Fractions.empty() ? 0.0 : this->Fractions.back(); }
  int calls() const { return static_cast<int>(this->Fractions.size()); }
  const std::vector<double>& fractions() const { return this->Fractions; }

private:
  std::vector<double> Fractions;
};
}

#endif

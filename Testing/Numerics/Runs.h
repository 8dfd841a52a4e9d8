/// Make execution contexts for tests: threads in an unusual order, and progress callbacks that
/// check their input.

#ifndef ConformalTestRuns_h
#define ConformalTestRuns_h

#include "Base/Run.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace runs
{
/// Return a run with two threads. Each thread runs its blocks from the last to the first. Results
/// must not depend on this order.
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

/// Return a run that is aborted when the progress reaches a fraction.
inline conformal::Run stoppingAt(double fraction)
{
  return { {}, [fraction](double done) { return done < fraction; } };
}

/// Observer that checks that progress never decreases, and remains in [0, 1].
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

  /// Return the last reported progress, or 0 before the first report.
  double last() const { return this->Fractions.empty() ? 0.0 : this->Fractions.back(); }
  int calls() const { return static_cast<int>(this->Fractions.size()); }
  const std::vector<double>& fractions() const { return this->Fractions; }

private:
  std::vector<double> Fractions;
};
}

#endif

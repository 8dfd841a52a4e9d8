#include "Base/NumericalFailure.h"
#include "Linear/HarmonicExtension.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

using conformal::Columns;
using conformal::EdgeWeights;
using conformal::extendHarmonically;
using conformal::Index;
using conformal::Points;

namespace
{
// A string of so many pieces along x, its springs as given by turns; the ends come first and last.
struct String
{
  EdgeWeights Weights;
  Points Places;
  std::vector<int> Free;

  String(int pieces, double even, double odd)
    : Places(Points::Zero(pieces + 1, 3))
  {
    this->Weights.Neighbors.Offsets = { 0 };
    for (int i = 0; i <= pieces; ++i)
    {
      this->Places(i, 0) = i;
      for (int other : { i - 1, i + 1 })
      {
        if (other >= 0 && other <= pieces)
        {
          this->Weights.Neighbors.Ids.push_back(other);
          this->Weights.Weights.push_back(std::min(i, other) % 2 == 0 ? even : odd);
        }
      }
      this->Weights.Neighbors.Offsets.push_back(
        static_cast<int>(this->Weights.Neighbors.Ids.size()));
    }
    this->Free.resize(pieces - 1);
    std::iota(this->Free.begin(), this->Free.end(), 1);
  }
};

constexpr int Small = 100, Large = 40000; // Eigen's solver, and ours
}

// Springs share a stretch in inverse proportion to their constants.
TEST(HarmonicExtension, DrawsAStringStraight)
{
  for (int pieces : { Small, Large })
  {
    const String string(pieces, 1.0, 3.0);
    Columns values = Columns::Zero(pieces + 1, 2);
    values.row(pieces) << 1.0, -2.0;
    extendHarmonically(string.Weights, string.Places, string.Free, values);
    double worst = 0.0, expected = 0.0;
    for (int i = 0; i <= pieces; ++i)
    {
      worst = std::max(worst, std::abs(values(i, 0) - expected));
      worst = std::max(worst, std::abs(values(i, 1) + 2.0 * expected));
      expected += (i % 2 == 0 ? 1.5 : 0.5) / pieces;
    }
    EXPECT_LT(worst, 1e-7) << pieces;
  }
}

TEST(HarmonicExtension, LeavesAllAsItIsWhereNothingIsFree)
{
  const String string(Small, 1.0, 1.0);
  Columns values = Columns::Constant(Small + 1, 2, 7.0);
  extendHarmonically(string.Weights, string.Places, {}, values);
  EXPECT_EQ(values, Columns::Constant(Small + 1, 2, 7.0));
}

TEST(HarmonicExtension, RefusesSpringsThatPush)
{
  for (int pieces : { Small, Large })
  {
    const String string(pieces, 1.0, -3.0);
    Columns values = Columns::Zero(pieces + 1, 1);
    EXPECT_THROW(extendHarmonically(string.Weights, string.Places, string.Free, values),
      conformal::NumericalFailure)
      << pieces;
  }
}

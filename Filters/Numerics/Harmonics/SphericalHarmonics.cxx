#include "Harmonics/SphericalHarmonics.h"

#include "Harmonics/LegendreFunctions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace conformal
{
namespace
{
using Waves = Eigen::Array<double, LegendreLanes, 2>; // cos and sin of a multiple of the longitude

// Block of directions that are evaluated together. An incomplete block is padded with copies of its
// last direction.
struct Block
{
  LegendreLane Heights, LogRadii;
  Waves First; // cosine and sine of the longitude

  Block(const Points& directions, Index begin, Index end)
  {
    for (int i = 0; i < LegendreLanes; ++i)
    {
      const Vector3 p = directions.row(std::min(begin + i, end - 1));
      const double radius = std::hypot(p[0], p[1]);
      this->Heights[i] = p[2];
      this->LogRadii[i] = std::log2(radius);
      this->First.row(i) << (radius > 0.0 ? p[0] / radius : 1.0),
        (radius > 0.0 ? p[1] / radius : 0.0);
    }
  }

  // Compute the cosine and sine of m times the longitude, as power m of a complex number. The error
  // is about m units of the last digit.
  Waves wavesOf(int order) const
  {
    Waves waves;
    waves.col(0).setOnes();
    waves.col(1).setZero();
    Waves power = this->First;
    for (int bits = order; bits > 0; bits /= 2)
    {
      if (bits % 2 == 1)
      {
        waves = product(waves, power);
      }
      power = product(power, power);
    }
    return waves;
  }

  static Waves product(const Waves& a, const Waves& b)
  {
    Waves result;
    result.col(0) = a.col(0) * b.col(0) - a.col(1) * b.col(1);
    result.col(1) = a.col(0) * b.col(1) + a.col(1) * b.col(0);
    return result;
  }
};

// Return the coefficients of one order, with one row for each degree. The first columns belong to
// the cosines, the other columns to the sines.
Columns coefficientsOfOrder(const Columns& coefficients, int degree, int order)
{
  const Index columns = coefficients.cols();
  Columns result(degree - order + 1, 2 * columns);
  for (int l = order; l <= degree; ++l)
  {
    result.row(l - order).head(columns) = coefficients.row(harmonicIndex(l, order));
    result.row(l - order).tail(columns) = coefficients.row(harmonicIndex(l, -order));
  }
  return result;
}

void evaluateBlock(const LegendreFunctions& functions, const std::vector<Columns>& coefficients,
  const Points& directions, Index begin, Index end, Columns& values)
{
  const Index columns = values.cols();
  const Block block(directions, begin, end);
  LegendreBlock legendre(LegendreLanes, functions.degree() + 1);
  Waves waves = block.wavesOf(0);
  Columns sum = Columns::Zero(LegendreLanes, columns), parts(LegendreLanes, 2 * columns);
  for (int m = 0; m <= functions.degree(); ++m)
  {
    functions.evaluate(m, block.Heights, block.LogRadii, legendre);
    parts.noalias() = legendre.leftCols(functions.degree() - m + 1) * coefficients[m];
    for (Index c = 0; c < columns; ++c)
    {
      sum.col(c).array() += waves.col(0) * parts.col(c).array();
      sum.col(c).array() += waves.col(1) * parts.col(columns + c).array();
    }
    waves = Block::product(waves, block.First);
  }
  values.middleRows(begin, end - begin) = sum.topRows(end - begin);
}

// Add the moments of one order over the directions [begin, end).
void addMoments(const LegendreFunctions& functions, int order, const std::vector<Block>& blocks,
  const Columns& values, Index begin, Index end, Columns& moments)
{
  const Index columns = values.cols();
  LegendreBlock legendre(LegendreLanes, functions.degree() - order + 1);
  Columns weighted(LegendreLanes, 2 * columns);
  Columns sum = Columns::Zero(functions.degree() - order + 1, 2 * columns);
  for (const Block& block : blocks)
  {
    const Index size = std::min<Index>(LegendreLanes, end - begin);
    const Waves waves = block.wavesOf(order);
    weighted.setZero();
    for (Index c = 0; c < columns; ++c)
    {
      const auto own = values.col(c).segment(begin, size).array();
      weighted.col(c).head(size) = own * waves.col(0).head(size);
      weighted.col(columns + c).head(size) = own * waves.col(1).head(size);
    }
    functions.evaluate(order, block.Heights, block.LogRadii, legendre);
    sum.noalias() += legendre.transpose() * weighted;
    begin += size;
  }
  for (int l = order; l <= functions.degree(); ++l)
  {
    moments.row(harmonicIndex(l, order)) += sum.row(l - order).head(columns);
    if (order > 0)
    {
      moments.row(harmonicIndex(l, -order)) += sum.row(l - order).tail(columns);
    }
  }
}
}

//------------------------------------------------------------------------------
int degreeOfHarmonics(Index numberOfCoefficients)
{
  const auto degree =
    static_cast<int>(std::lround(std::sqrt(static_cast<double>(numberOfCoefficients)))) - 1;
  if (degree < 0 || numberOfHarmonics(degree) != numberOfCoefficients)
  {
    throw std::invalid_argument("there are " + std::to_string(numberOfCoefficients) +
      " coefficients, but those of all degrees up to L are (L + 1)^2");
  }
  if (degree > MaximumHarmonicDegree)
  {
    throw std::invalid_argument("the coefficients have degree " + std::to_string(degree) +
      ", but the highest is " + std::to_string(MaximumHarmonicDegree));
  }
  return degree;
}

//------------------------------------------------------------------------------
Columns evaluateHarmonics(const Columns& coefficients, const Points& directions, const Run& run)
{
  const LegendreFunctions functions(degreeOfHarmonics(coefficients.rows()));
  std::vector<Columns> ofOrders;
  for (int m = 0; m <= functions.degree(); ++m)
  {
    ofOrders.push_back(coefficientsOfOrder(coefficients, functions.degree(), m));
  }
  Columns values(directions.rows(), coefficients.cols());
  forBlocksReporting(run, directions.rows(), LegendreLanes,
    [&](Index begin, Index end)
    { evaluateBlock(functions, ofOrders, directions, begin, end, values); });
  return values;
}

//------------------------------------------------------------------------------
Columns harmonicMoments(const Points& directions, const Columns& values, int degree, const Run& run)
{
  // Each order is summed separately, over consecutive chunks of directions. Thus the order of
  // summation does not depend on the number of threads.
  constexpr Index chunkSize = Index(32) * LegendreLanes;
  const LegendreFunctions functions(degree);
  Columns moments = Columns::Zero(numberOfHarmonics(degree), values.cols());
  for (Index begin = 0; begin < directions.rows(); begin += chunkSize)
  {
    const Index end = std::min(begin + chunkSize, directions.rows());
    std::vector<Block> blocks;
    for (Index i = begin; i < end; i += LegendreLanes)
    {
      blocks.emplace_back(directions, i, end);
    }
    run.forEach(degree + 1,
      [&](Index m)
      { addMoments(functions, static_cast<int>(m), blocks, values, begin, end, moments); });
    run.report(static_cast<double>(end) / static_cast<double>(directions.rows()));
  }
  return moments;
}

//------------------------------------------------------------------------------
Eigen::VectorXd powerPerDegree(const Columns& coefficients)
{
  const int degree = degreeOfHarmonics(coefficients.rows());
  Eigen::VectorXd power(degree + 1);
  for (int l = 0; l <= degree; ++l)
  {
    power[l] = coefficients.middleRows(harmonicIndex(l, -l), 2 * l + 1).squaredNorm();
  }
  return power;
}
}

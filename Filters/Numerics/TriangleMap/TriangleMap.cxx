#include "TriangleMap/TriangleMap.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
using namespace halfdisk;

//------------------------------------------------------------------------------
TriangleMap::TriangleMap(const TriangleShape& shape)
  : TriangleMap(shape, nullptr, 0)
{
}

//------------------------------------------------------------------------------
TriangleMap::TriangleMap(const TriangleShape& shape, const ShapeTable* table, int rotation)
  : Shape(shape)
  , Table(table)
  , Rotation(rotation)
{
  const std::array<double, 3>& angles = shape.angles();
  for (int k = 0; k < 3; ++k)
  {
    this->Series[k] = CornerSeries(angles[k], angles[next(k)], angles[previous(k)]);
  }
}

//------------------------------------------------------------------------------
ShapeTable TriangleMap::makeTable(const TriangleShape& shape)
{
  return { makeTable(shape, 0), makeTable(shape, 1), makeTable(shape, 2) };
}

//------------------------------------------------------------------------------
// log(s/W) = T(W) solves 1 + W T' = exp(X), X = -a T + (1-2b) log(1-s) + (1-2c) log(1+s), s = W
// exp(T). Compute the power series coefficient by coefficient.
CornerTable TriangleMap::makeTable(const TriangleShape& shape, int corner)
{
  const double a = shape.Angles[corner], b = shape.Angles[next(corner)],
               c = shape.Angles[previous(corner)];
  CornerTable table;
  CornerSeries series(a, b, c);
  series.extend(MaximumTerms);
  table.Map = series.Map;

  // Coefficients of derivatives: minus[n] of log(1-s), plus[n] of log(1+s), both times n.
  constexpr int N = CornerTable::InverseTerms + 1;
  std::array<double, N> t{}, x{}, exponential{}, ratio{}, s{}, minus{}, plus{};
  exponential[0] = ratio[0] = 1.0;
  for (int n = 1; n < N; ++n)
  {
    s[n] = ratio[n - 1];
    minus[n] = -n * s[n];
    plus[n] = n * s[n];
    double sum = 0.0;
    for (int j = 1; j < n; ++j)
    {
      minus[n] += minus[j] * s[n - j];
      plus[n] -= plus[j] * s[n - j];
      sum += j * x[j] * exponential[n - j];
    }
    const double known = ((1.0 - 2.0 * b) * minus[n] + (1.0 - 2.0 * c) * plus[n] + sum) / n;
    t[n] = known / (n + a);
    x[n] = ((1.0 - 2.0 * b) * minus[n] + (1.0 - 2.0 * c) * plus[n]) / n - a * t[n];
    exponential[n] = n * t[n];
    for (int j = 1; j <= n; ++j)
    {
      ratio[n] += j * t[j] * ratio[n - j];
    }
    ratio[n] /= n;
  }
  std::copy_n(t.begin() + 1, CornerTable::InverseTerms, table.Inverse.begin());

  // The series converges up to the nearer of the two other corners.
  Vector3 atNext = Vector3::Zero(), atPrevious = Vector3::Zero();
  atNext[next(corner)] = 1.0;
  atPrevious[previous(corner)] = 1.0;
  table.Limit =
    std::min(shape.logUniform(corner, atNext).real(), shape.logUniform(corner, atPrevious).real()) +
    LogEpsilon / CornerTable::InverseTerms * 0.9;
  return table;
}

//------------------------------------------------------------------------------
const double* TriangleMap::mapSeries(int corner, int terms)
{
  if (this->Table)
  {
    return (*this->Table)[(corner + 3 - this->Rotation) % 3].Map.data();
  }
  this->Series[corner].extend(terms);
  return this->Series[corner].Map.data();
}

//------------------------------------------------------------------------------
TriangleMap::Sums TriangleMap::sums(int corner, double s, double logS)
{
  const int terms = termsFor(logS);
  CornerSeries& series = this->Series[corner];
  series.extend(terms);
  return { sumSeries(series.Map.data(), terms, s), 1.0 + sumSeries(series.Slope.data(), terms, s) };
}

//------------------------------------------------------------------------------
HalfDiskPoint TriangleMap::toHalfDisk(const Vector3& barycentric) const
{
  const Vector3 inside = barycentric.cwiseMax(0.0);
  Complex logUniform;
  const int corner = this->Shape.corner(inside, logUniform);
  const CornerTable* table =
    this->Table ? &(*this->Table)[(corner + 3 - this->Rotation) % 3] : nullptr;
  if (!table || !(logUniform.real() < table->Limit))
  {
    return this->Shape.solve(corner, logUniform, inside);
  }
  const Complex w = expOf(logUniform);
  const Complex logS = logUniform + sumSeries(table->Inverse.data(), CornerTable::InverseTerms, w);
  return { corner, expOf(logS), logS };
}

//------------------------------------------------------------------------------
Vector3 TriangleMap::fromHalfDisk(const HalfDiskPoint& point)
{
  const int terms = termsFor(point.LogS.real());
  return this->Shape.place(point, sumSeries(this->mapSeries(point.Corner, terms), terms, point.S));
}

//------------------------------------------------------------------------------
double TriangleMap::logFactor(int edge, bool atSecond)
{
  if (!this->HasLogarithms)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->LogLeading[k] = std::log(this->Shape.leading(k));
      this->LogLengths[k] = std::log(this->Shape.Sines[k]);
    }
    this->HasLogarithms = true;
  }
  return this->LogLeading[corner(edge, atSecond)] - this->LogLengths[edge];
}

//------------------------------------------------------------------------------
double TriangleMap::logUniform(int edge, bool atSecond, double share)
{
  return (std::log(share) - this->logFactor(edge, atSecond)) /
    this->Shape.Angles[corner(edge, atSecond)] -
    Log4;
}

//------------------------------------------------------------------------------
// Halley's method on log W(s) = log |s| + log(1 + sum) / a, a function close to a straight line.
EdgePoint TriangleMap::toHalfDisk(int edge, const EdgeShares& shares)
{
  EdgePoint point;
  point.AtSecond = shares.First < shares.Second;
  double logUniform =
    this->logUniform(edge, point.AtSecond, point.AtSecond ? shares.First : shares.Second);
  const double surelyNear = std::log(0.15);
  if (logUniform > surelyNear)
  {
    const double other =
      this->logUniform(edge, !point.AtSecond, point.AtSecond ? shares.Second : shares.First);
    if (other < logUniform)
    {
      logUniform = other;
      point.AtSecond = !point.AtSecond;
    }
  }
  for (int end = 0; end < 2; ++end)
  {
    const int k = corner(edge, point.AtSecond);
    const double a = this->Shape.Angles[k];
    point.S = std::exp(logUniform) * (point.AtSecond ? -1.0 : 1.0);
    point.LogS = logUniform;
    if (logUniform < LogEpsilon)
    {
      return point;
    }
    CornerSeries& series = this->Series[k];
    const double guess = series.guess(point.S) / point.S;
    point.S *= guess;
    point.LogS += std::log(guess);
    for (int iteration = 0; iteration < 20 && point.LogS < MaximumLogS; ++iteration)
    {
      const Sums at = this->sums(k, point.S, point.LogS);
      const double miss = point.LogS + std::log1p(at.Map) / a - logUniform;
      const double slope = at.Slope / (1.0 + at.Map);
      // Derivative of the logarithmic slope
      const double bend = series.bend(point.S) - a * (slope - 1.0);
      const double newton = miss / slope;
      const double step = -newton / (1.0 - 0.5 * newton * bend);
      point.LogS += step;
      const double enough = 1e-4; // the remaining error is less than the cube of the step
      if (std::abs(step) < enough)
      {
        point.S *= 1.0 + step * (1.0 + step * (0.5 + step / 6.0));
        return point;
      }
      point.S *= std::exp(step);
    }
    // The point is nearer to the other end of the edge.
    point.AtSecond = !point.AtSecond;
    logUniform =
      this->logUniform(edge, point.AtSecond, point.AtSecond ? shares.First : shares.Second);
  }
  return point;
}

//------------------------------------------------------------------------------
EdgeShares TriangleMap::fromHalfDisk(int edge, const EdgePoint& point)
{
  const int k = corner(edge, point.AtSecond);
  const int terms = termsFor(point.LogS);
  const double sum = sumSeries(this->mapSeries(k, terms), terms, point.S);
  const double share = std::min(1.0,
    std::exp(this->logFactor(edge, point.AtSecond) + this->Shape.Angles[k] * (point.LogS + Log4)) *
      (1.0 + sum));
  return point.AtSecond ? EdgeShares{ share, 1.0 - share } : EdgeShares{ 1.0 - share, share };
}

//------------------------------------------------------------------------------
double TriangleMap::logSlope(int edge, const EdgePoint& point)
{
  const int k = corner(edge, point.AtSecond);
  const Sums at = this->sums(k, point.S, point.LogS);
  return this->Shape.Angles[k] * at.Slope / (1.0 + at.Map);
}
}

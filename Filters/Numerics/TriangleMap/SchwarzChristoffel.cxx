#include "TriangleMap/SchwarzChristoffel.h"

#include "TriangleMap/HalfDiskSeries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace conformal
{
using namespace halfdisk;

namespace
{
// Minimum angle of a triangle [radians]. Thinner needles have no shape in double precision.
constexpr double MinimumAngle = 1e-9;

/// Compute a^-1 b for an upper triangular a.
Eigen::Matrix2d upperTriangularSolve(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b)
{
  Eigen::Matrix2d result;
  result.row(1) = b.row(1) / a(1, 1);
  result.row(0) = (b.row(0) - a(0, 1) * result.row(1)) / a(0, 0);
  return result;
}

/// Convert a point of the half disk to the coordinate of the corner at s = 1 (toNext) or at s = -1.
Complex fromNeighbor(const Complex& s, bool toNext)
{
  // The upper half plane y = 2s / (1 + s^2) has the corners at 0, 1, -1, which a Moebius map
  // permutes.
  const double sign = toNext ? 1.0 : -1.0;
  const Complex one = 1.0 - sign * s;
  const Complex y = over(-sign * times(one, one), 1.0 + 6.0 * sign * s + times(s, s));
  return over(y, 1.0 + std::sqrt(1.0 - times(y, y)));
}

/// Compute log s with the imaginary part in [0, pi].
Complex logOf(const Complex& s)
{
  const double angle = s.imag() > 0.0 ? std::arg(s) : (s.real() < 0.0 ? Pi : 0.0);
  return { std::log(std::abs(s)), angle };
}
}

//------------------------------------------------------------------------------
TriangleShape::TriangleShape(const Vector3& p0, const Vector3& p1, const Vector3& p2)
{
  // Edge k is opposite to corner k. Scale by the longest edge, so that nothing underflows or
  // overflows.
  std::array<Vector3, 3> edges{ p2 - p1, p0 - p2, p1 - p0 };
  const double size = std::max({ edges[0].cwiseAbs().maxCoeff(), edges[1].cwiseAbs().maxCoeff(),
    edges[2].cwiseAbs().maxCoeff() });
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return;
  }
  for (Vector3& edge : edges)
  {
    edge /= size;
  }
  const double doubleArea = edges[0].cross(edges[1]).norm();
  std::array<double, 3> lengths;
  for (int k = 0; k < 3; ++k)
  {
    lengths[k] = edges[k].norm();
  }
  for (int k = 0; k < 3; ++k)
  {
    const double cosine = -edges[next(k)].dot(edges[previous(k)]);
    const double angle = std::atan2(doubleArea, cosine);
    if (!(angle > MinimumAngle) || !std::isfinite(angle))
    {
      return;
    }
    const double product = lengths[next(k)] * lengths[previous(k)];
    this->Angles[k] = angle / Pi;
    this->Sines[k] = doubleArea / product;
    this->Cosines[k] = cosine / product;
  }
  this->Scale = Pi /
    (std::tgamma(this->Angles[0]) * std::tgamma(this->Angles[1]) * std::tgamma(this->Angles[2]));
  this->Degenerate = false;
}

//------------------------------------------------------------------------------
// Compute log W. W = (a z / k)^(1/a) / 4 is an analytic and univalent function of s in the whole
// disk, W = s + ... at 0. It maps the diameter of the half disk to the real axis, so Newton's
// method converges.
std::complex<double> TriangleShape::logUniform(int corner, const Vector3& barycentric) const
{
  const double alongNext = barycentric[next(corner)] * this->Sines[previous(corner)];
  const double alongPrevious = barycentric[previous(corner)] * this->Sines[next(corner)];
  const double real = alongNext + alongPrevious * this->Cosines[corner];
  const double imaginary = alongPrevious * this->Sines[corner];
  const double a = this->Angles[corner];
  const double size = std::hypot(real, imaginary);
  const double angle = alongPrevious == 0.0 ? 0.0
    : alongNext == 0.0                      ? Pi
                                            : std::min(Pi, std::atan2(imaginary, real) / a);
  return { std::log(size / this->leading(corner)) / a - Log4, angle };
}

//------------------------------------------------------------------------------
// Find the corner of minimum |s|, first by approximation.
int TriangleShape::corner(const Vector3& barycentric, std::complex<double>& logUniform) const
{
  int best = 0;
  barycentric.maxCoeff(&best);
  logUniform = this->logUniform(best, barycentric);
  const double surelyNear = std::log(0.25);
  if (logUniform.real() > surelyNear)
  {
    const int guess = best;
    for (const int other : { next(guess), previous(guess) })
    {
      if (barycentric[other] > 0.0)
      {
        const Complex candidate = this->logUniform(other, barycentric);
        if (candidate.real() < logUniform.real())
        {
          logUniform = candidate;
          best = other;
        }
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
HalfDiskPoint TriangleShape::solve(
  int corner, std::complex<double> logUniform, const Vector3& barycentric) const
{
  if (logUniform.real() < LogEpsilon)
  {
    return { corner, expOf(logUniform), logUniform };
  }
  const auto seriesAt = [this](int k)
  { return CornerSeries(this->Angles[k], this->Angles[next(k)], this->Angles[previous(k)]); };
  CornerSeries series = seriesAt(corner);
  Complex logS = series.guess(logUniform), step = 0.0;
  double lastSize = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    logS = { logS.real(), std::min(Pi, std::max(0.0, logS.imag())) };
    if (logS.real() > MaximumLogS)
    {
      // The point is outside of the region of the series of this corner: continue at the corner
      // that is nearer to the point.
      const Complex s = expOf({ std::min(logS.real(), -0.1), logS.imag() });
      const bool toNext = s.real() > 0.0;
      corner = toNext ? next(corner) : previous(corner);
      logUniform = this->logUniform(corner, barycentric);
      if (logUniform.real() < LogEpsilon)
      {
        return { corner, expOf(logUniform), logUniform };
      }
      logS = logOf(fromNeighbor(s, toNext));
      series = seriesAt(corner);
      lastSize = std::numeric_limits<double>::infinity();
    }
    const Complex s = expOf(logS);
    const int terms = termsFor(logS.real());
    series.extend(terms);
    const Complex map = 1.0 + sumSeries(series.Map.data(), terms, s);
    const Complex slope = 1.0 + sumSeries(series.Slope.data(), terms, s);
    const Complex residual = logS - logUniform + log1p(map - 1.0) / this->Angles[corner];
    const double size = std::norm(residual);
    if (size > lastSize && size > 1e-24) // rare, in needles; a halved step descends
    {
      step *= 0.5;
      logS -= step;
      continue;
    }
    lastSize = size;
    step = -over(times(residual, map), slope);
    logS += step;
    if (std::norm(step) < 1e-16) // the remaining error is about the square of the step
    {
      break;
    }
  }
  logS = { std::min(logS.real(), LogEpsilon / MaximumTerms),
    std::min(Pi, std::max(0.0, logS.imag())) };
  return { corner, expOf(logS), logS };
}

//------------------------------------------------------------------------------
HalfDiskPoint TriangleShape::toHalfDisk(const Vector3& barycentric) const
{
  const Vector3 inside = barycentric.cwiseMax(0.0);
  Complex logUniform;
  const int corner = this->corner(inside, logUniform);
  return this->solve(corner, logUniform, inside);
}

//------------------------------------------------------------------------------
Vector3 TriangleShape::place(const HalfDiskPoint& point, std::complex<double> series) const
{
  const int k = point.Corner;
  const double a = this->Angles[k];
  const Complex power = point.LogS.imag() == Pi
    ? Complex(std::exp(a * (point.LogS.real() + Log4)), 0.0)
    : expOf(a * (point.LogS + Log4));
  const Complex z = this->leading(k) * times(power, 1.0 + series);

  Vector3 barycentric = Vector3::Zero();
  double &alongNext = barycentric[next(k)], &alongPrevious = barycentric[previous(k)];
  if (point.LogS.imag() == Pi) // z is measured along the edge to the previous corner
  {
    alongPrevious = z.real() / this->Sines[next(k)];
  }
  else
  {
    alongPrevious = z.imag() / (this->Sines[next(k)] * this->Sines[k]);
    alongNext = (z.real() * this->Sines[k] - z.imag() * this->Cosines[k]) /
      (this->Sines[previous(k)] * this->Sines[k]);
  }
  alongNext = std::min(1.0, std::max(0.0, alongNext));
  alongPrevious = std::min(1.0 - alongNext, std::max(0.0, alongPrevious));
  barycentric[k] = 1.0 - alongNext - alongPrevious;
  return barycentric;
}

//------------------------------------------------------------------------------
Vector3 TriangleShape::fromHalfDisk(const HalfDiskPoint& point) const
{
  const int k = point.Corner;
  CornerSeries series(this->Angles[k], this->Angles[next(k)], this->Angles[previous(k)]);
  const int terms = termsFor(point.LogS.real());
  series.extend(terms);
  return this->place(point, sumSeries(series.Map.data(), terms, point.S));
}

//------------------------------------------------------------------------------
std::complex<double> TriangleShape::derivative(const HalfDiskPoint& point) const
{
  const int k = point.Corner;
  const double a = this->Angles[k], b = this->Angles[next(k)], c = this->Angles[previous(k)];
  return this->Scale *
    expOf(a * Log4 + (a - 1.0) * point.LogS + (2.0 * b - 1.0) * log1p(-point.S) +
      (2.0 * c - 1.0) * log1p(point.S));
}

//------------------------------------------------------------------------------
Eigen::Matrix2d TriangleShape::plane(int corner) const
{
  const double alongPrevious = this->Sines[next(corner)];
  Eigen::Matrix2d plane;
  plane << this->Sines[previous(corner)], alongPrevious * this->Cosines[corner], 0.0,
    alongPrevious * this->Sines[corner];
  return plane;
}

//------------------------------------------------------------------------------
double TriangleShape::dilatation(const TriangleShape& to) const
{
  // The affine map is to.plane(0) this->plane(0)^-1, a product of upper triangular matrices.
  const Eigen::Matrix2d from = this->plane(0), image = to.plane(0);
  const double x = image(0, 0) / from(0, 0), y = image(1, 1) / from(1, 1),
               shear = (image(0, 1) - x * from(0, 1)) / from(1, 1);
  const double mean = 0.5 * (x * x + y * y + shear * shear) / (x * y);
  return mean + std::sqrt(std::max(0.0, mean * mean - 1.0));
}

//------------------------------------------------------------------------------
Eigen::Matrix3d TriangleShape::mapDerivative(
  const TriangleShape& to, const HalfDiskPoint& point) const
{
  const int k = point.Corner;
  // The quotient of the two derivatives, products of powers, is evaluated as one product.
  const Complex factor = to.Scale / this->Scale *
    expOf((to.Angles[k] - this->Angles[k]) * (point.LogS + Log4) +
      2.0 * (to.Angles[next(k)] - this->Angles[next(k)]) * log1p(-point.S) +
      2.0 * (to.Angles[previous(k)] - this->Angles[previous(k)]) * log1p(point.S));
  Eigen::Matrix2d turn;
  turn << factor.real(), -factor.imag(), factor.imag(), factor.real();
  const Eigen::Matrix2d map = upperTriangularSolve(to.plane(k), turn * this->plane(k));
  Eigen::Matrix3d derivative = Eigen::Matrix3d::Zero();
  const std::array<int, 2> others{ next(k), previous(k) };
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      derivative(others[i], others[j]) = map(i, j);
    }
    derivative(k, others[i]) = -map.col(i).sum();
  }
  return derivative;
}
}

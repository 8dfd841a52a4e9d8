#include "SchwarzChristoffel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace conformal
{
namespace
{
using Complex = std::complex<double>;

constexpr double Pi = 3.14159265358979323846;
constexpr double Log4 = 1.38629436111989061883;
constexpr double SmallestAngle = 1e-9;   // radians; needles beyond carry no shape in doubles
constexpr double LogEpsilon = -39.0;     // e^-39 = 1e-17
constexpr double LargestLogS = -1.09861; // |s| < 1/3, a little beyond the farthest point's 0.268
constexpr int MaximumTerms = 36;         // an even number, enough for |s| = 1/3

int next(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}

int previous(int corner)
{
  return corner == 0 ? 2 : corner - 1;
}

/// exp, exactly real on the edges of the half disk.
Complex expOf(const Complex& logarithm)
{
  const double size = std::exp(logarithm.real());
  if (logarithm.imag() == 0.0)
  {
    return { size, 0.0 };
  }
  if (logarithm.imag() == Pi)
  {
    return { -size, 0.0 };
  }
  return { size * std::cos(logarithm.imag()), size * std::sin(logarithm.imag()) };
}

/// log(1 + x) with all digits for small x.
Complex log1p(const Complex& x)
{
  return { 0.5 * std::log1p(x.real() * (2.0 + x.real()) + x.imag() * x.imag()),
    std::atan2(x.imag(), 1.0 + x.real()) };
}

Complex times(const Complex& a, const Complex& b)
{
  return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
}

Complex over(const Complex& a, const Complex& b)
{
  const double square = std::norm(b);
  return { (a.real() * b.real() + a.imag() * b.imag()) / square,
    (a.imag() * b.real() - a.real() * b.imag()) / square };
}

/// Terms, an even number, that a series with coefficients of order 1 needs for all digits.
int termsFor(double logS)
{
  return logS > LogEpsilon / MaximumTerms ? MaximumTerms
                                          : 2 * (static_cast<int>(LogEpsilon / logS) / 2 + 1);
}

/// coefficients[0] s + coefficients[1] s^2 + ..., an even number of real coefficients: even and odd
/// powers as two independent recurrences in s^2, real arithmetic within.
Complex sumSeries(const double* coefficients, int terms, const Complex& s)
{
  const Complex x = times(s, s);
  const double p = 2.0 * x.real(), q = std::norm(x);
  const int pairs = terms / 2;
  double odd1 = 0.0, odd2 = 0.0, even1 = 0.0, even2 = 0.0;
  for (int i = pairs - 1; i > 0; --i)
  {
    const double odd = coefficients[2 * i] - q * odd2 + p * odd1;
    const double even = coefficients[2 * i + 1] - q * even2 + p * even1;
    odd2 = odd1;
    odd1 = odd;
    even2 = even1;
    even1 = even;
  }
  const Complex odd(coefficients[0] - q * odd2 + x.real() * odd1, x.imag() * odd1);
  const Complex even(coefficients[1] - q * even2 + x.real() * even1, x.imag() * even1);
  return times(s, odd) + times(x, even);
}

/// The series of one corner. With f(s) = (1-s)^(2b-1) (1+s)^(2c-1) = sum d_n s^n, d_0 = 1, the map
/// is z = (k/a) (4s)^a (1 + sum_{n>0} a d_n/(n+a) s^n).
class CornerSeries
{
public:
  CornerSeries(double a, double b, double c)
    : A(a)
    , Twist(2.0 * (c - b))
  {
  }

  /// Have at least so many terms.
  void extend(int terms)
  {
    for (; this->Terms < terms; ++this->Terms)
    {
      // (1 - s^2) f' = (2 (c - b) + 2 a s) f
      const int n = this->Terms;
      const double d =
        (this->Twist * this->Last + (n - 1 + 2.0 * this->A) * this->BeforeLast) / (n + 1.0);
      this->Slope[n] = d;
      this->Map[n] = this->A * d / (n + 1.0 + this->A);
      this->BeforeLast = this->Last;
      this->Last = d;
    }
  }

  /// log s for a given log W, W = (1 + sum)^(1/a) s. W = s / (1 - g s + q s^2) agrees up to s^3 and
  /// is W for the extremes among univalent functions, so this is near everywhere.
  Complex guess(const Complex& logUniform)
  {
    this->extend(2);
    const double g = this->Map[0] / this->A;
    const double q = 0.5 * (1.0 + this->A) * g * g - this->Map[1] / this->A;
    const Complex w = expOf(logUniform);
    const Complex half = 1.0 + g * w;
    const Complex ratio = over(2.0, half + std::sqrt(times(half, half) - 4.0 * q * times(w, w)));
    return logUniform + log1p(ratio - 1.0);
  }

  std::array<double, MaximumTerms> Map{};   // of s^1, s^2, ...
  std::array<double, MaximumTerms> Slope{}; // the same of f

private:
  double A;
  double Twist;
  double Last = 1.0;
  double BeforeLast = 0.0;
  int Terms = 0;
};

/// The same point of the half disk seen from the corner at s = 1 (toNext) or at s = -1.
Complex fromNeighbor(const Complex& s, bool toNext)
{
  // Upper half plane y = 2s / (1 + s^2) has the corners at 0, 1, -1, where a Moebius map turns
  // them.
  const double sign = toNext ? 1.0 : -1.0;
  const Complex one = 1.0 - sign * s;
  const Complex y = over(-sign * times(one, one), 1.0 + 6.0 * sign * s + times(s, s));
  return over(y, 1.0 + std::sqrt(1.0 - times(y, y)));
}

/// log s, with the imaginary part kept in [0, pi].
Complex logOf(const Complex& s)
{
  const double angle = s.imag() > 0.0 ? std::arg(s) : (s.real() < 0.0 ? Pi : 0.0);
  return { std::log(std::abs(s)), angle };
}
}

//------------------------------------------------------------------------------
TriangleShape::TriangleShape(const Vector3& p0, const Vector3& p1, const Vector3& p2)
{
  // Edge k lies opposite to corner k; in units of the longest so that nothing under- or overflows.
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
    if (!(angle > SmallestAngle) || !std::isfinite(angle))
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
// W = (a z / k)^(1/a) / 4 is an analytic and univalent function of s in the whole disk, with
// W = s + ... at 0, since it maps the half disk's diameter to the real axis: Newton's method has
// nothing to get stuck at. This is log W.
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
// The corner that sees a point nearest, first by guess.
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
    if (logS.real() > LargestLogS)
    {
      // Too far for this corner's series: go on from the neighbour on whose side the point lies.
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
    if (size > lastSize && size > 1e-24) // rare, in needles; halving surely descends
    {
      step *= 0.5;
      logS -= step;
      continue;
    }
    lastSize = size;
    step = -over(times(residual, map), slope);
    logS += step;
    if (std::norm(step) < 1e-16) // the error left is of the order of its square
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
NetworkShapes::NetworkShapes(
  const Points& positions, const Triangles& faces, const ParallelFor& parallelFor)
  : Uses(faces.rows())
{
  // Triangles are alike if their squared edges, as shares of the sum, are. Counted from the
  // longest edge, so that turned triangles meet as well. In flat triangles the edges say too little
  // about the angles: each has a shape to itself.
  struct Key
  {
    std::int64_t First, Second;
    bool operator==(const Key& k) const { return First == k.First && Second == k.Second; }
  };
  struct Hash
  {
    std::size_t operator()(const Key& k) const
    {
      return static_cast<std::size_t>(k.First) * 0x9e3779b97f4a7c15u ^
        static_cast<std::size_t>(k.Second);
    }
  };
  const double resolution = 1e12;
  std::vector<Key> keys(faces.rows());
  const Index blockSize = 1024;
  forBlocks(parallelFor, faces.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        Vector3 squares;
        for (int k = 0; k < 3; ++k)
        {
          squares[k] =
            (positions.row(faces(r, next(k))) - positions.row(faces(r, previous(k)))).squaredNorm();
        }
        int longest = 0;
        squares.maxCoeff(&longest);
        squares /= squares.sum();
        const double base = squares[longest], second = squares[next(longest)],
                     third = squares[previous(longest)];
        const double height2 = base * second - 0.25 * std::pow(base + second - third, 2);
        const bool isFlat = !(height2 > 0.0025 * base * base);
        this->Uses[r].Rotation = longest;
        keys[r] = isFlat
          ? Key{ -1 - r, 0 }
          : Key{ std::llround(base * resolution), std::llround(second * resolution) };
      }
    });

  std::unordered_map<Key, int, Hash> shapeOfKey;
  std::vector<int> firstUse, numberOfUses;
  for (Index r = 0; r < faces.rows(); ++r)
  {
    const auto [entry, isNew] = shapeOfKey.emplace(keys[r], static_cast<int>(firstUse.size()));
    if (isNew)
    {
      firstUse.push_back(static_cast<int>(r));
      numberOfUses.push_back(0);
    }
    this->Uses[r].Shape = entry->second;
    ++numberOfUses[entry->second];
  }

  const int enoughUses = 8; // tables take as long as mapping a few points without
  this->Shapes.resize(firstUse.size());
  this->TableOfShape.assign(firstUse.size(), -1);
  int numberOfTables = 0;
  for (std::size_t i = 0; i < firstUse.size(); ++i)
  {
    if (numberOfUses[i] >= enoughUses)
    {
      this->TableOfShape[i] = numberOfTables++;
    }
  }
  this->Tables.resize(numberOfTables);
  const Index shapesPerBlock = 16;
  forBlocks(parallelFor, static_cast<Index>(firstUse.size()), shapesPerBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const int r = firstUse[i], rotation = this->Uses[r].Rotation;
        TriangleShape& shape = this->Shapes[i];
        shape = TriangleShape(positions.row(faces(r, rotation)),
          positions.row(faces(r, next(rotation))), positions.row(faces(r, previous(rotation))));
        if (this->TableOfShape[i] >= 0 && !shape.degenerate())
        {
          for (int k = 0; k < 3; ++k)
          {
            this->Tables[this->TableOfShape[i]][k] = makeCornerTable(shape, k);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
// log(s/W) = T(W) solves 1 + W T' = exp(X), X = -a T + (1-2b) log(1-s) + (1-2c) log(1+s),
// s = W exp(T): power series, one coefficient after the other.
NetworkShapes::CornerTable NetworkShapes::makeCornerTable(const TriangleShape& shape, int corner)
{
  const double a = shape.Angles[corner], b = shape.Angles[next(corner)],
               c = shape.Angles[previous(corner)];
  CornerTable table;
  CornerSeries series(a, b, c);
  series.extend(Terms);
  std::copy_n(series.Map.begin(), Terms, table.Series.begin());

  // Derivatives' coefficients: minus[n] of log(1-s), plus[n] of log(1+s), both times n.
  constexpr int N = InverseTerms + 1;
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
  std::copy_n(t.begin() + 1, InverseTerms, table.Inverse.begin());

  // The series converges up to the nearer of the two other corners.
  Vector3 atNext = Vector3::Zero(), atPrevious = Vector3::Zero();
  atNext[next(corner)] = 1.0;
  atPrevious[previous(corner)] = 1.0;
  table.Limit =
    std::min(shape.logUniform(corner, atNext).real(), shape.logUniform(corner, atPrevious).real()) +
    LogEpsilon / InverseTerms * 0.9;
  return table;
}

//------------------------------------------------------------------------------
HalfDiskPoint NetworkShapes::toHalfDisk(Index triangle, const Vector3& barycentric) const
{
  const Use& use = this->Uses[triangle];
  const TriangleShape& shape = this->Shapes[use.Shape];
  const int table = this->TableOfShape[use.Shape];
  Vector3 turned;
  for (int k = 0; k < 3; ++k)
  {
    turned[k] = std::max(0.0, barycentric[(k + use.Rotation) % 3]);
  }
  HalfDiskPoint point;
  Complex logUniform;
  point.Corner = shape.corner(turned, logUniform);
  const CornerTable* series = table < 0 ? nullptr : &this->Tables[table][point.Corner];
  if (series && logUniform.real() < series->Limit)
  {
    const Complex w = expOf(logUniform);
    point.LogS = logUniform + sumSeries(series->Inverse.data(), InverseTerms, w);
    point.S = expOf(point.LogS);
  }
  else
  {
    point = shape.solve(point.Corner, logUniform, turned);
  }
  point.Corner = (point.Corner + use.Rotation) % 3;
  return point;
}

//------------------------------------------------------------------------------
Vector3 NetworkShapes::fromHalfDisk(Index triangle, const HalfDiskPoint& point) const
{
  const Use& use = this->Uses[triangle];
  const TriangleShape& shape = this->Shapes[use.Shape];
  const int table = this->TableOfShape[use.Shape];
  HalfDiskPoint turned = point;
  turned.Corner = (point.Corner + 3 - use.Rotation) % 3;
  const int terms = std::min(Terms, termsFor(point.LogS.real()));
  const Vector3 placed = table < 0
    ? shape.fromHalfDisk(turned)
    : shape.place(
        turned, sumSeries(this->Tables[table][turned.Corner].Series.data(), terms, point.S));
  Vector3 barycentric;
  for (int k = 0; k < 3; ++k)
  {
    barycentric[(k + use.Rotation) % 3] = placed[k];
  }
  return barycentric;
}

//------------------------------------------------------------------------------
Vector3 NetworkShapes::toModel(
  Index triangle, const TriangleShape& model, const Vector3& barycentric) const
{
  return model.degenerate() || this->degenerate(triangle)
    ? barycentric
    : model.fromHalfDisk(this->toHalfDisk(triangle, barycentric));
}

//------------------------------------------------------------------------------
Vector3 NetworkShapes::toNetwork(
  Index triangle, const TriangleShape& model, const Vector3& barycentric) const
{
  return model.degenerate() || this->degenerate(triangle)
    ? barycentric
    : this->fromHalfDisk(triangle, model.toHalfDisk(barycentric));
}
}

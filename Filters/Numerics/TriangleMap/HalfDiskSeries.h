/// Evaluate the conformal map of a triangle near a corner by power series. The map is defined on
/// the upper half of the unit disk. The complex coordinate s of this half disk is defined at the
/// beginning of SchwarzChristoffel.h. The integrand of \cite Liou2008 Eqs. 4 and 5 is expanded in
/// powers of s, at the image s = 0 of the corner. The series is our own construction: it converges
/// for triangles of any shape.

#ifndef ConformalHalfDiskSeries_h
#define ConformalHalfDiskSeries_h

#include "Base/Types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace conformal
{
namespace halfdisk
{
using Complex = std::complex<double>;

constexpr double Log4 = 1.38629436111989061883;
constexpr double LogEpsilon = -39.0; // smaller terms, below e^-39 = 1e-17, are neglected
// log(1/3). For every point, a corner can be mapped to s = 0 so that |s| <= 0.268. The bound 1/3
// adds a small margin.
constexpr double MaximumLogS = -1.09861;
constexpr int MaximumTerms = 36; // even; |s|^36 < 1e-17 for |s| < 1/3

/// Compute the exponential function of a logarithm. If the imaginary part is 0 or pi, the result is
/// exactly real. These imaginary parts occur at points on the diameter of the half disk.
inline Complex expOf(const Complex& logarithm)
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

/// Compute log(1 + x) to full precision for small x.
inline Complex log1p(const Complex& x)
{
  return { 0.5 * std::log1p(x.real() * (2.0 + x.real()) + x.imag() * x.imag()),
    std::atan2(x.imag(), 1.0 + x.real()) };
}

inline Complex times(const Complex& a, const Complex& b)
{
  return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
}

inline Complex over(const Complex& a, const Complex& b)
{
  const double square = std::norm(b);
  return { (a.real() * b.real() + a.imag() * b.imag()) / square,
    (a.imag() * b.real() - a.real() * b.imag()) / square };
}

/// Return the number of terms that a power series in s needs for full precision. The argument logS
/// is log |s|. The returned number is even. The coefficients of the series are assumed to have
/// magnitudes near 1.
inline int termsFor(double logS)
{
  return logS > LogEpsilon / MaximumTerms ? MaximumTerms
                                          : 2 * (static_cast<int>(LogEpsilon / logS) / 2 + 1);
}

/// Sum the series coefficients[0] s + coefficients[1] s^2 + ... for an even number of real
/// coefficients. Even and odd powers are summed by two independent recurrences in s^2, in real
/// arithmetic.
inline Complex sumSeries(const double* coefficients, int terms, const Complex& s)
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

/// Sum the series coefficients[0] s + coefficients[1] s^2 + ... for real s.
inline double sumSeries(const double* coefficients, int terms, double s)
{
  const double x = s * s;
  double odd = 0.0, even = 0.0;
  for (int i = terms - 2; i >= 0; i -= 2)
  {
    odd = odd * x + coefficients[i];
    even = even * x + coefficients[i + 1];
  }
  return s * (odd + s * even);
}

/// Table of 1, 1/2, 1/3, ...
inline constexpr auto Reciprocals = []()
{
  std::array<double, MaximumTerms> result{};
  for (int n = 0; n < MaximumTerms; ++n)
  {
    result[n] = 1.0 / (n + 1.0);
  }
  return result;
}();

/// Power series of the conformal map at one corner of a triangle. Let a be the angle of this
/// corner, in units of pi. Let b be the angle of the next corner, and c the angle of the previous
/// corner. Let s be the coordinate of the half disk that is 0 at this corner. Let D be the diameter
/// of the circumcircle. With
///     k = pi D / (Gamma(a) Gamma(b) Gamma(c)),
///     f(s) = (1-s)^(2b-1) (1+s)^(2c-1) = sum d_n s^n,   where d_0 = 1,
/// the map to the plane of the triangle is
///     z = (k/a) (4s)^a (1 + sum_{n>0} a d_n/(n+a) s^n).
class CornerSeries
{
public:
  CornerSeries() = default;
  CornerSeries(double a, double b, double c)
    : A(a)
    , Twist(2.0 * (c - b))
  {
  }

  /// Compute further coefficients, until Map and Slope have `terms` coefficients each.
  void extend(int terms)
  {
    for (; this->Terms < terms; ++this->Terms)
    {
      // The recurrence follows from (1 - s^2) f' = (2 (c - b) + 2 a s) f.
      const int n = this->Terms;
      const double d =
        (this->Twist * this->Last + (n - 1 + 2.0 * this->A) * this->BeforeLast) * Reciprocals[n];
      this->Slope[n] = d;
      this->Map[n] = this->A * d / (n + 1.0 + this->A);
      this->BeforeLast = this->Last;
      this->Last = d;
    }
  }

  /// Approximate log s for given log W, as a starting value of Newton's method. Here
  /// W = (1 + sum)^(1/a) s, with the sum over n > 0 in the comment of this class. The approximation
  /// is W(s) = s / (1 - g s + q s^2). The constants g and q are chosen so that the approximation is
  /// exact up to s^3. The approximation is also exact for the extremal univalent functions (the
  /// most distorted one-to-one maps). Since all other maps are less distorted, the approximation is
  /// accurate for triangles of any shape.
  Complex guess(const Complex& logUniform)
  {
    const auto [g, q] = this->leading();
    const Complex w = expOf(logUniform);
    const Complex half = 1.0 + g * w;
    const Complex ratio = over(2.0, half + std::sqrt(times(half, half) - 4.0 * q * times(w, w)));
    return logUniform + log1p(ratio - 1.0);
  }

  /// Approximate s for a given real number W, positive or negative. The formula is the same as in
  /// guess() for complex numbers.
  double guess(double w)
  {
    const auto [g, q] = this->leading();
    const double half = 1.0 + g * w;
    return 2.0 * w / (half + std::sqrt(std::max(0.0, half * half - 4.0 * q * w * w)));
  }

  /// Compute the derivative d log f / d log s.
  double bend(double s) const { return s * (this->Twist + 2.0 * this->A * s) / (1.0 - s * s); }

  std::array<double, MaximumTerms> Map;   // coefficients of s^1, s^2, ... in the sum of z
  std::array<double, MaximumTerms> Slope; // coefficients of s^1, s^2, ... in f

private:
  struct Leading
  {
    double G, Q;
  };
  Leading leading()
  {
    this->extend(2);
    const double g = this->Map[0] / this->A;
    return { g, 0.5 * (1.0 + this->A) * g * g - this->Map[1] / this->A };
  }

  double A = 0.0;
  double Twist = 0.0;
  double Last = 1.0;
  double BeforeLast = 0.0;
  int Terms = 0;
};
}
}

#endif

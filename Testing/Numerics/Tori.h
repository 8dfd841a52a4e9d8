/// Make surfaces of genus 1 whose moduli are known, for tests of the core.

#ifndef ConformalTestTori_h
#define ConformalTestTori_h

#include "Mesh/Mesh.h"
#include "TorusMap/FlatTorus.h"

#include <cmath>
#include <complex>
#include <functional>

namespace tori
{
/// Build a surface of genus 1 from a grid of `along` by `around` quadrilaterals, each divided into
/// two triangles.
/// @param[in] position  position for two periodic parameters in [0, 1)
inline conformal::Mesh gridTorus(
  int along, int around, const std::function<conformal::Vector3(double, double)>& position)
{
  conformal::Mesh mesh;
  mesh.Positions.resize(static_cast<conformal::Index>(along) * around, 3);
  mesh.Triangles.resize(2 * mesh.Positions.rows(), 3);
  const auto id = [=](int i, int j) { return (i % along) * around + j % around; };
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const int a = id(i, j);
      mesh.Positions.row(a) =
        position(static_cast<double>(i) / along, static_cast<double>(j) / around);
      mesh.Triangles.row(2 * a) << a, id(i + 1, j), id(i + 1, j + 1);
      mesh.Triangles.row(2 * a + 1) << a, id(i + 1, j + 1), id(i, j + 1);
    }
  }
  return mesh;
}

/// Position on a torus of revolution with major radius 1, for the angles 2 pi s around the axis and
/// 2 pi t around the tube.
inline conformal::Vector3 onRevolution(double radius, double s, double t)
{
  const double a = 2.0 * conformal::Pi * s, b = 2.0 * conformal::Pi * t,
               r = 1.0 + radius * std::cos(b);
  return { r * std::cos(a), r * std::sin(a), radius * std::sin(b) };
}

/// Modulus of a torus of revolution with radii R = 1 and r: i sqrt(R^2 - r^2) / r, or the inverse
/// ratio if it is smaller than 1.
inline std::complex<double> modulusOfRevolution(double radius)
{
  const double ratio = std::sqrt(1.0 - radius * radius) / radius;
  return { 0.0, std::max(ratio, 1.0 / ratio) };
}

/// Polar angle of a closed curve on the sphere, at a longitude.
inline double polarAngle(double longitude)
{
  return 1.2 + 0.4 * std::sin(3.0 * longitude);
}

/// Position on the Hopf torus of the curve polarAngle(), projected stereographically from the
/// sphere in four dimensions, \cite Pinkall1985.
inline conformal::Vector3 onHopfTorus(double s, double t)
{
  const double longitude = 2.0 * conformal::Pi * s, fiber = 2.0 * conformal::Pi * t,
               half = 0.5 * polarAngle(longitude);
  const conformal::Vector3 first(std::cos(half) * std::cos(fiber + longitude),
    std::cos(half) * std::sin(fiber + longitude), std::sin(half) * std::cos(fiber));
  return first / (1.0 - std::sin(half) * std::sin(fiber));
}

/// Modulus of the Hopf torus. Let L be the length of the curve, and A the area that it encloses.
/// The periods are (2 pi, 0) and (A / 2, L / 2), \cite Pinkall1985 proposition 1.
inline std::complex<double> modulusOfHopfTorus()
{
  constexpr int count = 4096;
  const double step = 2.0 * conformal::Pi / count;
  double length = 0.0, area = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double longitude = (i + 0.5) * step, angle = polarAngle(longitude);
    length += std::hypot(1.2 * std::cos(3.0 * longitude), std::sin(angle)) * step;
    area += (1.0 - std::cos(angle)) * step;
  }
  Eigen::Matrix2d periods;
  periods << 2.0 * conformal::Pi, 0.5 * area, 0.0, 0.5 * length;
  return conformal::reduceBasis(periods.transpose() * periods).Torus.Modulus;
}
}

#endif

#include "Body/MapProjection.h"

#include "Texture/Lemniscate.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace conformal
{
namespace
{
using Complex = std::complex<double>;

const double Sqrt2 = std::sqrt(2.0);

// Rotate the sphere so that the central longitude is at 0.
Vector3 turned(const Vector3& n, double degrees)
{
  const double c = std::cos(degrees * Degree), s = std::sin(degrees * Degree);
  return { c * n[0] + s * n[1], c * n[1] - s * n[0], n[2] };
}

// Compute the angle of Mollweide's map from the pole: 2 t - sin 2 t = 2 pi sin^2(c / 2) for a
// distance c from the pole.
double sweep(double t)
{
  if (t < 0.05)
  {
    const double u = 2.0 * t, square = u * u;
    return u * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0)));
  }
  return 2.0 * t - std::sin(2.0 * t);
}

double mollweideAngle(double sineOfHalf)
{
  const double wanted = 2.0 * Pi * sineOfHalf * sineOfHalf;
  double t = std::min(std::cbrt(0.75 * wanted), 0.5 * Pi);
  constexpr int maximum = 30;
  for (int i = 0; i < maximum && t > 0.0; ++i)
  {
    const double slope = 4.0 * std::sin(t) * std::sin(t);
    const double step = (sweep(t) - wanted) / slope;
    t = std::clamp(t - step, 0.25 * t, 0.5 * Pi);
    if (std::abs(step) <= 1e-16 * t)
    {
      break;
    }
  }
  return t;
}

Vector2 toMollweide(const Vector3& n)
{
  const double radius = std::hypot(n[0], n[1]);
  const double fromPole = std::atan2(radius, std::abs(n[2]));
  const double t = mollweideAngle(std::sin(0.5 * fromPole));
  return { 2.0 * Sqrt2 / Pi * std::atan2(n[1], n[0]) * std::sin(t),
    std::copysign(Sqrt2 * std::cos(t), n[2]) };
}

bool fromMollweide(const Vector2& place, Vector3& n)
{
  const double cosine = std::abs(place[1]) / Sqrt2;
  if (cosine > 1.0)
  {
    return false;
  }
  const double t = std::acos(cosine), width = 2.0 * Sqrt2 * std::sin(t);
  if (std::abs(place[0]) > width)
  {
    return false;
  }
  const double longitude = width > 0.0 ? Pi * place[0] / width : 0.0;
  const double fromPole = 2.0 * std::asin(std::min(1.0, std::sqrt(sweep(t) / (2.0 * Pi))));
  n = { std::sin(fromPole) * std::cos(longitude), std::sin(fromPole) * std::sin(longitude),
    std::copysign(std::cos(fromPole), place[1]) };
  return true;
}

// Project a hemisphere, seen from outside, with its pole at (0, 0). Longitude 0 points down. Two
// hemispheres side by side then touch at one point of the equator.
Vector2 toHemisphere(const Vector3& n)
{
  const double scale = std::sqrt(2.0 / (1.0 + std::abs(n[2])));
  return { n[2] >= 0.0 ? scale * n[1] : -scale * n[1], -scale * n[0] };
}

Vector2 toLambert(const Vector3& n)
{
  return toHemisphere(n) + Vector2(n[2] >= 0.0 ? -Sqrt2 : Sqrt2, 0.0);
}

bool fromLambert(const Vector2& place, Vector3& n)
{
  const bool isNorth = place[0] < 0.0;
  const double x = place[0] + (isNorth ? Sqrt2 : -Sqrt2);
  const Vector2 p = { isNorth ? x : -x, -place[1] };
  const double square = p.squaredNorm();
  constexpr double rim = 2.0 * (1.0 + 1e-15); // the equator belongs to both
  if (square > rim)
  {
    return false;
  }
  const double scale = std::sqrt(1.0 - square / 4.0), z = std::max(0.0, 1.0 - square / 2.0);
  n = Vector3(scale * p[1], scale * p[0], isNorth ? z : -z).normalized();
  return true;
}

// Reflect a position at the nearest side of the diamond: from the northern hemisphere to the
// southern, or back.
Complex mirrored(const Complex& z)
{
  const double half = HalfLemniscate;
  return { std::copysign(half - std::abs(z.imag()), z.real()),
    std::copysign(half - std::abs(z.real()), z.imag()) };
}

// The stereographic hemisphere of the nearer pole is a disk, which the arcsine maps to a diamond.
// The disk has half the scale of the sphere at the pole.
Vector2 toPeirce(const Vector3& n)
{
  Complex disk = Complex(n[1], -n[0]) / (1.0 + std::abs(n[2]));
  const double radius = std::abs(disk);
  disk = radius > 1.0 ? disk / radius : disk;
  Complex z = lemniscateArcsine(disk);
  z = n[2] >= 0.0 ? z : mirrored(z);
  return { 2.0 * z.real(), 2.0 * z.imag() };
}

bool fromPeirce(const Vector2& place, Vector3& n)
{
  const double half = HalfLemniscate;
  if (place.cwiseAbs().maxCoeff() > 2.0 * half)
  {
    return false;
  }
  const Complex z(0.5 * place[0], 0.5 * place[1]);
  const bool isNorth = std::abs(z.real()) + std::abs(z.imag()) <= half;
  const Complex disk = lemniscateSine(isNorth ? z : mirrored(z));
  const double square = std::norm(disk);
  const double height = std::max(0.0, 1.0 - square);
  n = Vector3(-2.0 * disk.imag(), 2.0 * disk.real(), isNorth ? height : -height).normalized();
  return true;
}

// Tangent of half the angle of a direction from the nearer pole, on the sphere. Near the pole, it
// has all digits.
double halfTangent(const Vector3& n)
{
  return std::hypot(n[0], n[1]) / (1.0 + std::abs(n[2]));
}

// The isometric latitude of the sphere is -log(halfTangent). On the cylinder, it is the height. On
// a hemisphere, whose isometric latitude begins at 0, the half tangent is exp(half) times as large.
Vector2 toCapsule(const Vector3& n, double half)
{
  const double onCap = std::exp(half) * halfTangent(n), longitude = std::atan2(n[1], n[0]);
  if (onCap >= 1.0)
  {
    return { longitude, std::asinh(n[2] / std::hypot(n[0], n[1])) };
  }
  const double radius = 2.0 * onCap / std::sqrt(1.0 + onCap * onCap), middle = half + Sqrt2;
  return { radius * std::sin(longitude),
    std::copysign(middle - radius * std::cos(longitude), n[2]) };
}

bool fromCapsule(const Vector2& place, double half, Vector3& n)
{
  if (std::abs(place[1]) < half)
  {
    n = Vector3(std::cos(place[0]), std::sin(place[0]), std::sinh(place[1])) / std::cosh(place[1]);
    return std::abs(place[0]) <= Pi;
  }
  const Vector2 p(place[0], half + Sqrt2 - std::abs(place[1])); // longitude 0 points along y
  const double square = 0.25 * p.squaredNorm();
  constexpr double rim = 0.5 * (1.0 + 1e-15); // the end of the cylinder belongs to both
  if (square > rim)
  {
    return false;
  }
  const double onCap = std::sqrt(square / (1.0 - square)), tangent = std::exp(-half) * onCap;
  const double scale = 2.0 * tangent / (1.0 + tangent * tangent);
  const Vector2 across = square > 0.0 ? Vector2(scale * p.normalized()) : Vector2(0.0, 0.0);
  n = { across[1], across[0],
    std::copysign((1.0 - tangent * tangent) / (1.0 + tangent * tangent), place[1]) };
  return true;
}
}

//------------------------------------------------------------------------------
double capsuleScale(const Vector3& n, MapProjection projection, double capsuleAspect)
{
  if (projection != MapProjection::Capsule)
  {
    return 1.0;
  }
  const double tangent = std::max(halfTangent(n), std::exp(-2.0 * MaximumCapsuleAspect));
  const double onCap = std::min(std::exp(capsuleAspect - 1.0) * tangent, 1.0);
  const double radiusOfCapsule = 2.0 * onCap / (1.0 + onCap * onCap);
  return radiusOfCapsule / (2.0 * tangent / (1.0 + tangent * tangent));
}

//------------------------------------------------------------------------------
Vector2 halfSizeOfMap(MapProjection projection, double capsuleAspect)
{
  switch (projection)
  {
    case MapProjection::Equirectangular:
      return { 180.0, 90.0 };
    case MapProjection::PeirceQuincuncial:
      return { 2.0 * HalfLemniscate, 2.0 * HalfLemniscate };
    case MapProjection::Mercator:
      return { Pi, Pi };
    case MapProjection::Capsule:
      return { Pi, capsuleAspect - 1.0 + 2.0 * Sqrt2 };
    default:
      return { 2.0 * Sqrt2, Sqrt2 };
  }
}

//------------------------------------------------------------------------------
Vector2 sphereToMap(
  const Vector3& direction, MapProjection projection, double centralLongitude, double capsuleAspect)
{
  const Vector3 n = turned(direction, centralLongitude);
  switch (projection)
  {
    case MapProjection::LambertAzimuthal:
      return toLambert(n);
    case MapProjection::Mollweide:
      return toMollweide(n);
    case MapProjection::PeirceQuincuncial:
      return toPeirce(n);
    case MapProjection::Mercator:
      return { std::atan2(n[1], n[0]),
        std::clamp(std::asinh(n[2] / std::hypot(n[0], n[1])), -Pi, Pi) };
    case MapProjection::Capsule:
      return toCapsule(n, capsuleAspect - 1.0);
    default:
      return Vector2(std::atan2(n[1], n[0]), std::atan2(n[2], std::hypot(n[0], n[1]))) / Degree;
  }
}

//------------------------------------------------------------------------------
bool mapToSphere(const Vector2& place, MapProjection projection, double centralLongitude,
  Vector3& direction, double capsuleAspect)
{
  Vector3 n;
  bool isOnMap = false;
  switch (projection)
  {
    case MapProjection::LambertAzimuthal:
      isOnMap = fromLambert(place, n);
      break;
    case MapProjection::Mollweide:
      isOnMap = fromMollweide(place, n);
      break;
    case MapProjection::PeirceQuincuncial:
      isOnMap = fromPeirce(place, n);
      break;
    case MapProjection::Mercator:
      isOnMap = place.cwiseAbs().maxCoeff() <= Pi;
      n =
        Vector3(std::cos(place[0]), std::sin(place[0]), std::sinh(place[1])) / std::cosh(place[1]);
      break;
    case MapProjection::Capsule:
      isOnMap = fromCapsule(place, capsuleAspect - 1.0, n);
      break;
    default:
    {
      const double longitude = place[0] * Degree, latitude = place[1] * Degree;
      isOnMap = std::abs(place[0]) <= 180.0 && std::abs(place[1]) <= 90.0;
      n = { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
        std::sin(latitude) };
      break;
    }
  }
  if (isOnMap)
  {
    direction = turned(n, -centralLongitude);
  }
  return isOnMap;
}
}

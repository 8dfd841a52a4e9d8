#include "Texture/SphereProjection.h"

#include "Texture/Lemniscate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace conformal
{
namespace
{

// Substitute for infinity. Its square is finite.
constexpr double FarAway = 1e100;

constexpr int NumberOfLunes = 8;
const double LuneAngle = 2.0 * Pi / NumberOfLunes;

// Return (right, up, towards the viewer), of unit length.
Vector3 inView(const Vector3& n, const SphereView& view)
{
  return Vector3(n.dot(view.Right), n.dot(view.Up), n.dot(view.Pole)).normalized();
}

Vector3 fromView(const Vector3& m, const SphereView& view)
{
  return (m[0] * view.Right + m[1] * view.Up + m[2] * view.Pole).normalized();
}

Vector2 planeOf(const Vector3& m)
{
  const Vector2 w = m.head<2>();
  if (m[2] >= 0.0)
  {
    return w / (1.0 + m[2]);
  }
  // 1 + z loses all digits near the opposite pole; it equals |w|^2 / (1 - z).
  const double square = w.squaredNorm();
  return square * FarAway > 1.0 ? Vector2(w * ((1.0 - m[2]) / square)) : Vector2(FarAway, 0.0);
}

// Half the side of the image in the stereographic plane.
double halfSide(const SphereImage& image)
{
  return std::tan(0.25 * image.FieldOfView * Degree);
}

//------------------------------------------------------------------------------
// Stereographic: patch 0 is the maximum field of view. Patch 1 is the rest, where a triangle may
// contain more than the whole image.
int stereographicPatch(const Vector3& m)
{
  return m[2] >= std::cos(0.5 * MaximumFieldOfView * Degree) ? 0 : 1;
}

Vector2 stereographic(const Vector3& m, const SphereImage& image, int patch)
{
  const Vector2 w = patch == 0 ? planeOf(m) : Vector2(FarAway, 0.0);
  return Vector2::Constant(0.5) + 0.5 / halfSide(image) * w;
}

//------------------------------------------------------------------------------
// Longitude and latitude: patches are lunes, narrow enough that a triangle with a corner on the
// axis bends little.
int lunePatch(const Vector3& m)
{
  const double longitude = std::atan2(m[0], m[2]);
  return std::clamp(
    static_cast<int>(std::floor((longitude + Pi) / LuneAngle)), 0, NumberOfLunes - 1);
}

Vector2 longitudeLatitude(const Vector3& m, int patch)
{
  const double across = std::hypot(m[0], m[2]);
  const double middle = (patch + 0.5) * LuneAngle - Pi;
  // On the axis all longitudes are valid; the middle one bends a triangle the least.
  const double offset = across > 1e-9
    ? std::clamp(std::remainder(std::atan2(m[0], m[2]) - middle, 2.0 * Pi), -0.5 * LuneAngle,
        0.5 * LuneAngle)
    : 0.0;
  return { 0.5 + (middle + offset) / (2.0 * Pi), 0.5 + std::atan2(m[1], across) / Pi };
}

//------------------------------------------------------------------------------
// Octahedral: patches are octants, by the signs of x, y and z.
int octantPatch(const Vector3& m)
{
  return (m[0] < 0.0 ? 1 : 0) + (m[1] < 0.0 ? 2 : 0) + (m[2] < 0.0 ? 4 : 0);
}

Vector3 octantSigns(int patch)
{
  return { patch & 1 ? -1.0 : 1.0, patch & 2 ? -1.0 : 1.0, patch & 4 ? -1.0 : 1.0 };
}

Vector2 octahedral(const Vector3& m, const SphereImage& image, int patch)
{
  const Vector3 signs = octantSigns(patch);
  Vector3 p = signs.cwiseProduct(m).cwiseMax(0.0);
  const double sum = p.sum();
  p = sum > 0.0 ? Vector3(p / sum) : Vector3::Constant(1.0 / 3.0); // center of the octant
  const Vector2 folded = patch & 4 ? Vector2(1.0 - p[1], 1.0 - p[0]) : Vector2(p[0], p[1]);
  return Vector2::Constant(0.5) + (0.5 - image.Margin) * signs.head<2>().cwiseProduct(folded);
}

Vector3 fromOctahedral(const Vector2& st, const SphereImage& image)
{
  Vector2 q = (st - Vector2::Constant(0.5)) / (0.5 - image.Margin);
  for (int k = 0; k < 2; ++k)
  {
    if (std::abs(q[k]) > 1.0) // beyond a seam, the same edge of the square rotated by 180 degrees
    {
      q[k] = (q[k] > 0.0 ? 2.0 : -2.0) - q[k];
      q[1 - k] = -q[1 - k];
    }
  }
  const Vector2 size = q.cwiseAbs();
  const double z = 1.0 - size.sum();
  if (z < 0.0)
  {
    q = Vector2(q[0] < 0.0 ? -1.0 : 1.0, q[1] < 0.0 ? -1.0 : 1.0)
          .cwiseProduct(Vector2(1.0 - size[1], 1.0 - size[0]));
  }
  return { q[0], q[1], z };
}

//------------------------------------------------------------------------------
// Cube: the faces of each row are connected, left to right.
struct CubeFace
{
  Vector3 Right, Up, Outward;
};

const std::array<CubeFace, 6>& cubeFaces()
{
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  static const std::array<CubeFace, 6> faces = { {
    { z, y, -x },  // left
    { x, y, z },   // front
    { -z, y, x },  // right
    { -z, x, -y }, // below
    { y, x, -z },  // back
    { z, x, y },   // above
  } };
  return faces;
}

int facePatch(const Vector3& m)
{
  Index axis = 0;
  m.cwiseAbs().maxCoeff(&axis);
  constexpr int positive[] = { 2, 5, 1 }, negative[] = { 0, 3, 4 };
  return m[axis] < 0.0 ? negative[axis] : positive[axis];
}

Vector2 cube(const Vector3& m, const SphereImage& image, int patch)
{
  const CubeFace& face = cubeFaces()[patch];
  const double outward = m.dot(face.Outward);
  Vector2 q(m.dot(face.Right), m.dot(face.Up));
  q = outward > 0.0 ? Vector2(q / outward) : Vector2::Zero(); // center of the face
  const Vector2 inFace =
    Vector2::Constant(0.5) + (0.5 - image.Margin) * q.cwiseMax(-1.0).cwiseMin(1.0);
  const int column = patch % 3, row = patch / 3;
  return { (column + inFace[0]) / 3.0, (1 - row + inFace[1]) / 2.0 };
}

Vector3 fromCube(const Vector2& st, const SphereImage& image)
{
  const double column = std::clamp(std::floor(3.0 * st[0]), 0.0, 2.0);
  const double row = std::clamp(std::floor(2.0 * st[1]), 0.0, 1.0);
  const Vector2 inFace(3.0 * st[0] - column, 2.0 * st[1] - row);
  const Vector2 q = (inFace - Vector2::Constant(0.5)) / (0.5 - image.Margin);
  const CubeFace& face = cubeFaces()[static_cast<int>(column + 3.0 * (1.0 - row))];
  return face.Outward + q[0] * face.Right + q[1] * face.Up;
}

//------------------------------------------------------------------------------
// Disk and square: patch 0 is the hemisphere z >= 0, with what rounding adds. Patch 1 is the rest,
// which is not in the image.
constexpr double BelowBorder = 1e-6; // height

int hemispherePatch(const Vector3& n)
{
  return n[2] >= -BelowBorder ? 0 : 1;
}

using Complex = std::complex<double>;

// Rotation by 45 degrees: the sides of the square are parallel to the axes of the image.
const Complex& eighthTurn()
{
  static const Complex turn = std::sqrt(Complex(0.0, 1.0));
  return turn;
}

Vector2 squareOf(const Vector2& disk)
{
  Complex w = Complex(disk[0], disk[1]) * std::conj(eighthTurn());
  const double radius = std::abs(w);
  w = radius > 1.0 ? w / radius : w;
  w = lemniscateArcsine(w) * eighthTurn() / (std::sqrt(0.5) * HalfLemniscate);
  return 0.5 * Vector2(1.0 + w.real(), 1.0 + w.imag());
}

// The border is a mirror: the image beyond a side is that before it.
Vector2 diskOf(const Vector2& st)
{
  Vector2 q = 2.0 * st - Vector2::Ones();
  for (int k = 0; k < 2; ++k)
  {
    q[k] = std::abs(q[k]) > 1.0 ? std::copysign(2.0 - std::min(std::abs(q[k]), 2.0), q[k]) : q[k];
  }
  const Complex z = Complex(q[0], q[1]) * std::conj(eighthTurn()) * std::sqrt(0.5) * HalfLemniscate;
  const Complex w = lemniscateSine(z) * eighthTurn();
  return { w.real(), w.imag() };
}

Vector2 hemisphere(const Vector3& n, SphereProjection projection, int patch)
{
  if (patch == 1)
  {
    return Vector2(FarAway, 0.0);
  }
  const double length = n.norm();
  const Vector2 w = length > 0.0 ? planeOf(n / length) : Vector2(0.0, 0.0);
  const Vector2 st =
    projection == SphereProjection::Disk ? Vector2(0.5 * (Vector2::Ones() + w)) : squareOf(w);
  return st.cwiseMax(0.0).cwiseMin(1.0); // rounding may move the border out of the image
}

Vector3 fromHemisphere(const Vector2& st, SphereProjection projection)
{
  const Vector2 w =
    projection == SphereProjection::Disk ? Vector2(2.0 * st - Vector2::Ones()) : diskOf(st);
  const double square = w.squaredNorm();
  return Vector3(2.0 * w[0], 2.0 * w[1], std::abs(1.0 - square)).normalized();
}

//------------------------------------------------------------------------------
using Borders = std::vector<Eigen::Vector4d>; // borders of a patch in the frame of the viewer

Vector2 unscaled(const Vector3& m, const SphereImage& image, int patch)
{
  switch (image.Projection)
  {
    case SphereProjection::LongitudeLatitude:
      return longitudeLatitude(m, patch);
    case SphereProjection::Octahedral:
      return octahedral(m, image, patch);
    case SphereProjection::CubeMap:
      return cube(m, image, patch);
    default:
      return stereographic(m, image, patch);
  }
}

std::vector<Borders> bordersInView(SphereProjection projection)
{
  std::vector<Borders> result;
  const auto through = [](const Vector3& inward)
  { return Eigen::Vector4d(inward[0], inward[1], inward[2], 0.0); };
  switch (projection)
  {
    case SphereProjection::LongitudeLatitude:
      for (int k = 0; k < NumberOfLunes; ++k)
      {
        const double from = k * LuneAngle - Pi, to = from + LuneAngle;
        result.push_back({ through({ std::cos(from), 0.0, -std::sin(from) }),
          through({ -std::cos(to), 0.0, std::sin(to) }) });
      }
      break;
    case SphereProjection::Octahedral:
      for (int k = 0; k < 8; ++k)
      {
        const Vector3 signs = octantSigns(k);
        result.push_back({ through({ signs[0], 0.0, 0.0 }), through({ 0.0, signs[1], 0.0 }),
          through({ 0.0, 0.0, signs[2] }) });
      }
      break;
    case SphereProjection::CubeMap:
      for (const CubeFace& face : cubeFaces())
      {
        result.push_back({ through(face.Outward + face.Right), through(face.Outward - face.Right),
          through(face.Outward + face.Up), through(face.Outward - face.Up) });
      }
      break;
    case SphereProjection::Disk:
    case SphereProjection::Square:
    {
      const Eigen::Vector4d border(0.0, 0.0, 1.0, BelowBorder);
      result = { { border }, { -border } };
      break;
    }
    default:
    {
      const Eigen::Vector4d farthest(0.0, 0.0, 1.0, -std::cos(0.5 * MaximumFieldOfView * Degree));
      result = { { farthest }, { -farthest } };
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
bool isHemisphere(SphereProjection projection)
{
  return projection == SphereProjection::Disk || projection == SphereProjection::Square;
}

//------------------------------------------------------------------------------
Vector2 stereographicPlane(const Vector3& n, const SphereView& view)
{
  return planeOf(inView(n, view));
}

//------------------------------------------------------------------------------
int patchOf(const Vector3& n, const SphereImage& image)
{
  if (isHemisphere(image.Projection))
  {
    return hemispherePatch(n.normalized());
  }
  const Vector3 m = inView(n, image.View);
  switch (image.Projection)
  {
    case SphereProjection::LongitudeLatitude:
      return lunePatch(m);
    case SphereProjection::Octahedral:
      return octantPatch(m);
    case SphereProjection::CubeMap:
      return facePatch(m);
    default:
      return stereographicPatch(m);
  }
}

//------------------------------------------------------------------------------
Vector2 patchToTexture(const Vector3& n, const SphereImage& image, int patch)
{
  const Vector2 middle = Vector2::Constant(0.5);
  const Vector2 st = isHemisphere(image.Projection) ? hemisphere(n, image.Projection, patch)
                                                    : unscaled(inView(n, image.View), image, patch);
  return middle + (st - middle).cwiseQuotient(image.Scale);
}

//------------------------------------------------------------------------------
Vector2 sphereToTexture(const Vector3& n, const SphereImage& image)
{
  // The stereographic projection extends to the opposite pole.
  return patchToTexture(
    n, image, image.Projection == SphereProjection::Stereographic ? 0 : patchOf(n, image));
}

//------------------------------------------------------------------------------
Vector3 textureToSphere(const Vector2& st, const SphereImage& image)
{
  const Vector2 middle = Vector2::Constant(0.5);
  const Vector2 q = (st - middle).cwiseProduct(image.Scale);
  if (isHemisphere(image.Projection))
  {
    return fromHemisphere(middle + q, image.Projection);
  }
  switch (image.Projection)
  {
    case SphereProjection::LongitudeLatitude:
    {
      const double longitude = 2.0 * Pi * q[0], latitude = Pi * q[1];
      return fromView({ std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                        std::cos(latitude) * std::cos(longitude) },
        image.View);
    }
    case SphereProjection::Octahedral:
      return fromView(fromOctahedral(middle + q, image), image.View);
    case SphereProjection::CubeMap:
      return fromView(fromCube(middle + q, image), image.View);
    default:
    {
      const Vector2 w = 2.0 * halfSide(image) * q;
      const double square = w.squaredNorm();
      return fromView(Vector3(2.0 * w[0], 2.0 * w[1], 1.0 - square) / (1.0 + square), image.View);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<SpherePatch> spherePatches(const SphereImage& image)
{
  std::vector<SpherePatch> patches;
  const bool isFixed = isHemisphere(image.Projection);
  for (const Borders& borders : bordersInView(image.Projection))
  {
    SpherePatch patch;
    patch.Borders.resize(static_cast<Index>(borders.size()), 4);
    for (std::size_t i = 0; i < borders.size(); ++i)
    {
      const Vector3 inward = isFixed
        ? Vector3(borders[i].head<3>())
        : Vector3(borders[i][0] * image.View.Right + borders[i][1] * image.View.Up +
            borders[i][2] * image.View.Pole);
      patch.Borders.row(i) << inward.transpose(), borders[i][3];
    }
    patches.push_back(patch);
  }
  if (isFixed || image.Projection == SphereProjection::Stereographic)
  {
    patches[1].InImage = false;
  }
  return patches;
}
}

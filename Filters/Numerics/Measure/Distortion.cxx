#include "Measure/Distortion.h"

#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{

using Corners = std::array<Vector3, 3>;

double areaOf(const Corners& t)
{
  return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
}

double angleAt(const Corners& t, int k)
{
  const Vector3 u = t[next(k)] - t[k], v = t[previous(k)] - t[k];
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

// Compute the mean over the corners, in degrees.
double angleChange(const Corners& a, const Corners& b)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sum += std::abs(angleAt(a, k) - angleAt(b, k));
  }
  return sum / 3.0 * 180.0 / Pi;
}

// Corners in the plane of the triangle: (0, 0), (Base, 0), (Offset, Height).
struct Flat
{
  double Base;
  double Offset;
  double Height;

  explicit Flat(const Corners& t)
  {
    const Vector3 base = t[1] - t[0], side = t[2] - t[0];
    this->Base = base.norm();
    this->Offset = side.dot(base) / this->Base;
    this->Height = base.cross(side).norm() / this->Base;
  }
};

// Compute the area of the spherical triangle, negative if clockwise seen from outside.
double solidAngle(const Corners& n)
{
  return 2.0 *
    std::atan2(n[0].dot(n[1].cross(n[2])), 1.0 + n[0].dot(n[1]) + n[1].dot(n[2]) + n[2].dot(n[0]));
}

double sumOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (double value : values)
  {
    sum += value;
  }
  return sum;
}

struct Measured
{
  std::vector<double> MeshAreas, SphereAreas, SolidAngles;
  std::vector<int> Orientations;
  explicit Measured(Index size)
    : MeshAreas(size)
    , SphereAreas(size)
    , SolidAngles(size)
    , Orientations(size)
  {
  }
};

// Compute means over the valid triangles; set the others to no distortion.
void summarize(Distortion& result, const Measured& measured)
{
  const double meshArea = sumOf(measured.MeshAreas), sphereArea = sumOf(measured.SphereAreas);
  const double covered = sumOf(measured.SolidAngles);
  const double sign = covered > 0.0 ? 1.0 : -1.0;
  result.SphereDegree = covered / (4.0 * Pi);

  double angles = 0.0, errors = 0.0, logs = 0.0, area = 0.0, errorsByArea = 0.0;
  Index count = 0;
  std::vector<char> counts(result.AngleDistortion.size());
  for (std::size_t r = 0; r < counts.size(); ++r)
  {
    result.NumberOfFlippedTriangles += sign * measured.Orientations[r] <= 0.0;
    const double log =
      std::log(measured.SphereAreas[r] / sphereArea) - std::log(measured.MeshAreas[r] / meshArea);
    counts[r] = std::isfinite(result.QuasiConformalError[r]) && std::isfinite(log);
    if (!counts[r])
    {
      result.AngleDistortion[r] = result.AreaDistortion[r] = 0.0;
      result.QuasiConformalError[r] = 1.0;
      ++result.NumberOfZeroAreaTriangles;
      continue;
    }
    result.AreaDistortion[r] = log;
    angles += result.AngleDistortion[r];
    errors += result.QuasiConformalError[r];
    area += measured.MeshAreas[r];
    errorsByArea += measured.MeshAreas[r] * result.QuasiConformalError[r];
    result.MaximumQuasiConformalError =
      std::max(result.MaximumQuasiConformalError, result.QuasiConformalError[r]);
    logs += log;
    ++count;
  }
  if (count == 0)
  {
    return;
  }
  result.MeanAngleDistortion = angles / count;
  result.MeanQuasiConformalError = errors / count;
  result.AreaMeanQuasiConformalError = errorsByArea / area;
  double squares = 0.0;
  for (std::size_t r = 0; r < counts.size(); ++r)
  {
    const double deviation = counts[r] ? result.AreaDistortion[r] - logs / count : 0.0;
    squares += deviation * deviation;
  }
  result.AreaDistortionDeviation = std::sqrt(squares / count);
}
}

//------------------------------------------------------------------------------
double quasiConformalError(const Corners& a, const Corners& b)
{
  const Flat from(a), to(b);
  const double xx = to.Base / from.Base, yy = to.Height / from.Height;
  const double xy = (to.Offset - xx * from.Offset) / from.Height;
  const double squares = xx * xx + xy * xy + yy * yy, determinant = xx * yy;
  // Product form of the discriminant, which cannot be negative.
  const double root =
    std::sqrt(((xx - yy) * (xx - yy) + xy * xy) * ((xx + yy) * (xx + yy) + xy * xy));
  return (squares + root) / (2.0 * determinant);
}

//------------------------------------------------------------------------------
Distortion measureDistortion(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const Run& run)
{
  if (points.size() != spherePositions.rows())
  {
    throw std::invalid_argument("every point must have a position on the sphere");
  }
  Distortion result;
  const Index size = triangles.rows();
  if (size == 0)
  {
    return result;
  }
  result.AngleDistortion.resize(size);
  result.AreaDistortion.resize(size);
  result.QuasiConformalError.resize(size);
  Steps steps(run, { 0.08, 0.84, 0.08 });
  steps.next();
  const Points mesh = inUnitBox(points);
  Measured measured(size);
  constexpr Index blockSize = 1 << 10;
  forBlocksReporting(steps.next(), size, blockSize,
    [&](Index begin, Index end)
    {
      const auto corners = [&](const Points& from, Index r)
      {
        return Corners{ from.row(triangles(r, 0)), from.row(triangles(r, 1)),
          from.row(triangles(r, 2)) };
      };
      for (Index r = begin; r < end; ++r)
      {
        const Corners a = corners(mesh, r), b = corners(spherePositions, r);
        measured.MeshAreas[r] = areaOf(a);
        measured.SphereAreas[r] = areaOf(b);
        measured.SolidAngles[r] = solidAngle(b);
        measured.Orientations[r] = orientation(b[0], b[1], b[2]);
        result.AngleDistortion[r] = angleChange(a, b);
        result.QuasiConformalError[r] = quasiConformalError(a, b);
      }
    });
  steps.next();
  summarize(result, measured);
  return result;
}
}

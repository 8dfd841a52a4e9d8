#include "SphericalTexture.h"

#include "UnitBox.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
const double Radians = std::acos(-1.0) / 180.0;

// Stands for infinity, but can still be squared.
constexpr double FarAway = 1e100;

// Half the image's side in the stereographic plane.
double halfSide(double fieldOfView)
{
  return std::tan(0.25 * fieldOfView * Radians);
}

// Stereographic plane, of unit scale at the pole: |w| = tan(theta / 2).
Vector2 project(const Vector3& n, const SphereView& view)
{
  const Vector2 w(n.dot(view.Right), n.dot(view.Up));
  const double height = n.dot(view.Pole);
  if (height >= 0.0)
  {
    return w / (1.0 + height);
  }
  // 1 + height would lose all digits near the opposite pole; it equals |w|^2 / (1 - height).
  const double square = w.squaredNorm();
  return square * FarAway > 1.0 ? Vector2(w * ((1.0 - height) / square)) : Vector2(FarAway, 0.0);
}

// Axes of a viewer: Pole towards the viewer, Up and Right as seen.
SphereView viewerAxes(const SphericalTextureOptions& options)
{
  const auto unit = [](const Vector3& v, const char* name)
  {
    const double length = v.stableNorm();
    if (!(length > 0.0) || !std::isfinite(length))
    {
      throw std::invalid_argument(std::string(name) + " must be finite and not zero");
    }
    return Vector3(v / length);
  };
  SphereView axes;
  axes.Pole = unit(options.ViewDirection, "ViewDirection");
  const Vector3 right = unit(options.ViewUp, "ViewUp").cross(axes.Pole);
  if (!(right.norm() > 1e-9))
  {
    throw std::invalid_argument("ViewUp must not be parallel to ViewDirection");
  }
  axes.Right = right.normalized();
  axes.Up = axes.Pole.cross(axes.Right);
  return axes;
}

// A point of the surface.
struct Place
{
  int Triangle = -1; // one that holds it
  Vector3 Barycentric = Vector3::Zero();
};

Vector3 areaCentroid(const Points& points, const Triangles& triangles)
{
  Vector3 sum = Vector3::Zero();
  double area = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = points.row(triangles(r, 0)), b = points.row(triangles(r, 1)),
                  c = points.row(triangles(r, 2));
    const double weight = (b - a).cross(c - a).norm();
    sum += weight * (a + b + c) / 3.0;
    area += weight;
  }
  return area > 0.0 ? Vector3(sum / area) : Vector3(points.row(triangles(0, 0)));
}

// The surface as the viewer sees it: right, up, towards the viewer.
Points inViewer(const Points& points, const SphereView& axes)
{
  Eigen::Matrix3d columns;
  columns << axes.Right, axes.Up, axes.Pole;
  return points * columns;
}

// What the viewer meets first on the line through (0, 0).
Place firstMet(const Points& seen, const Triangles& triangles)
{
  Place best;
  double nearest = -std::numeric_limits<double>::infinity();
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    // Edge functions change sign exactly where two triangles share the edge, so that the line
    // cannot slip through between them.
    Vector3 sides;
    for (int k = 0; k < 3; ++k)
    {
      const auto p = seen.row(triangles(r, (k + 1) % 3)), q = seen.row(triangles(r, (k + 2) % 3));
      sides[k] = p[0] * q[1] - p[1] * q[0];
    }
    const double sum = sides.sum();
    if (sum == 0.0 || (sides.minCoeff() < 0.0 && sides.maxCoeff() > 0.0))
    {
      continue;
    }
    const Vector3 barycentric = sides / sum;
    double depth = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      depth += barycentric[k] * seen(triangles(r, k), 2);
    }
    if (depth > nearest)
    {
      nearest = depth;
      best.Triangle = static_cast<int>(r);
      best.Barycentric = barycentric;
    }
  }
  return best;
}

Place nearestCorner(const Points& seen, const Triangles& triangles)
{
  Place best;
  double nearest = -std::numeric_limits<double>::infinity();
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (seen(triangles(r, k), 2) > nearest)
      {
        nearest = seen(triangles(r, k), 2);
        best.Triangle = static_cast<int>(r);
        best.Barycentric = Vector3::Unit(k);
      }
    }
  }
  return best;
}

Vector3 interpolated(const Points& values, const Triangles& triangles, const Place& place)
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    sum += place.Barycentric[k] * Vector3(values.row(triangles(place.Triangle, k)));
  }
  return sum;
}

// The middle of a large triangle may lie at the sphere's centre; a corner then stands for it.
Vector3 poleAt(const Points& spherePositions, const Triangles& triangles, const Place& place)
{
  const Vector3 n = interpolated(spherePositions, triangles, place);
  if (n.norm() > 1e-12)
  {
    return n.normalized();
  }
  Index corner = 0;
  place.Barycentric.maxCoeff(&corner);
  return spherePositions.row(triangles(place.Triangle, corner));
}

// Turn (and, for a mirrored map, flip) the image about the pole until its axes agree with the
// viewer's. In the stereographic plane, with z for a place on the sphere and Z for where the viewer
// sees it, both seen from the pole, the mean of conj(z) Z over a disk is the derivative dZ/dz at
// its middle, if Z depends analytically on z.
void alignAxes(SphereView& view, const Points& seen, const Triangles& triangles,
  const Points& spherePositions, const Place& place, double capAngle)
{
  using Complex = std::complex<double>;
  const Vector3 origin = interpolated(seen, triangles, place);
  const double capRadius = std::tan(0.5 * capAngle);
  Complex upright = 0.0, mirrored = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    std::array<Vector3, 3> n;
    std::array<Complex, 3> z, Z;
    Complex middle = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int id = triangles(r, k);
      n[k] = spherePositions.row(id);
      const Vector2 w = project(n[k], view);
      z[k] = { w[0], w[1] };
      Z[k] = { seen(id, 0) - origin[0], seen(id, 1) - origin[1] };
      middle += z[k] / 3.0;
    }
    if (r == place.Triangle || std::abs(middle) < capRadius)
    {
      const double area = (n[1] - n[0]).cross(n[2] - n[0]).norm();
      for (int k = 0; k < 3; ++k)
      {
        upright += area * std::conj(z[k]) * Z[k];
        mirrored += area * z[k] * Z[k];
      }
    }
  }
  const bool isMirrored = std::abs(mirrored) > std::abs(upright);
  const Complex derivative = isMirrored ? mirrored : upright;
  if (!(std::abs(derivative) > 0.0) || std::abs(derivative) >= FarAway)
  {
    return; // nothing to be told from a neighbourhood without extent
  }
  // Z = e^(i angle) z, or e^(i angle) conj(z), up to a positive factor; up is where Z = i.
  const Complex turn = derivative / std::abs(derivative);
  const auto direction = [&](Complex Z)
  {
    const Complex z = isMirrored ? std::conj(Z / turn) : Z / turn;
    return Vector3(z.real() * view.Right + z.imag() * view.Up);
  };
  const Vector3 right = direction(1.0), up = direction({ 0.0, 1.0 });
  view.Right = right;
  view.Up = up;
}
}

//------------------------------------------------------------------------------
Vector2 sphereToTexture(const Vector3& n, const SphereView& view, double fieldOfView)
{
  return Vector2::Constant(0.5) + 0.5 / halfSide(fieldOfView) * project(n, view);
}

//------------------------------------------------------------------------------
Vector3 textureToSphere(const Vector2& st, const SphereView& view, double fieldOfView)
{
  const Vector2 w = 2.0 * halfSide(fieldOfView) * (st - Vector2::Constant(0.5));
  const double square = w.squaredNorm();
  return (2.0 * w[0] * view.Right + 2.0 * w[1] * view.Up + (1.0 - square) * view.Pole) /
    (1.0 + square);
}

//------------------------------------------------------------------------------
SphereView chooseSphereView(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options, const Progress& progress)
{
  if (triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  if (points.size() != spherePositions.rows())
  {
    throw std::invalid_argument("every point needs a position on the sphere");
  }
  if (!(options.FieldOfView >= MinimumFieldOfView && options.FieldOfView <= MaximumFieldOfView))
  {
    throw std::invalid_argument("FieldOfView must lie between 0.001 and 340 degrees");
  }
  const SphereView axes = viewerAxes(options);
  Points model = inUnitBox(points);
  model.rowwise() -= areaCentroid(model, triangles).transpose();
  const Points seen = inViewer(model, axes);
  report(progress, 0.3);

  Place place = firstMet(seen, triangles);
  if (place.Triangle < 0)
  {
    place = nearestCorner(seen, triangles);
  }
  report(progress, 0.6);
  SphereView view;
  view.Pole = poleAt(spherePositions, triangles, place);
  view.Right = view.Pole.unitOrthogonal();
  view.Up = view.Pole.cross(view.Right);
  alignAxes(view, seen, triangles, spherePositions, place, options.FieldOfView / 8.0 * Radians);
  report(progress, 1.0);
  return view;
}

//------------------------------------------------------------------------------
SphericalTexture makeSphericalTexture(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options,
  const ParallelFor& parallelFor, const Progress& progress)
{
  const auto share = [&](double begin, double end)
  {
    return [&progress, begin, end](double fraction)
    {
      report(progress, begin + fraction * (end - begin));
      return true;
    };
  };
  SphericalTexture texture;
  texture.View = chooseSphereView(points, triangles, spherePositions, options, share(0.0, 0.7));
  texture.Coordinates.resize(spherePositions.rows(), 2);
  texture.OutsideImage.resize(spherePositions.rows());
  constexpr Index blockSize = 1 << 12;
  forBlocks(parallelFor, spherePositions.rows(), blockSize, share(0.7, 1.0),
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Vector2 st =
          sphereToTexture(spherePositions.row(i), texture.View, options.FieldOfView);
        const Vector2 clamped = st.cwiseMax(0.0).cwiseMin(1.0);
        texture.Coordinates.row(i) = clamped;
        texture.OutsideImage[i] = clamped != st;
      }
    });
  return texture;
}
}

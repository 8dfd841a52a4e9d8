#include "Texture/SphereViewChoice.h"

#include "Base/CoordinateFrame.h"
#include "Base/Run.h"
#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Search/TriangleTree.h"
#include "Texture/SphereProjection.h"

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

Vector3 directionOf(const Vector3& v, const char* name)
{
  Vector3 unit = unitVector(v);
  if (!unit.allFinite())
  {
    throw std::invalid_argument(std::string(name) + " must be finite and not zero");
  }
  return unit;
}

// Compute the axes of a viewer: Pole points toward the viewer, Up and Right are those of the view.
SphereView viewerAxes(const Vector3& toViewer, const Vector3& upward)
{
  SphereView axes;
  axes.Pole = toViewer;
  const Vector3 right = upward.cross(axes.Pole);
  if (!(right.norm() > 1e-9))
  {
    throw std::invalid_argument("ViewUp must not be parallel to the direction of the view");
  }
  axes.Right = right.normalized();
  axes.Up = axes.Pole.cross(axes.Right);
  return axes;
}

// Point of the surface.
struct Place
{
  int Triangle = -1; // triangle that contains the point
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

// Convert points to the frame of the viewer: right, up, toward the viewer.
Points inViewer(const Points& points, const SphereView& axes)
{
  Eigen::Matrix3d columns;
  columns << axes.Right, axes.Up, axes.Pole;
  return points * columns;
}

// Find the intersection of the surface with the line of sight through (0, 0) that is nearest to the
// viewer.
Place firstMet(const Points& seen, const Triangles& triangles)
{
  Place best;
  double nearest = -std::numeric_limits<double>::infinity();
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    // Edge functions change sign exactly at a shared edge, so that the line cannot pass between two
    // triangles.
    Vector3 sides;
    for (int k = 0; k < 3; ++k)
    {
      const auto p = seen.row(triangles(r, next(k))), q = seen.row(triangles(r, previous(k)));
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

// The centroid of a large triangle may lie at the center of the sphere; use a corner instead.
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

// Compute the mean outward normal over a cap around the pole; zero if undefined.
Vector3 meanNormal(const Points& points, const Triangles& triangles, const Points& spherePositions,
  const Vector3& pole, const Place& place, double capAngle)
{
  Vector3 sum = Vector3::Zero();
  double volume = 0.0; // negative for an inverted surface
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = points.row(triangles(r, 0)), b = points.row(triangles(r, 1)),
                  c = points.row(triangles(r, 2));
    const Vector3 normal = (b - a).cross(c - a);
    volume += normal.dot(a);
    const Vector3 n = spherePositions.row(triangles(r, 0));
    if (r == place.Triangle || n.dot(pole) > std::cos(capAngle))
    {
      sum += normal;
    }
  }
  return (volume < 0.0 ? -1.0 : 1.0) * sum.stableNormalized();
}

// Rotate (and, for a mirrored map, reflect) the image about the pole until its axes agree with
// those of the viewer. In the stereographic plane, let z be a position on the sphere and Z its
// position in the view, both seen from the pole. If Z depends analytically on z, the mean of
// conj(z) Z over a disk is the derivative dZ/dz at its center.
void alignAxes(SphereView& view, const Points& seen, const Triangles& triangles,
  const Points& spherePositions, const Place& place, double capAngle, const Run& run)
{
  using Complex = std::complex<double>;
  const Vector3 origin = interpolated(seen, triangles, place);
  const double capRadius = std::tan(0.5 * capAngle);
  Complex upright = 0.0, mirrored = 0.0;
  const auto add = [&](Index r)
  {
    std::array<Vector3, 3> n;
    std::array<Complex, 3> z, Z;
    Complex middle = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int id = triangles(r, k);
      n[k] = spherePositions.row(id);
      const Vector2 w = stereographicPlane(n[k], view);
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
  };
  forBlocksReporting(run.inOrder(), triangles.rows(), 1 << 8,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        add(r);
      }
    });
  const bool isMirrored = std::abs(mirrored) > std::abs(upright);
  const Complex derivative = isMirrored ? mirrored : upright;
  if (!(std::abs(derivative) > 0.0) || !std::isfinite(std::abs(derivative)))
  {
    return; // a cap whose image is a point has no orientation
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

SphereView turned(const SphereView& view, double degrees)
{
  const double c = std::cos(degrees * Degree), s = std::sin(degrees * Degree);
  SphereView result = view;
  result.Right = c * view.Right + s * view.Up;
  result.Up = c * view.Up - s * view.Right;
  return result;
}

void check(const SphereViewOptions& options)
{
  if (!(options.FieldOfView >= MinimumFieldOfView && options.FieldOfView <= MaximumFieldOfView))
  {
    throw std::invalid_argument("FieldOfView must lie between 0.001 and 340 degrees");
  }
  if (!std::isfinite(options.Rotation))
  {
    throw std::invalid_argument("Rotation must be finite");
  }
  if (options.UseViewPoint && !options.ViewPoint.allFinite())
  {
    throw std::invalid_argument("ViewPoint must be finite");
  }
}
}

//------------------------------------------------------------------------------
void requireMap(const PointView& points, const Triangles& triangles, const Points& spherePositions)
{
  if (triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  if (points.size() != spherePositions.rows())
  {
    throw std::invalid_argument("every point must have a position on the sphere");
  }
}

//------------------------------------------------------------------------------
SphereView chooseSphereView(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphereViewOptions& options, const Run& run)
{
  requireMap(points, triangles, spherePositions);
  check(options);
  Vector3 toViewer = directionOf(options.ViewDirection, "ViewDirection");
  const Vector3 upward = directionOf(options.ViewUp, "ViewUp");
  const double withPoint = options.UseViewPoint ? 1.0 : 0.0;
  Steps steps(run, { 0.15, 7.2 * withPoint, 0.1 * withPoint, 0.2, 0.65 });
  steps.next();
  const UnitBox box = unitBoxOf(points);
  Points model(points.size(), 3);
  for (Index i = 0; i < points.size(); ++i)
  {
    model.row(i) = box(points[i]);
  }
  const Vector3 centroid = areaCentroid(model, triangles);
  model.rowwise() -= centroid.transpose();
  const double capAngle = options.FieldOfView / 8.0 * Degree;

  const Run seeking = steps.next();
  Place place;
  SphereView view;
  if (options.UseViewPoint)
  {
    const FootPoint foot = TriangleTree(model, triangles, seeking)
                             .closestPoint(box.fromAfar(options.ViewPoint) - centroid);
    place = { foot.Triangle, foot.Barycentric };
    view.Pole = poleAt(spherePositions, triangles, place);
    steps.next();
    const Vector3 normal =
      meanNormal(model, triangles, spherePositions, view.Pole, place, capAngle);
    toViewer = normal.norm() > 0.0 ? normal : toViewer;
  }
  else
  {
    steps.next();
  }
  steps.next();
  const SphereView axes = viewerAxes(toViewer, upward);
  const Points seen = inViewer(model, axes);
  if (!options.UseViewPoint)
  {
    place = firstMet(seen, triangles);
    place = place.Triangle < 0 ? nearestCorner(seen, triangles) : place;
    view.Pole = poleAt(spherePositions, triangles, place);
  }
  view.Right = view.Pole.unitOrthogonal();
  view.Up = view.Pole.cross(view.Right);
  alignAxes(view, seen, triangles, spherePositions, place, capAngle, steps.next());
  run.report(1.0);
  return turned(view, options.Rotation);
}
}

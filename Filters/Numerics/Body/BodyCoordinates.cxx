#include "Body/BodyCoordinates.h"

#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"
#include "Search/OutermostHits.h"
#include "Search/TriangleTree.h"
#include "Sphere/MoebiusTransform.h"
#include "Sphere/SphereLocator.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{

// Point of the surface in a triangle.
struct BodyPoint
{
  int Triangle = -1;
  Vector3 Barycentric = Vector3::Zero();
};

Vector3 mixed(const Points& positions, const Triangles& triangles, const BodyPoint& point)
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    sum += point.Barycentric[k] * positions.row(triangles(point.Triangle, k)).transpose();
  }
  return sum;
}

// Find the intersection of a ray with the surface that is farthest along the ray. If there is none,
// the triangle is -1.
BodyPoint farthestAlong(const OutermostHits& hits, const Vector3& origin, const Vector3& direction)
{
  const RayHit hit = hits.along(origin, direction);
  return { hit.Triangle, hit.Barycentric };
}

BodyPoint closestTo(const MappedMesh& surface, const Vector3& x)
{
  BodyPoint best;
  double minimum = std::numeric_limits<double>::infinity();
  for (int r = 0; r < surface.Triangles.rows(); ++r)
  {
    const FootPoint foot = closestPointOfTriangle(x, surface.Positions.row(surface.Triangles(r, 0)),
      surface.Positions.row(surface.Triangles(r, 1)),
      surface.Positions.row(surface.Triangles(r, 2)));
    if (foot.SquareDistance < minimum)
    {
      minimum = foot.SquareDistance;
      best = { r, foot.Barycentric };
    }
  }
  return best;
}

Eigen::VectorXd areasOfVertices(const MappedMesh& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.Positions.rows());
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    const double area = areaVector(surface.Positions, surface.Triangles, r).norm();
    for (int k = 0; k < 3; ++k)
    {
      areas[surface.Triangles(r, k)] += area / 3.0;
    }
  }
  return areas;
}

// Compute the distance (rapidity) by which a map is moved along an axis so that both sides have
// equal weight.
double balancingRapidity(const Eigen::VectorXd& heights, const Eigen::VectorXd& weights)
{
  constexpr int steps = 60;
  double low = -30.0, high = 30.0;
  for (int i = 0; i < steps; ++i)
  {
    const double middle = 0.5 * (low + high), up = std::exp(middle), down = std::exp(-middle);
    double sum = 0.0;
    for (Index v = 0; v < heights.size(); ++v)
    {
      const double north = up * (1.0 + heights[v]), south = down * (1.0 - heights[v]);
      sum += weights[v] * (north - south) / (north + south);
    }
    (sum < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Transform the poles to their positions, and the marker to longitude 0.
void moveToPoles(Points& map, const Vector3& north, const Vector3& south, const Vector3& marker,
  const Eigen::VectorXd& areas)
{
  const Vector3 sum = north + south;
  const double cosine = 0.5 * sum.norm(), sine = 0.5 * (north - south).norm();
  // Moving the point of the ball halfway between the poles to the center makes them antipodal.
  MoebiusTransform first;
  first.Center = cosine > 0.0 ? Vector3(cosine / (1.0 + sine) * sum.normalized()) : Vector3::Zero();
  const Vector3 axis = (first(north) - first(south)).normalized();
  first.applyTo(map);
  MoebiusTransform second;
  second.Center = -std::tanh(0.5 * balancingRapidity(map * axis, areas)) * axis;
  second.applyTo(map);
  const Vector3 meridian = second(first(marker));
  const Vector3 x = (meridian - meridian.dot(axis) * axis).normalized();
  Eigen::Matrix3d rotation;
  rotation << x, axis.cross(x), axis;
  map *= rotation;
  for (Index v = 0; v < map.rows(); ++v)
  {
    map.row(v).normalize();
  }
}

void requirePoint(const BodyPoint& point, const char* message)
{
  if (point.Triangle < 0)
  {
    throw std::invalid_argument(message);
  }
}

// Return the point of a vertex.
BodyPoint atVertex(const Triangles& triangles, int vertex)
{
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (triangles(r, k) == vertex)
      {
        return { static_cast<int>(r), Vector3::Unit(k) };
      }
    }
  }
  return {};
}

int farthest(const std::vector<double>& distances)
{
  return static_cast<int>(std::max_element(distances.begin(), distances.end()) - distances.begin());
}

// Ends of a surface, and a vertex midway between them.
struct SurfaceEnds
{
  BodyPoint North, South, Middle;
};

SurfaceEnds findEnds(const MappedMesh& surface, const Vector3& axis)
{
  const auto distancesFrom = [&](int vertex)
  { return pathsAlongEdges(surface, { vertex }).Lengths; };
  int north = farthest(distancesFrom(surface.Triangles(0, 0)));
  const std::vector<double> fromNorth = distancesFrom(north);
  int south = farthest(fromNorth);
  const std::vector<double> fromSouth = distancesFrom(south);
  constexpr double midway = 0.1; // of the distance of the ends
  const Eigen::VectorXd heights = surface.Positions * towardsLongitudeZero(axis);
  int middle = -1;
  for (int v = 0; v < static_cast<int>(heights.size()); ++v)
  {
    if (fromNorth[v] >= 0.0 && std::abs(fromNorth[v] - fromSouth[v]) <= midway * fromNorth[south] &&
      (middle < 0 || heights[v] > heights[middle]))
    {
      middle = v;
    }
  }
  if ((surface.Positions.row(south) - surface.Positions.row(north)).dot(axis) > 0.0)
  {
    std::swap(north, south);
  }
  return { atVertex(surface.Triangles, north), atVertex(surface.Triangles, south),
    atVertex(surface.Triangles, middle) };
}

double radiusOf(const Points& positions)
{
  return 0.5 * (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).norm();
}

//------------------------------------------------------------------------------
// Split a line where its points are not finite. Pieces of one point are left out.
std::vector<GraticuleLine> piecesOfLine(
  const GraticuleLine& line, const std::vector<Vector3>& points)
{
  const auto isFinite = [](const Vector3& x) { return x.allFinite(); };
  std::vector<GraticuleLine> pieces;
  for (auto first = points.begin(), last = first; first != points.end(); first = last)
  {
    first = std::find_if(first, points.end(), isFinite);
    last = std::find_if_not(first, points.end(), isFinite);
    if (last - first < 2)
    {
      continue;
    }
    pieces.push_back({ line.IsMeridian, line.Degrees, Points(last - first, 3) });
    for (auto i = first; i != last; ++i)
    {
      pieces.back().Positions.row(i - first) = *i;
    }
  }
  return pieces;
}
}

//------------------------------------------------------------------------------
Vector3 towardsLongitudeZero(const Vector3& axis)
{
  constexpr double parallel = 0.999;
  const Vector3 x = std::abs(axis[0]) < parallel ? Vector3::UnitX() : Vector3::UnitY();
  return (x - x.dot(axis) * axis).normalized();
}

//------------------------------------------------------------------------------
BodyCoordinates findBodyCoordinates(
  const MappedMesh& surface, const BodyCoordinatesOptions& options, const Run& run)
{
  if (surface.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  if (!surface.Positions.allFinite())
  {
    throw std::invalid_argument("some points of the surface are not finite");
  }
  if (!options.Center.allFinite() || !options.RotationAxis.allFinite() ||
    !options.MarkerPoint.allFinite() || !(options.RotationAxis.stableNorm() > 0.0))
  {
    throw std::invalid_argument(
      "Center, RotationAxis and MarkerPoint must be finite, and RotationAxis not zero");
  }
  Steps steps(run, { 0.09, 0.09, 0.09, 0.73 }); // poles, marker, map
  const Vector3 axis = options.RotationAxis.stableNormalized();
  const OutermostHits hits(surface.Positions, surface.Triangles, steps.next().unwatched());
  BodyPoint north, south, marker;
  if (options.UseEnds)
  {
    const SurfaceEnds ends = findEnds(surface, axis);
    north = ends.North;
    south = ends.South;
    marker = ends.Middle;
    steps.next();
  }
  else
  {
    north = farthestAlong(hits, options.Center, axis);
    requirePoint(north, "the rotation axis does not intersect the surface to the north of Center");
    steps.next();
    south = farthestAlong(hits, options.Center, -axis);
    requirePoint(south, "the rotation axis does not intersect the surface to the south of Center");
    marker = farthestAlong(hits, options.Center, towardsLongitudeZero(axis));
  }
  steps.next();
  marker = options.UseMarkerPoint ? closestTo(surface, options.MarkerPoint) : marker;
  requirePoint(marker,
    "no point of the surface lies from Center towards longitude 0; set UseMarkerPoint and "
    "MarkerPoint");
  const Run moving = steps.next();

  BodyCoordinates result;
  result.SpherePositions = surface.SpherePositions;
  result.NorthPole = mixed(surface.Positions, surface.Triangles, north);
  result.SouthPole = mixed(surface.Positions, surface.Triangles, south);
  result.Marker = mixed(surface.Positions, surface.Triangles, marker);
  const bool isMirrored = signedVolume(surface.SpherePositions, surface.Triangles) *
      signedVolume(surface.Positions, surface.Triangles) <
    0.0;
  if (isMirrored)
  {
    result.SpherePositions.col(2) *= -1.0;
  }
  const Eigen::VectorXd areas = areasOfVertices(surface);
  const auto placeOf = [&](const BodyPoint& point) -> Vector3
  { return mixed(result.SpherePositions, surface.Triangles, point).normalized(); };
  // The transform moves vertices, while triangles stay flat. Points inside of triangles are
  // therefore not moved exactly. Repeat the transform until the poles and the marker are at their
  // positions.
  constexpr int maximumRounds = 12;
  constexpr double tolerance = 1e-14;
  for (int i = 0; i < maximumRounds; ++i)
  {
    moving.report(1.0 - std::pow(0.2, i)); // usually one or two iterations suffice
    const Vector3 toNorth = placeOf(north), toSouth = placeOf(south), toMarker = placeOf(marker);
    if (!((toNorth - toSouth).norm() > 1e-9))
    {
      throw std::invalid_argument("both poles have the same position on the sphere");
    }
    if ((toMarker - toNorth).norm() < 1e-9 || (toMarker - toSouth).norm() < 1e-9)
    {
      throw std::invalid_argument("the marker is a pole, where there is no longitude");
    }
    const double off = (toNorth - Vector3::UnitZ()).norm() + (toSouth + Vector3::UnitZ()).norm() +
      std::abs(std::atan2(toMarker[1], toMarker[0]));
    if (i > 0 && off < tolerance)
    {
      break;
    }
    moveToPoles(result.SpherePositions, toNorth, toSouth, toMarker, areas);
  }
  return result;
}

//------------------------------------------------------------------------------
Vector2 toLongitudeLatitude(const Vector3& n)
{
  double longitude = std::atan2(n[1], n[0]) / Degree;
  longitude += longitude < 0.0 ? 360.0 : 0.0;
  return { longitude < 360.0 ? longitude : 0.0, std::atan2(n[2], std::hypot(n[0], n[1])) / Degree };
}

//------------------------------------------------------------------------------
Vector3 toDirection(const Vector2& longitudeLatitude)
{
  const double longitude = longitudeLatitude[0] * Degree, latitude = longitudeLatitude[1] * Degree;
  return { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
    std::sin(latitude) };
}

//------------------------------------------------------------------------------
Points placeOnBody(const MappedMesh& body, const Points& directions, const Run& run)
{
  Steps steps(run, { 0.7, 0.3 }); // locator, places
  const Triangles triangles = turnedOutward(body.Triangles, body.SpherePositions);
  const SphereLocator locator(body.SpherePositions, triangles, steps.next());
  Points result(directions.rows(), 3);
  constexpr Index blockSize = 1 << 10;
  forBlocksReporting(steps.next(), directions.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const SphereLocation location = locator.locate(directions.row(i));
        result.row(i) = location.Triangle < 0
          ? Vector3(Vector3::Constant(std::numeric_limits<double>::infinity()))
          : mixed(body.Positions, triangles, { location.Triangle, location.Barycentric });
      }
    });
  return result;
}

//------------------------------------------------------------------------------
std::vector<GraticuleLine> makeGraticule(const MappedMesh& body, double spacing, const Run& run)
{
  if (!(spacing >= 1.0 && spacing <= 90.0))
  {
    throw std::invalid_argument("the spacing of the graticule must be in [1, 90] degrees");
  }
  if (body.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  std::vector<GraticuleLine> lines;
  for (double degrees = 0.0; degrees < 360.0 - 1e-9; degrees += spacing)
  {
    lines.push_back({ true, degrees, {} });
  }
  const int parallels = static_cast<int>(std::ceil(90.0 / spacing - 1e-9)) - 1;
  for (int i = -parallels; i <= parallels; ++i)
  {
    lines.push_back({ false, i * spacing, {} });
  }
  Steps steps(run, { 0.8, 0.2 }); // locator, lines
  const Triangles triangles = turnedOutward(body.Triangles, body.SpherePositions);
  const SphereLocator locator(body.SpherePositions, triangles, steps.next());
  const double step = 0.01 * radiusOf(body.Positions);
  std::vector<std::vector<GraticuleLine>> pieces(lines.size());
  forBlocksReporting(steps.next(), static_cast<Index>(lines.size()), 1,
    [&](Index begin, Index)
    {
      const GraticuleLine& line = lines[begin];
      const double first = line.IsMeridian ? -90.0 : 0.0, last = line.IsMeridian ? 90.0 : 360.0;
      int hint = -1;
      const auto at = [&](double t) -> Vector3
      {
        const SphereLocation location = locator.locate(
          toDirection(line.IsMeridian ? Vector2(line.Degrees, t) : Vector2(t, line.Degrees)), hint);
        hint = location.Triangle;
        return location.Triangle < 0
          ? Vector3(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()))
          : mixed(body.Positions, triangles, { location.Triangle, location.Barycentric });
      };
      std::vector<Vector3> points; // not finite where the line is interrupted by a hole of the map
      const std::function<void(double, const Vector3&, double, const Vector3&, int)> fill =
        [&](double from, const Vector3& a, double to, const Vector3& b, int depth)
      {
        if (depth > 0 && !((a - b).norm() <= step))
        {
          const double middle = 0.5 * (from + to);
          const Vector3 between = at(middle);
          fill(from, a, middle, between, depth - 1);
          fill(middle, between, to, b, depth - 1);
        }
        else
        {
          points.push_back(b);
        }
      };
      constexpr int parts = 90, maximumHalvings = 8;
      Vector3 before = at(first);
      points.push_back(before);
      for (int i = 1; i <= parts; ++i)
      {
        const double from = first + (last - first) * (i - 1) / parts,
                     to = first + (last - first) * i / parts;
        const Vector3 here = at(to);
        fill(from, before, to, here, maximumHalvings);
        before = here;
      }
      pieces[begin] = piecesOfLine(line, points);
    });
  std::vector<GraticuleLine> result;
  for (const std::vector<GraticuleLine>& ofLine : pieces)
  {
    result.insert(result.end(), ofLine.begin(), ofLine.end());
  }
  return result;
}
}

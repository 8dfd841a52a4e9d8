#include "Body/MapOutlines.h"

#include "Base/Steps.h"
#include "Body/MapParts.h"
#include "Mesh/GenusZeroCheck.h"
#include "Sphere/SphereLocator.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{

double signedArea(const std::vector<Vector2>& corners)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector2 a = corners[i] - corners[0], b = corners[(i + 1) % corners.size()] - corners[0];
    twice += cross(a, b);
  }
  return 0.5 * twice;
}

// Point of the body that a position in the image shows.
struct Shown
{
  int Triangle = -1; // -1 outside of the map or in a hole
  Vector3 Position = Vector3::Zero();
};

// Trace lines of the image on the surface.
class Tracer
{
public:
  Tracer(const MappedMesh& body, const MapImage& image, const Run& run)
    : Body(body)
    , Image(image)
    , Outward(turnedOutward(body.Triangles, body.SpherePositions))
    , Locator(body.SpherePositions, this->Outward, run)
    , Size((body.Positions.colwise().maxCoeff() - body.Positions.colwise().minCoeff()).norm())
    , Step(pictureUnit(image))
  {
  }

  SurfaceOutline trace(const MapOutline& outline) const;

private:
  // Line through the image, and its pieces on the surface.
  struct Side
  {
    Vector2 From, To;
    std::vector<Vector3> Points; // without the first
    bool IsWhole = true;
  };
  struct Corner
  {
    Vector2 Pixels;
    int Id;
  };

  Shown at(const Vector2& pixels, int hint) const
  {
    Shown shown;
    Vector3 n;
    if (!this->Image.fromPixels(inImage(this->Image, pixels), n))
    {
      return shown;
    }
    const SphereLocation location = this->Locator.locate(n, hint);
    shown.Triangle = location.Triangle;
    for (int k = 0; k < 3 && shown.Triangle >= 0; ++k)
    {
      shown.Position += location.Barycentric[k] *
        this->Body.Positions.row(this->Outward(shown.Triangle, k)).transpose();
    }
    return shown;
  }

  void divide(Side& side, double from, const Shown& a, double to, const Shown& b, int level) const
  {
    constexpr int fine = 6, shallow = 24, deepest = 44;
    constexpr double straight = 1e-3, tiny = 1e-9, gap = 1e-6;
    if (a.Triangle < 0 || b.Triangle < 0)
    {
      side.IsWhole = false;
    }
    if (!side.IsWhole)
    {
      return;
    }
    const double middle = 0.5 * (from + to), chord = (b.Position - a.Position).norm();
    const Shown between = this->at(side.From + middle * (side.To - side.From), a.Triangle);
    const bool isInOne = a.Triangle == b.Triangle && between.Triangle == a.Triangle;
    const double sag = (between.Position - 0.5 * (a.Position + b.Position)).norm();
    // Along an edge, rounding chooses either triangle. Small pieces that are straight are therefore
    // accepted, whatever their triangles are. A gap of the surface is not straight.
    const bool isStraight = sag <= straight * chord;
    const bool isInside = isInOne || (isStraight && level >= fine);
    if (between.Triangle >= 0 &&
      (chord <= tiny * this->Size || level == deepest ||
        (isInside && (isStraight || level >= shallow))))
    {
      side.IsWhole = chord <= gap * this->Size || isInside;
      // Pieces across an edge have no length; the next piece begins where they do.
      if (isInside || to == 1.0)
      {
        side.Points.push_back(b.Position);
      }
      return;
    }
    this->divide(side, from, a, middle, between, level + 1);
    this->divide(side, middle, between, to, b, level + 1);
  }

  Side traceSide(const Vector2& from, const Vector2& to) const
  {
    Side side = { from, to, {}, true };
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / this->Step)));
    Shown before = this->at(from, -1);
    for (int i = 0; i < pieces && side.IsWhole; ++i)
    {
      const double first = double(i) / pieces, last = double(i + 1) / pieces;
      const Shown here = this->at(from + last * (to - from), before.Triangle);
      this->divide(side, first, before, last, here, 0);
      before = here;
    }
    return side;
  }

  // Tangent on the surface, of the line from a corner towards another.
  Vector3 tangent(const Vector2& corner, const Vector2& towards) const
  {
    const Vector2 line = towards - corner;
    const double step = std::min(1e-4 * this->Step / line.norm(), 0.5);
    const Shown here = this->at(corner, -1), there = this->at(corner + step * line, here.Triangle);
    return here.Triangle < 0 || there.Triangle < 0 ? Vector3(Vector3::Zero())
                                                   : Vector3(there.Position - here.Position);
  }

  const MappedMesh& Body;
  const MapImage& Image;
  Triangles Outward;
  SphereLocator Locator;
  double Size; // diagonal of the body
  double Step; // largest piece of a line [pixels]
};

std::vector<int> differentCorners(const MapOutline& outline)
{
  std::vector<int> ids;
  const auto& corners = outline.Corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (ids.empty() || corners[ids.back()] != corners[i])
    {
      ids.push_back(static_cast<int>(i));
    }
  }
  while (outline.IsClosed && ids.size() > 1 && corners[ids.back()] == corners[ids.front()])
  {
    ids.pop_back();
  }
  return ids;
}

SurfaceOutline Tracer::trace(const MapOutline& outline) const
{
  SurfaceOutline result;
  const std::vector<int> ids = differentCorners(outline);
  const int size = static_cast<int>(ids.size());
  if (size < 2)
  {
    return result;
  }
  std::vector<Vector2> corners;
  corners.reserve(ids.size());
  for (const int id : ids)
  {
    corners.push_back(outline.Corners[id]);
  }
  const double pictureArea = outline.IsClosed ? signedArea(corners) : 0.0;
  const double orientation = pictureArea < 0.0 ? -1.0 : 1.0;
  result.PictureArea = std::abs(pictureArea);
  const int sides = outline.IsClosed ? size : size - 1;
  result.IsOnMap = true;
  std::vector<Vector3> points = { this->at(corners[0], -1).Position };
  result.Corners = { ids[0] };
  for (int i = 0; i < sides; ++i)
  {
    const Vector2 &from = corners[i], &to = corners[(i + 1) % size];
    result.PictureLength += (to - from).norm();
    const Side side = result.IsOnMap ? this->traceSide(from, to) : Side();
    result.IsOnMap = result.IsOnMap && side.IsWhole;
    for (const Vector3& point : side.Points)
    {
      result.Length += (point - points.back()).norm();
      points.push_back(point);
      result.Corners.push_back(-1);
    }
    result.Corners.back() = ids[(i + 1) % size];
  }
  if (!result.IsOnMap)
  {
    result.Length = 0.0;
    result.Corners.clear();
    return result;
  }
  result.Positions.resize(static_cast<Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result.Positions.row(static_cast<Index>(i)) = points[i];
  }
  std::vector<double> angles(outline.Corners.size(), 0.0);
  for (int i = outline.IsClosed ? 0 : 1; i < (outline.IsClosed ? size : size - 1); ++i)
  {
    const Vector2 &before = corners[(i + size - 1) % size], &here = corners[i],
                  &after = corners[(i + 1) % size];
    const double angle =
      angleBetween(this->tangent(here, before), this->tangent(here, after)) / Degree;
    const bool isReflex =
      outline.IsClosed && orientation * cross(here - before, after - here) < 0.0;
    angles[ids[i]] = isReflex ? 360.0 - angle : angle;
  }
  for (const int id : result.Corners)
  {
    result.Angles.push_back(id >= 0 ? angles[id] : 0.0);
  }
  return result;
}
}

//------------------------------------------------------------------------------
std::vector<SurfaceOutline> measureMapOutlines(const MappedMesh& given, const MapImage& image,
  const std::vector<MapOutline>& outlines, const Run& run)
{
  if (image.Grid.size() < 1 || given.Triangles.rows() == 0)
  {
    throw std::invalid_argument("outlines need a surface with triangles, and a map with pixels");
  }
  requireFiniteTriangles(given.Positions, given.Triangles);
  const double farthest = 10.0 * double(std::max(image.Grid.Width, image.Grid.Height));
  bool hasArea = false;
  for (const MapOutline& outline : outlines)
  {
    hasArea = hasArea || outline.IsClosed;
    for (const Vector2& corner : outline.Corners)
    {
      if (!corner.allFinite() || corner.cwiseAbs().maxCoeff() > farthest)
      {
        throw std::invalid_argument("a corner of an outline is far from the image of the map, or "
                                    "not finite; coordinates must be pixels of the map");
      }
    }
  }
  Steps steps(run, { 0.1, 0.4, 0.5 }); // locator, parts, outlines
  Vector3 middle;
  const MappedMesh body = movedToOrigin(given, middle);
  const Tracer tracer(body, image, steps.next());
  const Run dividing = steps.next();
  const MapParts parts = hasArea ? MapParts(body, image, dividing) : MapParts();
  std::vector<SurfaceOutline> results(outlines.size());
  forBlocksReporting(steps.next(), static_cast<Index>(outlines.size()), 1,
    [&](Index begin, Index)
    {
      results[begin] = tracer.trace(outlines[begin]);
      if (outlines[begin].IsClosed && results[begin].IsOnMap)
      {
        results[begin].Area = parts.areaInside(outlines[begin].Corners);
      }
      results[begin].Positions.rowwise() += middle.transpose();
    });
  return results;
}
}

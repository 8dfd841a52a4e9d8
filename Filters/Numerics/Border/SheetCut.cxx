#include "Border/SheetCut.h"

#include "Base/DisjointSets.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace conformal
{
namespace
{
constexpr double BandWidth = 2.5; // edges on each side of the curves, where heights are exact

using Ends = std::pair<int, int>;
using Corners = std::array<int, 3>;

/// Place on the nearest curve, and height above it: positive beyond the border.
struct NearestBorder
{
  Vector3 Place;
  Vector3 Normal;
  double Height;
};

/// Find the nearest places on curves.
class Borders
{
public:
  explicit Borders(const std::vector<BorderCurve>& curves)
  {
    Index size = 0;
    for (const BorderCurve& curve : curves)
    {
      size += curve.Positions.rows();
    }
    this->All = { Points(size, 3), Points(size, 3), Points(size, 3) };
    Index begin = 0;
    for (const BorderCurve& curve : curves)
    {
      const Index count = curve.Positions.rows();
      this->All.Positions.middleRows(begin, count) = curve.Positions;
      this->All.Normals.middleRows(begin, count) = curve.Normals;
      this->All.Outward.middleRows(begin, count) = curve.Outward;
      for (Index i = 0; i < count; ++i)
      {
        this->Next.push_back(static_cast<int>(begin + (i + 1) % count));
        this->Previous.push_back(static_cast<int>(begin + (i + count - 1) % count));
      }
      begin += count;
    }
    this->Tree = PointTree(this->All.Positions);
  }

  NearestBorder nearest(const Vector3& x) const
  {
    const int node = this->Tree.nearest(x).Id;
    const auto [after, t1] = this->along(node, this->Next[node], x);
    const auto [before, t0] = this->along(node, this->Previous[node], x);
    const bool isAfter = after <= before;
    const int other = isAfter ? this->Next[node] : this->Previous[node];
    const double t = isAfter ? t1 : t0;
    const auto between = [&](const Points& values) -> Vector3
    { return (1.0 - t) * values.row(node) + t * values.row(other); };
    NearestBorder found;
    found.Place = between(this->All.Positions);
    found.Normal = between(this->All.Normals).stableNormalized();
    const Vector3 apart = x - found.Place;
    found.Height = std::copysign(apart.norm(), apart.dot(between(this->All.Outward)));
    return found;
  }

private:
  /// Distance of x from a segment, and the parameter of the closest place.
  std::pair<double, double> along(int from, int to, const Vector3& x) const
  {
    const Vector3 a = this->All.Positions.row(from),
                  way = this->All.Positions.row(to) - a.transpose();
    const double square = way.squaredNorm();
    const double t = square > 0.0 ? std::clamp((x - a).dot(way) / square, 0.0, 1.0) : 0.0;
    return { (x - a - t * way).norm(), t };
  }

  BorderCurve All;
  std::vector<int> Next, Previous;
  PointTree Tree;
};

/// Mesh with the height of each vertex beyond the border, before triangles are split.
struct Heights
{
  Points Positions;
  std::vector<double> Values;
};

double meanEdge(const BorderSurface& surface, const Adjacency& neighbors, Index v)
{
  double sum = 0.0;
  for (const int* j = neighbors.begin(v); j != neighbors.end(v); ++j)
  {
    sum += (surface.Mesh.Positions.row(*j) - surface.Mesh.Positions.row(v)).norm();
  }
  return sum / std::max(neighbors.size(v), 1);
}

/// Restore the sign of heights where a curve passes near another part of the surface. The fit moves
/// the border from edges between vertices with different marks. A vertex on the other side than
/// before is therefore connected to such an edge by vertices of this kind.
void restoreSigns(const Adjacency& neighbors, const std::vector<char>& open, double band,
  std::vector<double>& heights)
{
  const auto size = static_cast<Index>(heights.size());
  const auto changed = [&](Index v) { return open[v] ? heights[v] < 0.0 : heights[v] > 0.0; };
  std::vector<char> reached(size, 0);
  std::vector<int> front;
  const auto reach = [&](int v)
  {
    if (changed(v) && !reached[v])
    {
      reached[v] = 1;
      front.push_back(v);
    }
  };
  for (int v = 0; v < size; ++v)
  {
    if (std::any_of(
          neighbors.begin(v), neighbors.end(v), [&](int j) { return open[j] != open[v]; }))
    {
      reach(v);
    }
  }
  while (!front.empty())
  {
    const int v = front.back();
    front.pop_back();
    std::for_each(neighbors.begin(v), neighbors.end(v), reach);
  }
  for (Index v = 0; v < size; ++v)
  {
    if (changed(v) && !reached[v])
    {
      heights[v] = open[v] ? band : -band;
    }
  }
}

/// Compute heights. Vertices near a curve are moved to it, unless they are fixed.
Heights heightsOf(const BorderSurface& surface, const std::vector<char>& open,
  const Borders& borders, const std::vector<char>& fixed)
{
  constexpr double snap = 0.25;     // mean edges
  constexpr double opposite = -0.3; // cosine; the other side of a thin sheet
  constexpr double steepest = 0.8;  // sine of the angle to the surface at the border
  const Mesh& mesh = surface.Mesh;
  const double band = BandWidth * surface.EdgeLength, flat = 0.5 * surface.EdgeLength;
  const Adjacency neighbors = vertexNeighbors(mesh.Triangles, mesh.Positions.rows());
  Heights heights{ mesh.Positions, std::vector<double>(mesh.Positions.rows()) };
  std::vector<Vector3> places(mesh.Positions.rows());
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const Vector3 x = mesh.Positions.row(v);
    const NearestBorder border = borders.nearest(x);
    const double distance = std::abs(border.Height);
    const bool isNear = distance < band &&
      border.Normal.dot(surface.VertexNormals.row(v)) > opposite &&
      std::abs(border.Normal.dot(x - border.Place)) < std::max(steepest * distance, flat);
    heights.Values[v] = isNear ? border.Height : open[v] ? band : -band;
    places[v] = border.Place;
  }
  restoreSigns(neighbors, open, band, heights.Values);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    if (!fixed[v] && std::abs(heights.Values[v]) < snap * meanEdge(surface, neighbors, v))
    {
      heights.Positions.row(v) = places[v];
      heights.Values[v] = 0.0;
    }
  }
  return heights;
}

/// Splits triangles at height 0 and keeps the lower parts.
class Splitting
{
public:
  Splitting(const Heights& heights, const Borders& borders, double reach)
    : H(heights)
    , Curves(borders)
    , Reach(reach)
  {
    for (int v = 0; v < static_cast<int>(heights.Values.size()); ++v)
    {
      this->Vertices.push_back({ v, v, 0.0 });
    }
  }

  void add(const Corners& corners)
  {
    const auto below =
      std::count_if(corners.begin(), corners.end(), [&](int v) { return this->H.Values[v] < 0.0; });
    const auto above =
      std::count_if(corners.begin(), corners.end(), [&](int v) { return this->H.Values[v] > 0.0; });
    if (below == 0)
    {
      return;
    }
    if (above == 0)
    {
      this->Kept.push_back(corners);
      return;
    }
    // The polygon of the corners below or on the border, and of the cuts of the edges.
    std::vector<int> polygon;
    for (int k = 0; k < 3; ++k)
    {
      const int a = corners[k], b = corners[next(k)];
      if (this->H.Values[a] <= 0.0)
      {
        polygon.push_back(a);
      }
      if (this->H.Values[a] * this->H.Values[b] < 0.0)
      {
        polygon.push_back(this->cut(a, b));
      }
    }
    if (polygon.size() == 3)
    {
      this->Kept.push_back({ polygon[0], polygon[1], polygon[2] });
      return;
    }
    const int first =
      this->distance(polygon[0], polygon[2]) <= this->distance(polygon[1], polygon[3]) ? 0 : 1;
    const auto at = [&](int k) { return polygon[(first + k) % 4]; };
    this->Kept.push_back({ at(0), at(1), at(2) });
    this->Kept.push_back({ at(0), at(2), at(3) });
  }

  CutSheet sheet() const
  {
    CutSheet sheet;
    sheet.Vertices = this->Vertices;
    sheet.Positions.resize(static_cast<Index>(this->Vertices.size()), 3);
    for (int v = 0; v < static_cast<int>(this->Vertices.size()); ++v)
    {
      sheet.Positions.row(v) = this->position(v);
    }
    sheet.Triangles.resize(static_cast<Index>(this->Kept.size()), 3);
    for (Index f = 0; f < sheet.Triangles.rows(); ++f)
    {
      sheet.Triangles.row(f) << this->Kept[f][0], this->Kept[f][1], this->Kept[f][2];
    }
    return sheet;
  }

private:
  int cut(int a, int b)
  {
    const auto found = this->Cuts.find(std::minmax(a, b));
    if (found != this->Cuts.end())
    {
      return found->second;
    }
    const auto [first, second] = std::minmax(a, b);
    const double low = this->H.Values[first], high = this->H.Values[second];
    const double t = low / (low - high);
    const Vector3 x = (1.0 - t) * this->H.Positions.row(first) + t * this->H.Positions.row(second);
    const NearestBorder border = this->Curves.nearest(x);
    const int id = static_cast<int>(this->Vertices.size());
    this->Vertices.push_back({ first, second, t });
    this->New.push_back(std::abs(border.Height) < this->Reach ? border.Place : x);
    this->Cuts[{ first, second }] = id;
    return id;
  }

  Vector3 position(int v) const
  {
    const auto old = static_cast<int>(this->H.Values.size());
    return v < old ? Vector3(this->H.Positions.row(v)) : this->New[v - old];
  }

  double distance(int a, int b) const { return (this->position(a) - this->position(b)).norm(); }

  const Heights& H;
  const Borders& Curves;
  double Reach;
  std::vector<CutVertex> Vertices;
  std::vector<Vector3> New;
  std::vector<Corners> Kept;
  std::map<Ends, int> Cuts;
};

/// Keep the largest connected part, without isolated vertices.
CutSheet largestPart(CutSheet all, double wholeArea)
{
  DisjointSets sets(all.Positions.rows());
  for (Index f = 0; f < all.Triangles.rows(); ++f)
  {
    sets.unite(all.Triangles(f, 0), all.Triangles(f, 1));
    sets.unite(all.Triangles(f, 0), all.Triangles(f, 2));
  }
  std::vector<double> areas(all.Positions.rows(), 0.0);
  double sum = 0.0;
  for (Index f = 0; f < all.Triangles.rows(); ++f)
  {
    const double area = areaVector(all.Positions, all.Triangles, f).norm();
    areas[sets.find(all.Triangles(f, 0))] += area;
    sum += area;
  }
  const int largest =
    static_cast<int>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  CutSheet part;
  part.DroppedFraction = wholeArea > 0.0 ? (sum - areas[largest]) / wholeArea : 0.0;
  part.Triangles.resize(all.Triangles.rows(), 3);
  Index count = 0;
  for (Index f = 0; f < all.Triangles.rows(); ++f)
  {
    if (sets.find(all.Triangles(f, 0)) == largest)
    {
      part.Triangles.row(count++) = all.Triangles.row(f);
    }
  }
  part.Triangles.conservativeResize(count, 3);
  const std::vector<int> ids = dropIsolatedPoints(part.Triangles, all.Positions.rows());
  part.Positions.resize(static_cast<Index>(ids.size()), 3);
  for (Index v = 0; v < part.Positions.rows(); ++v)
  {
    part.Positions.row(v) = all.Positions.row(ids[v]);
    part.Vertices.push_back(all.Vertices[ids[v]]);
  }
  return part;
}

CutSheet cutAt(const BorderSurface& surface, const std::vector<char>& open, const Borders& borders,
  const std::vector<char>& fixed)
{
  const Heights heights = heightsOf(surface, open, borders, fixed);
  Splitting splitting(heights, borders, 0.5 * surface.EdgeLength);
  for (Index f = 0; f < surface.Mesh.Triangles.rows(); ++f)
  {
    const auto ids = surface.Mesh.Triangles.row(f);
    splitting.add({ ids[0], ids[1], ids[2] });
  }
  return largestPart(
    splitting.sheet(), surfaceArea(surface.Mesh.Positions, surface.Mesh.Triangles));
}
}

CutSheet cutSheet(const BorderSurface& surface, const std::vector<char>& open,
  const std::vector<BorderCurve>& borders)
{
  // A vertex that was moved to the curve may connect two parts of the sheet that otherwise do not
  // touch. It is then left where it is.
  constexpr int attempts = 10;
  const Borders curves(borders);
  std::vector<char> fixed(surface.Mesh.Positions.rows(), 0);
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    CutSheet sheet = cutAt(surface, open, curves, fixed);
    if (sheet.Triangles.rows() == 0)
    {
      return {};
    }
    const GenusZeroReport report = checkGenusZero(sheet.Triangles, sheet.Positions.rows());
    if (report.isSheet())
    {
      return sheet;
    }
    for (const auto& v : report.NonManifoldVertices)
    {
      fixed[sheet.Vertices[v].First] = fixed[sheet.Vertices[v].Second] = 1;
    }
  }
  return {};
}
}

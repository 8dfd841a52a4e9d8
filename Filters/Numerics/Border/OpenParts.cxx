#include "Border/OpenParts.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <numeric>

namespace conformal
{
namespace
{
constexpr double SmallHole = 0.1; // of the area of the largest part

// A connected part of the surface without points.
struct Part
{
  double Area = 0.0;
  Vector3 Center = Vector3::Zero(); // mean weighted by area, after division by the area
  double Radius = 0.0;              // largest distance of a vertex from the center
};

/// Connect vertices with equal marks along edges.
DisjointSets connected(const Mesh& mesh, const std::vector<char>& marks)
{
  DisjointSets sets(mesh.Positions.rows());
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = mesh.Triangles(f, k), b = mesh.Triangles(f, next(k));
      if (marks[a] == marks[b])
      {
        sets.unite(a, b);
      }
    }
  }
  return sets;
}

/// Add the neighbors of marked vertices.
std::vector<char> widened(const Mesh& mesh, const std::vector<char>& marks)
{
  std::vector<char> wider = marks;
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    const auto ids = mesh.Triangles.row(f);
    if (marks[ids[0]] || marks[ids[1]] || marks[ids[2]])
    {
      wider[ids[0]] = wider[ids[1]] = wider[ids[2]] = 1;
    }
  }
  return wider;
}

/// Mark all unmarked vertices but those of the largest connected part. Parts that are connected
/// only by bridges of one or two vertices are separate.
/// @return area of the vertices that were marked
double markIslands(const Mesh& mesh, const std::vector<double>& areas, std::vector<char>& marks)
{
  const auto size = static_cast<int>(areas.size());
  const std::vector<char> wide = widened(mesh, marks);
  DisjointSets sets = connected(mesh, wide);
  std::vector<double> ofParts(areas.size(), 0.0);
  for (int v = 0; v < size; ++v)
  {
    ofParts[sets.find(v)] += wide[v] ? 0.0 : areas[v];
  }
  const int largest =
    static_cast<int>(std::max_element(ofParts.begin(), ofParts.end()) - ofParts.begin());
  std::vector<char> kept(areas.size(), 0);
  for (int v = 0; v < size; ++v)
  {
    kept[v] = !wide[v] && sets.find(v) == largest;
  }
  kept = widened(mesh, kept);
  double area = 0.0;
  for (int v = 0; v < size; ++v)
  {
    if (!marks[v] && !kept[v])
    {
      marks[v] = 1;
      area += areas[v];
    }
  }
  return area;
}

std::vector<double> areasOfVertices(const Mesh& mesh)
{
  std::vector<double> areas(mesh.Positions.rows(), 0.0);
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    const double third = areaVector(mesh.Positions, mesh.Triangles, f).norm() / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      areas[mesh.Triangles(f, k)] += third;
    }
  }
  return areas;
}
}

OpenParts findOpenParts(
  const Mesh& mesh, const std::vector<double>& support, const BorderOptions& options)
{
  const Index size = mesh.Positions.rows();
  OpenParts open;
  open.Marks.assign(size, 0);
  std::vector<char> bare(size);
  for (Index v = 0; v < size; ++v)
  {
    bare[v] = support[v] < HalfSupport;
  }
  DisjointSets sets = connected(mesh, bare);
  const std::vector<double> areas = areasOfVertices(mesh);
  std::vector<Part> parts(size);
  for (int v = 0; v < size; ++v)
  {
    if (bare[v])
    {
      Part& part = parts[sets.find(v)];
      part.Area += areas[v];
      part.Center += areas[v] * mesh.Positions.row(v).transpose();
    }
  }
  double largest = 0.0;
  for (Part& part : parts)
  {
    part.Center /= part.Area > 0.0 ? part.Area : 1.0;
    largest = std::max(largest, part.Area);
  }
  for (int v = 0; v < size; ++v)
  {
    if (bare[v])
    {
      Part& part = parts[sets.find(v)];
      part.Radius = std::max(part.Radius, (mesh.Positions.row(v).transpose() - part.Center).norm());
    }
  }
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  open.LargestFraction = whole > 0.0 ? largest / whole : 0.0;
  if (!(largest > 0.0) || options.Border == Border::Closed ||
    (options.Border == Border::Automatic && open.LargestFraction < OpenFraction))
  {
    return open;
  }
  const auto isOpen = [&](const Part& part)
  {
    return part.Area == largest ||
      (options.HoleSize > 0.0 ? part.Radius > options.HoleSize : part.Area >= SmallHole * largest);
  };
  double area = 0.0;
  for (int v = 0; v < size; ++v)
  {
    open.Marks[v] = bare[v] && isOpen(parts[sets.find(v)]);
    area += open.Marks[v] ? areas[v] : 0.0;
  }
  open.Fraction = area / whole;
  open.IslandFraction = markIslands(mesh, areas, open.Marks) / whole;
  return open;
}
}

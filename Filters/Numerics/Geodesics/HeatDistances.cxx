#include "Geodesics/HeatDistances.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace conformal
{
namespace
{
// Meshes with fewer vertices are divided. The largest ones then have less than four times as many.
constexpr Index FewVertices = 25000;
constexpr double FinestTime = 1.0 / 400.0; // fraction of the largest distance
// Number that makes Poisson's equation positive definite, in units of 1 / area.
constexpr double Shift = 1e-6;

struct Equations
{
  std::vector<Eigen::Triplet<double>> Laplacian;
  Eigen::VectorXd Masses; // area of each vertex
};

// Assemble the cotangent Laplacian, \cite Pinkall1993, and the areas.
Equations assemble(const IntrinsicTriangulation& surface, Index numberOfVertices)
{
  Equations result;
  result.Masses = Eigen::VectorXd::Zero(numberOfVertices);
  result.Laplacian.reserve(12 * surface.Triangles.rows());
  for (Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Vector3 cotangents = cotangentsOf(surface.Lengths.row(t));
    const double area = areaOf(surface.Lengths.row(t));
    for (int k = 0; k < 3; ++k)
    {
      const int i = surface.Triangles(t, (k + 1) % 3), j = surface.Triangles(t, (k + 2) % 3);
      result.Masses[surface.Triangles(t, k)] += area / 3.0;
      const double weight = 0.5 * cotangents[k];
      if (i != j)
      {
        result.Laplacian.emplace_back(i, j, -weight);
        result.Laplacian.emplace_back(j, i, -weight);
        result.Laplacian.emplace_back(i, i, weight);
        result.Laplacian.emplace_back(j, j, weight);
      }
    }
  }
  return result;
}

// Return the Laplacian with a factor for each row, plus a diagonal.
SparseMatrix matrixOf(
  const Equations& equations, const Eigen::VectorXd& factors, const Eigen::VectorXd& diagonal)
{
  const Index size = diagonal.size();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(equations.Laplacian.size() + size);
  for (const Eigen::Triplet<double>& entry : equations.Laplacian)
  {
    entries.emplace_back(entry.row(), entry.col(), factors[entry.row()] * entry.value());
  }
  for (Index v = 0; v < size; ++v)
  {
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), diagonal[v]);
  }
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Divide each triangle into four at the midpoints of its edges. The old vertices come first.
Mesh quartered(const Mesh& mesh)
{
  std::vector<std::pair<int, int>> edges;
  const auto edgeOf = [&](Index t, int k) {
    return std::minmax({ mesh.Triangles(t, k), mesh.Triangles(t, (k + 1) % 3) });
  };
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.emplace_back(edgeOf(t, k));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const Index size = mesh.Positions.rows(), count = static_cast<Index>(edges.size());
  Mesh result;
  result.Positions.resize(size + count, 3);
  result.Positions.topRows(size) = mesh.Positions;
  for (Index e = 0; e < count; ++e)
  {
    result.Positions.row(size + e) =
      0.5 * (mesh.Positions.row(edges[e].first) + mesh.Positions.row(edges[e].second));
  }
  result.Triangles.resize(4 * mesh.Triangles.rows(), 3);
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const auto corners = mesh.Triangles.row(t);
    int middles[3];
    for (int k = 0; k < 3; ++k)
    {
      const auto found =
        std::lower_bound(edges.begin(), edges.end(), std::pair<int, int>(edgeOf(t, k)));
      middles[k] = static_cast<int>(size + (found - edges.begin()));
    }
    for (int k = 0; k < 3; ++k)
    {
      result.Triangles.row(4 * t + k) << corners[k], middles[k], middles[(k + 2) % 3];
    }
    result.Triangles.row(4 * t + 3) << middles[0], middles[1], middles[2];
  }
  return result;
}

// Follow paths with few edges from a vertex to all others of its part. Return the vertex with the
// longest path.
int farthestFrom(
  const Mesh& mesh, const Adjacency& neighbors, int from, std::vector<double>& lengths)
{
  int farthest = from;
  lengths[from] = 0.0;
  std::vector<int> queue = { from };
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const int v = queue[i];
    farthest = lengths[v] > lengths[farthest] ? v : farthest;
    for (const int* u = neighbors.begin(v); u != neighbors.end(v); ++u)
    {
      if (lengths[*u] < 0.0)
      {
        lengths[*u] = lengths[v] + (mesh.Positions.row(*u) - mesh.Positions.row(v)).norm();
        queue.push_back(*u);
      }
    }
  }
  return farthest;
}

// Estimate the largest distance between two vertices of each part, by the length of a path. The
// estimate belongs to the first vertex of the part.
std::vector<double> spansOf(const Mesh& mesh, const std::vector<int>& parts)
{
  const Index size = mesh.Positions.rows();
  const Adjacency neighbors = vertexNeighbors(mesh.Triangles, size);
  std::vector<double> fromFirst(size, -1.0), fromFar(size, -1.0), spans(size, 0.0);
  for (int v = 0; v < static_cast<int>(size); ++v)
  {
    if (parts[v] == v)
    {
      const int far = farthestFrom(mesh, neighbors, v, fromFirst);
      spans[v] = fromFar[farthestFrom(mesh, neighbors, far, fromFar)];
    }
  }
  return spans;
}

// Compute the area of each connected part. It belongs to the first vertex of the part.
std::vector<double> areasOf(const std::vector<int>& parts, const Eigen::VectorXd& masses)
{
  std::vector<double> areas(parts.size(), 0.0);
  for (std::size_t v = 0; v < parts.size(); ++v)
  {
    areas[parts[v]] += masses[static_cast<Index>(v)];
  }
  return areas;
}
}

//------------------------------------------------------------------------------
HeatDistances::HeatDistances(const Mesh& mesh, const Run& run)
{
  Steps steps(run, { 0.2, 0.4, 0.4 });
  Mesh fine = mesh;
  while (fine.Positions.rows() < FewVertices && fine.Triangles.rows() > 0 &&
    fine.Triangles.rows() < 4 * FewVertices)
  {
    fine = quartered(fine);
  }
  this->NumberOfVertices = mesh.Positions.rows();
  this->Surface = intrinsicDelaunay(fine, steps.next());
  const std::vector<int>& parts = this->Surface.Parts;
  const auto size = static_cast<Index>(parts.size());
  const Equations equations = assemble(this->Surface, size);
  const SidesOfParts sides = sidesOfParts(this->Surface);
  const std::vector<double> areas = areasOf(parts, equations.Masses);
  const std::vector<double> spans = spansOf(fine, parts);
  // Parts can differ much in size. Each one has its own time of the heat flow.
  Eigen::VectorXd masses(size), shifts(size), times(size);
  for (Index v = 0; v < size; ++v)
  {
    const int part = parts[v];
    const double area = areas[part];
    if (area > 0.0)
    {
      const double edge = sides.Lengths[part] / sides.Counts[part];
      masses[v] = std::max(equations.Masses[v], 1e-7 * area / static_cast<double>(size));
      shifts[v] = Shift * masses[v] / area;
      times[v] = std::pow(std::max(edge, FinestTime * spans[part]), 2);
    }
    else // the vertex has an equation of its own
    {
      masses[v] = shifts[v] = 1.0;
      times[v] = 0.0;
    }
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(size);
  const Points& places = this->Surface.Positions;
  this->Factors.push_back(factorize(matrixOf(equations, times, masses), places, 1, steps.next()));
  this->Factors.push_back(factorize(matrixOf(equations, ones, shifts), places, 1, steps.next()));
}

Eigen::VectorXd HeatDistances::from(const std::vector<int>& sources) const
{
  return this->fineDistances(sources).head(this->NumberOfVertices);
}

Eigen::VectorXd HeatDistances::fineDistances(const std::vector<int>& sources) const
{
  const auto size = static_cast<Index>(this->Surface.Parts.size());
  Columns heat = Columns::Zero(size, 1);
  std::vector<char> isReached(size, 0);
  for (const int source : sources)
  {
    heat(source, 0) = 1.0;
    isReached[this->Surface.Parts[source]] = 1;
  }
  this->Factors[0].solve(heat);
  for (Index v = 0; v < size; ++v)
  {
    if (isReached[this->Surface.Parts[v]] && !(heat(v, 0) > 0.0))
    {
      throw NumericalFailure("the heat does not reach all points that are connected with a source");
    }
  }
  Columns potential = this->divergence(heat.col(0));
  this->Factors[1].solve(potential);
  // In each part, the smallest distance of a source is 0.
  std::vector<double> lowest(size, std::numeric_limits<double>::infinity());
  for (const int source : sources)
  {
    double& low = lowest[this->Surface.Parts[source]];
    low = std::min(low, potential(source, 0));
  }
  Eigen::VectorXd distances(size);
  for (Index v = 0; v < size; ++v)
  {
    distances[v] = isReached[this->Surface.Parts[v]]
      ? std::max(0.0, potential(v, 0) - lowest[this->Surface.Parts[v]])
      : -1.0;
  }
  for (const int source : sources)
  {
    distances[source] = 0.0;
  }
  return distances;
}

// Compute the divergence of unit vectors that point away from the sources, times -1,
// \cite Crane2013 section 3.2.
Eigen::VectorXd HeatDistances::divergence(const Eigen::VectorXd& heat) const
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(heat.size());
  for (Index t = 0; t < this->Surface.Triangles.rows(); ++t)
  {
    const Vector3 lengths = this->Surface.Lengths.row(t);
    const auto ids = this->Surface.Triangles.row(t);
    const double area = areaOf(lengths);
    if (!(area > 0.0))
    {
      continue;
    }
    // Corners in the plane of the triangle.
    using Vector2 = Eigen::Vector2d;
    const double x = (lengths[0] * lengths[0] + lengths[2] * lengths[2] - lengths[1] * lengths[1]) /
      (2.0 * lengths[0]);
    const Vector2 corners[] = { { 0.0, 0.0 }, { lengths[0], 0.0 }, { x, 2.0 * area / lengths[0] } };
    // Heat can be very small. Divide it by the largest value of the triangle.
    const double largest = std::max({ heat[ids[0]], heat[ids[1]], heat[ids[2]] });
    if (!(largest > 0.0))
    {
      continue;
    }
    Vector2 gradient = Vector2::Zero();
    Vector2 inward[3]; // perpendicular to the opposite edge, of the length of this edge
    for (int k = 0; k < 3; ++k)
    {
      const Vector2 opposite = corners[(k + 2) % 3] - corners[(k + 1) % 3];
      inward[k] = { -opposite.y(), opposite.x() };
      gradient += heat[ids[k]] / largest * inward[k];
    }
    const double length = gradient.norm();
    if (length > 0.0)
    {
      for (int k = 0; k < 3; ++k)
      {
        result[ids[k]] -= 0.5 * gradient.dot(inward[k]) / length;
      }
    }
  }
  return result;
}

NearestSources HeatDistances::nearestSources(const std::vector<int>& sources) const
{
  const Eigen::VectorXd distances = this->fineDistances(sources);
  const Index size = distances.size();
  std::vector<int> previous(size, -1), nearest(size, -1);
  std::vector<double> least(size, std::numeric_limits<double>::infinity());
  for (Index t = 0; t < this->Surface.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = this->Surface.Triangles(t, k), b = this->Surface.Triangles(t, (k + 1) % 3);
      const double length = this->Surface.Lengths(t, k);
      for (const auto& [from, to] : { std::pair(a, b), std::pair(b, a) })
      {
        if (distances[from] < distances[to] && distances[from] + length < least[to])
        {
          least[to] = distances[from] + length;
          previous[to] = from;
        }
      }
    }
  }
  for (std::size_t s = sources.size(); s-- > 0;)
  {
    nearest[sources[s]] = static_cast<int>(s);
  }
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return distances[a] < distances[b]; });
  for (const int v : order)
  {
    if (nearest[v] < 0 && previous[v] >= 0)
    {
      nearest[v] = nearest[previous[v]];
    }
  }
  this->spread(distances, nearest);
  nearest.resize(this->NumberOfVertices);
  return { distances.head(this->NumberOfVertices), nearest };
}

// Assign sources to the remaining vertices, such as those where errors make the distance smaller
// than at all neighbors: the source of a neighbor.
void HeatDistances::spread(const Eigen::VectorXd& distances, std::vector<int>& nearest) const
{
  std::vector<double> least(nearest.size(), std::numeric_limits<double>::infinity());
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    std::vector<int> found = nearest;
    for (Index t = 0; t < this->Surface.Triangles.rows(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = this->Surface.Triangles(t, k), b = this->Surface.Triangles(t, (k + 1) % 3);
        for (const auto& [from, to] : { std::pair(a, b), std::pair(b, a) })
        {
          const double length = distances[from] + this->Surface.Lengths(t, k);
          if (nearest[from] >= 0 && nearest[to] < 0 && length < least[to])
          {
            least[to] = length;
            found[to] = nearest[from];
            isChanged = true;
          }
        }
      }
    }
    nearest = std::move(found);
  }
}

std::vector<int> HeatDistances::usedVertices() const
{
  std::vector<int> used = conformal::usedVertices(
    this->Surface.Triangles, static_cast<Index>(this->Surface.Parts.size()));
  used.erase(std::lower_bound(used.begin(), used.end(), static_cast<int>(this->NumberOfVertices)),
    used.end());
  return used;
}

//------------------------------------------------------------------------------
void addFarthestVertices(
  const HeatDistances& surface, Index count, std::vector<int>& sources, const Run& run)
{
  // Parts without a source are infinitely far.
  Eigen::VectorXd distances = surface.from(sources);
  for (const int v : surface.usedVertices())
  {
    distances[v] = distances[v] < 0.0 ? std::numeric_limits<double>::infinity() : distances[v];
  }
  for (Index i = 0; i < count; ++i)
  {
    Index farthest = 0;
    if (!(distances.maxCoeff(&farthest) > 0.0))
    {
      break;
    }
    sources.push_back(static_cast<int>(farthest));
    const Eigen::VectorXd ofLast = surface.from({ sources.back() });
    distances = (ofLast.array() < 0.0).select(distances, distances.cwiseMin(ofLast));
    run.report(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  run.report(1.0);
}
}

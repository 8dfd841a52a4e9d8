#include "Volume/LayerLimits.h"

#include "Base/Steps.h"
#include "Mesh/MeshTopology.h"
#include "Search/PointTree.h"
#include "Search/SelfIntersections.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace conformal
{
namespace
{
constexpr double Safety = 0.9;

// Radius of the largest ball, up to a maximum, that touches the surface at a vertex and contains no
// other vertex.
double ballRadius(
  const PointTree& tree, const Points& points, Index vertex, const Vector3& normal, double maximum)
{
  constexpr int mostSteps = 50;
  constexpr double tolerance = 1e-9;
  const Vector3 p = points.row(vertex);
  std::vector<Neighbor> nearest;
  double radius = maximum;
  for (int step = 0; step < mostSteps && radius > 0.0; ++step)
  {
    const Vector3 center = p + radius * normal;
    tree.nearest(center, 2, nearest);
    const auto other = std::find_if(
      nearest.begin(), nearest.end(), [&](const Neighbor& n) { return n.Id != vertex; });
    if (other == nearest.end() ||
      other->SquareDistance >= radius * radius * (1.0 - tolerance) * (1.0 - tolerance))
    {
      break;
    }
    const Vector3 apart = points.row(other->Id).transpose() - p;
    radius = std::min(radius, apart.squaredNorm() / (2.0 * normal.dot(apart)));
  }
  return radius;
}

// Reduce limits so that those of neighbors differ by at most their distance.
void makeEven(std::vector<double>& limits, const Points& points, const Adjacency& neighbors)
{
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  for (std::size_t i = 0; i < limits.size(); ++i)
  {
    queue.emplace(limits[i], static_cast<int>(i));
  }
  while (!queue.empty())
  {
    const auto [limit, vertex] = queue.top();
    queue.pop();
    if (limit > limits[vertex])
    {
      continue;
    }
    for (const int* other = neighbors.begin(vertex); other != neighbors.end(vertex); ++other)
    {
      const double bound = limit + (points.row(vertex) - points.row(*other)).norm();
      if (bound < limits[*other])
      {
        limits[*other] = bound;
        queue.emplace(bound, *other);
      }
    }
  }
}

// Triangles of a layer that are inverted, or cross another triangle.
std::vector<int> faultyTriangles(
  const Mesh& surface, const Points& normals, const Points& layer, const Run& run)
{
  std::vector<int> faulty;
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    const Vector3 before = areaVector(surface.Positions, surface.Triangles, r),
                  after = areaVector(layer, surface.Triangles, r);
    Vector3 mean = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      mean += normals.row(surface.Triangles(r, k)).transpose();
    }
    // A triangle without area has no orientation to lose.
    if (before.squaredNorm() > 0.0 && before.dot(mean) > 0.0 && !(after.dot(mean) > 0.0))
    {
      faulty.push_back(static_cast<int>(r));
    }
  }
  for (const auto& pair : selfIntersections(layer, surface.Triangles, run))
  {
    faulty.insert(faulty.end(), pair.begin(), pair.end());
  }
  std::sort(faulty.begin(), faulty.end());
  faulty.erase(std::unique(faulty.begin(), faulty.end()), faulty.end());
  return faulty;
}

// Triangles of layers that are inverted or cross others: their number, their vertices on each side,
// and the depths of the layers.
struct LayerFaults
{
  std::vector<double> Depths;
  Index Count = 0;
  std::vector<unsigned char> Inward, Outward;
};

class Reduction
{
public:
  Reduction(const Mesh& surface, const Points& normals, const Adjacency& neighbors)
    : Surface(surface)
    , Normals(normals)
    , Neighbors(neighbors)
  {
  }

  LayerFaults find(
    const LayerLimits& limits, const std::vector<double>& depths, const Run& run) const
  {
    LayerFaults faults;
    faults.Inward.assign(this->normalsSize(), 0);
    faults.Outward.assign(this->normalsSize(), 0);
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      run.report(static_cast<double>(i) / static_cast<double>(depths.size()));
      const Points layer = layerPositions(this->Surface, this->Normals, limits, depths[i]);
      const std::vector<int> faulty =
        faultyTriangles(this->Surface, this->Normals, layer, run.unwatched());
      faults.Count += static_cast<Index>(faulty.size());
      for (const int r : faulty)
      {
        for (int k = 0; k < 3; ++k)
        {
          (depths[i] < 0.0 ? faults.Inward : faults.Outward)[this->Surface.Triangles(r, k)] = 1;
        }
      }
      if (!faulty.empty())
      {
        faults.Depths.push_back(depths[i]);
      }
    }
    return faults;
  }

  void reduce(LayerLimits& limits, const LayerFaults& faults) const
  {
    constexpr double factor = 0.7;
    for (Index v = 0; v < this->normalsSize(); ++v)
    {
      limits.Inward[v] *= faults.Inward[v] ? factor : 1.0;
      limits.Outward[v] *= faults.Outward[v] ? factor : 1.0;
    }
    makeEven(limits.Inward, this->Surface.Positions, this->Neighbors);
    makeEven(limits.Outward, this->Surface.Positions, this->Neighbors);
  }

private:
  Index normalsSize() const { return this->Normals.rows(); }

  const Mesh& Surface;
  const Points& Normals;
  const Adjacency& Neighbors;
};
}

//------------------------------------------------------------------------------
double LayerLimits::depthAt(Index vertex, double wanted) const
{
  return std::clamp(wanted, -this->Inward[vertex], this->Outward[vertex]);
}

//------------------------------------------------------------------------------
Points layerPositions(
  const Mesh& surface, const Points& normals, const LayerLimits& limits, double depth)
{
  Points layer = surface.Positions;
  for (Index v = 0; v < layer.rows(); ++v)
  {
    layer.row(v) += limits.depthAt(v, depth) * normals.row(v);
  }
  return layer;
}

//------------------------------------------------------------------------------
LayerLimits limitLayers(
  const Mesh& surface, const Points& normals, const std::vector<double>& depths, const Run& run)
{
  double inward = 0.0, outward = 0.0;
  for (const double depth : depths)
  {
    inward = std::max(inward, -depth);
    outward = std::max(outward, depth);
  }
  const Index size = surface.Positions.rows();
  LayerLimits limits;
  limits.Inward.resize(size);
  limits.Outward.resize(size);
  Steps steps(run, { 0.05, 0.25, 0.5, 0.2 }); // tree, balls, tests, last test
  const PointTree tree(surface.Positions, steps.next());
  forBlocksReporting(steps.next(), size, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const Vector3 normal = normals.row(v);
        const bool hasNormal = normal.squaredNorm() > 0.0;
        const auto limit = [&](double side, double wanted)
        {
          // A ball that is larger than the layers need not be measured.
          const double radius = hasNormal
            ? ballRadius(tree, surface.Positions, v, side * normal, wanted / Safety)
            : 0.0;
          return std::min(wanted, Safety * radius);
        };
        limits.Inward[v] = limit(-1.0, inward);
        limits.Outward[v] = limit(1.0, outward);
      }
    });
  const Adjacency neighbors = vertexNeighbors(surface.Triangles, size);
  makeEven(limits.Inward, surface.Positions, neighbors);
  makeEven(limits.Outward, surface.Positions, neighbors);
  const Reduction reduction(surface, normals, neighbors);
  constexpr int mostRounds = 20;
  const Run watch = steps.next();
  std::vector<double> tested = depths;
  for (int round = 0; round < mostRounds; ++round)
  {
    const LayerFaults faults = reduction.find(
      limits, tested, watch.part(double(round) / mostRounds, double(round + 1) / mostRounds));
    if (faults.Depths.empty() && tested.size() == depths.size())
    {
      run.report(1.0);
      return limits;
    }
    if (!faults.Depths.empty())
    {
      reduction.reduce(limits, faults);
    }
    // If limits are reduced at one layer, layers that were good can change.
    tested = faults.Depths.empty() ? depths : faults.Depths;
  }
  limits.NumberOfFaults = reduction.find(limits, depths, steps.next()).Count;
  return limits;
}
}

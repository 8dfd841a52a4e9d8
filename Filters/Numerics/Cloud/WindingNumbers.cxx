#include "Cloud/WindingNumbers.h"

#include "Search/BoxTree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace conformal
{
namespace
{
// Minimum distance of a distant cluster, divided by half of its longest side
constexpr double Farness = 4.0;
constexpr int LeafSize = 8, GroupSize = 16, RunSize = 64;
constexpr Index GroupsPerBlock = 8;

// Positions that are evaluated together, one per SIMD lane.
constexpr int NumberOfLanes = 8;
using Lanes = Eigen::Array<float, NumberOfLanes, 1>;

struct LanePlaces
{
  std::array<Lanes, 3> X;
};

// Differences from positions to a source, and the divisor of the kernel.
struct Way
{
  Way(const LanePlaces& places, const Eigen::Vector3f& to, float squareWidth)
    : D{ to[0] - places.X[0], to[1] - places.X[1], to[2] - places.X[2] }
    , Square((this->D[0].square() + this->D[1].square() + this->D[2].square()))
    , Inverse(this->Square.max(squareWidth).inverse())
    , InverseCubed(this->Inverse * this->Inverse.sqrt())
  {
  }
  Lanes dot(const Eigen::Vector3f& a) const
  {
    return a[0] * this->D[0] + a[1] * this->D[1] + a[2] * this->D[2];
  }

  std::array<Lanes, 3> D;
  Lanes Square, Inverse, InverseCubed;
};

Lanes numbersOf(
  const LanePlaces& places, const std::vector<WindingNumbers::Source>& list, float squareWidth)
{
  Lanes sum = Lanes::Zero();
  for (const WindingNumbers::Source& source : list)
  {
    const Way way(places, source.Position, squareWidth);
    sum += way.dot(source.Strength) * way.InverseCubed;
  }
  return sum;
}

std::array<Lanes, 3> descentOf(
  const LanePlaces& places, const std::vector<WindingNumbers::Source>& list, float squareWidth)
{
  std::array<Lanes, 3> sum = { Lanes::Zero(), Lanes::Zero(), Lanes::Zero() };
  for (const WindingNumbers::Source& source : list)
  {
    const Way way(places, source.Position, squareWidth);
    const Lanes along = (way.Square < squareWidth)
                          .select(Lanes::Zero(), -3.0F * way.dot(source.Strength) * way.Inverse);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += (source.Strength[c] + along * way.D[c]) * way.InverseCubed;
    }
  }
  return sum;
}

// Sum over charges, the first components of the strengths.
std::array<Lanes, 3> attractionOf(
  const LanePlaces& places, const std::vector<WindingNumbers::Source>& list, float squareWidth)
{
  std::array<Lanes, 3> sum = { Lanes::Zero(), Lanes::Zero(), Lanes::Zero() };
  for (const WindingNumbers::Source& source : list)
  {
    const Way way(places, source.Position, squareWidth);
    const Lanes charge = -source.Strength[0] * way.InverseCubed;
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += charge * way.D[c];
    }
  }
  return sum;
}

// Call body(first, count, lanes) for groups of positions, one position per lane. Unused lanes
// contain the last position.
template <typename PlaceOf, typename Body>
void forLanes(int first, int last, const PlaceOf& placeOf, const Body& body)
{
  for (int start = first; start < last; start += NumberOfLanes)
  {
    LanePlaces lanes;
    for (int lane = 0; lane < NumberOfLanes; ++lane)
    {
      const Vector3 place = placeOf(std::min(start + lane, last - 1));
      for (int c = 0; c < 3; ++c)
      {
        lanes.X[c][lane] = static_cast<float>(place[c]);
      }
    }
    body(start, std::min(NumberOfLanes, last - start), lanes);
  }
}

float squareOf(double width)
{
  return static_cast<float>(width * width);
}

// Contribution of one point to the sum of its cluster.
Vector3 strengthOf(const Points& areas, int point)
{
  return areas.row(point);
}
Vector3 strengthOf(const Eigen::VectorXd& charges, int point)
{
  return { charges[point], 0.0, 0.0 };
}
}

//------------------------------------------------------------------------------
WindingNumbers::WindingNumbers(const Points& points, const Run& run)
  : Places(points)
{
  std::vector<Box> boxes(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    boxes[i].extend(Vector3(points.row(i)));
  }
  BoxTree tree = buildBoxTree(boxes, run);
  this->Order.swap(tree.Items);
  const int size = static_cast<int>(tree.Nodes.size());
  // For each node, from the last to the first, compute the range of its points and the next node
  // that is not part of it.
  std::vector<int> first(size), last(size), next(size);
  for (int i = size - 1; i >= 0; --i)
  {
    const BoxTree::Node& node = tree.Nodes[i];
    const bool leaf = node.Count > 0;
    first[i] = leaf ? node.First : first[i + 1];
    last[i] = leaf ? node.First + node.Count : last[node.Second];
    next[i] = leaf ? i + 1 : next[node.Second];
  }
  // Clusters of few points are not divided.
  std::vector<int> clusterOf(size + 1);
  std::vector<int> nodes;
  for (int i = 0; i < size;)
  {
    clusterOf[i] = static_cast<int>(nodes.size());
    nodes.push_back(i);
    const int after = last[i] - first[i] <= LeafSize ? next[i] : i + 1;
    for (int skipped = i + 1; skipped < after; ++skipped)
    {
      clusterOf[skipped] = static_cast<int>(nodes.size());
    }
    i = after;
  }
  clusterOf[size] = static_cast<int>(nodes.size());
  int grouped = 0; // points already in a group
  for (const int node : nodes)
  {
    const Box& bounds = tree.Nodes[node].Bounds;
    Cluster cluster;
    cluster.Center = 0.5 * (bounds.Lower + bounds.Upper);
    cluster.HalfSide = 0.5 * (bounds.Upper - bounds.Lower).maxCoeff();
    cluster.First = first[node];
    cluster.Last = last[node];
    cluster.Next = clusterOf[next[node]];
    cluster.Leaf = last[node] - first[node] <= LeafSize;
    if (first[node] == grouped && last[node] - first[node] <= GroupSize)
    {
      this->Groups.push_back(static_cast<int>(this->Clusters.size()));
      grouped = last[node];
    }
    this->Clusters.push_back(cluster);
  }
}

//------------------------------------------------------------------------------
template <typename Strengths>
WindingNumbers::Sources WindingNumbers::sourcesOf(const Strengths& strengths) const
{
  struct Moments
  {
    Vector3 Strength = Vector3::Zero(), Weighted = Vector3::Zero();
    double Weight = 0.0;
  };
  Sources sources;
  sources.OfPoints.reserve(this->Order.size());
  for (const int point : this->Order)
  {
    sources.OfPoints.push_back({ Vector3(this->Places.row(point)).cast<float>(),
      strengthOf(strengths, point).template cast<float>() });
  }
  std::vector<Moments> moments(this->Clusters.size());
  sources.OfClusters.resize(this->Clusters.size());
  for (int i = static_cast<int>(this->Clusters.size()) - 1; i >= 0; --i)
  {
    const Cluster& cluster = this->Clusters[i];
    Moments& sum = moments[i];
    for (int k = cluster.First; k < cluster.Last && cluster.Leaf; ++k)
    {
      const Vector3 strength = strengthOf(strengths, this->Order[k]);
      const double weight = strength.norm();
      sum.Strength += strength;
      sum.Weighted += weight * Vector3(this->Places.row(this->Order[k]));
      sum.Weight += weight;
    }
    if (!cluster.Leaf)
    {
      for (const int child : { i + 1, this->Clusters[i + 1].Next })
      {
        sum.Strength += moments[child].Strength;
        sum.Weighted += moments[child].Weighted;
        sum.Weight += moments[child].Weight;
      }
    }
    const Eigen::Vector3d center =
      sum.Weight > 0.0 ? Vector3(sum.Weighted / sum.Weight) : Vector3(cluster.Center);
    sources.OfClusters[i] = { center.template cast<float>(), sum.Strength.template cast<float>() };
  }
  return sources;
}

//------------------------------------------------------------------------------
WindingNumbers::Sources WindingNumbers::sources(const Points& areas) const
{
  return this->sourcesOf(areas);
}

//------------------------------------------------------------------------------
void WindingNumbers::gather(const Sources& sources, const Vector3& lower, const Vector3& upper,
  double width, std::vector<Source>& list) const
{
  list.clear();
  const int size = static_cast<int>(this->Clusters.size());
  for (int i = 0; i < size;)
  {
    const Cluster& cluster = this->Clusters[i];
    const double square =
      (lower - cluster.Center).cwiseMax(cluster.Center - upper).cwiseMax(0.0).squaredNorm();
    // Within `width`, the kernel has another formula: no point of a distant cluster may be so near.
    const double far = std::max(Farness * cluster.HalfSide, width + 2.0 * cluster.HalfSide);
    if (square > far * far)
    {
      list.push_back(sources.OfClusters[i]);
      i = cluster.Next;
    }
    else if (cluster.Leaf)
    {
      list.insert(list.end(), sources.OfPoints.begin() + cluster.First,
        sources.OfPoints.begin() + cluster.Last);
      i = cluster.Next;
    }
    else
    {
      ++i;
    }
  }
}

//------------------------------------------------------------------------------
template <typename Sum>
void WindingNumbers::sumAtPoints(
  const Sources& sources, double width, const Run& run, const Sum& sum) const
{
  forBlocks(run, static_cast<Index>(this->Groups.size()), GroupsPerBlock,
    [&](Index begin, Index end)
    {
      std::vector<Source> list;
      for (Index group = begin; group < end; ++group)
      {
        const Cluster& cluster = this->Clusters[this->Groups[group]];
        Box bounds;
        const auto placeOf = [&](int k) { return Vector3(this->Places.row(this->Order[k])); };
        for (int k = cluster.First; k < cluster.Last; ++k)
        {
          bounds.extend(placeOf(k));
        }
        this->gather(sources, bounds.Lower, bounds.Upper, width, list);
        forLanes(cluster.First, cluster.Last, placeOf,
          [&](int first, int count, const LanePlaces& places)
          { sum(this->Order.data() + first, count, places, list); });
      }
    });
}

//------------------------------------------------------------------------------
Eigen::VectorXd WindingNumbers::atPoints(const Points& areas, double width, const Run& run) const
{
  Eigen::VectorXd numbers(this->size());
  this->sumAtPoints(this->sourcesOf(areas), width, run,
    [&](const int* ids, int count, const LanePlaces& places, const std::vector<Source>& list)
    {
      const Lanes sum = numbersOf(places, list, squareOf(width));
      for (int lane = 0; lane < count; ++lane)
      {
        numbers[ids[lane]] = sum[lane] / (4.0 * Pi);
      }
    });
  return numbers;
}

//------------------------------------------------------------------------------
Points WindingNumbers::descentAtPoints(const Points& areas, double width, const Run& run) const
{
  Points descent(this->size(), 3);
  this->sumAtPoints(this->sourcesOf(areas), width, run,
    [&](const int* ids, int count, const LanePlaces& places, const std::vector<Source>& list)
    {
      const std::array<Lanes, 3> sum = descentOf(places, list, squareOf(width));
      for (int lane = 0; lane < count; ++lane)
      {
        descent.row(ids[lane]) = Vector3(sum[0][lane], sum[1][lane], sum[2][lane]) / (4.0 * Pi);
      }
    });
  return descent;
}

//------------------------------------------------------------------------------
Points WindingNumbers::transposed(const Eigen::VectorXd& values, double width, const Run& run) const
{
  Points result(this->size(), 3);
  this->sumAtPoints(this->sourcesOf(values), width, run,
    [&](const int* ids, int count, const LanePlaces& places, const std::vector<Source>& list)
    {
      const std::array<Lanes, 3> sum = attractionOf(places, list, squareOf(width));
      for (int lane = 0; lane < count; ++lane)
      {
        result.row(ids[lane]) = Vector3(sum[0][lane], sum[1][lane], sum[2][lane]) / (4.0 * Pi);
      }
    });
  return result;
}

//------------------------------------------------------------------------------
Eigen::VectorXd WindingNumbers::at(
  const Points& places, const Sources& sources, double width, const Run& run) const
{
  Eigen::VectorXd numbers(places.rows());
  forBlocks(run, places.rows(), RunSize,
    [&](Index begin, Index end)
    {
      Box bounds;
      const auto placeOf = [&](int k) { return Vector3(places.row(begin + k)); };
      for (Index k = 0; k < end - begin; ++k)
      {
        bounds.extend(placeOf(static_cast<int>(k)));
      }
      std::vector<Source> list;
      this->gather(sources, bounds.Lower, bounds.Upper, width, list);
      forLanes(0, static_cast<int>(end - begin), placeOf,
        [&](int first, int count, const LanePlaces& lanes)
        {
          const Lanes sum = numbersOf(lanes, list, squareOf(width));
          for (int lane = 0; lane < count; ++lane)
          {
            numbers[begin + first + lane] = sum[lane] / (4.0 * Pi);
          }
        });
    });
  return numbers;
}
}

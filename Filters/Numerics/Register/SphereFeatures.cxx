#include "Register/SphereFeatures.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Measure/SurfaceShape.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace conformal
{
namespace
{
// Edges of a mesh and straight lines across pairs of triangles, with their lengths.
struct DistanceGraph
{
  std::vector<int> Offsets;
  std::vector<std::pair<int, float>> Links;
};

// Unfold the two triangles at an edge into a plane, and compute the distance of the corners
// opposite to the edge. If the straight line leaves the triangles, compute the path along their
// edges.
double lengthAcross(const Vector3& a, const Vector3& b, const Vector3& left, const Vector3& right)
{
  const Vector3 edge = b - a;
  const double length = edge.norm();
  if (!(length > 0.0))
  {
    return (left - a).norm() + (right - a).norm();
  }
  const double x = (left - a).dot(edge) / length, u = (right - a).dot(edge) / length;
  const double y = (left - a).cross(edge).norm() / length,
               v = (right - a).cross(edge).norm() / length;
  const double crossing = y + v > 0.0 ? x + (u - x) * y / (y + v) : x;
  if (crossing < 0.0)
  {
    return (left - a).norm() + (right - a).norm();
  }
  return crossing > length ? (left - b).norm() + (right - b).norm() : std::hypot(x - u, y + v);
}

DistanceGraph distanceGraph(const Mesh& surface)
{
  const Index size = surface.Positions.rows();
  const Triangles neighbors = triangleNeighbors(surface.Triangles, size);
  struct Link
  {
    int From, To;
    float Length;
  };
  std::vector<Link> links;
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int other = neighbors(r, k);
      if (other < r)
      {
        continue;
      }
      const int a = surface.Triangles(r, k), b = surface.Triangles(r, next(k)),
                left = surface.Triangles(r, previous(k));
      const auto& ids = surface.Triangles.row(other);
      const int right = ids[0] + ids[1] + ids[2] - a - b;
      const Vector3 p = surface.Positions.row(a), q = surface.Positions.row(b),
                    l = surface.Positions.row(left), s = surface.Positions.row(right);
      const auto edge = static_cast<float>((q - p).norm()),
                 across = static_cast<float>(lengthAcross(p, q, l, s));
      links.push_back({ a, b, edge });
      links.push_back({ b, a, edge });
      links.push_back({ left, right, across });
      links.push_back({ right, left, across });
    }
  }
  DistanceGraph graph;
  graph.Offsets.assign(size + 1, 0);
  graph.Links.resize(links.size());
  for (const Link& link : links)
  {
    ++graph.Offsets[link.From + 1];
  }
  for (Index v = 0; v < size; ++v)
  {
    graph.Offsets[v + 1] += graph.Offsets[v];
  }
  std::vector<int> filled(graph.Offsets.begin(), graph.Offsets.end() - 1);
  for (const Link& link : links)
  {
    graph.Links[filled[link.From]++] = { link.To, link.Length };
  }
  return graph;
}

void shortestPaths(const DistanceGraph& graph, int source, std::vector<float>& distances)
{
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distances.assign(graph.Offsets.size() - 1, std::numeric_limits<float>::infinity());
  distances[source] = 0.0F;
  queue.push({ 0.0F, source });
  while (!queue.empty())
  {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v])
    {
      continue;
    }
    for (int i = graph.Offsets[v]; i < graph.Offsets[v + 1]; ++i)
    {
      const auto [to, length] = graph.Links[i];
      if (distance + length < distances[to])
      {
        distances[to] = distance + length;
        queue.push({ distance + length, to });
      }
    }
  }
}
}

//------------------------------------------------------------------------------
Rows geodesicFeatures(const Mesh& surface, const GeodesicFeatureOptions& options, const Run& run)
{
  const Index size = surface.Positions.rows();
  const auto radii = static_cast<Index>(options.Radii.size());
  Eigen::VectorXd areas = vertexAreas(surface.Positions, surface.Triangles);
  // Here each triangle is counted twice at each of its three corners.
  const double unit = std::sqrt(areas.sum() / 6.0);
  areas /= areas.sum();
  const DistanceGraph graph = distanceGraph(surface);
  const int count = static_cast<int>(std::min<Index>(options.NumberOfSources, size));
  // Each source is the vertex farthest from the previous sources. Each vertex is assigned to the
  // nearest source.
  std::vector<std::vector<float>> distances(count);
  std::vector<float> nearest(size, std::numeric_limits<float>::infinity());
  std::vector<int> owner(size, 0);
  int source = 0;
  for (int s = 0; s < count; ++s)
  {
    shortestPaths(graph, source, distances[s]);
    for (Index v = 0; v < size; ++v)
    {
      if (distances[s][v] < nearest[v])
      {
        nearest[v] = distances[s][v];
        owner[v] = s;
      }
    }
    source = static_cast<int>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    run.report((s + 0.9) / count);
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (Index v = 0; v < size; ++v)
  {
    weights[owner[v]] += areas[v];
  }
  Rows features = Rows::Zero(size, 1 + radii);
  for (Index v = 0; v < size; ++v)
  {
    for (int s = 0; s < count; ++s)
    {
      const double distance = distances[s][v] / unit;
      features(v, 0) += weights[s] * distance;
      for (Index k = 0; k < radii; ++k)
      {
        const double ratio = distance / options.Radii[k];
        features(v, 1 + k) += weights[s] * std::exp(-0.5 * ratio * ratio);
      }
    }
  }
  // If a radius is far below the spacing of the sources, the area feature underflows.
  constexpr double minimum = 1e-6;
  features = features.cwiseMax(minimum).array().log().matrix();
  run.report(1.0);
  return features;
}

//------------------------------------------------------------------------------
Rows landmarkProximities(const Mesh& surface, const Points& landmarks, const Run& run)
{
  const Index size = surface.Positions.rows(), count = landmarks.rows();
  const DistanceGraph graph = distanceGraph(surface);
  Eigen::VectorXd areas = vertexAreas(surface.Positions, surface.Triangles);
  const double unit = std::sqrt(areas.sum() / 6.0);
  areas /= areas.sum();
  // Distance below which the proximity is constant, since the mesh does not resolve it.
  constexpr double near = 0.02;
  Rows result(size, count);
  std::vector<float> distances;
  for (Index k = 0; k < count; ++k)
  {
    Index source = 0;
    (surface.Positions.rowwise() - landmarks.row(k)).rowwise().squaredNorm().minCoeff(&source);
    shortestPaths(graph, static_cast<int>(source), distances);
    for (Index v = 0; v < size; ++v)
    {
      result(v, k) = 1.0 / std::hypot(distances[v] / unit, near);
    }
    run.report(static_cast<double>(k + 1) / static_cast<double>(count));
  }
  for (Index v = 0; v < size; ++v)
  {
    result.row(v) /= result.row(v).sum();
  }
  const Eigen::RowVectorXd means = areas.transpose() * result;
  const double variance = areas.dot((result.rowwise() - means).rowwise().squaredNorm());
  constexpr double flat = 1e-12; // variance of proximities to landmarks at one vertex
  return variance > flat ? Rows(result / std::sqrt(variance)) : Rows(Rows::Zero(size, count));
}

//------------------------------------------------------------------------------
Eigen::VectorXd smoothMeanCurvature(const Mesh& surface, double scale, const Run& run)
{
  const Eigen::VectorXd areas = vertexAreas(surface.Positions, surface.Triangles) / 6.0;
  const double area = areas.sum();
  const Columns integrals = meanCurvatureIntegrals(surface) * std::sqrt(area);
  return smoothDensities(surface, areas, scale * scale * area, integrals, run).col(0);
}

//------------------------------------------------------------------------------
void normalizeFeatures(Rows& features, const Eigen::VectorXd& weights)
{
  const double sum = weights.sum();
  for (Index k = 0; k < features.cols(); ++k)
  {
    const double mean = weights.dot(features.col(k)) / sum;
    features.col(k).array() -= mean;
    const double deviation = std::sqrt(weights.dot(features.col(k).cwiseAbs2()) / sum);
    const double flat = 1e-12 * std::max(1.0, std::abs(mean));
    features.col(k) *= deviation > flat ? 1.0 / deviation : 0.0;
  }
}
}

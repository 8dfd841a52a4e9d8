#include "Linear/EdgeWeights.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace conformal
{
namespace
{
// Compute the cotangents of the corners of all triangles. The cotangents of triangles of zero area
// are zero. List the ids of triangles of zero area.
Points cotangentsOf(
  const Points& points, const Triangles& triangles, std::vector<Index>& withoutArea)
{
  Points result = Points::Zero(triangles.rows(), 3);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    Vector3 row;
    bool finite = true;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 a = points.row(triangles(r, k));
      const Vector3 u = points.row(triangles(r, next(k))).transpose() - a;
      const Vector3 v = points.row(triangles(r, previous(k))).transpose() - a;
      const double sine = u.cross(v).norm(), cosine = u.dot(v);
      constexpr double minimum = 1e-12; // smaller angles are rounding error
      finite = finite && sine > minimum * (u.squaredNorm() + v.squaredNorm());
      row[k] = cosine / sine;
    }
    if (finite)
    {
      result.row(r) = row;
    }
    else
    {
      withoutArea.push_back(r);
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
EdgeWeights equalWeights(const Triangles& triangles, Index numberOfVertices)
{
  EdgeWeights result;
  result.Neighbors = vertexNeighbors(triangles, numberOfVertices);
  result.Weights.assign(result.Neighbors.Ids.size(), 1.0);
  return result;
}

//------------------------------------------------------------------------------
EdgeWeights cotangentWeights(
  const Triangles& triangles, Index numberOfVertices, const Points& cotangents)
{
  EdgeWeights result;
  const Adjacency& neighbors = result.Neighbors = vertexNeighbors(triangles, numberOfVertices);
  result.Weights.assign(neighbors.Ids.size(), 0.0);
  const auto add = [&](int from, int to, double weight)
  {
    const auto* place = std::lower_bound(neighbors.begin(from), neighbors.end(from), to);
    result.Weights[place - neighbors.Ids.data()] += weight;
  };
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = triangles(r, next(k)), to = triangles(r, previous(k));
      add(from, to, 0.5 * cotangents(r, k));
      add(to, from, 0.5 * cotangents(r, k));
    }
  }
  return result;
}

//------------------------------------------------------------------------------
StringConstants harmonicStrings(const Points& points, const Triangles& triangles)
{
  std::vector<Index> withoutArea;
  StringConstants result;
  result.Strings =
    cotangentWeights(triangles, points.rows(), cotangentsOf(points, triangles, withoutArea));
  constexpr double rounding = -1e-9;            // rounding error of the weight for two right angles
  const auto& weights = result.Strings.Weights; // each edge is stored twice
  result.NumberOfNegative =
    std::count_if(weights.begin(), weights.end(), [](double weight) { return weight < rounding; }) /
    2;
  std::vector<std::pair<int, int>> infinite;
  for (Index r : withoutArea)
  {
    for (int k = 0; k < 3; ++k)
    {
      infinite.push_back(std::minmax({ triangles(r, k), triangles(r, next(k)) }));
    }
  }
  std::sort(infinite.begin(), infinite.end());
  result.NumberOfInfinite = std::unique(infinite.begin(), infinite.end()) - infinite.begin();
  return result;
}

//------------------------------------------------------------------------------
Eigen::VectorXd vertexAreas(const Points& points, const Triangles& triangles)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(points.rows());
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = points.row(triangles(r, 0));
    const Vector3 p = points.row(triangles(r, 1)).transpose() - a;
    const Vector3 q = points.row(triangles(r, 2)).transpose() - a;
    for (int k = 0; k < 3; ++k)
    {
      areas[triangles(r, k)] += p.cross(q).norm();
    }
  }
  return areas.sum() > 0.0 ? areas : Eigen::VectorXd::Ones(points.rows()).eval();
}

//------------------------------------------------------------------------------
double stringEnergy(const EdgeWeights& strings, const Points& places)
{
  double sum = 0.0;
  for (Index v = 0; v < places.rows(); ++v)
  {
    for (int i = strings.Neighbors.Offsets[v]; i < strings.Neighbors.Offsets[v + 1]; ++i)
    {
      const int other = strings.Neighbors.Ids[i];
      if (other > v)
      {
        sum += strings.Weights[i] * (places.row(v) - places.row(other)).squaredNorm();
      }
    }
  }
  return 0.5 * sum;
}
}

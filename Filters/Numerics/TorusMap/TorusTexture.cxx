#include "TorusMap/TorusTexture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace conformal
{
namespace
{
using Corners = Eigen::Matrix<double, 3, 2>;

// Return the position of a vertex in [0, 1)^2.
Eigen::RowVector2d inUnitSquare(const TorusPositions& positions, Index vertex)
{
  return positions.row(vertex).array() - positions.row(vertex).array().floor();
}

// Return the corners of a triangle in the plane, with its center in [0, 1)^2. The position of the
// torus that is next to the first corner is taken for the others.
Corners cornersOf(const TorusPositions& positions, const Triangles& triangles, Index triangle)
{
  Corners corners;
  for (int k = 0; k < 3; ++k)
  {
    corners.row(k) = inUnitSquare(positions, triangles(triangle, k));
    corners.row(k) -= (corners.row(k) - corners.row(0)).array().round().matrix();
  }
  const Eigen::RowVector2d whole = (corners.colwise().sum() / 3.0).array().floor();
  return corners.rowwise() - whole;
}
}

//------------------------------------------------------------------------------
TorusTexture makeTorusTexture(const TorusPositions& positions, const Triangles& triangles,
  const std::array<int, 2>& repeats, const Run& run)
{
  if (!positions.allFinite())
  {
    throw std::invalid_argument("a position on the torus is not finite");
  }
  if (repeats[0] < 1 || repeats[1] < 1)
  {
    throw std::invalid_argument("the image must be repeated at least once");
  }
  constexpr Index interval = 1 << 16;
  TorusTexture result;
  result.Triangles = triangles;
  std::vector<Eigen::RowVector2d> coordinates(positions.rows(), Eigen::RowVector2d::Zero());
  result.VertexIds.resize(positions.rows());
  for (Index v = 0; v < positions.rows(); ++v)
  {
    result.VertexIds[v] = static_cast<int>(v);
    coordinates[v] = inUnitSquare(positions, v);
  }
  std::map<std::tuple<int, int, int>, int> copies; // by vertex and whole numbers of periods
  std::vector<std::array<int, 2>> turns(positions.rows());
  std::vector<char> isUsed(positions.rows(), 0);
  double area = 0.0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if (t % interval == 0)
    {
      run.report(static_cast<double>(t) / static_cast<double>(triangles.rows()));
    }
    const Corners corners = cornersOf(positions, triangles, t);
    area += 0.5 *
      cross((corners.row(1) - corners.row(0)).transpose(),
        (corners.row(2) - corners.row(0)).transpose());
    for (int k = 0; k < 3; ++k)
    {
      const int v = triangles(t, k);
      const Eigen::RowVector2d base = inUnitSquare(positions, v);
      const std::array<int, 2> turn = { static_cast<int>(std::lround(corners(k, 0) - base[0])),
        static_cast<int>(std::lround(corners(k, 1) - base[1])) };
      if (!isUsed[v])
      {
        isUsed[v] = 1;
        turns[v] = turn;
        coordinates[v] = corners.row(k);
      }
      if (turns[v] == turn)
      {
        continue;
      }
      const auto [copy, isNew] =
        copies.try_emplace({ v, turn[0], turn[1] }, static_cast<int>(result.VertexIds.size()));
      if (isNew)
      {
        result.VertexIds.push_back(v);
        coordinates.push_back(corners.row(k));
      }
      result.Triangles(t, k) = copy->second;
    }
  }
  constexpr double tolerance = 1e-3;
  if (!(std::abs(std::abs(area) - 1.0) < tolerance))
  {
    throw std::invalid_argument("the triangles cover the torus " + std::to_string(area) +
      " times instead of once; if triangles are longer than half of the torus, subdivide the "
      "surface before it is mapped");
  }
  result.Coordinates.resize(static_cast<Index>(coordinates.size()), 2);
  for (Index i = 0; i < result.Coordinates.rows(); ++i)
  {
    result.Coordinates.row(i) << repeats[0] * coordinates[i][0], repeats[1] * coordinates[i][1];
  }
  run.report(1.0);
  return result;
}
}

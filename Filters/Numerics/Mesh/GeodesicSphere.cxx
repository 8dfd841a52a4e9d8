#include "Mesh/GeodesicSphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr int NumberOfCorners = 12;
constexpr int NumberOfSides = 20;

// Poles 0 and 11; upper ring 1..5; lower ring 6..10, rotated by half a step.
Points icosahedronCorners()
{
  const double z = 1.0 / std::sqrt(5.0), r = 2.0 / std::sqrt(5.0);
  Points corners(NumberOfCorners, 3);
  corners.row(0) << 0.0, 0.0, 1.0;
  corners.row(11) << 0.0, 0.0, -1.0;
  for (int k = 0; k < 5; ++k)
  {
    const double up = 2.0 * Pi * k / 5.0, down = 2.0 * Pi * (k + 0.5) / 5.0;
    corners.row(1 + k) << r * std::cos(up), r * std::sin(up), z;
    corners.row(6 + k) << r * std::cos(down), r * std::sin(down), -z;
  }
  return corners;
}

std::array<std::array<int, 3>, NumberOfSides> icosahedronSides()
{
  std::array<std::array<int, 3>, NumberOfSides> sides{};
  for (int k = 0; k < 5; ++k)
  {
    const int next = (k + 1) % 5;
    sides[k] = { 0, 1 + k, 1 + next };
    sides[5 + k] = { 1 + k, 6 + k, 1 + next };
    sides[10 + k] = { 1 + next, 6 + k, 6 + next };
    sides[15 + k] = { 11, 6 + next, 6 + k };
  }
  return sides;
}
}

//------------------------------------------------------------------------------
int geodesicFrequencyFor(Index numberOfVertices)
{
  const double square = static_cast<double>(numberOfVertices - 2) / 10.0;
  return std::max(1, static_cast<int>(std::lround(std::sqrt(square))));
}

Mesh makeGeodesicSphere(int f, const Run& run)
{
  if (f < 1 || f > MaximumFrequency)
  {
    throw std::invalid_argument("the frequency must lie between 1 and " +
      std::to_string(MaximumFrequency) + ", not " + std::to_string(f));
  }
  const Points corners = icosahedronCorners();
  const auto sides = icosahedronSides();

  Mesh sphere;
  sphere.Positions.resize(geodesicSphereSize(f), 3);
  sphere.Triangles.resize(20 * Index(f) * f, 3);
  sphere.Positions.topRows(NumberOfCorners) = corners;

  // Points inside edges follow the corners, points inside faces follow these.
  std::map<std::pair<int, int>, int> firstOnEdge;
  int nextId = NumberOfCorners;
  for (const auto& side : sides)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [a, b] = std::minmax(side[k], side[next(k)]);
      if (firstOnEdge.emplace(std::make_pair(a, b), nextId).second)
      {
        for (int step = 1; step < f; ++step)
        {
          sphere.Positions.row(nextId++) =
            ((f - step) * corners.row(a) + step * corners.row(b)).normalized();
        }
      }
    }
  }
  const auto onEdge = [&](int from, int to, int step)
  {
    const int first = firstOnEdge.at({ std::min(from, to), std::max(from, to) });
    return first + (from < to ? step : f - step) - 1;
  };

  // Row i of a face has i + 1 points, from its corner 0 to the opposite edge. Add the triangles
  // between each row and the row above.
  const int firstInside = nextId, numberInside = (f - 1) * (f - 2) / 2;
  const auto idAt = [&](int side, int i, int j)
  {
    const auto [a, b, c] = sides[side];
    if (i == 0)
    {
      return a;
    }
    if (i == f && (j == 0 || j == f))
    {
      return j == 0 ? b : c;
    }
    if (j == 0 || j == i)
    {
      return onEdge(a, j == 0 ? b : c, i);
    }
    return i == f ? onEdge(b, c, j)
                  : firstInside + side * numberInside + (i - 1) * (i - 2) / 2 + j - 1;
  };
  const auto makeRow = [&](int side, int i, std::vector<int>& above, std::vector<int>& row)
  {
    const auto [a, b, c] = sides[side];
    row.resize(i + 1);
    for (int j = 0; j <= i; ++j)
    {
      row[j] = idAt(side, i, j);
      if (i < f && j > 0 && j < i)
      {
        sphere.Positions.row(row[j]) =
          ((f - i) * corners.row(a) + (i - j) * corners.row(b) + j * corners.row(c)).normalized();
      }
    }
    Index face = Index(side) * f * f + Index(i - 1) * (i - 1);
    for (int j = 0; j < i; ++j)
    {
      sphere.Triangles.row(face++) << above[j], row[j], row[j + 1];
      if (j + 1 < i)
      {
        sphere.Triangles.row(face++) << above[j], row[j + 1], above[j + 1];
      }
    }
    above.swap(row);
  };
  constexpr Index rowsAtATime = 8;
  const Index blocksOfSide = (f + rowsAtATime - 1) / rowsAtATime;
  forBlocksReporting(run, NumberOfSides * blocksOfSide, 1,
    [&](Index block, Index)
    {
      const int side = static_cast<int>(block / blocksOfSide);
      const int first = static_cast<int>(block % blocksOfSide * rowsAtATime);
      std::vector<int> above, row;
      for (int j = 0; j <= first; ++j)
      {
        above.push_back(idAt(side, first, j));
      }
      for (int i = first + 1; i <= std::min<int>(f, first + rowsAtATime); ++i)
      {
        makeRow(side, i, above, row);
      }
    });
  return sphere;
}

//------------------------------------------------------------------------------
bool hasGeodesicConnectivity(const Triangles& triangles, Index numberOfVertices)
{
  const Index squared = (numberOfVertices - 2) / 10;
  const auto f = static_cast<Index>(std::llround(std::sqrt(static_cast<double>(squared))));
  if (f < 1 || geodesicSphereSize(f) != numberOfVertices || triangles.rows() != 20 * f * f)
  {
    return false;
  }
  std::vector<int> valences(numberOfVertices);
  for (const int id : triangles.reshaped())
  {
    ++valences[id];
  }
  return std::count(valences.begin(), valences.end(), 5) == 12 &&
    std::count(valences.begin(), valences.end(), 6) == numberOfVertices - 12;
}

//------------------------------------------------------------------------------
bool isGeodesicSphere(const Points& positions, const Triangles& triangles)
{
  if (!hasGeodesicConnectivity(triangles, positions.rows()))
  {
    return false;
  }
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = positions.row(triangles(r, 0)), b = positions.row(triangles(r, 1)),
                  c = positions.row(triangles(r, 2));
    const double area = (b - a).cross(c - a).norm();
    smallest = std::min(smallest, area);
    largest = std::max(largest, area);
  }
  constexpr double even = 4.0;
  return largest <= even * smallest;
}
}

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

// Row i of a side holds i + 1 points, from its corner 0 down to the edge opposite, and the
// triangles between them and the row above. Points inside edges come after the corners, points
// inside sides after those.
class GeodesicSphereMaker
{
public:
  explicit GeodesicSphereMaker(int frequency)
    : Frequency(frequency)
    , FirstInside(NumberOfCorners)
    , NumberInside((frequency - 1) * (frequency - 2) / 2)
  {
    this->Sphere.Positions.resize(geodesicSphereSize(frequency), 3);
    this->Sphere.Triangles.resize(20 * Index(frequency) * frequency, 3);
    this->Sphere.Positions.topRows(NumberOfCorners) = this->Corners;
    for (const auto& side : this->Sides)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto [a, b] = std::minmax(side[k], side[next(k)]);
        if (this->FirstOnEdge.emplace(std::make_pair(a, b), this->FirstInside).second)
        {
          for (int step = 1; step < frequency; ++step)
          {
            this->Sphere.Positions.row(this->FirstInside++) =
              ((frequency - step) * this->Corners.row(a) + step * this->Corners.row(b))
                .normalized();
          }
        }
      }
    }
  }

  // Make the rows of a side after the first one, up to the last one. Rows may be made at the same
  // time.
  void makeRows(int side, int first, int last)
  {
    std::vector<int> above, row;
    for (int j = 0; j <= first; ++j)
    {
      above.push_back(this->idAt(side, first, j));
    }
    for (int i = first + 1; i <= last; ++i)
    {
      row.resize(i + 1);
      for (int j = 0; j <= i; ++j)
      {
        row[j] = this->idAt(side, i, j);
      }
      this->placeRow(side, row);
      this->joinRows(side, above, row);
      above.swap(row);
    }
  }

  Mesh Sphere;

private:
  int onEdge(int from, int to, int step) const
  {
    const int first = this->FirstOnEdge.at({ std::min(from, to), std::max(from, to) });
    return first + (from < to ? step : this->Frequency - step) - 1;
  }

  int idAt(int side, int i, int j) const
  {
    const auto [a, b, c] = this->Sides[side];
    const int f = this->Frequency;
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
      return this->onEdge(a, j == 0 ? b : c, i);
    }
    return i == f ? this->onEdge(b, c, j)
                  : this->FirstInside + side * this->NumberInside + (i - 1) * (i - 2) / 2 + j - 1;
  }

  // Points inside the side; those of its edges have their places.
  void placeRow(int side, const std::vector<int>& row)
  {
    const auto [a, b, c] = this->Sides[side];
    const int i = static_cast<int>(row.size()) - 1, f = this->Frequency;
    for (int j = 1; i < f && j < i; ++j)
    {
      this->Sphere.Positions.row(row[j]) =
        ((f - i) * this->Corners.row(a) + (i - j) * this->Corners.row(b) + j * this->Corners.row(c))
          .normalized();
    }
  }

  void joinRows(int side, const std::vector<int>& above, const std::vector<int>& row)
  {
    const auto i = static_cast<int>(above.size());
    Index face = Index(side) * this->Frequency * this->Frequency + Index(i - 1) * (i - 1);
    for (int j = 0; j < i; ++j)
    {
      this->Sphere.Triangles.row(face++) << above[j], row[j], row[j + 1];
      if (j + 1 < i)
      {
        this->Sphere.Triangles.row(face++) << above[j], row[j + 1], above[j + 1];
      }
    }
  }

  const int Frequency;
  const Points Corners = icosahedronCorners();
  const std::array<std::array<int, 3>, NumberOfSides> Sides = icosahedronSides();
  std::map<std::pair<int, int>, int> FirstOnEdge;
  int FirstInside;
  const int NumberInside; // number of points inside each side
};
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
  GeodesicSphereMaker maker(f);
  constexpr Index rowsAtATime = 8;
  const Index blocksOfSide = (f + rowsAtATime - 1) / rowsAtATime;
  forBlocksReporting(run, NumberOfSides * blocksOfSide, 1,
    [&](Index block, Index)
    {
      const int first = static_cast<int>(block % blocksOfSide * rowsAtATime);
      maker.makeRows(
        static_cast<int>(block / blocksOfSide), first, std::min<int>(f, first + rowsAtATime));
    });
  return std::move(maker.Sphere);
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
  double minimum = std::numeric_limits<double>::infinity(), maximum = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = positions.row(triangles(r, 0)), b = positions.row(triangles(r, 1)),
                  c = positions.row(triangles(r, 2));
    const double area = (b - a).cross(c - a).norm();
    minimum = std::min(minimum, area);
    maximum = std::max(maximum, area);
  }
  constexpr double even = 4.0;
  return maximum <= even * minimum;
}
}

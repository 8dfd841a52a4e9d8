#include "PLY/RangeGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::int64_t NoPoint = -1;

template <typename T>
std::array<double, 3> pointOf(const unsigned char* bytes)
{
  T p[3];
  std::memcpy(p, bytes, sizeof(p));
  return { static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) };
}

class GridTriangles
{
public:
  GridTriangles(const NamedArray& points, const OwnedArray<std::int64_t>& grid, std::size_t columns)
    : Points(points)
    , Grid(grid)
    , Columns(columns)
    , Rows(grid.size() / columns)
  {
  }

  // Compute the median distance between points of neighboring cells. If there are no neighbors,
  // return 0.
  double medianEdge() const
  {
    std::vector<float> lengths;
    for (std::size_t cell = 0; cell < this->Grid.size(); ++cell)
    {
      const bool hasRight = (cell + 1) % this->Columns != 0;
      const bool hasBelow = cell + this->Columns < this->Grid.size();
      for (const std::size_t other :
        { hasRight ? cell + 1 : cell, hasBelow ? cell + this->Columns : cell })
      {
        if (other != cell && this->Grid[cell] != NoPoint && this->Grid[other] != NoPoint)
        {
          lengths.push_back(static_cast<float>(this->length(this->Grid[cell], this->Grid[other])));
        }
      }
    }
    if (lengths.empty())
    {
      return 0.0;
    }
    const auto middle = lengths.begin() + lengths.size() / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
  }

  void append(double maximumEdge, OwnedArray<std::int64_t>& offsets, OwnedArray<std::int64_t>& ids)
  {
    const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c)
    {
      const bool isTriangle = a != b && b != c && c != a;
      if (isTriangle && this->length(a, b) <= maximumEdge && this->length(b, c) <= maximumEdge &&
        this->length(c, a) <= maximumEdge)
      {
        ids.push(a);
        ids.push(b);
        ids.push(c);
        offsets.push(static_cast<std::int64_t>(ids.size()));
      }
    };
    for (std::size_t row = 0; row + 1 < this->Rows; ++row)
    {
      for (std::size_t column = 0; column + 1 < this->Columns; ++column)
      {
        const std::size_t cell = row * this->Columns + column;
        const std::size_t below = cell + this->Columns;
        // List the four cells in cyclic order, starting at one end of the diagonal that divides
        // them.
        std::array<std::int64_t, 4> ring = { this->Grid[cell], this->Grid[below],
          this->Grid[below + 1], this->Grid[cell + 1] };
        const auto missing = std::count(ring.begin(), ring.end(), NoPoint);
        if (missing == 0)
        {
          if (this->length(ring[1], ring[3]) < this->length(ring[0], ring[2]))
          {
            std::rotate(ring.begin(), ring.begin() + 1, ring.end());
          }
          add(ring[0], ring[1], ring[2]);
          add(ring[0], ring[2], ring[3]);
        }
        else if (missing == 1)
        {
          std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), NoPoint), ring.end());
          add(ring[1], ring[2], ring[3]);
        }
      }
    }
  }

private:
  double length(std::int64_t a, std::int64_t b) const
  {
    const std::array<double, 3> p = this->point(a);
    const std::array<double, 3> q = this->point(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  std::array<double, 3> point(std::int64_t id) const
  {
    const unsigned char* bytes = this->Points.Values.data() + id * this->Points.tupleBytes();
    return this->Points.Type == ScalarType::Float32 ? pointOf<float>(bytes)
                                                    : pointOf<double>(bytes);
  }

  const NamedArray& Points;
  const OwnedArray<std::int64_t>& Grid;
  const std::size_t Columns;
  const std::size_t Rows;
};
}

//------------------------------------------------------------------------------
void appendGridTriangles(const NamedArray& points, const OwnedArray<std::int64_t>& grid,
  std::size_t columns, double maximumEdge, OwnedArray<std::int64_t>& offsets,
  OwnedArray<std::int64_t>& ids)
{
  constexpr double wideFactor = 4.0; // distance ratio of neighbors on a slope of 75 degrees
  GridTriangles triangles(points, grid, columns);
  triangles.append(
    maximumEdge > 0.0 ? maximumEdge : wideFactor * triangles.medianEdge(), offsets, ids);
}
}

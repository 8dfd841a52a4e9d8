#include "Mesh/PolygonTriangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
using Vector2 = Eigen::Vector2d;

// Project the polygon along its normal to counter-clockwise coordinates of size 1. The result is
// empty without a normal.
std::vector<Vector2> flatten(const Points& corners)
{
  const Vector3 low = corners.colwise().minCoeff();
  const Vector3 high = corners.colwise().maxCoeff();
  const Vector3 middle = 0.5 * low + 0.5 * high; // avoids overflow
  const double size = (0.5 * high - 0.5 * low).maxCoeff();
  if (!(size > 0.0 && std::isfinite(size)) || !corners.allFinite())
  {
    return {};
  }
  const auto corner = [&](Index i) -> Vector3
  { return (corners.row(i).transpose() / size - middle / size); };
  Vector3 normal = Vector3::Zero();
  for (Index i = 1; i + 1 < corners.rows(); ++i)
  {
    normal += (corner(i) - corner(0)).cross(corner(i + 1) - corner(0));
  }
  Index axis = 0;
  if (!(normal.cwiseAbs().maxCoeff(&axis) > 0.0))
  {
    return {};
  }
  Index right = (axis + 1) % 3, up = (axis + 2) % 3;
  if (normal[axis] < 0.0)
  {
    std::swap(right, up);
  }
  std::vector<Vector2> flat;
  for (Index i = 0; i < corners.rows(); ++i)
  {
    const Vector3 p = corner(i);
    flat.emplace_back(p[right], p[up]);
  }
  return flat;
}

// Compute twice the area of a triangle, positive if it is counter-clockwise.
double turn(const Vector2& a, const Vector2& b, const Vector2& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// What remains of a polygon while ears are clipped
class RemainingPolygon
{
public:
  explicit RemainingPolygon(std::vector<Vector2> corners)
    : Corners(std::move(corners))
    , Next(this->Corners.size())
    , Previous(this->Corners.size())
    , IsHollow(this->Corners.size())
  {
    const int count = static_cast<int>(this->Corners.size());
    for (int i = 0; i < count; ++i)
    {
      this->Next[i] = (i + 1) % count;
      this->Previous[i] = (i + count - 1) % count;
    }
    this->Side = std::max(1, static_cast<int>(std::sqrt(count)));
    this->Cells.resize(static_cast<std::size_t>(this->Side) * this->Side);
    for (int i = 0; i < count; ++i)
    {
      this->IsHollow[i] = this->turnAt(i) <= 0.0;
      if (this->IsHollow[i])
      {
        const Vector2& p = this->Corners[i];
        this->Cells[this->cellAt(p.y()) * this->Side + this->cellAt(p.x())].push_back(i);
        ++this->NumberOfHollows;
      }
    }
  }

  int next(int i) const { return this->Next[i]; }
  int previous(int i) const { return this->Previous[i]; }

  // Test whether the triangle of a corner and its neighbors contains no other part of the polygon.
  bool isEar(int i) const
  {
    const Vector2 &a = this->Corners[this->Previous[i]], &b = this->Corners[i],
                  &c = this->Corners[this->Next[i]];
    if (!(turn(a, b, c) > 0.0))
    {
      return false;
    }
    if (this->NumberOfHollows == 0)
    {
      return true;
    }
    const Vector2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (int row = this->cellAt(low.y()); row <= this->cellAt(high.y()); ++row)
    {
      for (int column = this->cellAt(low.x()); column <= this->cellAt(high.x()); ++column)
      {
        for (int k : this->Cells[static_cast<std::size_t>(row) * this->Side + column])
        {
          const Vector2& p = this->Corners[k];
          if (this->IsHollow[k] && p != a && p != b && p != c && turn(a, b, p) >= 0.0 &&
            turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0)
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  void cut(int i)
  {
    const int before = this->Previous[i], after = this->Next[i];
    this->Next[before] = after;
    this->Previous[after] = before;
    this->fill(i);
    for (int k : { before, after })
    {
      if (this->turnAt(k) > 0.0)
      {
        this->fill(k);
      }
    }
  }

private:
  double turnAt(int i) const
  {
    return turn(this->Corners[this->Previous[i]], this->Corners[i], this->Corners[this->Next[i]]);
  }

  void fill(int i)
  {
    this->NumberOfHollows -= this->IsHollow[i];
    this->IsHollow[i] = 0;
  }

  // Coordinates are in [-1, 1].
  int cellAt(double coordinate) const
  {
    return std::clamp(static_cast<int>(0.5 * (coordinate + 1.0) * this->Side), 0, this->Side - 1);
  }

  std::vector<Vector2> Corners;
  std::vector<int> Next, Previous;
  std::vector<char> IsHollow; ///< reflex corners, which an ear must not contain
  int NumberOfHollows = 0;
  int Side = 1;
  std::vector<std::vector<int>> Cells; ///< reflex corners by grid cell
};
}

//------------------------------------------------------------------------------
Triangles triangulatePolygon(const Points& corners)
{
  const Index count = corners.rows();
  std::vector<Vector2> flat = count >= 3 ? flatten(corners) : std::vector<Vector2>();
  if (flat.empty())
  {
    return Triangles(0, 3);
  }
  RemainingPolygon polygon(std::move(flat));
  Triangles triangles(count - 2, 3);
  int i = 0;
  Index misses = 0;
  for (Index cut = 0; cut + 3 < count;)
  {
    if (polygon.isEar(i))
    {
      triangles.row(cut++) << polygon.previous(i), i, polygon.next(i);
      polygon.cut(i);
      i = polygon.next(i); // skip the neighbor: fans make thin triangles
      misses = 0;
    }
    else if (++misses > count - cut)
    {
      return Triangles(0, 3);
    }
    i = polygon.next(i);
  }
  triangles.row(count - 3) << polygon.previous(i), i, polygon.next(i);
  return triangles;
}
}

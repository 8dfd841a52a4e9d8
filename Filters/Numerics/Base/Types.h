/// Define shared types of the numerical library: matrices, and read-only views of points and
/// numbers.

#ifndef ConformalTypes_h
#define ConformalTypes_h

#include <Eigen/Core>
#include <Eigen/Geometry> // cross products

#include <algorithm>
#include <array>
#include <vector>

namespace conformal
{
using Index = Eigen::Index;
using Vector3 = Eigen::Vector3d;
/// One row of 3 coordinates for each point
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// One row of 3 vertex ids for each triangle
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>; ///< column-major matrix

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180.0; ///< in radians

/// Return the corner (0, 1 or 2) that follows a corner of a triangle counter-clockwise. The inverse
/// function is previous().
constexpr int next(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}
constexpr int previous(int corner)
{
  return corner == 0 ? 2 : corner - 1;
}

/// Return two ids in ascending order. An edge has the same ids in both of its triangles.
inline std::array<int, 2> sortedIds(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Compute the cross product of two vectors of the plane.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Read-only view of packed points, in float or double. The view does not own the memory, so that
/// ten million points need no copy. On access, coordinates are divided by a unit of length, see
/// CoordinateFrame.
class PointView
{
public:
  PointView() = default;
  PointView(const double* xyz, Index size, double unit = 1.0)
    : Doubles(xyz)
    , Size(size)
    , Unit(unit)
  {
  }
  PointView(const float* xyz, Index size, double unit = 1.0)
    : Floats(xyz)
    , Size(size)
    , Unit(unit)
  {
  }
  PointView(const Points& points)
    : PointView(points.data(), points.rows())
  {
  }

  Index size() const { return this->Size; }
  Vector3 operator[](Index i) const
  {
    if (this->Doubles)
    {
      return Vector3(this->Doubles + 3 * i) / this->Unit;
    }
    const float* p = this->Floats + 3 * i;
    return Vector3(p[0], p[1], p[2]) / this->Unit;
  }

private:
  const double* Doubles = nullptr;
  const float* Floats = nullptr;
  Index Size = 0;
  double Unit = 1.0;
};

/// Read-only view of floats or doubles. The view does not own the memory.
class NumberView
{
public:
  NumberView() = default;
  NumberView(const double* values, Index size)
    : Doubles(values)
    , Size(size)
  {
  }
  NumberView(const float* values, Index size)
    : Floats(values)
    , Size(size)
  {
  }
  NumberView(const std::vector<double>& values)
    : NumberView(values.data(), static_cast<Index>(values.size()))
  {
  }

  Index size() const { return this->Size; }
  double operator[](Index i) const { return this->Doubles ? this->Doubles[i] : this->Floats[i]; }

private:
  const double* Doubles = nullptr;
  const float* Floats = nullptr;
  Index Size = 0;
};
}

#endif

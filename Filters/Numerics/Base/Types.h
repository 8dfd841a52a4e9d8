/// Shared types of the numerical core: matrices by shape, a view of samples, progress.

#ifndef ConformalTypes_h
#define ConformalTypes_h

#include <Eigen/Core>
#include <Eigen/Geometry> // cross products

#include <algorithm>
#include <exception>
#include <functional>
#include <vector>

namespace conformal
{
using Index = Eigen::Index;
using Vector3 = Eigen::Vector3d;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>; ///< #P by 3
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>; ///< #F by 3, vertex ids
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>; ///< of numbers, by columns

/// Called with the fraction done, in [0, 1], never falling, always from the calling thread.
/// Returns whether to go on; after a false the core throws Aborted.
using Progress = std::function<bool(double)>;

/// Thrown by every function of the core whose Progress returns false.
class Aborted : public std::exception
{
public:
  const char* what() const noexcept override { return "aborted"; }
};

/// Report progress; an empty callback always goes on.
/// @throws Aborted if the callback says stop
inline void report(const Progress& progress, double fraction)
{
  if (progress && !progress(fraction))
  {
    throw Aborted();
  }
}

/// A part of a longer task: its [0, 1] is [begin, end] of the whole.
inline Progress partOf(const Progress& whole, double begin, double end)
{
  if (!whole)
  {
    return {};
  }
  return [=](double fraction)
  { return whole(fraction < 1.0 ? std::min(begin + fraction * (end - begin), end) : end); };
}

/// View of points in memory owned elsewhere, as packed floats or doubles, so that ten million of
/// them need no copy. Seen in a unit of length, see CoordinateFrame.
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

/// View of numbers in memory owned elsewhere.
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

/// Copy a triangle and a point of a space of any dimension to three dimensions, with equal
/// distances. Own construction: functions for triangles in space then also serve in more
/// dimensions. A triangle and a point span at most three dimensions, so the copy loses nothing.

#ifndef ConformalTriangleInSpace_h
#define ConformalTriangleInSpace_h

#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace conformal
{
/// Point X and triangle A, B, C.
struct TriangleInSpace
{
  Vector3 X, A, B, C;
};

/// Return a copy of a point and a triangle in three dimensions. All distances of the four points
/// are equal to those in the given dimension, up to rounding. The triangle can be degenerate.
/// @param[in] x          point, an array of `dimension` coordinates
/// @param[in] a,b,c      corners of the triangle
/// @param[in] dimension  number of coordinates, at least 1
inline TriangleInSpace toSpace(
  const double* x, const double* a, const double* b, const double* c, Index dimension)
{
  double bb = 0.0, bc = 0.0, cc = 0.0, bx = 0.0, cx = 0.0, xx = 0.0;
  for (Index i = 0; i < dimension; ++i)
  {
    const double toB = b[i] - a[i], toC = c[i] - a[i], toX = x[i] - a[i];
    bb += toB * toB;
    bc += toB * toC;
    cc += toC * toC;
    bx += toB * toX;
    cx += toC * toX;
    xx += toX * toX;
  }
  // The first axis is along the longer edge at A, the second one is in the plane of the triangle.
  const bool swapped = cc > bb;
  if (swapped)
  {
    std::swap(bb, cc);
    std::swap(bx, cx);
  }
  const double length = std::sqrt(bb);
  const double along = bb > 0.0 ? bc / length : 0.0;
  const double across = std::sqrt(std::max(0.0, cc - along * along));
  const double x0 = bb > 0.0 ? bx / length : 0.0;
  const double farthest =
    std::sqrt(std::max(0.0, xx - x0 * x0)); // bounds rounding errors of slivers
  const double x1 =
    across > 0.0 ? std::clamp((cx - along * x0) / across, -farthest, farthest) : 0.0;
  TriangleInSpace result;
  result.A = Vector3::Zero();
  result.B = Vector3(length, 0.0, 0.0);
  result.C = Vector3(along, across, 0.0);
  result.X = Vector3(x0, x1, std::sqrt(std::max(0.0, farthest * farthest - x1 * x1)));
  if (swapped)
  {
    std::swap(result.B, result.C);
  }
  return result;
}
}

#endif

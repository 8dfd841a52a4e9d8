#include "Texture/SurfaceTangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
Vector3 anyPerpendicular(const Vector3& n)
{
  return n.unitOrthogonal();
}

Vector3 perpendicularPart(const Vector3& v, const Vector3& n)
{
  return v - v.dot(n) * n;
}

// Direction of increasing s in a triangle, or zero if the triangle has no area in the image or
// shows the image mirrored.
Vector3 directionOfS(const Mesh& surface, const TextureCoordinates& coordinates, Index triangle)
{
  const auto corners = surface.Triangles.row(triangle);
  const Vector3 p = surface.Positions.row(corners[0]);
  const Vector3 toB = Vector3(surface.Positions.row(corners[1])) - p;
  const Vector3 toC = Vector3(surface.Positions.row(corners[2])) - p;
  const Vector2 st = coordinates.row(corners[0]);
  const Vector2 b = Vector2(coordinates.row(corners[1])) - st;
  const Vector2 c = Vector2(coordinates.row(corners[2])) - st;
  if (!(b[0] * c[1] - c[0] * b[1] > 0.0))
  {
    return Vector3::Zero();
  }
  return (toB * c[1] - toC * b[1]).stableNormalized();
}

// Key of a vertex: vertices with equal keys share their tangent.
std::array<double, 8> keyOf(
  const Mesh& surface, const Points& normals, const TextureCoordinates& coordinates, int vertex)
{
  const auto p = surface.Positions.row(vertex), n = normals.row(vertex);
  return { p[0], p[1], p[2], n[0], n[1], n[2], coordinates(vertex, 0), coordinates(vertex, 1) };
}

// For each vertex, the first vertex with the same key.
std::vector<int> firstOfEqual(
  const Mesh& surface, const Points& normals, const TextureCoordinates& coordinates)
{
  std::vector<int> order(surface.Positions.rows());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int v) { return keyOf(surface, normals, coordinates, v); };
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      const auto first = key(a), second = key(b);
      return first != second ? first < second : a < b;
    });
  std::vector<int> firsts(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isEqual = i > 0 && key(order[i]) == key(order[i - 1]);
    firsts[order[i]] = isEqual ? firsts[order[i - 1]] : order[i];
  }
  return firsts;
}

// Add the direction of s in a triangle to the sums of its three corners.
void addTriangle(const Mesh& surface, const Points& normals, const std::vector<int>& firsts,
  Index triangle, const Vector3& direction, Points& sums)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const int vertex = surface.Triangles(triangle, corner);
    const Vector3 p = surface.Positions.row(vertex), n = normals.row(vertex);
    const auto side = [&](int other)
    {
      const Vector3 end = surface.Positions.row(surface.Triangles(triangle, other));
      return perpendicularPart(end - p, n);
    };
    const double angle = angleBetween(side(next(corner)), side(previous(corner)));
    sums.row(firsts[vertex]) += angle * perpendicularPart(direction, n).stableNormalized();
  }
}
}

//------------------------------------------------------------------------------
Points surfaceTangents(
  const Mesh& surface, const Points& normals, const TextureCoordinates& coordinates, const Run& run)
{
  const Index count = surface.Positions.rows();
  if (normals.rows() != count || coordinates.rows() != count)
  {
    throw std::invalid_argument("each point needs a normal and texture coordinates");
  }
  const std::vector<int> firsts = firstOfEqual(surface, normals, coordinates);
  run.report(0.5);
  Points sums = Points::Zero(count, 3);
  for (Index f = 0; f < surface.Triangles.rows(); ++f)
  {
    const Vector3 direction = directionOfS(surface, coordinates, f);
    if (!direction.isZero(0.0))
    {
      addTriangle(surface, normals, firsts, f, direction, sums);
    }
  }
  run.report(0.9);
  Points tangents(count, 3);
  for (Index v = 0; v < count; ++v)
  {
    const Vector3 n = normals.row(v);
    const Vector3 tangent = perpendicularPart(sums.row(firsts[v]), n);
    tangents.row(v) = tangent.norm() > 1e-12 ? Vector3(tangent.normalized()) : anyPerpendicular(n);
  }
  run.report(1.0);
  return tangents;
}
}

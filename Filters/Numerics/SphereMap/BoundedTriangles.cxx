#include "SphereMap/BoundedTriangles.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr double MinimumArea = 1e-11;
}

//------------------------------------------------------------------------------
BoundedTriangles::BoundedTriangles(const Points& points, const Triangles& triangles, Weight weight)
  : Places(points)
  , Kind(weight)
{
  double area = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    area += this->triangle(triangles(r, 0), triangles(r, 1), triangles(r, 2)).Area;
  }
  this->Scale = 4.0 * Pi / area;
}

//------------------------------------------------------------------------------
SourceTriangle BoundedTriangles::triangle(int a, int b, int c) const
{
  const Vector3 p = this->Places.row(a), q = this->Places.row(b), r = this->Places.row(c);
  Vector3 squares((q - r).squaredNorm(), (r - p).squaredNorm(), (p - q).squaredNorm());
  constexpr double roundness = 1e-8, minimum = 1e-14;
  squares.array() += roundness * squares.sum() + minimum;
  const double sum = squares.sum();
  const double twiceArea = 0.5 * std::sqrt(sum * sum - 2.0 * squares.squaredNorm());
  SourceTriangle result;
  const double regularity =
    this->Kind == Weight::Area ? 1.0 : 2.0 * std::sqrt(3.0) * twiceArea / sum; // at most 1
  result.Area = std::max(0.5 * this->Scale * twiceArea * regularity, MinimumArea);
  for (int k = 0; k < 3; ++k)
  {
    result.Cotangents[k] = (sum - 2.0 * squares[k]) / (8.0 * twiceArea);
  }
  return result;
}

//------------------------------------------------------------------------------
void BoundedTriangles::cornersOf(int v, const Ring& ring, std::vector<Corner>& corners) const
{
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    corners.push_back(
      { ring[i], this->triangle(v, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]) });
  }
}

//------------------------------------------------------------------------------
void relaxVertices(std::vector<Vector3>& positions, const std::vector<int>& vertices,
  const VertexRings& rings, const BoundedTriangles& shapes, const SphereEnergy& energy, int sweeps,
  const std::function<void()>& counted)
{
  std::vector<Corner> corners;
  std::vector<std::size_t> offsets = { 0 };
  for (int v : vertices)
  {
    shapes.cornersOf(v, rings[v], corners);
    offsets.push_back(corners.size());
  }
  for (int i = 0; i < sweeps; ++i)
  {
    for (std::size_t j = 0; j < vertices.size(); ++j)
    {
      relaxVertex(positions, vertices[j], corners.data() + offsets[j],
        static_cast<int>(offsets[j + 1] - offsets[j]), energy);
      if (counted)
      {
        counted();
      }
    }
  }
}
}

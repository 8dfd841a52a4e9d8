#include "Measure/MeanCurvature.h"

#include <array>
#include <vector>

namespace conformal
{
namespace
{
Vector3 positionOf(const Points& points, const Triangles& triangles, Index r, int corner)
{
  return points.row(triangles(r, corner));
}

/// Compute the vertex normals of Max (1999): sums of (a x b) / (|a|^2 |b|^2) over the corners of a
/// vertex, whose edges are a and b.
Points normalsOf(
  const Points& points, const Triangles& triangles, const Adjacency& around, const Run& run)
{
  Points normals(points.rows(), 3);
  forBlocks(run, points.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        Vector3 sum = Vector3::Zero();
        for (const int* r = around.begin(i); r != around.end(i); ++r)
        {
          const int k = triangles(*r, 0) == i ? 0 : triangles(*r, 1) == i ? 1 : 2;
          const Vector3 at = points.row(i);
          const Vector3 a = positionOf(points, triangles, *r, next(k)) - at,
                        b = positionOf(points, triangles, *r, previous(k)) - at;
          const double scale = a.squaredNorm() * b.squaredNorm();
          if (scale > 0.0)
          {
            sum += a.cross(b) / scale;
          }
        }
        normals.row(i) = sum.stableNormalized();
      }
    });
  return normals;
}
}

//------------------------------------------------------------------------------
MeanCurvature::MeanCurvature(
  const Points& points, const conformal::Triangles& triangles, const Run& run)
  : Triangles(triangles)
  , Around(vertexTriangles(triangles, points.rows()))
  , Centroids(triangles.rows(), 3)
  , Areas(triangles.rows())
  , Values(triangles.rows())
{
  const Points normals = normalsOf(points, triangles, this->Around, run);
  forBlocks(run, triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const Vector3 a = positionOf(points, triangles, r, 0),
                      b = positionOf(points, triangles, r, 1),
                      c = positionOf(points, triangles, r, 2);
        const Vector3 cross = (b - a).cross(c - a);
        const Vector3 up = cross.stableNormalized();
        const std::array<Vector3, 3> opposite{ c - b, a - c, b - a };
        this->Centroids.row(r) = (a + b + c) / 3.0;
        this->Areas[r] = 0.5 * cross.norm();
        double sum = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          sum += Vector3(normals.row(triangles(r, k))).dot(up.cross(opposite[k]));
        }
        this->Values[r] = this->Areas[r] > 0.0 ? sum / (4.0 * this->Areas[r]) : 0.0;
      }
    });
}

//------------------------------------------------------------------------------
double MeanCurvature::over(
  const Vector3& center, Index triangle, double radius, Memory& memory) const
{
  std::vector<int>& found = memory.Found;
  found.assign(1, static_cast<int>(triangle));
  memory.IsFound.resize(this->Triangles.rows(), false);
  memory.IsFound[triangle] = true;
  double sum = 0.0, area = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const int r = found[i];
    sum += this->Areas[r] * this->Values[r];
    area += this->Areas[r];
    for (int k = 0; k < 3; ++k)
    {
      const int v = this->Triangles(r, k);
      for (const int* other = this->Around.begin(v); other != this->Around.end(v); ++other)
      {
        const Vector3 way = Vector3(this->Centroids.row(*other)) - center;
        if (!memory.IsFound[*other] && way.squaredNorm() < radius * radius)
        {
          memory.IsFound[*other] = true;
          found.push_back(*other);
        }
      }
    }
  }
  for (const int r : found)
  {
    memory.IsFound[r] = false;
  }
  return area > 0.0 ? sum / area : 0.0;
}
}

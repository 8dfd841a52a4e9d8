#include "Surface/Creases.h"

#include "Mesh/SharpEdges.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr double BendOfSide = 0.4; // maximum, in units of the angle of the edge

/// Test the second condition of creaseVertices() for the side of an edge.
/// @param[in] r  triangle on this side
/// @param[in] apex  corner of r opposite to the edge: 0, 1 or 2
/// @param[in] maximum  maximum angle between normals of the side [radians]
bool sideIsSmooth(const Triangles& triangles, const Triangles& across, const Points& normals,
  int valence, Index r, int apex, double maximum)
{
  const int center = triangles(r, apex);
  const double cosine = std::cos(maximum);
  int others = 0;
  // Turn around the apex in both directions, until a sharp edge or the start.
  for (const bool forward : { true, false })
  {
    Index at = r;
    int corner = apex;
    for (int count = 0; count < valence; ++count)
    {
      const Index beside = across(at, forward ? previous(corner) : corner);
      if (beside < 0 || beside == r || normals.row(at).dot(normals.row(beside)) < SharpCosine)
      {
        break;
      }
      if (normals.row(beside).dot(normals.row(r)) < cosine)
      {
        return false;
      }
      ++others;
      at = beside;
      corner = triangles(at, 0) == center ? 0 : triangles(at, 1) == center ? 1 : 2;
    }
  }
  return others > 0;
}
}

//------------------------------------------------------------------------------
std::vector<unsigned char> creaseVertices(const Points& points, const Triangles& triangles,
  const Adjacency& around, const Triangles& across, const Run& run)
{
  Points normals(triangles.rows(), 3);
  forBlocks(run, triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const Vector3 a = points.row(triangles(r, 0)), b = points.row(triangles(r, 1)),
                      c = points.row(triangles(r, 2));
        normals.row(r) = (b - a).stableNormalized().cross(c - a).stableNormalized();
      }
    });
  // Marks of the three edges of each triangle, by the triangle with the smaller id.
  std::vector<unsigned char> sharp(triangles.rows(), 0);
  forBlocks(run, triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Index other = across(r, k);
          const double cosine = other > r ? normals.row(r).dot(normals.row(other)) : 1.0;
          if (!(cosine < SharpCosine))
          {
            continue;
          }
          int apex = 0;
          while (across(other, next(apex)) != r)
          {
            ++apex;
          }
          const double maximum = BendOfSide * std::acos(std::max(cosine, -1.0));
          const auto smooth = [&](Index triangle, int corner)
          {
            return sideIsSmooth(triangles, across, normals,
              around.size(triangles(triangle, corner)), triangle, corner, maximum);
          };
          if (smooth(r, previous(k)) && smooth(other, apex))
          {
            sharp[r] |= static_cast<unsigned char>(1 << k);
          }
        }
      }
    });
  std::vector<unsigned char> edges(points.rows(), 0);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; sharp[r] != 0 && k < 3; ++k)
    {
      for (const int v : { triangles(r, k), triangles(r, next(k)) })
      {
        edges[v] += (sharp[r] >> k & 1) && edges[v] < 2 ? 1 : 0;
      }
    }
  }
  for (unsigned char& mark : edges)
  {
    mark = mark == 2;
  }
  return edges;
}
}

#include "Surface/SampledSurface.h"

#include "Mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
//------------------------------------------------------------------------------
bool isOrientedInward(
  const PointsIn& positions, const Triangles& triangles, const PointsIn& normals)
{
  double along = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const int a = triangles(r, 0), b = triangles(r, 1), c = triangles(r, 2);
    const Vector3 u = positions.row(b) - positions.row(a);
    const Vector3 v = positions.row(c) - positions.row(a);
    along += u.cross(v).dot(normals.row(a) + normals.row(b) + normals.row(c));
  }
  return along < 0.0;
}

//------------------------------------------------------------------------------
void smoothNormals(const PointsIn& positions, const Triangles& triangles, PointsOut normals)
{
  const Points smooth = vertexNormals(positions, triangles);
  for (Index i = 0; i < normals.rows(); ++i)
  {
    if (!smooth.row(i).isZero(0.0))
    {
      normals.row(i) = smooth.row(i);
    }
  }
}

//------------------------------------------------------------------------------
void fillNormals(PointsOut normals, const PointsIn& directions, const Run& run)
{
  forBlocks(run, normals.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        if (normals.row(i).isZero(0.0))
        {
          normals.row(i) = directions.row(i);
        }
      }
    });
}

//------------------------------------------------------------------------------
std::vector<double> clampedSupport(const CurvedSeamlessSurface& surface, const NumberView& support)
{
  std::vector<double> clamped(surface.sphere().rows(), 0.0);
  for (Index i = 0; i < support.size(); ++i)
  {
    clamped[i] = std::isfinite(support[i]) ? std::clamp(support[i], 0.0, 1.0) : 0.0;
  }
  return clamped;
}

//------------------------------------------------------------------------------
void markDegenerate(const CurvedSeamlessSurface& surface, const Triangles& triangles,
  int subdivisions, const std::vector<unsigned char>& degenerate, unsigned char* marks,
  const Run& run)
{
  const Index pieces = Index(subdivisions) * subdivisions;
  forBlocks(run, triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const auto ids = triangles.row(r);
        marks[r] = pieces > 0 ? surface.degenerate()[r / pieces]
                              : degenerate[ids[0]] | degenerate[ids[1]] | degenerate[ids[2]];
      }
    });
}
}

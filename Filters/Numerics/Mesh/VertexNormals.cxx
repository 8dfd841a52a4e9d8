#include "Mesh/VertexNormals.h"

namespace conformal
{
Points vertexNormals(const Points& points, const Triangles& triangles)
{
  return vertexNormals(points, triangles, vertexTriangles(triangles, points.rows()));
}

Points vertexNormals(
  const Points& points, const Triangles& triangles, const Adjacency& around, const Run& run)
{
  // Scale by the size of the mesh, since areas are squares.
  const double size = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0.0;
  const double unit = size > 0.0 ? 1.0 / size : 0.0;
  const Index blockSize = 1024;
  Points twiceAreas(triangles.rows(), 3);
  forBlocks(run, triangles.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const Vector3 a = unit * points.row(triangles(r, 0)),
                      b = unit * points.row(triangles(r, 1)),
                      c = unit * points.row(triangles(r, 2));
        twiceAreas.row(r) = (b - a).cross(c - a);
      }
    });
  Points normals = Points::Zero(points.rows(), 3);
  forBlocks(run, points.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        for (const int* r = around.begin(i); r != around.end(i); ++r)
        {
          normals.row(i) += twiceAreas.row(*r);
        }
        normals.row(i).stableNormalize();
      }
    });
  return normals;
}
}

#include "VertexNormals.h"

namespace conformal
{
Points vertexNormals(const Points& points, const Triangles& faces)
{
  Points normals = Points::Zero(points.rows(), 3);
  // Areas are squares, so they are taken in units of the mesh's size.
  const double size = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0.0;
  const double unit = size > 0.0 ? 1.0 / size : 0.0;
  for (Index r = 0; r < faces.rows(); ++r)
  {
    const Vector3 a = unit * points.row(faces(r, 0)), b = unit * points.row(faces(r, 1)),
                  c = unit * points.row(faces(r, 2));
    const Eigen::RowVector3d twiceArea = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k)
    {
      normals.row(faces(r, k)) += twiceArea;
    }
  }
  for (Index i = 0; i < normals.rows(); ++i)
  {
    normals.row(i).stableNormalize();
  }
  return normals;
}
}

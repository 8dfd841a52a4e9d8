/// The conformal maps of a fixed network of triangles.

#ifndef ConformalNetworkShapes_h
#define ConformalNetworkShapes_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/SchwarzChristoffel.h"
#include "TriangleMap/TriangleMap.h"

#include <vector>

namespace conformal
{
/// The triangles of a fixed network, those of one shape sharing tables of their map.
///
/// A geodesic sphere of frequency 36 has 25,920 triangles but 156 shapes (312 with their mirror
/// images). A shape that few triangles have is mapped without tables, so that a mesh without any
/// symmetry costs no memory.
class NetworkShapes
{
public:
  NetworkShapes() = default;

  /// @param[in] positions  #N by 3
  /// @param[in] triangles      #R by 3 ids of positions
  NetworkShapes(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// How many shapes have tables.
  Index numberOfTables() const { return static_cast<Index>(this->Tables.size()); }

  /// Network triangle to model triangle, \cite Liou2008 Eq. 10: barycentric coordinates of p' to
  /// those of q'. Affine (returned as they are) if one of the triangles is degenerate.
  Vector3 toModel(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  /// Model triangle to network triangle, z' = f_2(f_1^-1(z)) below \cite Liou2008 Eq. 5.
  Vector3 toNetwork(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  bool degenerate(Index triangle) const
  {
    return this->Shapes[this->Uses[triangle].Shape].degenerate();
  }

  /// The map of a triangle, in its own order of the corners.
  /// @pre not degenerate
  TriangleMap map(Index triangle) const;

private:
  struct Use
  {
    int Shape = 0;
    int Rotation = 0; // vertex k of the shape is vertex k + Rotation of the triangle
  };

  TriangleShape shape(Index triangle) const;

  std::vector<Use> Uses;
  std::vector<TriangleShape> Shapes;
  std::vector<int> TableOfShape; // or -1
  std::vector<ShapeTable> Tables;
};
}

#endif

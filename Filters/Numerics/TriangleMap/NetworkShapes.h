/// Map points between triangles of the network and of the model conformally, \cite Liou2008. The
/// network is a fixed mesh on the unit sphere. The model is a mesh in space with the same
/// connectivity.

#ifndef ConformalNetworkShapes_h
#define ConformalNetworkShapes_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/SchwarzChristoffel.h"
#include "TriangleMap/TriangleMap.h"

#include <vector>

namespace conformal
{
/// Conformal maps of all triangles of a network. Triangles with equal angles have the same shape. A
/// table contains precomputed series coefficients of the conformal map of one shape.
///
/// A geodesic sphere of frequency 36 (icosahedron with 36 segments per edge) has 25,920 triangles
/// but only 156 shapes (312 if mirror images are counted separately). Tables are made only for
/// shapes that many triangles have. A mesh without symmetry thus needs little memory.
class NetworkShapes
{
public:
  NetworkShapes() = default;

  /// @param[in] positions  #N by 3 positions of the vertices
  /// @param[in] triangles  #R by 3 ids of vertices
  NetworkShapes(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Return the number of shapes with tables.
  Index numberOfTables() const { return static_cast<Index>(this->Tables.size()); }

  /// Map a point p' of a network triangle to a point q' of a model triangle, \cite Liou2008 Eq. 10.
  /// Points are in barycentric coordinates. If one of the triangles is degenerate, the map is
  /// affine: coordinates do not change.
  Vector3 toModel(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  /// Map a point of a model triangle to a point of a network triangle: the inverse of toModel().
  /// The map is z' = f_2(f_1^-1(z)), the formula below Eq. 5 of \cite Liou2008. In this formula,
  /// f_1 maps the unit disk to the model triangle, and f_2 maps the unit disk to the network
  /// triangle.
  Vector3 toNetwork(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  bool degenerate(Index triangle) const
  {
    return this->Shapes[this->Uses[triangle].Shape].degenerate();
  }

  /// Return the map of a network triangle. The corners of the map have the same sequence as the
  /// vertices of the triangle.
  /// @pre the triangle is not degenerate
  TriangleMap map(Index triangle) const;

private:
  struct Use
  {
    int Shape = 0;
    int Rotation = 0; // corner k of the shape is corner k + Rotation (mod 3) of the triangle
  };

  TriangleShape shape(Index triangle) const;

  std::vector<Use> Uses;
  std::vector<TriangleShape> Shapes;
  std::vector<int> TableOfShape; // index into Tables, or -1 if the shape has no table
  std::vector<ShapeTable> Tables;
};
}

#endif

/// Conformal maps of the triangles of a network, \cite Liou2008. The network is the mesh on the
/// sphere, which does not change.

#ifndef ConformalNetworkShapes_h
#define ConformalNetworkShapes_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/SchwarzChristoffel.h"
#include "TriangleMap/TriangleMap.h"

#include <vector>

namespace conformal
{
/// Triangles of a network and their conformal maps. Triangles of the same shape share the tables of
/// their map.
///
/// A geodesic sphere of frequency 36 has 25,920 triangles but only 156 shapes (312 with mirror
/// images). Tables are made only for shapes of many triangles, so that a mesh without symmetry
/// needs little memory.
class NetworkShapes
{
public:
  NetworkShapes() = default;

  /// @param[in] positions  #N by 3 positions of the vertices
  /// @param[in] triangles  #R by 3 ids of positions
  NetworkShapes(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Return the number of shapes with tables.
  Index numberOfTables() const { return static_cast<Index>(this->Tables.size()); }

  /// Map a point p' of a network triangle to a point q' of a model triangle, \cite Liou2008 Eq. 10.
  /// Points are in barycentric coordinates. If one of the triangles is degenerate, the map is
  /// affine: coordinates do not change.
  Vector3 toModel(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  /// Map a point of a model triangle to a point of a network triangle: the inverse of toModel(), z'
  /// = f_2(f_1^-1(z)) below \cite Liou2008 Eq. 5.
  Vector3 toNetwork(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  bool degenerate(Index triangle) const
  {
    return this->Shapes[this->Uses[triangle].Shape].degenerate();
  }

  /// Return the map of a network triangle. Its corners have the same order as the triangle's
  /// vertices.
  /// @pre the triangle is not degenerate
  TriangleMap map(Index triangle) const;

private:
  struct Use
  {
    int Shape = 0;
    int Rotation = 0; // corner k of the shape is corner k + Rotation of the triangle
  };

  TriangleShape shape(Index triangle) const;

  std::vector<Use> Uses;
  std::vector<TriangleShape> Shapes;
  std::vector<int> TableOfShape; // index into Tables, or -1 if the shape has no table
  std::vector<ShapeTable> Tables;
};
}

#endif

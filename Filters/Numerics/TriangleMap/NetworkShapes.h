/// Conformal maps of a fixed network of triangles, \cite Liou2008.

#ifndef ConformalNetworkShapes_h
#define ConformalNetworkShapes_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/SchwarzChristoffel.h"
#include "TriangleMap/TriangleMap.h"

#include <vector>

namespace conformal
{
/// Triangles of a fixed network. Triangles of one shape share the tables of their map.
///
/// A geodesic sphere of frequency 36 has 25,920 triangles but 156 shapes (312 with mirror images).
/// A shape of few triangles has no tables, so that a mesh without symmetry costs no memory.
class NetworkShapes
{
public:
  NetworkShapes() = default;

  /// @param[in] positions  #N by 3
  /// @param[in] triangles  #R by 3 ids of positions
  NetworkShapes(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Return the number of shapes with tables.
  Index numberOfTables() const { return static_cast<Index>(this->Tables.size()); }

  /// Map barycentric coordinates from p' in the network to q' in the model, \cite Liou2008 Eq. 10.
  /// The map is affine, the coordinates unchanged, if one of the triangles is degenerate.
  Vector3 toModel(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  /// Map barycentric coordinates from the model to the network: z' = f_2(f_1^-1(z)) below \cite
  /// Liou2008 Eq. 5.
  Vector3 toNetwork(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  bool degenerate(Index triangle) const
  {
    return this->Shapes[this->Uses[triangle].Shape].degenerate();
  }

  /// Return the map of a triangle, with the corners in the order of the triangle.
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
  std::vector<int> TableOfShape; // -1 without a table
  std::vector<ShapeTable> Tables;
};
}

#endif

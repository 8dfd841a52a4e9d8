/// The curved seamless surface of a closed mesh with a map to the sphere, \cite Liou2008 Section 3.

#ifndef ConformalCurvedSeamlessSurface_h
#define ConformalCurvedSeamlessSurface_h

#include "NetworkShapes.h"
#include "Parallel.h"
#include "SphereLocator.h"
#include "Types.h"

#include <vector>

namespace conformal
{
/// The surface as a function of the direction, to be evaluated wherever it is wanted.
///
/// Steps of the CSS algorithm: the constructor does 1 to 5, evaluate() 6 to 10.
///
/// Implementation note: the paper adds the heights of the unit sphere's domes to a model of the
/// sphere's size. Here the model may have any unit and place: heights are multiplied by the
/// largest distance of a vertex from the vertices' mean.
///
/// Implementation note: the flat maps of two triangles move the points of their common edge
/// differently, so as a map the published construction jumps there; each direction by itself has
/// one image.
///
/// Implementation note: domes rise to the outside, where the model's volume is positive, whichever
/// way the triangles run and even if the map mirrors.
///
/// Implementation note: where Eq. 11 leaves a choice. At a corner, 0/0, the quotient is 1; the
/// height is 0 there. If the centre's image lies beyond an end of the edge, a_q' is the point
/// where the perpendicular leaves the subtriangle on the side away from the edge. Neighbours that
/// face exactly opposite ways have no mean normal (Eq. 8): each uses its own. A triangle without
/// area has no normal: it takes its neighbours' at its edges.
class CurvedSeamlessSurface
{
public:
  struct Image
  {
    Vector3 Position = Vector3::Zero(); ///< q
    int Triangle = -1;                  ///< r
  };

  /// @param[in] sphere  #N by 3, n_i; any length but 0
  /// @param[in] model   #N by 3, w_i
  /// @param[in] faces   #R by 3 ids, a closed, consistently oriented surface
  /// @throws std::invalid_argument if positions are not finite, or if the sphere map has no
  ///   direction for a vertex or does not cover the sphere just once
  CurvedSeamlessSurface(const Points& sphere, const Points& model, const Triangles& faces,
    const ParallelFor& parallelFor = {}, const Progress& progress = {});

  /// Image q of a direction p of the sphere, \cite Liou2008 Eqs. 9 to 12. About 0.5 us.
  /// @param[in] direction  p, a unit vector
  /// @throws std::invalid_argument if it is far from being one
  /// @post at p = n_i the position is w_i, to the bit
  Image evaluate(const Vector3& direction) const;

  /// Unit normal of a flat triangle of the model, \cite Liou2008 Eq. 7; zero if it has no area.
  Vector3 normal(Index triangle) const { return this->Normals.row(triangle); }

  /// For each triangle 1 if something in the construction is undefined: it has no shape, in the
  /// model or on the sphere, and is mapped affinely; or a neighbour faces the opposite way.
  const std::vector<unsigned char>& degenerate() const { return this->Degenerate; }

private:
  Vector3 direction(Index triangle, const Vector3& barycentric) const;
  Vector3 modelPoint(Index triangle, const Vector3& barycentric) const;
  bool edgeDirection(Index triangle, int opposite, Vector3& direction) const;

  Points Sphere;
  Points Model;
  Triangles Faces;
  Triangles Neighbors;
  double HeightUnit = 1.0;
  SphereLocator Locator;
  NetworkShapes Network;
  std::vector<TriangleShape> Shapes;
  Points Centers; // #R by 3, barycentric coordinates of c_w
  Points Normals; // #R by 3
  std::vector<unsigned char> Degenerate;
};

struct CurvedSeamlessSurfaceResult
{
  Points Directions;                     ///< #P by 3, p as unit vectors
  Points Positions;                      ///< #P by 3, q
  Points Normals;                        ///< #P by 3, flat normal of each point's triangle, or zero
  std::vector<unsigned char> Degenerate; ///< #P, 1 in triangles where something is undefined
  Index NumberOfDegenerateTriangles = 0; ///< of the mesh
};

/// Evaluate a surface once, CSS algorithm steps 1 to 11.
///
/// @param[in] sphere      #N by 3, n_i; any length but 0
/// @param[in] model       #N by 3, w_i
/// @param[in] faces       #R by 3 ids, a closed, consistently oriented surface
/// @param[in] directions  #P by 3, N^new; any length but 0
/// @throws std::invalid_argument as CurvedSeamlessSurface does, or if a direction is none
CurvedSeamlessSurfaceResult buildCurvedSeamlessSurface(const Points& sphere, const Points& model,
  const Triangles& faces, const Points& directions, const ParallelFor& parallelFor = {},
  const Progress& progress = {});
}

#endif

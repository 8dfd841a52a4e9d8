/// Which triangle of a map to the sphere holds a direction.

#ifndef ConformalSphereLocator_h
#define ConformalSphereLocator_h

#include "BoxTree.h"
#include "Types.h"

#include <vector>

namespace conformal
{
/// Where the line from the sphere's centre along a direction meets the flat triangles.
struct SphereLocation
{
  int Triangle = -1;                     ///< -1 if no triangle is near
  Vector3 Barycentric = Vector3::Zero(); ///< of p', \cite Liou2008 Eq. 9; >= 0, sum 1
};

/// Point location on the sphere, exact to the rounding of the positions, however small the
/// triangles are: conformal maps of long limbs shrink them to exp(-16) of their fair area.
///
/// The side of an edge on which a direction lies is computed from differences to the direction
/// and in one order of the edge's vertices, so the two triangles of an edge never disagree. Of
/// triangles that share the direction the lowest id is taken; where rounding at a vertex leaves
/// none, the one that misses it least.
///
/// A query costs about log(#R) and only reads, so many threads may ask at once.
class SphereLocator
{
public:
  SphereLocator() = default;

  /// @param[in] positions  #N by 3 unit vectors
  /// @param[in] faces      #R by 3 ids, counter-clockwise seen from outside
  SphereLocator(const Points& positions, const Triangles& faces);

  /// @param[in] direction  p, a unit vector
  SphereLocation locate(const Vector3& direction) const;

private:
  struct Corners
  {
    Vector3 Positions[3];
    bool Ascending[3] = {}; // edge k, opposite to corner k, runs from its lower to its higher id
  };
  static double side(const Corners& corners, int opposite, const Vector3& direction);
  template <typename Visit>
  void visitNear(const Vector3& direction, Visit visit) const;

  BoxTree Tree;
  std::vector<Corners> Placed; // of the triangle at each place of Tree.Items
};
}

#endif

/// Straighten paths on a surface until they are geodesics: locally shortest paths, which cross
/// triangles in any direction.

#ifndef ConformalGeodesicPath_h
#define ConformalGeodesicPath_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Point of a path: on the edge between two vertices. First and Second are equal at a vertex.
struct PathPoint
{
  int First = -1, Second = -1;
  double Fraction = 0.0; ///< position between First (0) and Second (1)
};

/// Check that paths across edges are defined.
/// @throws std::invalid_argument if an edge belongs to more than two triangles, or to two triangles
///   of opposite orientation
void requireSimpleEdges(const Mesh& mesh);

/// Compute the position of a point of a path.
Vector3 positionOf(const PathPoint& point, const Points& positions);

/// Compute the length of a path.
double lengthOf(const std::vector<PathPoint>& path, const Points& positions);

/// Find paths along edges on which distances decrease: the next vertex v is the neighbor with the
/// smallest sum of its distance and the length of the edge. Locally shortest paths found from them
/// usually pass obstacles on the right side, on which paths along edges can be longer.
/// @param[in] distances  approximate distance of each vertex from a source, as of HeatDistances
/// @return like EdgePaths::Ways; -1 also for vertices whose neighbors have no smaller distance
std::vector<int> waysDownhill(const Mesh& mesh, const Eigen::VectorXd& distances);

/// Surface on which paths are straightened.
///
/// Own construction, with the criterion of \cite Sharp2020b for a locally shortest path. At each
/// vertex on such a path, the angles of the surface on both sides are at least pi. The triangles
/// that a path crosses are unfolded in the plane, where the shortest path among them is found by
/// the funnel method, \cite Lee1984. Where the path touches a vertex whose angle on the other side
/// is smaller than pi, the triangles on the other side replace those that were crossed. Each
/// replacement makes the path shorter.
class PathStraightener
{
public:
  /// @param[in] mesh  triangles, which may have borders. The mesh must exist as long as this
  /// object.
  /// @throws std::invalid_argument if an edge belongs to more than two triangles, or to two
  ///   triangles of opposite orientation
  explicit PathStraightener(const Mesh& mesh);

  /// Straighten a path along edges.
  /// @param[in] vertices  at least two ids; successive ones are the ends of an edge
  /// @return points of the path, from the first vertex to the last one. If triangles around a
  /// vertex
  ///   of the path are not connected by edges, return the path along edges.
  /// @throws Aborted
  std::vector<PathPoint> straighten(const std::vector<int>& vertices, const Run& run = {}) const;

private:
  struct Unfolded;
  struct Touched;

  std::vector<int> fan(int center, int from, int to) const;
  double angleOf(const std::vector<int>& fan, int center) const;
  std::vector<int> sleeveOf(const std::vector<int>& vertices) const;
  Unfolded unfold(const std::vector<int>& sleeve, int start, int end) const;
  bool bypass(
    std::vector<int>& sleeve, const Unfolded& unfolded, const std::vector<Touched>& touched) const;

  static std::vector<Touched> shortestPath(const Unfolded& unfolded);

  const Mesh& Surface;
  Adjacency Around;    // triangles of each vertex
  Triangles Neighbors; // triangle across each edge
  Points Angles;       // #F by 3, at the corners
};
}

#endif

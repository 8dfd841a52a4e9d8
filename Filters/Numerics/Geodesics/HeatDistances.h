/// Compute geodesic distances: lengths of shortest paths on a surface. The heat method,
/// \cite Crane2013, solves two sparse systems of equations for each set of sources.

#ifndef ConformalHeatDistances_h
#define ConformalHeatDistances_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Geodesics/IntrinsicTriangulation.h"
#include "Linear/MultifrontalCholesky.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Distances from the nearest sources, and these sources.
struct NearestSources
{
  Eigen::VectorXd Distances; ///< #V, as of HeatDistances::from()
  /// For each vertex, the position of its source in the list of sources; -1 where the distance is
  /// -1
  std::vector<int> Positions;
};

/// Geodesic distances on a surface. The equations are factored once, for any number of sources.
///
/// Implementation note: equations are those of the intrinsic Delaunay triangulation, so that the
/// method does not depend on the shapes of triangles. A mesh of less than 25,000 vertices is
/// divided into smaller triangles of the same surface, since errors are proportional to the length
/// of edges. The time t of the heat flow is the square of the mean edge length, as in section 3.2.4
/// of the paper, but at least the square of 1/400 of the longest path: on finer meshes, heat that
/// is far from the sources would be below the smallest number of double precision. Each connected
/// part of the surface has its own time t.
class HeatDistances
{
public:
  /// @param[in] mesh  any triangles, also with borders; no triangle repeats a vertex
  /// @throws NumericalFailure if the equations cannot be factored
  /// @throws Aborted
  explicit HeatDistances(const Mesh& mesh, const Run& run = {});

  /// Compute the distance of each vertex from the nearest source.
  /// @param[in] sources  at least one id of a vertex
  /// @return #V distances, at least 0. The distance is -1 for vertices that are not connected with
  ///   a source, such as vertices without triangles.
  /// @throws NumericalFailure if the computed heat of a vertex that is connected with a source is
  ///   not positive
  Eigen::VectorXd from(const std::vector<int>& sources) const;

  /// Assign each vertex to its nearest source. A vertex belongs to the source of the neighbor that
  /// is next on the way to the source.
  /// @throws NumericalFailure like from()
  NearestSources nearestSources(const std::vector<int>& sources) const;

  /// List the vertices of triangles.
  std::vector<int> usedVertices() const;

private:
  Eigen::VectorXd divergence(const Eigen::VectorXd& heat) const;
  Eigen::VectorXd fineDistances(const std::vector<int>& sources) const;
  void spread(const Eigen::VectorXd& distances, std::vector<int>& nearest) const;

  Index NumberOfVertices = 0; // of the mesh that was given, which come first
  IntrinsicTriangulation Surface;
  std::vector<MultifrontalCholesky> Factors; // of the heat flow, and of Poisson's equation
};

/// Choose vertices that are far from each other: repeatedly the vertex with the largest distance
/// from all sources so far, \cite Eldar1997. A connected part without sources is farther than all
/// others.
/// @param[in,out] sources  given sources, at least one. The chosen vertices are added. Fewer are
///   added if no vertex is left.
/// @param[in] count  number of vertices to add
void addFarthestVertices(
  const HeatDistances& surface, Index count, std::vector<int>& sources, const Run& run = {});
}

#endif

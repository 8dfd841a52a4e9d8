/// Collapse half-edges of a closed mesh one by one, \cite Garland1997. Collapses that change the
/// shape least are made first.

#ifndef ConformalQuadricCollapse_h
#define ConformalQuadricCollapse_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <queue>
#include <vector>

namespace conformal
{
/// Half-edge collapses of a closed mesh. A half-edge collapse merges a vertex into one of its
/// neighbors. Each call of next() makes the collapse of minimum cost. The cost is the quadric
/// error, plus a small penalty for large and thin triangles. The quadric error is the sum of
/// squared distances from planes of triangles, weighted by area, \cite Garland1997. In flat parts,
/// where the quadric error is 0, the penalty distributes the remaining vertices evenly.
///
/// A collapse is unwanted if afterwards a triangle is flipped or very thin, or a vertex has more
/// than ten neighbors. Unwanted collapses have a much higher cost, and are therefore made last.
/// Every closed surface of genus zero has a vertex with at most five neighbors. This vertex can
/// collapse into one of its neighbors. The surface can therefore be reduced to a tetrahedron.
class QuadricCollapse
{
public:
  /// Treatment of needles, very thin triangles of the input surface.
  enum class Needles
  {
    /// Collapse vertices of needles last, because most of these collapses make new needles. This
    /// value is for surfaces with few needles.
    Keep,
    /// Collapse vertices of needles like other vertices, unless the collapse makes thinner
    /// triangles
    Thin
  };

  /// Compute the costs of all collapses. The parameters `points` and `rings` must outlive this
  /// object.
  /// @param[in] points     #V by 3 positions, with coordinates of magnitude about 1
  /// @param[in,out] rings  connectivity of a closed surface of genus zero; changed by each collapse
  QuadricCollapse(const Points& points, VertexRings& rings, Needles needles = Needles::Keep);

  struct Collapse
  {
    int Vertex; ///< id of the removed vertex
    /// Neighbors of the removed vertex before the collapse, starting with the neighbor into which
    /// the removed vertex collapsed
    Ring Neighbors;
  };

  /// Remove the vertex whose collapse has minimum cost. If several vertices have this cost, remove
  /// the one with the smallest id.
  /// @pre more than four vertices are in use (belong to triangles)
  Collapse next();

private:
  struct Quadric
  {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Vector3 B = Vector3::Zero();
    double C = 0.0;

    double at(const Vector3& x) const { return x.dot(this->A * x + 2.0 * this->B) + this->C; }
  };
  struct Candidate
  {
    double Cost;
    int Vertex;
    int Stamp;

    bool operator<(const Candidate& other) const // the top of the queue is its maximum
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost : this->Vertex > other.Vertex;
    }
  };
  struct Choice
  {
    double Cost;
    int Target;
  };

  Vector3 point(int v) const { return this->Places.row(v); }
  double shapeCost(int v, int u) const;
  Choice bestTarget(int v) const;
  void enqueue(int v);

  const Points& Places;
  VertexRings& Rings;
  std::vector<Quadric> Quadrics;
  // maximum aspect ratio of triangles (1 if equilateral) accepted at each vertex
  std::vector<double> Aspects;
  // stamp (counter) of the latest candidate of each vertex; queued candidates with lower stamps are
  // outdated
  std::vector<int> Stamps;
  std::priority_queue<Candidate> Queue;
};
}

#endif

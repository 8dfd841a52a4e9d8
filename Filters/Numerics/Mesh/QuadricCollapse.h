/// Half-edge collapses of a closed mesh in the order of their quadric error, \cite Garland1997.

#ifndef ConformalQuadricCollapse_h
#define ConformalQuadricCollapse_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <queue>
#include <vector>

namespace conformal
{
/// Half-edge collapses in the order of their quadric error, \cite Garland1997. A small penalty for
/// large and misshapen triangles makes flat parts lose vertices evenly.
///
/// Collapses that flip a triangle, make a needle or join many neighbors are postponed until no
/// other collapse is left. Every closed surface of genus zero can thus be reduced to a tetrahedron.
/// The reason is that it always has a vertex with at most five neighbors, which can always collapse
/// into one of them.
class QuadricCollapse
{
public:
  /// Priority of collapses at needles of the input surface. A needle is a very thin triangle.
  enum class Needles
  {
    /// Remove needles last, because collapses there make new needles. For surfaces with few needles
    Keep,
    Thin ///< Remove needles like other triangles, unless the collapse makes thinner ones
  };

  /// Prepare collapses. The object refers to `points` and `rings`, which must outlive it.
  /// @param[in] points     #V by 3 positions, of size about 1
  /// @param[in,out] rings  connectivity of a closed surface of genus zero; changed by each collapse
  QuadricCollapse(const Points& points, VertexRings& rings, Needles needles = Needles::Keep);

  struct Collapse
  {
    int Vertex; ///< id of the removed vertex
    /// Its neighbors before the collapse, starting with the vertex into which it collapsed
    Ring Neighbors;
  };

  /// Remove the vertex of minimum cost. Of vertices with equal cost, the smallest id is removed.
  /// @pre more than four vertices are in use
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
  std::vector<double> Aspects; // maximum aspect accepted at each vertex
  std::vector<int> Stamps;     // a candidate with an older stamp is outdated
  std::priority_queue<Candidate> Queue;
};
}

#endif

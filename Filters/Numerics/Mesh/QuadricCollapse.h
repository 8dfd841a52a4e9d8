/// Half-edge collapses of a closed mesh in the order of their quadric error, \cite Garland1997.

#ifndef ConformalQuadricCollapse_h
#define ConformalQuadricCollapse_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <queue>
#include <vector>

namespace conformal
{
/// Half-edge collapses in the order of quadric error \cite Garland1997. A small penalty for large
/// and misshapen triangles thins flat parts evenly.
///
/// A collapse that flips a triangle, makes a needle or joins many neighbors is postponed until no
/// other is left. Every closed surface of genus zero can thus be reduced to a tetrahedron. It
/// always has a vertex of at most five neighbors, and such a vertex can always collapse into one of
/// them.
class QuadricCollapse
{
public:
  /// Priority of collapses at needles of the surface itself.
  enum class Needles
  {
    Keep, ///< remove needles last, as collapses there make needles: suits surfaces with few needles
    Thin  ///< remove needles like other triangles, unless that makes worse ones
  };

  /// Keep references to the points and the rings.
  /// @param[in] points     #V by 3, of size about 1
  /// @param[in,out] rings  a closed surface of genus zero
  QuadricCollapse(const Points& points, VertexRings& rings, Needles needles = Needles::Keep);

  struct Collapse
  {
    int Vertex;     ///< id of the removed vertex
    Ring Neighbors; ///< neighbors before the collapse, the target of the collapse first
  };

  /// Remove the vertex of minimum cost; of equal costs the smallest id is removed first.
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

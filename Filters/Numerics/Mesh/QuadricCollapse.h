/// Half-edge collapses of a closed mesh in the order of their quadric error.

#ifndef ConformalQuadricCollapse_h
#define ConformalQuadricCollapse_h

#include "Base/Types.h"
#include "Mesh/VertexRings.h"

#include <queue>
#include <vector>

namespace conformal
{
/// Half-edge collapses in the order of the quadric error \cite Garland1997, with a little for
/// large and misshapen triangles, so that flat parts are thinned evenly too. A collapse that turns
/// a triangle over, makes a needle or gathers many neighbors is left until there is no other, so
/// every closed surface of genus zero gets down to a tetrahedron: it always has a vertex of at
/// most five neighbors, and such a vertex always has a neighbor into which it can go.
class QuadricCollapse
{
public:
  /// What to do where the surface's own triangles are needles.
  enum class Needles
  {
    Keep, ///< to the last, as collapses there make needles: good if they are few
    Thin  ///< as readily as others, as long as it makes none that are worse
  };

  /// Points and rings are kept by reference.
  /// @param[in] points     #V by 3, about of size one
  /// @param[in,out] rings  a closed surface of genus zero
  QuadricCollapse(const Points& points, VertexRings& rings, Needles needles = Needles::Keep);

  struct Collapse
  {
    int Vertex;     ///< the one taken out
    Ring Neighbors; ///< it had, the one it went into first
  };

  /// Take out the next vertex. Of equal costs the smallest id goes first.
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

    bool operator<(const Candidate& other) const // the queue takes the greatest first
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
  std::vector<double> Aspects; // the worst to be accepted at each vertex
  std::vector<int> Stamps;     // a candidate of an older stamp is out of date
  std::priority_queue<Candidate> Queue;
};
}

#endif

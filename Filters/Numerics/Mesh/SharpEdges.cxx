#include "Mesh/SharpEdges.h"

#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr int FilterPasses = 8;
constexpr int MajorityPasses = 3;
constexpr int GrowthPasses = 3; // number of passes that continue sharp edges into corners

// Parameters of the filter of normals: width in space, in units of the edge length, and width of
// the differences of unit normals.
constexpr double FilterWidth = 1.0, NormalWidth = 0.35;

// Minimum cosine, in a plane, between the normal of a triangle and its smoothed normal
constexpr double PlaneCosine = 0.985;

// Radius of the area whose planes are weighted at a vertex, and maximum move of a vertex, both in
// units of the edge length.
constexpr double PlaneWidth = 1.2, LongestWay = 1.2;
// Minimum fraction of the area around a vertex that consists of planes. Triangles across an edge
// are not counted. Measured: 0.95 or more on edges of a machine part, 0.90 or less on ridges of
// animals, with one exception in twenty vertices each. In corners, between accepted vertices, a
// smaller share suffices.
constexpr double SurePlaneShare = 0.92, MinimumPlaneShare = 0.6;

// Maximum residual of planes on sharp edges, in edge lengths. Measured: 0.02 to 0.06 on a machine
// part, mostly above 0.12 on ridges of animals.
constexpr double MaximumMisfit = 0.09;

// Relative second moment of the normals below which a direction is undetermined, as along an edge.
constexpr double MinimumEigenvalue = 0.04;

// Limits for the rotation and quality of triangles with a moved vertex
constexpr double SnapCosine = 0.0, SnapQuality = 0.05;

using Corners = std::array<Vector3, 3>;

Corners cornersOf(const Mesh& mesh, Index triangle)
{
  const auto ids = mesh.Triangles.row(triangle);
  return { mesh.Positions.row(ids[0]), mesh.Positions.row(ids[1]), mesh.Positions.row(ids[2]) };
}

Vector3 areaVector(const Corners& corners)
{
  return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

double quality(const Corners& c)
{
  return triangleQuality(c[0], c[1], c[2]);
}

double meanEdge(const Mesh& mesh)
{
  const double area = surfaceArea(mesh.Positions, mesh.Triangles);
  return std::sqrt(4.0 / std::sqrt(3.0) * area / static_cast<double>(mesh.Triangles.rows()));
}

void sortUnique(std::vector<int>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// Vertices beside sharp edges, and their target positions.
struct SharpEdges
{
  std::vector<int> Vertices; ///< ids, ascending
  std::vector<Vector3> Places;
};

/// Find the sharp edges, see sharpenEdges().
class Finder
{
public:
  Finder(const Mesh& mesh, const Run& run)
    : Surface(mesh)
    , Threads(run.unwatched())
    , Around(vertexTriangles(mesh.Triangles, mesh.Positions.rows()))
    , Neighbors(vertexNeighbors(mesh.Triangles, mesh.Positions.rows()))
    , TrianglesAcross(triangleNeighbors(mesh.Triangles, this->Around, run))
    , Edge(meanEdge(mesh))
    , Normals(mesh.Triangles.rows(), 3)
    , Centers(mesh.Triangles.rows(), 3)
    , Areas(mesh.Triangles.rows())
  {
    forBlocks(this->Threads, this->Areas.size(), HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index r = begin; r < end; ++r)
        {
          const Corners corners = cornersOf(mesh, r);
          const Vector3 vector = areaVector(corners);
          this->Areas[r] = vector.norm();
          this->Normals.row(r) = this->Areas[r] > 0.0 ? Vector3(vector / this->Areas[r]) : vector;
          this->Centers.row(r) = (corners[0] + corners[1] + corners[2]) / 3.0;
        }
      });
    this->Smoothed = this->Normals;
  }

  void smoothNormals(const Run& run)
  {
    Points next(this->Smoothed.rows(), 3);
    for (int pass = 0; pass < FilterPasses; ++pass)
    {
      forBlocks(this->Threads, next.rows(), HeavyBlock,
        [&](Index begin, Index end)
        {
          for (Index r = begin; r < end; ++r)
          {
            next.row(r) = this->smoothedNormal(r);
          }
        });
      this->Smoothed.swap(next);
      run.report((pass + 1.0) / FilterPasses);
    }
    for (int pass = 0; pass < MajorityPasses; ++pass)
    {
      this->takeSides();
    }
  }

  SharpEdges edges() const
  {
    std::vector<int> beside;
    for (Index r = 0; r < this->TrianglesAcross.rows(); ++r)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (this->sharp(r, k))
        {
          beside.push_back(this->Surface.Triangles(r, k));
          beside.push_back(this->Surface.Triangles(r, next(k)));
        }
      }
    }
    sortUnique(beside);
    std::vector<Candidate> candidates(beside.size());
    std::vector<char> sure(this->Surface.Positions.rows(), 0);
    forBlocks(this->Threads, static_cast<Index>(beside.size()), HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          candidates[i] = this->candidate(beside[i]);
          sure[beside[i]] = candidates[i].Sure;
        }
      });
    // An edge continues in two directions.
    const auto amongSure = [&](int v)
    {
      return std::count_if(this->Neighbors.begin(v), this->Neighbors.end(v),
               [&](int neighbor) { return sure[neighbor] != 0; }) >= 2;
    };
    for (int pass = 0; pass < GrowthPasses; ++pass)
    {
      std::vector<char> more = sure;
      for (std::size_t i = 0; i < candidates.size(); ++i)
      {
        more[beside[i]] = sure[beside[i]] || (candidates[i].Possible && amongSure(beside[i]));
      }
      sure.swap(more);
    }
    SharpEdges result;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      if (sure[beside[i]] && amongSure(beside[i]))
      {
        result.Vertices.push_back(beside[i]);
        result.Places.push_back(candidates[i].Place);
      }
    }
    return result;
  }

private:
  Vector3 smoothedNormal(Index r) const
  {
    const auto ids = this->Surface.Triangles.row(r);
    const Vector3 normal = this->Smoothed.row(r), center = this->Centers.row(r);
    const double spread = FilterWidth * this->Edge;
    Vector3 sum = this->Areas[r] * normal;
    for (int k = 0; k < 3; ++k)
    {
      for (const int* t = this->Around.begin(ids[k]); t != this->Around.end(ids[k]); ++t)
      {
        // A triangle that also contains the next corner is visited there.
        if ((this->Surface.Triangles.row(*t).array() != ids[next(k)]).all())
        {
          const Vector3 other = this->Smoothed.row(*t), way = this->Centers.row(*t);
          sum += this->Areas[*t] *
            std::exp(-0.5 * (way - center).squaredNorm() / (spread * spread) -
              0.5 * (other - normal).squaredNorm() / (NormalWidth * NormalWidth)) *
            other;
        }
      }
    }
    const double length = sum.norm();
    return length > 0.0 ? Vector3(sum / length) : normal;
  }

  bool sharp(Index r, int k) const
  {
    return this->Smoothed.row(r).dot(this->Smoothed.row(this->TrianglesAcross(r, k))) < SharpCosine;
  }

  /// Test whether a triangle bevels a sharp edge, or is adjacent to such a triangle.
  bool across(Index r) const { return this->sharp(r, 0) || this->sharp(r, 1) || this->sharp(r, 2); }

  /// A triangle between two or three sharp edges belongs to no plane.
  void takeSides()
  {
    for (Index r = 0; r < this->TrianglesAcross.rows(); ++r)
    {
      int count = 0;
      Vector3 sum = Vector3::Zero();
      for (int k = 0; k < 3; ++k)
      {
        if (this->sharp(r, k))
        {
          ++count;
          sum += Vector3(this->Smoothed.row(this->TrianglesAcross(r, k)));
        }
      }
      if (count >= 2 && sum.squaredNorm() > 0.0)
      {
        this->Smoothed.row(r) = sum.normalized();
      }
    }
  }

  struct Candidate
  {
    Vector3 Place;     ///< target position on the edge
    bool Sure = false; ///< whether the area around consists of planes that the position fits
    bool Possible = false;
  };

  Candidate candidate(int v) const
  {
    const Vector3 from = this->Surface.Positions.row(v);
    const double spread = PlaneWidth * this->Edge;
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Vector3 side = Vector3::Zero();
    double squares = 0.0, weights = 0.0, all = 0.0;
    for (const int t : this->trianglesAround(v))
    {
      const Vector3 normal = this->Normals.row(t), way = Vector3(this->Centers.row(t)) - from;
      const double weight = this->Areas[t] * std::exp(-0.5 * way.squaredNorm() / (spread * spread));
      const bool planar = normal.dot(Vector3(this->Smoothed.row(t))) >= PlaneCosine;
      all += planar || !this->across(t) ? weight : 0.0;
      if (planar)
      {
        const double distance = normal.dot(way);
        matrix += weight * normal * normal.transpose();
        side += weight * distance * normal;
        squares += weight * distance * distance;
        weights += weight;
      }
    }
    if (!(weights > MinimumPlaneShare * all))
    {
      return {};
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(matrix / weights);
    Vector3 way = Vector3::Zero();
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 direction = moments.eigenvectors().col(axis);
      const double moment = moments.eigenvalues()[axis];
      way += moment > MinimumEigenvalue
        ? Vector3(direction.dot(side) / (weights * moment) * direction)
        : Vector3(Vector3::Zero());
    }
    const double misfit =
      std::sqrt(std::max(0.0, squares - 2.0 * side.dot(way) + way.dot(matrix * way)) / weights);
    const double length = way.norm(), longest = LongestWay * this->Edge;
    return { from + (length > longest ? longest / length : 1.0) * way,
      weights >= SurePlaneShare * all && misfit <= MaximumMisfit * this->Edge, true };
  }

  /// Find the triangles up to three triangles away.
  std::vector<int> trianglesAround(int v) const
  {
    std::vector<int> vertices = { v };
    for (int ring = 0; ring < 2; ++ring)
    {
      std::vector<int> wider = vertices;
      for (const int u : vertices)
      {
        wider.insert(wider.end(), this->Neighbors.begin(u), this->Neighbors.end(u));
      }
      sortUnique(wider);
      vertices = std::move(wider);
    }
    std::vector<int> triangles;
    for (const int u : vertices)
    {
      triangles.insert(triangles.end(), this->Around.begin(u), this->Around.end(u));
    }
    sortUnique(triangles);
    return triangles;
  }

  const Mesh& Surface;
  const Run Threads; // threads without progress reports
  const Adjacency Around, Neighbors;
  const Triangles TrianglesAcross;
  const double Edge;
  Points Normals, Centers, Smoothed;
  Eigen::VectorXd Areas;
};

/// Test whether no triangle around a vertex is flipped, flattened or folded when the vertex moves.
bool staysGood(
  const Mesh& mesh, const Adjacency& around, const Triangles& across, int v, const Vector3& to)
{
  const auto moved = [&](Index r)
  {
    Corners corners = cornersOf(mesh, r);
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = mesh.Triangles(r, k) == v ? to : corners[k];
    }
    return corners;
  };
  for (const int* t = around.begin(v); t != around.end(v); ++t)
  {
    const Corners before = cornersOf(mesh, *t), after = moved(*t);
    const Vector3 old = areaVector(before), now = areaVector(after);
    if (now.dot(old) < SnapCosine * now.norm() * old.norm() ||
      quality(after) < std::min(SnapQuality, quality(before)))
    {
      return false;
    }
    for (int k = 0; k < 3; ++k)
    {
      const Index other = across(*t, k);
      if (now.dot(areaVector(moved(other))) < 0.0 &&
        old.dot(areaVector(cornersOf(mesh, other))) >= 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

/// Move vertices serially, since each move depends on the neighbors.
Index moveVertices(Mesh& mesh, const SharpEdges& edges)
{
  const Adjacency around = vertexTriangles(mesh.Triangles, mesh.Positions.rows());
  const Triangles across = triangleNeighbors(mesh.Triangles, around);
  std::vector<bool> moved(edges.Vertices.size(), false);
  // In the second pass, neighbors that blocked a vertex have moved.
  for (const double share : { 1.0, 1.0, 0.5, 0.25 })
  {
    for (std::size_t i = 0; i < edges.Vertices.size(); ++i)
    {
      const int v = edges.Vertices[i];
      const Vector3 from = mesh.Positions.row(v);
      const Vector3 to = from + share * (edges.Places[i] - from);
      if (!moved[i] && staysGood(mesh, around, across, v, to))
      {
        mesh.Positions.row(v) = to;
        moved[i] = true;
      }
    }
  }
  return std::count(moved.begin(), moved.end(), true);
}
}

//------------------------------------------------------------------------------
Index sharpenEdges(Mesh& mesh, const Run& run)
{
  Steps steps(run, { 2.0, FilterPasses, 1.0 });
  steps.next();
  Finder finder(mesh, run);
  finder.smoothNormals(steps.next());
  steps.next();
  const SharpEdges edges = finder.edges();
  return edges.Vertices.empty() ? 0 : moveVertices(mesh, edges);
}
}

#include "Learn/Fit/SurfaceEquations.h"

#include "Base/Steps.h"
#include "Linear/ConjugateGradients.h"
#include "Mesh/HingeBending.h"
#include "Mesh/VertexNormals.h"

#include <algorithm>
#include <array>
#include <utility>

namespace conformal
{
namespace
{
/// Weight of a pattern's tangential distance, relative to that along the normal. Measured: 0.1
/// halves the progress per iteration; 0.003 is no better, with worse triangles.
constexpr double SlidingWeight = 0.02;

// Steps of conjugate gradients, for few and for many vertices. Measured with 60,000 vertices: more
// than 8 steps bring the surface no closer to the samples.
constexpr int NumberOfSteps = 25, StepsOfMany = 10;
constexpr Index ManyUnknowns = 20000;
constexpr double Converged = 1e-12;

// For each triangle: products of barycentric weights of foot points inside it, of foot points on
// its edges, then their residuals.
constexpr Index SumsPerTriangle = 21, RimSums = 6, ResidualSums = 12;
constexpr Index ProductOf[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };

/// Symmetric 3 by 3 matrix of floats, which halves the memory traffic of large networks. The
/// right-hand side, which determines the solution, has full precision.
struct Symmetric
{
  std::array<float, 6> Values{};

  /// a I + b v v^T
  void add(double a, double b, const Vector3& v)
  {
    this->Values[0] += static_cast<float>(a + b * v[0] * v[0]);
    this->Values[1] += static_cast<float>(b * v[0] * v[1]);
    this->Values[2] += static_cast<float>(b * v[0] * v[2]);
    this->Values[3] += static_cast<float>(a + b * v[1] * v[1]);
    this->Values[4] += static_cast<float>(b * v[1] * v[2]);
    this->Values[5] += static_cast<float>(a + b * v[2] * v[2]);
  }
  double trace() const { return double(this->Values[0]) + this->Values[3] + this->Values[5]; }
  Vector3 operator*(const Vector3& v) const
  {
    const auto& s = this->Values;
    return { s[0] * v[0] + s[1] * v[1] + s[2] * v[2], s[1] * v[0] + s[3] * v[1] + s[4] * v[2],
      s[2] * v[0] + s[4] * v[1] + s[5] * v[2] };
  }
  Symmetric inverse() const
  {
    Eigen::Matrix3d full;
    const auto& s = this->Values;
    full << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
    const Eigen::Matrix3d i = full.inverse();
    const auto value = [&](int r, int c) { return static_cast<float>(i(r, c)); };
    return { { value(0, 0), value(0, 1), value(0, 2), value(1, 1), value(1, 2), value(2, 2) } };
  }
};

Vector3 unitNormal(const Points& w, const conformal::Triangles& triangles, Index r)
{
  const Vector3 a = w.row(triangles(r, 0)), b = w.row(triangles(r, 1)), c = w.row(triangles(r, 2));
  return (b - a).cross(c - a).normalized(); // zero stays zero
}

/// Contribution of the patterns to the system: the matrix by rows of 3 by 3 blocks, and the
/// right-hand side.
struct Attraction
{
  Attraction(const Adjacency& neighbors)
    : Neighbors(neighbors)
    , Diagonal(neighbors.Offsets.size() - 1)
    , Others(neighbors.Ids.size())
    , Right(Points::Zero(static_cast<Index>(this->Diagonal.size()), 3))
  {
  }

  Symmetric& block(int i, int j)
  {
    if (i == j)
    {
      return this->Diagonal[i];
    }
    const int* found = std::find(this->Neighbors.begin(i), this->Neighbors.end(i), j);
    return this->Others[found - this->Neighbors.Ids.data()];
  }

  /// Return row i of the matrix times x.
  Vector3 product(int i, const Points& x) const
  {
    Vector3 y = this->Diagonal[i] * Vector3(x.row(i));
    const Symmetric* other = this->Others.data() + this->Neighbors.Offsets[i];
    for (const int* j = this->Neighbors.begin(i); j != this->Neighbors.end(i); ++j)
    {
      y += *other++ * Vector3(x.row(*j));
    }
    return y;
  }

  const Adjacency& Neighbors;
  std::vector<Symmetric> Diagonal;
  std::vector<Symmetric> Others; ///< for each vertex and neighbor
  Points Right;
};

/// Regularization: the stiffness of vertices and hinges.
class Resistance
{
public:
  Resistance(const Adjacency& neighbors, HingeBending hinges, Points normals,
    const Eigen::VectorXd& stiffness, double evenness, const Run& run)
    : Neighbors(neighbors)
    , Hinges(std::move(hinges))
    , Normals(std::move(normals))
    , Stiffness(stiffness)
    , Evenness(evenness)
    , Threads(run.unwatched())
    , Bent(stiffness.size(), 3)
  {
  }

  /// Prepare forceAt() for x.
  void bend(const Points& x)
  {
    this->Hinges.bend(x, this->Threads);
    forBlocks(this->Threads, x.rows(), HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          Vector3 sum = Vector3::Zero();
          for (const int* j = this->Neighbors.begin(i); j != this->Neighbors.end(i); ++j)
          {
            sum += x.row(*j);
          }
          const Vector3 bend = Vector3(x.row(i)) - sum / this->Neighbors.size(i);
          const Vector3 normal = this->Normals.row(i);
          this->Bent.row(i) = this->Stiffness[i] *
            (this->Evenness * bend + (1.0 - this->Evenness) * normal.dot(bend) * normal);
        }
      });
  }

  /// Return row i of L^T S L x plus the contribution of the hinges.
  Vector3 forceAt(int i) const
  {
    Vector3 force = this->Hinges.forceAt(i) + Vector3(this->Bent.row(i));
    for (const int* j = this->Neighbors.begin(i); j != this->Neighbors.end(i); ++j)
    {
      force -= Vector3(this->Bent.row(*j)) / this->Neighbors.size(*j);
    }
    return force;
  }

  /// Add the diagonal block of a vertex.
  void addDiagonal(int i, Symmetric& block) const
  {
    double bending = this->Stiffness[i];
    for (const int* j = this->Neighbors.begin(i); j != this->Neighbors.end(i); ++j)
    {
      const double share = 1.0 / this->Neighbors.size(*j);
      bending += share * share * this->Stiffness[*j];
    }
    block.add(this->Evenness * bending + this->Hinges.diagonalAt(i),
      (1.0 - this->Evenness) * bending, this->Normals.row(i));
  }

private:
  const Adjacency& Neighbors;
  HingeBending Hinges;
  const Points Normals;
  const Eigen::VectorXd& Stiffness;
  const double Evenness;
  const Run Threads; // without progress
  Points Bent;       ///< S L x
};

/// Solve by conjugate gradients, preconditioned with the diagonal blocks.
Points solveSystem(Attraction& attraction, Resistance& resistance, const Run& run)
{
  Points& residual = attraction.Right;
  const Index size = residual.rows();
  const auto forVertices = [&](const auto& body)
  {
    forBlocks(run, size, HeavyBlock,
      [&](Index begin, Index end)
      {
        for (int i = static_cast<int>(begin); i < end; ++i)
        {
          body(i);
        }
      });
  };
  std::vector<Symmetric> inverses = attraction.Diagonal;
  forVertices(
    [&](int i)
    {
      resistance.addDiagonal(i, inverses[i]);
      inverses[i] = inverses[i].inverse();
    });
  run.report(0.0);

  const LinearMap product = [&](const Points& x, Points& y)
  {
    resistance.bend(x);
    forVertices([&](int i) { y.row(i) = attraction.product(i, x) + resistance.forceAt(i); });
  };
  const LinearMap precondition = [&](const Points& x, Points& y)
  { forVertices([&](int i) { y.row(i) = inverses[i] * Vector3(x.row(i)); }); };
  const int steps = size > ManyUnknowns ? StepsOfMany : NumberOfSteps;
  return conjugateGradients(residual, product, precondition, { steps, Converged }, run);
}
}

SurfaceEquations::SurfaceEquations(
  const conformal::Triangles& triangles, const Adjacency& neighbors)
  : Triangles(triangles)
  , Neighbors(neighbors)
  , Around(vertexTriangles(triangles, static_cast<Index>(neighbors.Offsets.size()) - 1))
{
}

void SurfaceEquations::clear()
{
  this->Sums = FixedPointSums(SumsPerTriangle * this->Triangles.rows());
  this->Pulls.clear();
}

void SurfaceEquations::add(const FootPoint& foot, const Vector3& x, double weight)
{
  const Index first = SumsPerTriangle * foot.Triangle;
  const bool inside = foot.Barycentric.minCoeff() > 0.0;
  Index product = first + (inside ? 0 : RimSums), residual = first + ResidualSums;
  const Vector3 r = x - foot.Position;
  for (int k = 0; k < 3; ++k)
  {
    const double share = weight * foot.Barycentric[k];
    for (int l = k; l < 3; ++l)
    {
      this->Sums.add(product++, share * foot.Barycentric[l]);
    }
    for (int c = 0; c < 3; ++c)
    {
      this->Sums.add(residual++, share * r[c]);
    }
  }
}

void SurfaceEquations::pull(int vertex, const Vector3& direction, double distance, double weight)
{
  this->Pulls.push_back({ vertex, direction, distance, weight });
}

Points SurfaceEquations::solve(
  const Points& weights, const Eigen::VectorXd& stiffness, double evenness, const Run& run)
{
  Steps steps(run, { 0.06, 0.01, 0.1, 0.01, 0.02, 0.8 });
  const Index size = weights.rows();
  Attraction attraction(this->Neighbors);
  forBlocksReporting(steps.next(), size, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (int i = static_cast<int>(begin); i < end; ++i)
      {
        for (const int* r = this->Around.begin(i); r != this->Around.end(i); ++r)
        {
          const Index first = SumsPerTriangle * *r;
          const Vector3 normal = unitNormal(weights, this->Triangles, *r);
          int k = 0;
          while (this->Triangles(*r, k) != i)
          {
            ++k;
          }
          for (int l = 0; l < 3; ++l)
          {
            // Residuals of interior foot points are along the normal, so M does not change them.
            const double inside = this->Sums[first + ProductOf[k][l]];
            const double rim = this->Sums[first + RimSums + ProductOf[k][l]];
            attraction.block(i, this->Triangles(*r, l))
              .add(SlidingWeight * inside + rim, (1.0 - SlidingWeight) * inside, normal);
          }
          for (int c = 0; c < 3; ++c)
          {
            attraction.Right(i, c) += this->Sums[first + ResidualSums + 3 * k + c];
          }
        }
      }
    });
  steps.next();
  for (const Pull& pull : this->Pulls)
  {
    attraction.block(pull.Vertex, pull.Vertex).add(0.0, pull.Weight, pull.Direction);
    attraction.Right.row(pull.Vertex) += pull.Weight * pull.Distance * pull.Direction;
  }
  this->Sums = FixedPointSums(); // releases the memory
  for (Symmetric& block : attraction.Diagonal)
  {
    // A direction without patterns or stiffness is not moved.
    constexpr double minimum = 1e-12, share = 1e-5;
    block.add(minimum + share * block.trace(), 0.0, Vector3::Zero());
  }

  steps.next();
  HingeBending hinges(this->Triangles, this->Around, weights, stiffness, run);
  steps.next();
  Resistance resistance(this->Neighbors, std::move(hinges),
    vertexNormals(weights, this->Triangles, this->Around, run), stiffness, evenness, run);
  steps.next();
  resistance.bend(weights);
  forBlocks(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (int i = static_cast<int>(begin); i < end; ++i)
      {
        attraction.Right.row(i) -= resistance.forceAt(i);
      }
    });
  return solveSystem(attraction, resistance, steps.next());
}
}

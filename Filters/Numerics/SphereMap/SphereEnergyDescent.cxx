#include "SphereMap/SphereEnergyDescent.h"

#include "Base/IntegerPower.h"
#include "Base/NumericalFailure.h"
#include "Linear/EdgeWeights.h"
#include "Linear/MultifrontalCholesky.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index TrianglesPerSum = 512;
constexpr int Memory = 8;          // number of earlier steps that L-BFGS uses
constexpr int StepsPerFactor = 10; // number of steps after which the matrix is factored again
constexpr double MinimumSlope = 1e-4;
constexpr double MaximumCotangent = 1e3;

class Descent
{
public:
  Descent(const Triangles& triangles, const BoundedTriangles& shapes, Points& positions,
    const SphereEnergyDescentOptions& options, const Run& run)
    : Ids(triangles)
    , Around(vertexTriangles(triangles, positions.rows()))
    , Positions(positions)
    , Options(options)
    , Threads(run.unwatched())
    , Stiffness(triangles.rows())
    , Slopes(triangles.rows())
  {
    this->Sources.reserve(triangles.rows());
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      this->Sources.push_back(shapes.triangle(triangles(r, 0), triangles(r, 1), triangles(r, 2)));
    }
  }

  SphereEnergyMinimum descend(const Run& run)
  {
    SphereEnergyMinimum result;
    this->Current = this->evaluate(this->Positions);
    double first = 0.0, reached = 0.0; // gain of the first step, and progress
    int sinceFactor = StepsPerFactor;
    while (result.NumberOfSteps < this->Options.MaximumNumberOfSteps &&
      std::isfinite(this->Current.Energy))
    {
      if (sinceFactor >= StepsPerFactor)
      {
        try
        {
          this->factor();
        }
        catch (const NumericalFailure&)
        {
          break; // rounding of tiny triangles made the matrix indefinite
        }
        sinceFactor = 0;
      }
      const Points direction = this->direction(this->Current.Gradient);
      const double slope = -this->Current.Gradient.cwiseProduct(direction).sum();
      const double gain = -0.5 * slope / this->Current.Energy;
      if (gain >= 0.0 && gain <= this->Options.Tolerance)
      {
        result.Converged = true;
        break;
      }
      if (!(gain > 0.0) || !this->step(direction, slope))
      {
        if (this->Pairs.empty())
        {
          break;
        }
        this->Pairs.clear(); // next, try the direction without earlier steps
        sinceFactor = StepsPerFactor;
        continue;
      }
      ++result.NumberOfSteps;
      ++sinceFactor;
      first = std::max({ first, gain, 1.001 * this->Options.Tolerance });
      const double fallen = std::log(gain / first) / std::log(this->Options.Tolerance / first);
      reached = std::clamp(fallen,
        std::max(
          reached, static_cast<double>(result.NumberOfSteps) / this->Options.MaximumNumberOfSteps),
        1.0);
      run.report(reached);
    }
    result.Energy = this->Current.Energy;
    return result;
  }

private:
  // Step of L-BFGS, and the change of the gradient.
  struct Pair
  {
    Points Step, Change;
    double Product; // inner product of Step and Change
  };

  struct Evaluation
  {
    double Energy = 0.0;
    Points Gradient; // derivative with respect to the positions, in their tangent planes
  };

  // Energy of a triangle. Slope contains the derivatives with respect to its corners.
  double triangleEnergy(const Points& positions, Index r, Eigen::Matrix3d& slope)
  {
    const Vector3 a = positions.row(this->Ids(r, 0)), b = positions.row(this->Ids(r, 1)),
                  c = positions.row(this->Ids(r, 2));
    const SphereEnergy& energy = this->Options.Energy;
    const Vector3 ab = b - a, ac = c - a, bc = c - b;
    const double twice = a.dot(ab.cross(ac));
    if (!(twice >= MinimumDeterminant))
    {
      return std::numeric_limits<double>::infinity();
    }
    const SourceTriangle& source = this->Sources[r];
    const double area = 0.5 * twice, inverse = 1.0 / area;
    const auto& w = source.Cotangents;
    const double dirichlet =
      w[0] * bc.squaredNorm() + w[1] * ac.squaredNorm() + w[2] * ab.squaredNorm();
    const int m = energy.AngleExponent;
    const double angle = source.Area * integerPower(dirichlet * inverse, m);
    const double main = angle *
      (energy.AreaExponent == 0.0 ? 1.0 : std::pow(source.Area * inverse, energy.AreaExponent));
    const double guard = angle *
      (energy.AreaWeight * source.Area * source.Area + energy.SmallArea * energy.SmallArea) *
      inverse * inverse;
    const double both = (main + guard) * m / dirichlet;
    const double ofArea = -0.5 * inverse * (main * (energy.AreaExponent + m) + guard * (2.0 + m));
    slope.col(0) = -2.0 * both * (w[1] * ac + w[2] * ab) + ofArea * b.cross(bc);
    slope.col(1) = 2.0 * both * (w[2] * ab - w[0] * bc) - ofArea * c.cross(ac);
    slope.col(2) = 2.0 * both * (w[1] * ac + w[0] * bc) + ofArea * a.cross(ab);
    const double k1 = energy.AreaExponent + m, k2 = 2.0 + m;
    this->Stiffness[r] = main * k1 * k1 + guard * k2 * k2;
    return main + guard;
  }

  Evaluation evaluate(const Points& positions)
  {
    Evaluation result;
    std::vector<double> sums((this->Ids.rows() + TrianglesPerSum - 1) / TrianglesPerSum, 0.0);
    forBlocks(this->Threads, this->Ids.rows(), TrianglesPerSum,
      [&](Index begin, Index end)
      {
        for (Index r = begin; r < end; ++r)
        {
          sums[begin / TrianglesPerSum] += this->triangleEnergy(positions, r, this->Slopes[r]);
        }
      });
    result.Energy = std::accumulate(sums.begin(), sums.end(), 0.0);
    if (!std::isfinite(result.Energy))
    {
      return result;
    }
    result.Gradient.resize(positions.rows(), 3);
    forBlocks(this->Threads, positions.rows(), TrianglesPerSum,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          Vector3 total = Vector3::Zero();
          for (const int* r = this->Around.begin(v); r != this->Around.end(v); ++r)
          {
            const int k = this->Ids(*r, 0) == v ? 0 : this->Ids(*r, 1) == v ? 1 : 2;
            total += this->Slopes[*r].col(k);
          }
          const Vector3 place = positions.row(v);
          result.Gradient.row(v) = total - total.dot(place) * place;
        }
      });
    return result;
  }

  void toTangents(Points& vectors) const
  {
    for (Index v = 0; v < vectors.rows(); ++v)
    {
      vectors.row(v) -= vectors.row(v).dot(this->Positions.row(v)) * this->Positions.row(v);
    }
  }

  void factor()
  {
    Points cotangents(this->Ids.rows(), 3);
    std::vector<double> diagonal(this->Positions.rows(), 0.0);
    for (Index r = 0; r < this->Ids.rows(); ++r)
    {
      std::array<Vector3, 3> corners;
      for (int k = 0; k < 3; ++k)
      {
        corners[k] = this->Positions.row(this->Ids(r, k));
      }
      const double twice = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
      const double density = 2.0 * this->Stiffness[r] / twice;
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 u = corners[next(k)] - corners[k], v = corners[previous(k)] - corners[k];
        cotangents(r, k) =
          density * std::clamp(u.dot(v) / twice, -MaximumCotangent, MaximumCotangent);
        diagonal[this->Ids(r, k)] += this->Stiffness[r] / 3.0;
      }
    }
    const EdgeWeights weights = cotangentWeights(this->Ids, this->Positions.rows(), cotangents);
    for (Index v = 0; v < this->Positions.rows(); ++v)
    {
      diagonal[v] += weights.sumAt(v);
    }
    this->Solver =
      std::make_unique<MultifrontalCholesky>(weights, diagonal, this->Positions, this->Threads);
  }

  Points solved(const Points& vectors) const
  {
    Columns columns = vectors;
    this->Solver->solve(columns);
    Points result = columns;
    this->toTangents(result);
    return result;
  }

  // Direction of L-BFGS, in which the energy increases.
  Points direction(const Points& gradient) const
  {
    Points q = gradient;
    std::vector<double> factors;
    for (auto pair = this->Pairs.rbegin(); pair != this->Pairs.rend(); ++pair)
    {
      factors.push_back(pair->Step.cwiseProduct(q).sum() / pair->Product);
      q -= factors.back() * pair->Change;
    }
    this->toTangents(q);
    q = this->solved(q);
    if (!this->Pairs.empty())
    {
      const Pair& last = this->Pairs.back();
      const double scale = last.Product / last.Change.cwiseProduct(this->LastSolved).sum();
      q *= scale;
    }
    for (const Pair& pair : this->Pairs)
    {
      const double factor = factors.back() - pair.Change.cwiseProduct(q).sum() / pair.Product;
      factors.pop_back();
      q += factor * pair.Step;
    }
    this->toTangents(q);
    return q;
  }

  void remember(Points step, Points change)
  {
    const double product = step.cwiseProduct(change).sum();
    if (product > 1e-10 * step.norm() * change.norm())
    {
      this->LastSolved = this->solved(change);
      this->Pairs.push_back({ std::move(step), std::move(change), product });
      if (this->Pairs.size() > Memory)
      {
        this->Pairs.pop_front();
      }
    }
  }

  // Step against the direction, by a length at which the energy decreases enough.
  // @return whether there is one
  bool step(const Points& direction, double slope)
  {
    constexpr int attempts = 25;
    constexpr double farthestMove = 0.5;
    const double farthest = std::sqrt(direction.rowwise().squaredNorm().maxCoeff());
    double length = farthest > farthestMove ? farthestMove / farthest : 1.0;
    for (int i = 0; i < attempts; ++i, length *= 0.5)
    {
      Points moved = this->Positions - length * direction;
      moved.rowwise().normalize();
      Evaluation reached = this->evaluate(moved);
      if (reached.Energy <= this->Current.Energy + MinimumSlope * length * slope)
      {
        this->remember(moved - this->Positions, reached.Gradient - this->Current.Gradient);
        this->Positions = std::move(moved);
        this->Current = std::move(reached);
        return true;
      }
    }
    this->Current = this->evaluate(this->Positions); // restores Stiffness and Slopes
    return false;
  }

  const Triangles& Ids;
  const Adjacency Around;
  Points& Positions;
  const SphereEnergyDescentOptions& Options;
  const Run Threads;
  std::vector<SourceTriangle> Sources;
  // Of each triangle, at the last evaluated positions: its energy times the square of the exponent
  // of A, and the derivatives of its energy with respect to the corners.
  std::vector<double> Stiffness;
  std::vector<Eigen::Matrix3d> Slopes;
  Evaluation Current; // at Positions
  std::unique_ptr<MultifrontalCholesky> Solver;
  std::deque<Pair> Pairs;
  Points LastSolved;
};
}

//------------------------------------------------------------------------------
SphereEnergyMinimum descendSphereEnergy(const Triangles& triangles, const BoundedTriangles& shapes,
  Points& positions, const SphereEnergyDescentOptions& options, const Run& run)
{
  Descent descent(triangles, shapes, positions, options, run);
  return descent.descend(run);
}
}

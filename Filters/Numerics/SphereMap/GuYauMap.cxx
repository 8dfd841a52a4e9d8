#include "SphereMap/GuYauMap.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr double ShortestStep = 1e-6; // minimum time step, divided by the initial time step

// Compute vertex normals. If a normal is undefined, use the direction from the center of the
// surface to the vertex.
Points gaussMap(const Points& points, const Triangles& triangles)
{
  Points map = vertexNormals(points, triangles);
  const Eigen::RowVector3d middle = points.colwise().mean();
  for (Index v = 0; v < map.rows(); ++v)
  {
    if (map.row(v).isZero())
    {
      map.row(v) = points.row(v) - middle;
      map.row(v) = map.row(v).norm() > 0.0 ? map.row(v).normalized().eval()
                                           : Eigen::RowVector3d(Eigen::RowVector3d::UnitX());
    }
  }
  return map;
}

// Prediction of the iteration at which a descent converges.
class Convergence
{
public:
  explicit Convergence(int maximumIterations)
    : Maximum(maximumIterations)
  {
  }

  // Return the completed fraction of the iterations, which never decreases. The logarithm of the
  // changes is extrapolated from the second half of the iterations.
  // @param[in] excess  ratio of a change to the tolerance
  double next(double excess)
  {
    const double before = this->Logarithms.empty() ? 0.0 : this->Logarithms.back();
    this->Logarithms.push_back(excess > 0.0 ? std::log(excess) : before);
    const std::size_t last = this->Logarithms.size() - 1, half = last / 2;
    const double fall =
      (this->Logarithms[half] - this->Logarithms[last]) / static_cast<double>(last - half);
    const auto made = static_cast<double>(last + 1);
    double all = this->Maximum;
    if (last >= 4 && fall > 0.0)
    {
      all = std::min(all, made + std::max(this->Logarithms[last], 0.0) / fall);
    }
    this->Reached = std::max(this->Reached, made / all);
    return this->Reached;
  }

private:
  double Maximum, Reached = 0.0;
  std::vector<double> Logarithms;
};

class GuYauDescent
{
public:
  GuYauDescent(
    Points& map, const Eigen::VectorXd& areas, const GuYauOptions& options, const Run& run)
    : Map(map)
    , Areas(areas)
    , Options(options)
    , Threads(run.unwatched())
  {
  }

  // Return whether the descent converged.
  bool run(const EdgeWeights& strings, Index& iterations, const Run& run)
  {
    const double longest = firstStep(strings);
    double step = longest, energy = stringEnergy(strings, this->Map);
    Points next(this->Map.rows(), 3);
    Convergence convergence(this->Options.MaximumNumberOfIterations);
    for (int i = 0; i < this->Options.MaximumNumberOfIterations; ++i)
    {
      ++iterations;
      this->move(strings, step, next);
      const double moved = stringEnergy(strings, next);
      const double change = energy - moved;
      if (change >= 0.0)
      {
        std::swap(this->Map, next);
        energy = moved;
      }
      else
      {
        step *= 0.5;
      }
      const double small = this->Options.Tolerance * std::abs(energy) * step / longest;
      if (step < ShortestStep * longest || (change >= 0.0 && change <= small))
      {
        return true;
      }
      run.report(convergence.next(change / small));
    }
    return false;
  }

private:
  static double firstStep(const EdgeWeights& strings)
  {
    double maximum = 0.0;
    for (Index v = 0; v + 1 < static_cast<Index>(strings.Neighbors.Offsets.size()); ++v)
    {
      double sum = 0.0;
      for (int i = strings.Neighbors.Offsets[v]; i < strings.Neighbors.Offsets[v + 1]; ++i)
      {
        sum += std::abs(strings.Weights[i]);
      }
      maximum = std::max(maximum, sum);
    }
    return 1.0 / std::max(maximum, 1e-300);
  }

  void move(const EdgeWeights& strings, double step, Points& next) const
  {
    forBlocks(this->Threads, this->Map.rows(), LightBlock,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          const Vector3 place = this->Map.row(v);
          Vector3 pull = Vector3::Zero();
          for (int i = strings.Neighbors.Offsets[v]; i < strings.Neighbors.Offsets[v + 1]; ++i)
          {
            pull +=
              strings.Weights[i] * (this->Map.row(strings.Neighbors.Ids[i]).transpose() - place);
          }
          next.row(v) = (place + step * (pull - pull.dot(place) * place)).normalized();
        }
      });
    const Eigen::RowVector3d mean = this->Areas.transpose() * next / this->Areas.sum();
    for (Index v = 0; v < next.rows(); ++v)
    {
      const Eigen::RowVector3d centered = next.row(v) - mean;
      const double length = centered.norm();
      if (length > 0.0)
      {
        next.row(v) = centered / length;
      }
    }
  }

  Points& Map;
  const Eigen::VectorXd& Areas;
  const GuYauOptions& Options;
  const Run Threads; // threads without progress reports
};
}

//------------------------------------------------------------------------------
GuYauResult mapByGuYau(const Mesh& mesh, const GuYauOptions& options, const Run& run)
{
  const Points& points = mesh.Positions;
  const Triangles& triangles = mesh.Triangles;
  const EdgeWeights equal = equalWeights(triangles, points.rows());
  const StringConstants harmonic = harmonicStrings(points, triangles);
  GuYauResult result;
  result.NumberOfNegativeStringConstants = harmonic.NumberOfNegative;
  result.NumberOfInfiniteStringConstants = harmonic.NumberOfInfinite;
  result.Positions = gaussMap(points, triangles);
  const Eigen::VectorXd areas = vertexAreas(points, triangles);
  GuYauDescent descent(result.Positions, areas, options, run);
  // The second descent starts near its end, and its cost varies between almost none and that of the
  // first.
  Steps steps(run, { 2.0, 1.0 });
  const bool first = descent.run(equal, result.NumberOfIterations, steps.next());
  const bool second = descent.run(harmonic.Strings, result.NumberOfIterations, steps.next());
  result.Converged = first && second;
  result.Energy = stringEnergy(harmonic.Strings, result.Positions);
  return result;
}
}

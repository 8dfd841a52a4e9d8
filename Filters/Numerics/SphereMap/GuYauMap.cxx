#include "SphereMap/GuYauMap.h"

#include "Linear/EdgeWeights.h"
#include "Mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace conformal
{
namespace
{
constexpr Index BlockSize = 1 << 11;
constexpr double ShortestStep = 1e-6; // of the first one

// Normals, and where there is none the direction from the middle of the surface.
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

class Descent
{
public:
  Descent(Points& map, const Eigen::VectorXd& areas, const GuYauOptions& options,
    const ParallelFor& parallelFor)
    : Map(map)
    , Areas(areas)
    , Options(options)
    , Threads(parallelFor)
  {
  }

  // Whether it converged.
  bool run(const EdgeWeights& strings, Index& iterations, const Progress& progress)
  {
    const double longest = firstStep(strings);
    double step = longest, energy = stringEnergy(strings, this->Map);
    Points next(this->Map.rows(), 3);
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
      if (step < ShortestStep * longest ||
        (change >= 0.0 && change <= this->Options.Tolerance * std::abs(energy) * step / longest))
      {
        return true;
      }
      report(progress, (i + 1.0) / this->Options.MaximumNumberOfIterations);
    }
    return false;
  }

private:
  static double firstStep(const EdgeWeights& strings)
  {
    double greatest = 0.0;
    for (Index v = 0; v + 1 < static_cast<Index>(strings.Neighbors.Offsets.size()); ++v)
    {
      double sum = 0.0;
      for (int i = strings.Neighbors.Offsets[v]; i < strings.Neighbors.Offsets[v + 1]; ++i)
      {
        sum += std::abs(strings.Weights[i]);
      }
      greatest = std::max(greatest, sum);
    }
    return 1.0 / std::max(greatest, 1e-300);
  }

  void move(const EdgeWeights& strings, double step, Points& next) const
  {
    forBlocks(this->Threads, this->Map.rows(), BlockSize,
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
  const ParallelFor& Threads;
};
}

//------------------------------------------------------------------------------
GuYauResult mapByGuYau(const Mesh& mesh, const GuYauOptions& options,
  const ParallelFor& parallelFor, const Progress& progress)
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
  Descent descent(result.Positions, areas, options, parallelFor);
  const bool first = descent.run(equal, result.NumberOfIterations, partOf(progress, 0.0, 0.5));
  const bool second =
    descent.run(harmonic.Strings, result.NumberOfIterations, partOf(progress, 0.5, 1.0));
  result.Converged = first && second;
  result.Energy = stringEnergy(harmonic.Strings, result.Positions);
  return result;
}
}

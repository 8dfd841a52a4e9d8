#include "Learn/Fit/LeastSquaresFit.h"

#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Cloud/LocalScale.h"
#include "Cloud/SampleRotation.h"
#include "Learn/Fit/SurfaceEquations.h"
#include "Learn/Fit/SurfaceSupport.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"
#include "Search/PointTree.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
/// Without patterns, interpolate straight instead of extrapolating the curvature.
constexpr double BareStiffness = 30.0;

/// Folds are flattened in the last iterations only; earlier, this would reduce the quality of the
/// fit.
constexpr int FoldIterations = 5;
constexpr double FoldStiffening = 3.0, MaximumFoldStiffness = 30.0;

/// Vertices without samples are pulled in the second half of the iterations, when outliers are
/// classified, with half of the weight of patterns.
constexpr double IdleWeight = 0.5;
constexpr double GuideWeight = 0.1;   // of a neuron's patterns
constexpr Index TargetsPerNeuron = 1; // patterns stored as targets of vertices without samples

/// Factor of a sample's weight, see LeastSquaresFitOptions::AutomaticPriority.
double automaticPriority(double squareDistance, double meanSquare)
{
  return meanSquare > 0.0 ? std::sqrt(std::clamp(squareDistance / meanSquare, 0.1, 8.0)) : 1.0;
}

class Fit
{
public:
  Fit(const TrainingSamples& samples, const LeastSquaresFitOptions& options, LearnedMesh& result,
    const Run& run)
    : Samples(samples)
    , Options(options)
    , Threads(run.unwatched())
    , Positions(result.Positions)
    , Triangles(result.Triangles)
    , Neighbors(vertexNeighbors(Triangles, Positions.rows()))
    , Surface(Positions, Triangles, run)
    , Equations(Triangles, Neighbors)
    , Scale(Positions.rows(), options.OutlierRatio)
    , Rotation(samples, options.RandomSeed)
    , Bareness(Eigen::VectorXd::Ones(Positions.rows()))
    , Folds(Eigen::VectorXd::Ones(Positions.rows()))
    , Masses(Triangles.rows(), 0.0)
  {
  }

  /// Measure the scale before the first move, so that outliers never contribute.
  void measureScale(const Run& run)
  {
    this->Rotation.turn(this->Options.SamplesPerIteration);
    this->forEachFoot([&](Index, const Vector3&, const FootPoint& foot, double weight)
      { this->Scale.add(foot, this->Triangles, weight); },
      run);
    this->Scale.update(this->Neighbors, this->Samples.reduce());
  }

  TrainingRecord iterate(int number, const Run& run)
  {
    Steps steps(run, { 0.65, 0.01, 0.32, 0.02 }); // samples, guide, equations, tree
    const int firstIdle = std::max(1, this->Options.Iterations / 2);
    this->draw(number + 1 == firstIdle, steps.next());
    steps.next();
    if (this->Options.Guide)
    {
      this->drawToGuide();
    }
    else if (this->Options.AutomaticPriority && number >= firstIdle)
    {
      this->drawIdle();
    }
    const double way = static_cast<double>(number) / std::max(1, this->Options.Iterations - 1);
    const double smoothness = std::pow(this->Options.FirstSmoothness, 1.0 - way) *
      std::pow(this->Options.LastSmoothness, way);
    const Eigen::VectorXd stiffness =
      smoothness * this->meanMass() * this->Bareness.cwiseProduct(this->Folds);
    const Points moved =
      this->Equations.solve(this->Positions, stiffness, this->Options.Evenness, steps.next());
    this->Positions += moved;
    steps.next();
    this->Surface.refit(this->Positions, this->Threads);

    const std::vector<bool> bare =
      bareVertices(this->Positions, this->Triangles, this->Neighbors, this->Masses);
    for (Index i = 0; i < this->Positions.rows(); ++i)
    {
      this->Bareness[i] = bare[i] ? BareStiffness : 1.0;
    }
    if (number >= this->Options.Iterations - FoldIterations)
    {
      this->stiffenFolds();
    }
    TrainingRecord record;
    record.Frequency = static_cast<int>(std::lround(std::sqrt(this->Triangles.rows() / 20.0)));
    record.LearningRate = 1.0;
    record.MeanSquareError = this->MeanSquare;
    record.MeanDisplacement = moved.rowwise().norm().mean();
    run.report(1.0);
    return record;
  }

  /// Return the weight of the patterns of each triangle in the last iteration.
  const std::vector<double>& masses() const { return this->Masses; }

private:
  /// Call body(i, x, foot, weight) for each pattern: its index, position, foot point and weight.
  void forEachFoot(const std::function<void(Index, const Vector3&, const FootPoint&, double)>& body,
    const Run& run) const
  {
    conformal::forEachFoot(
      this->Samples, this->Surface, this->Rotation.count(),
      [&](Index i) { return this->Rotation.id(i); },
      [&](Index i, const Vector3& x, const FootPoint& foot)
      {
        if (!this->Options.Belongs || this->Options.Belongs(x))
        {
          body(this->Rotation.begin() + i, x, foot, this->Samples.weight(this->Rotation.id(i)));
        }
      },
      run);
  }

  /// Add the terms of the patterns to the equations.
  void draw(bool keepTargets, const Run& run)
  {
    this->Rotation.turn(this->Options.SamplesPerIteration);
    const Index stride =
      std::max<Index>(1, this->Rotation.totalCount() / (TargetsPerNeuron * this->Positions.rows()));
    std::vector<std::pair<Index, Vector3>> targets; // and their places
    this->Equations.clear();
    FixedPointSums masses(this->Triangles.rows()), squares(1);
    this->forEachFoot(
      [&](Index place, const Vector3& x, const FootPoint& foot, double weight)
      {
        this->Scale.add(foot, this->Triangles, weight);
        if (this->Scale.outlying(foot, this->Triangles))
        {
          return;
        }
        const double priority = this->Options.AutomaticPriority
          ? automaticPriority(foot.SquareDistance, this->MeanSquare)
          : 1.0;
        this->Equations.add(foot, x, weight * priority);
        masses.add(foot.Triangle, weight);
        squares.add(0, weight * foot.SquareDistance);
        if (keepTargets && place % stride == 0)
        {
          targets.emplace_back(place, x);
        }
      },
      run);
    const Reduce& reduce = this->Samples.reduce();
    this->Scale.update(this->Neighbors, reduce);
    this->Equations.reduce(reduce);
    masses.reduce(reduce);
    squares.reduce(reduce);
    this->Mass = 0.0;
    for (Index r = 0; r < this->Triangles.rows(); ++r)
    {
      this->Mass += this->Masses[r] = masses[r];
    }
    this->MeanSquare = this->Mass > 0.0 ? squares[0] / this->Mass : 0.0;
    if (keepTargets)
    {
      std::sort(targets.begin(), targets.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; });
      std::vector<double> coordinates;
      for (const auto& target : targets)
      {
        coordinates.insert(coordinates.end(), target.second.data(), target.second.data() + 3);
      }
      coordinates = gather(reduce, coordinates);
      this->Targets =
        Eigen::Map<const Points>(coordinates.data(), static_cast<Index>(coordinates.size() / 3), 3);
      this->TargetTree = PointTree(this->Targets);
    }
  }

  double meanMass() const { return this->Mass / static_cast<double>(this->Positions.rows()); }

  void drawIdle()
  {
    const Points normals =
      vertexNormals(this->Positions, this->Triangles, this->Equations.around(), this->Threads);
    const std::vector<bool> idle =
      idleVertices(this->Triangles, this->Masses, this->Positions.rows());
    for (Index i = 0; i < this->Positions.rows() && this->Targets.rows() > 0; ++i)
    {
      if (idle[i])
      {
        const Vector3 place = this->Positions.row(i), normal = normals.row(i);
        const Vector3 way = Vector3(this->Targets.row(this->TargetTree.nearest(place).Id)) - place;
        const double along = normal.dot(way);
        // Over a hole in the data, the nearest pattern lies at the border, beside the vertex.
        if (2.0 * along * along > way.squaredNorm())
        {
          this->Equations.pull(static_cast<int>(i), normal, along, IdleWeight * this->meanMass());
        }
      }
    }
  }

  /// Find vertices between distant patterns, excluding those at borders of larger holes, by
  /// dilation and erosion of the marks.
  std::vector<bool> idleBetweenPatterns() const
  {
    constexpr int rings = 4;
    const std::vector<bool> idle =
      idleVertices(this->Triangles, this->Masses, this->Positions.rows());
    const auto grow = [&](std::vector<bool>& marks)
    {
      for (int ring = 0; ring < rings; ++ring)
      {
        const std::vector<bool> before = marks;
        for (Index i = 0; i < this->Positions.rows(); ++i)
        {
          marks[i] = before[i] ||
            std::any_of(this->Neighbors.begin(i), this->Neighbors.end(i),
              [&](int neighbor) { return before[neighbor]; });
        }
      }
    };
    std::vector<bool> marks = idle;
    marks.flip();
    grow(marks);
    marks.flip();
    grow(marks);
    marks.flip();
    for (Index i = 0; i < this->Positions.rows(); ++i)
    {
      marks[i] = marks[i] && idle[i];
    }
    return marks;
  }

  void drawToGuide()
  {
    constexpr Index blockSize = 256;
    const Points normals =
      vertexNormals(this->Positions, this->Triangles, this->Equations.around(), this->Threads);
    const std::vector<bool> guided = this->idleBetweenPatterns();
    std::vector<double> along(this->Positions.rows(), 0.0);
    forBlocks(this->Threads, this->Positions.rows(), blockSize,
      [&](Index begin, Index end)
      {
        int hint = -1;
        for (Index i = begin; i < end; ++i)
        {
          if (guided[i])
          {
            const Vector3 place = this->Positions.row(i);
            const FootPoint foot = this->Options.Guide->closestPoint(place, hint);
            along[i] = normals.row(i).dot(foot.Position - place);
            hint = foot.Triangle;
          }
        }
      });
    for (Index i = 0; i < this->Positions.rows(); ++i)
    {
      if (guided[i])
      {
        this->Equations.pull(
          static_cast<int>(i), normals.row(i), along[i], GuideWeight * this->meanMass());
      }
    }
  }

  /// Increase the stiffness of vertices at edges with folded triangles.
  void stiffenFolds()
  {
    const auto normal = [&](Index r)
    {
      const Vector3 a = this->Positions.row(this->Triangles(r, 0)),
                    b = this->Positions.row(this->Triangles(r, 1)),
                    c = this->Positions.row(this->Triangles(r, 2));
      return Vector3((b - a).cross(c - a));
    };
    const conformal::Triangles across =
      triangleNeighbors(this->Triangles, this->Equations.around(), this->Threads);
    std::vector<bool> folded(this->Positions.rows(), false);
    for (Index r = 0; r < this->Triangles.rows(); ++r)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int other = across(r, k);
        if (other > r && normal(r).dot(normal(other)) < 0.0)
        {
          for (int corner = 0; corner < 3; ++corner)
          {
            folded[this->Triangles(r, corner)] = folded[this->Triangles(other, corner)] = true;
          }
        }
      }
    }
    for (Index i = 0; i < this->Positions.rows(); ++i)
    {
      this->Folds[i] = folded[i] ? std::min(this->Folds[i] * FoldStiffening, MaximumFoldStiffness)
                                 : this->Folds[i];
    }
  }

  const TrainingSamples& Samples;
  const LeastSquaresFitOptions& Options;
  const Run Threads; // without progress
  Points& Positions;
  const conformal::Triangles& Triangles;
  const Adjacency Neighbors;
  TriangleTree Surface;
  SurfaceEquations Equations;
  LocalScale Scale;
  SampleRotation Rotation;
  Points Targets; ///< for vertices without samples
  PointTree TargetTree;
  Eigen::VectorXd Bareness, Folds;
  std::vector<double> Masses;
  double Mass = 0.0, MeanSquare = 0.0;
};
}

std::vector<double> leastSquaresFit(const TrainingSamples& samples,
  const LeastSquaresFitOptions& options, LearnedMesh& mesh, const Run& run)
{
  if (options.Iterations == 0)
  {
    return std::vector<double>(mesh.Triangles.rows(), 0.0);
  }
  Steps steps(run, { 0.02, 0.08, 0.9 }); // trees, scale of outliers, iterations
  Fit fit(samples, options, mesh, steps.next());
  fit.measureScale(steps.next());
  const Run fitting = steps.next();
  const double all = options.Iterations;
  for (int number = 0; number < options.Iterations; ++number)
  {
    mesh.History.push_back(fit.iterate(number, fitting.part(number / all, (number + 1) / all)));
  }
  return fit.masses();
}
}

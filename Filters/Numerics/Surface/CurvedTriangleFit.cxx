#include "Surface/CurvedTriangleFit.h"

#include "Base/AcrossProcesses.h"
#include "Cloud/FootPoints.h"
#include "Cloud/LocalScale.h"
#include "Linear/ConjugateGradients.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
using Unknowns = Points; // #V by 3: offset along the normal, two tilts times the length around
using Blocks = std::vector<Eigen::Matrix3d>;

constexpr double OutlierRatio = 6.0;
constexpr double NormalShare = 0.1;   // weight of the normals, relative to the smoothness
constexpr double MaximumTilt = 0.5;   // maximum tilt of a normal in one iteration
constexpr double MaximumSlant = 0.95; // cosine below which a foot point is on a crease
constexpr int MaximumNumberOfSteps = 60;
constexpr double Accuracy = 1e-8; // relative square of the preconditioned residual

/// Normal of a vertex, two directions perpendicular to the normal, and the mean length of the
/// adjacent edges.
struct Frame
{
  Vector3 N, E1, E2;
  double Length;
};

std::vector<Frame> framesOf(const CurvedTriangles& surface, const Adjacency& neighbors)
{
  std::vector<Frame> frames(surface.positions().rows());
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    Frame& frame = frames[i];
    const Index v = static_cast<Index>(i);
    frame.N = surface.normals().row(v);
    frame.E1 = frame.N.unitOrthogonal();
    frame.E2 = frame.N.cross(frame.E1);
    double sum = 0.0;
    for (const int* j = neighbors.begin(v); j != neighbors.end(v); ++j)
    {
      sum += (surface.positions().row(*j) - surface.positions().row(v)).norm();
    }
    const double minimum = 1e-9; // in units of the cloud's radius
    frame.Length = std::max(sum / std::max(1, neighbors.size(v)), minimum);
  }
  return frames;
}

/// Normal equations. There is a 9 by 9 matrix for every triangle. The matrices are assembled into 3
/// by 3 blocks, one for each vertex and for each pair of neighbors.
class Equations
{
public:
  Equations(const Triangles& triangles, const Adjacency& neighbors)
    : Triangles(triangles)
    , Neighbors(neighbors)
    , Sums(triangles.rows() * 54 + 1, 0.0)
    , Diagonal(neighbors.Offsets.size() - 1)
    , Across(neighbors.Ids.size())
  {
  }

  void clear() { std::fill(this->Sums.begin(), this->Sums.end(), 0.0); }

  void add(Index triangle, const Eigen::Matrix<double, 9, 1>& row, double residual, double weight)
  {
    double* sums = this->Sums.data() + 54 * triangle;
    for (int i = 0; i < 9; ++i)
    {
      const double weighted = weight * row[i];
      for (int j = i; j < 9; ++j)
      {
        *sums++ += weighted * row[j];
      }
      *sums++ += weighted * residual;
    }
    this->Sums.back() += weight;
  }

  /// Return the sums so far, to be continued by another rank.
  std::vector<double>& sums() { return this->Sums; }

  /// Return the total weight so far.
  double weight() const { return this->Sums.back(); }

  /// @return the right-hand side
  Unknowns assemble()
  {
    std::fill(this->Diagonal.begin(), this->Diagonal.end(), Eigen::Matrix3d::Zero());
    std::fill(this->Across.begin(), this->Across.end(), Eigen::Matrix3d::Zero());
    Unknowns right = Unknowns::Zero(static_cast<Index>(this->Diagonal.size()), 3);
    for (Index r = 0; r < this->Triangles.rows(); ++r)
    {
      const double* sums = this->Sums.data() + 54 * r;
      Eigen::Matrix<double, 9, 9> matrix;
      for (int i = 0; i < 9; ++i)
      {
        for (int j = i; j < 9; ++j)
        {
          matrix(i, j) = matrix(j, i) = *sums++;
        }
        right(this->Triangles(r, i / 3), i % 3) += *sums++;
      }
      for (int k = 0; k < 3; ++k)
      {
        const int v = this->Triangles(r, k);
        this->Diagonal[v] += matrix.block<3, 3>(3 * k, 3 * k);
        for (const int l : { next(k), previous(k) })
        {
          this->Across[this->place(v, this->Triangles(r, l))] += matrix.block<3, 3>(3 * k, 3 * l);
        }
      }
    }
    return right;
  }

  Blocks& diagonal() { return this->Diagonal; }

  /// Compute the product of the matrix with unknowns, plus stiffness times L^T L times the offsets.
  Unknowns times(const Unknowns& x, double stiffness, const Run& run) const
  {
    Unknowns y(x.rows(), 3);
    Eigen::VectorXd bent(x.rows());
    forBlocks(run, x.rows(), LightBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          Vector3 sum = this->Diagonal[i] * x.row(i).transpose();
          double ring = 0.0;
          for (int at = this->Neighbors.Offsets[i]; at < this->Neighbors.Offsets[i + 1]; ++at)
          {
            sum += this->Across[at] * x.row(this->Neighbors.Ids[at]).transpose();
            ring += x(this->Neighbors.Ids[at], 0);
          }
          y.row(i) = sum;
          // The center of the fan that closes a border belongs to no triangle of the fit.
          bent[i] = x(i, 0) - ring / std::max(1, this->Neighbors.size(i));
        }
      });
    forBlocks(run, x.rows(), LightBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          double sum = bent[i];
          for (const int* j = this->Neighbors.begin(i); j != this->Neighbors.end(i); ++j)
          {
            sum -= bent[*j] / this->Neighbors.size(*j);
          }
          y(i, 0) += stiffness * sum;
        }
      });
    return y;
  }

private:
  std::size_t place(int vertex, int neighbor) const
  {
    const int* found =
      std::lower_bound(this->Neighbors.begin(vertex), this->Neighbors.end(vertex), neighbor);
    return static_cast<std::size_t>(found - this->Neighbors.Ids.data());
  }

  const conformal::Triangles& Triangles;
  const Adjacency& Neighbors;
  std::vector<double> Sums; // the upper triangle and the right-hand side, row by row; the weight
  Blocks Diagonal, Across;
};

/// Solve by conjugate gradients, preconditioned with the diagonal blocks of the vertices.
Unknowns solve(Equations& equations, Unknowns right, double stiffness, const Run& run)
{
  Blocks inverse = equations.diagonal();
  for (Eigen::Matrix3d& block : inverse)
  {
    block(0, 0) += stiffness; // about the diagonal of L^T L
    block = block.inverse().eval();
  }
  const LinearMap precondition = [&](const Unknowns& r, Unknowns& z)
  {
    for (Index i = 0; i < r.rows(); ++i)
    {
      z.row(i) = inverse[i] * r.row(i).transpose();
    }
  };
  const LinearMap product = [&](const Unknowns& x, Unknowns& y)
  { y = equations.times(x, stiffness, run); };
  return conjugateGradients(right, product, precondition, { MaximumNumberOfSteps, Accuracy }, run);
}

/// Compute the derivative of a triangle point along a direction by the unknowns of its corners.
Eigen::Matrix<double, 9, 1> motion(const CurvedTriangles& surface, const std::vector<Frame>& frames,
  const FootPoint& foot, const Vector3& direction)
{
  const auto ids = surface.triangles().row(foot.Triangle);
  const Vector3& m = foot.Barycentric;
  const double bubble = 0.5 * m[0] * m[1] * m[2];
  Eigen::Matrix<double, 9, 1> row;
  Vector3 seen;
  for (int k = 0; k < 3; ++k)
  {
    seen[k] = frames[ids[k]].N.dot(direction);
  }
  for (int i = 0; i < 3; ++i)
  {
    const Frame& own = frames[ids[i]];
    const Vector3 at = surface.positions().row(ids[i]);
    double offset = m[i] * seen[i];
    double tilts[2] = { 0.0, 0.0 };
    for (const int j : { next(i), previous(i) })
    {
      const double out = m[i] * m[i] * m[j] + bubble, in = m[j] * m[j] * m[i] + bubble;
      offset += out * seen[i] - in * own.N.dot(frames[ids[j]].N) * seen[j];
      const Vector3 edge = Vector3(surface.positions().row(ids[j])) - at;
      const double rise = edge.dot(own.N);
      tilts[0] -= out * (edge.dot(own.E1) * seen[i] + rise * own.E1.dot(direction));
      tilts[1] -= out * (edge.dot(own.E2) * seen[i] + rise * own.E2.dot(direction));
    }
    row.segment<3>(3 * i) << offset, tilts[0] / own.Length, tilts[1] / own.Length;
  }
  return row;
}

/// Find the foot points of all samples on all threads. Deliver the foot points in order on the
/// calling thread. With several ranks, each rank stores its foot points until the sums of the
/// previous rank arrive.
template <typename Body>
void forEachCurvedFoot(const CurvedTriangles& surface, const TrainingSamples& samples,
  std::vector<int>& hints, std::vector<double>& sums, const Run& run, Body body)
{
  const CurvedTriangleTree tree(surface, run);
  const ClosestPoint closest = [&](Index id, const Vector3& x, int last)
  {
    int& hint = hints[id];
    FootPoint foot = tree.closestPoint(x, hint < 0 ? last : hint);
    hint = foot.Triangle;
    return foot;
  };
  const bool keep = samples.reduce().NumberOfRanks > 1;
  std::vector<FootPoint> all(keep ? samples.size() : 0);
  forEachFoot(
    samples, closest, samples.size(), {},
    [&](Index i, const Vector3&, const FootPoint& foot)
    {
      if (keep)
      {
        all[i] = foot;
      }
      else
      {
        body(i, foot);
      }
    },
    run);
  if (keep)
  {
    inTurn(samples.reduce(), sums.data(), static_cast<Index>(sums.size()),
      [&]()
      {
        for (Index i = 0; i < samples.size(); ++i)
        {
          body(i, all[i]);
        }
      });
  }
}

/// Convert lengths to the samples' normalized unit, or back.
CurvedTriangles inUnit(const CurvedTriangles& surface, const TrainingSamples& samples, bool restore)
{
  const Points positions =
    restore ? samples.restoreAll(surface.positions()) : samples.normalizeAll(surface.positions());
  return CurvedTriangles(positions, surface.normals(), surface.triangles());
}

/// Apply the unknowns to a surface.
CurvedTriangles moved(
  const CurvedTriangles& surface, const std::vector<Frame>& frames, const Unknowns& step)
{
  Points positions = surface.positions(), normals = surface.normals();
  for (Index i = 0; i < positions.rows(); ++i)
  {
    const Frame& frame = frames[i];
    positions.row(i) += step(i, 0) * frame.N;
    Vector3 tilt = (step(i, 1) * frame.E1 + step(i, 2) * frame.E2) / frame.Length;
    const double size = tilt.norm();
    tilt *= size > MaximumTilt ? MaximumTilt / size : 1.0;
    normals.row(i) = (frame.N + tilt).normalized();
  }
  return CurvedTriangles(positions, normals, surface.triangles());
}

/// Add the regularization, which determines the surface without samples.
void addPriors(const CurvedTriangles& surface, const std::vector<Frame>& frames, double stiffness,
  double minimum, Equations& equations, Unknowns& right)
{
  const Points usual = vertexNormals(surface.positions(), surface.triangles());
  for (Index i = 0; i < right.rows(); ++i)
  {
    const Vector3 normal = usual.row(i);
    const double hold = NormalShare * stiffness / 16.0; // of tilts times length
    equations.diagonal()[i].diagonal() += Vector3(minimum, hold + minimum, hold + minimum);
    right(i, 1) += hold * frames[i].Length * frames[i].E1.dot(normal);
    right(i, 2) += hold * frames[i].Length * frames[i].E2.dot(normal);
  }
}

/// Throw if the cloud seems to have another unit of length than the surface. The cloud may cover a
/// part of the surface, or more than the surface.
void requireOneSize(const Points& positions)
{
  constexpr double maximum = 0x1p16, minimum = 0x1p-16;
  const double extent =
    (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).maxCoeff();
  if (!(positions.cwiseAbs().maxCoeff() <= maximum && extent >= minimum))
  {
    throw std::invalid_argument("the cloud must have about the size and position of the surface");
  }
}

/// Replace normals of length zero by an arbitrary direction.
CurvedTriangles withNormals(const CurvedTriangles& surface)
{
  Points normals = surface.normals();
  for (Index i = 0; i < normals.rows(); ++i)
  {
    if (normals.row(i).isZero(0.0))
    {
      normals.row(i) = Vector3::UnitZ();
    }
  }
  return CurvedTriangles(surface.positions(), normals, surface.triangles());
}
}

//------------------------------------------------------------------------------
CurvedTriangles fitCurvedTriangles(const CurvedTriangles& start, const TrainingSamples& samples,
  const CurvedTriangleFitOptions& options, const Run& run)
{
  if (options.NumberOfFitRounds < 0 ||
    !(options.FitSmoothness >= 0.0 && std::isfinite(options.FitSmoothness)))
  {
    throw std::invalid_argument("NumberOfFitRounds and FitSmoothness must not be negative");
  }
  CurvedTriangles surface = withNormals(inUnit(start, samples, false));
  requireOneSize(surface.positions());
  const Triangles& triangles = start.triangles();
  const Index size = surface.positions().rows();
  const Adjacency neighbors = vertexNeighbors(triangles, size);
  Equations equations(triangles, neighbors);
  LocalScale scale(size, OutlierRatio);
  std::vector<int> hints(samples.size(), -1);
  const double steps = options.NumberOfFitRounds + 1.0;
  // Iteration -1 only measures the scale, so that outliers never contribute.
  for (int round = -1; round < options.NumberOfFitRounds; ++round)
  {
    const std::vector<Frame> frames = framesOf(surface, neighbors);
    const double begin = (round + 1) / steps;
    equations.clear();
    std::vector<double> none;
    forEachCurvedFoot(surface, samples, hints, round < 0 ? none : equations.sums(),
      run.part(begin, begin + 0.8 / steps),
      [&](Index i, const FootPoint& foot)
      {
        const double weight = samples.weight(i);
        const bool use = round >= 0 && !scale.outlying(foot, triangles);
        scale.add(foot, triangles, weight);
        if (!use)
        {
          return;
        }
        const Vector3 way = samples[i] - foot.Position;
        Vector3 direction = surface[foot.Triangle].surfaceNormal(foot.Barycentric);
        const double along = direction.dot(way);
        if (along * along < MaximumSlant * MaximumSlant * foot.SquareDistance)
        {
          direction = way / std::sqrt(foot.SquareDistance);
        }
        equations.add(
          foot.Triangle, motion(surface, frames, foot, direction), direction.dot(way), weight);
      });
    scale.update(neighbors, samples.reduce());
    if (round < 0 || equations.weight() == 0.0)
    {
      continue;
    }
    const double perVertex = equations.weight() / static_cast<double>(size);
    const double stiffness = options.FitSmoothness * perVertex;
    Unknowns right = equations.assemble();
    addPriors(surface, frames, stiffness, 1e-6 * perVertex, equations, right);
    const Unknowns step = solve(
      equations, std::move(right), stiffness, run.part(begin + 0.8 / steps, begin + 1.0 / steps));
    surface = moved(surface, frames, step);
  }
  return inUnit(surface, samples, true);
}
}

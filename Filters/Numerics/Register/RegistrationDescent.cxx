#include "Register/RegistrationDescent.h"

#include "Linear/EdgeWeights.h"
#include "Measure/TriangleStretch.h"
#include "Mesh/MeshTopology.h"
#include "Sphere/SphereOrientation.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace conformal
{
namespace
{
using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;
using Tangents = Eigen::Matrix<double, 3, 2>; // two orthonormal vectors tangential to the sphere

Tangents tangentsAt(const Vector3& n)
{
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  Tangents result;
  result.col(0) = n.cross(Vector3::Unit(axis)).normalized();
  result.col(1) = n.cross(result.col(0));
  return result;
}

// Interpolated position on the fixed surface, in the direction of one vertex of the moving sphere.
struct Found
{
  int Triangle = -1;
  Tangents Along;
  Vector3 Position;
  Tangents Slope; // derivatives of Position along both tangents
};

// Interpolated positions and features on the fixed surface. Element or row i belongs to vertex i of
// the moving sphere.
struct Lookup
{
  std::vector<Found> At;
  Rows Features;              // #V by #K
  std::array<Rows, 2> Slopes; // derivatives of Features along both tangents, #V by #K
};

// Landmark on the moving sphere, by the triangle that contains the landmark, and its target.
struct Anchor
{
  std::array<int, 3> Ids;
  Vector3 Weights, To;
};

// Symmetric matrix of 2 by 2 blocks for adjacent vertices and for each vertex. Only the lower half
// is stored, as Eigen's solver requires.
class BlockMatrix
{
public:
  explicit BlockMatrix(const Adjacency& neighbors)
    : Neighbors(neighbors)
    , Size(static_cast<Index>(neighbors.Offsets.size()) - 1)
    , Diagonal(Size)
    , Beside(neighbors.Ids.size())
    , Matrix(2 * Size, 2 * Size)
  {
  }

  void clear()
  {
    std::fill(this->Diagonal.begin(), this->Diagonal.end(), Matrix2::Zero());
    std::fill(this->Beside.begin(), this->Beside.end(), Matrix2::Zero());
  }

  // Add a 2 by 2 block at the rows of vertex i and the columns of vertex j, and its transpose.
  void add(int i, int j, const Matrix2& block)
  {
    if (i == j)
    {
      this->Diagonal[i] += block;
      return;
    }
    const int row = std::max(i, j), column = std::min(i, j);
    const int* at =
      std::lower_bound(this->Neighbors.begin(column), this->Neighbors.end(column), row);
    this->Beside[at - this->Neighbors.Ids.data()] += i > j ? block : block.transpose();
  }

  Matrix2& diagonal(Index i) { return this->Diagonal[i]; }

  const Eigen::SparseMatrix<double>& lower()
  {
    std::vector<int> offsets = { 0 }, rows;
    std::vector<double> values;
    for (int j = 0; j < this->Size; ++j)
    {
      for (int c = 0; c < 2; ++c)
      {
        for (int r = c; r < 2; ++r)
        {
          rows.push_back(2 * j + r);
          values.push_back(this->Diagonal[j](r, c));
        }
        for (int k = this->Neighbors.Offsets[j]; k < this->Neighbors.Offsets[j + 1]; ++k)
        {
          if (this->Neighbors.Ids[k] > j)
          {
            for (int r = 0; r < 2; ++r)
            {
              rows.push_back(2 * this->Neighbors.Ids[k] + r);
              values.push_back(this->Beside[k](r, c));
            }
          }
        }
        offsets.push_back(static_cast<int>(rows.size()));
      }
    }
    this->Matrix = Eigen::Map<const Eigen::SparseMatrix<double>>(2 * this->Size, 2 * this->Size,
      static_cast<Index>(rows.size()), offsets.data(), rows.data(), values.data());
    return this->Matrix;
  }

private:
  const Adjacency& Neighbors;
  Index Size;
  std::vector<Matrix2> Diagonal, Beside;
  Eigen::SparseMatrix<double> Matrix;
};

class Descent
{
public:
  Descent(const SampledSurface& moving, const SampledSurface& fixed,
    const std::vector<SpherePair>& pairs, const RegistrationWeights& weights)
    : Moving(moving)
    , Fixed(fixed)
    , Weights(weights)
    , Size(moving.Grid.size())
    , Corners(moving.Grid.mesh().Triangles)
    , Neighbors(vertexNeighbors(Corners, Size))
    , Matrix(Neighbors)
  {
    const Index count = fixed.Values.cols() - 3;
    for (Lookup* lookup : { &this->Here, &this->There })
    {
      lookup->At.resize(this->Size);
      lookup->Features.resize(this->Size, count);
      lookup->Slopes.fill(Rows(this->Size, count));
    }
    const Points positions = moving.Values.leftCols<3>();
    this->Shares = vertexAreas(positions, this->Corners);
    this->Shares += Eigen::VectorXd::Constant(this->Size, weights.Sphere * this->Shares.mean());
    this->Shares /= this->Shares.sum();
    this->Metrics.resize(this->Corners.rows());
    double area = 0.0;
    for (Index r = 0; r < this->Corners.rows(); ++r)
    {
      const auto ids = this->Corners.row(r);
      const auto edge = [&](int k)
      {
        const Vector3 x = positions.row(ids[k]) - positions.row(ids[0]);
        const Vector3 n =
          moving.Grid.mesh().Positions.row(ids[k]) - moving.Grid.mesh().Positions.row(ids[0]);
        Eigen::Matrix<double, 6, 1> result;
        result << x, std::sqrt(weights.Sphere) * n;
        return result;
      };
      const auto p = edge(1), q = edge(2);
      this->Metrics[r] = { p.dot(p), p.dot(q), q.dot(q) };
      area += areaOf(this->Metrics[r]);
      this->SphereMetrics.push_back(this->sphereMetricAt(moving.Grid.mesh().Positions, r));
    }
    this->BarrierUnit = weights.Barrier / (16.0 * Pi);
    this->StretchUnit = weights.Stretch / (4.0 * area);
    for (const SpherePair& pair : pairs)
    {
      const SphereWeights at = moving.Grid.weightsAt(pair.From);
      this->Anchors.push_back({ at.Ids, at.Weights, pair.To });
    }
  }

  RegistrationEnergy run(Points& places, const DescentOptions& options, const Run& run)
  {
    this->look(places, this->Here);
    RegistrationEnergy energy = this->energyAt(places, this->Here);
    double damping = 1e-3;
    for (int step = 0; step < options.MaximumNumberOfSteps; ++step)
    {
      run.report(static_cast<double>(step) / options.MaximumNumberOfSteps);
      this->linearize(places);
      const double before = energy.Total;
      bool fell = false;
      for (int attempt = 0; attempt < 3 && !fell; ++attempt)
      {
        fell = this->goAlong(this->solve(damping), places, energy);
        damping = fell ? std::max(1e-5, damping / 3.0) : 30.0 * damping;
      }
      // The minimum of the stretch is 1.
      if (!fell || before - energy.Total < options.Tolerance * (before - this->Weights.Stretch))
      {
        break;
      }
    }
    run.report(1.0);
    return energy;
  }

private:
  static constexpr double LongestMove = 0.3;

  // Interpolate the values of the fixed surface in the directions `places`.
  void look(const Points& places, Lookup& found) const
  {
    const Rows& values = this->Fixed.Values;
    const Index count = values.cols() - 3;
    for (Index i = 0; i < this->Size; ++i)
    {
      Found& at = found.At[i];
      const Vector3 place = places.row(i);
      const SphereWeights weights = this->Fixed.Grid.weightsAt(place, this->Here.At[i].Triangle);
      at.Triangle = weights.Triangle;
      at.Along = tangentsAt(place);
      const Tangents slopes = weights.Slopes * at.Along; // derivatives of the weights
      at.Position.setZero();
      at.Slope.setZero();
      found.Features.row(i).setZero();
      found.Slopes[0].row(i).setZero();
      found.Slopes[1].row(i).setZero();
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 position = values.row(weights.Ids[k]).head<3>();
        const auto features = values.row(weights.Ids[k]).tail(count);
        at.Position += weights.Weights[k] * position;
        at.Slope += position * slopes.row(k);
        found.Features.row(i) += weights.Weights[k] * features;
        found.Slopes[0].row(i) += slopes(k, 0) * features;
        found.Slopes[1].row(i) += slopes(k, 1) * features;
      }
    }
  }

  TriangleMetric metricAt(const Points& places, const Lookup& found, Index r) const
  {
    const auto ids = this->Corners.row(r);
    const Vector3 p = found.At[ids[1]].Position - found.At[ids[0]].Position,
                  q = found.At[ids[2]].Position - found.At[ids[0]].Position,
                  m = places.row(ids[1]) - places.row(ids[0]),
                  n = places.row(ids[2]) - places.row(ids[0]);
    const double share = this->Weights.Sphere;
    return { p.dot(p) + share * m.dot(m), p.dot(q) + share * m.dot(n),
      q.dot(q) + share * n.dot(n) };
  }

  TriangleMetric sphereMetricAt(const Points& places, Index r) const
  {
    const auto ids = this->Corners.row(r);
    const Vector3 m = places.row(ids[1]) - places.row(ids[0]),
                  n = places.row(ids[2]) - places.row(ids[0]);
    return { m.dot(m), m.dot(n), n.dot(n) };
  }

  // Return triangle r of the fixed surface and of the moving sphere as one triangle in six
  // dimensions. The arguments `surface` and `sphere` are factors of both metrics.
  MovingTriangle triangleAt(const Points& places, Index r, double surface, double sphere) const
  {
    const auto ids = this->Corners.row(r);
    const double side = std::sqrt(surface), other = std::sqrt(sphere);
    std::array<Eigen::Matrix<double, 6, 1>, 3> corners;
    std::array<Eigen::Matrix<double, 6, 2>, 3> slopes;
    for (int k = 0; k < 3; ++k)
    {
      const Found& at = this->Here.At[ids[k]];
      corners[k] << side * at.Position, other * places.row(ids[k]).transpose();
      slopes[k] << side * at.Slope, other * at.Along;
    }
    MovingTriangle result;
    result.P = corners[1] - corners[0];
    result.Q = corners[2] - corners[0];
    result.PByUnknowns << -slopes[0], slopes[1], Eigen::Matrix<double, 6, 2>::Zero();
    result.QByUnknowns << -slopes[0], Eigen::Matrix<double, 6, 2>::Zero(), slopes[2];
    return result;
  }

  RegistrationEnergy energyAt(const Points& places, const Lookup& found) const
  {
    RegistrationEnergy energy;
    for (Index r = 0; r < this->Corners.rows(); ++r)
    {
      energy.Stretch += triangleStretch(this->Metrics[r], this->metricAt(places, found, r));
      energy.Barrier += triangleStretch(this->SphereMetrics[r], this->sphereMetricAt(places, r));
    }
    energy.Barrier *= this->BarrierUnit;
    energy.Stretch = 1.0 + energy.Stretch * this->StretchUnit / this->Weights.Stretch;
    for (Index i = 0; i < this->Size; ++i)
    {
      for (Index k = 0; k < found.Features.cols(); ++k)
      {
        const double difference = found.Features(i, k) - this->Moving.Values(i, 3 + k);
        energy.Features += this->Weights.Features[k] * this->Shares[i] * difference * difference;
      }
    }
    for (const Anchor& anchor : this->Anchors)
    {
      energy.Landmarks += (this->placeOf(anchor, places) - anchor.To).squaredNorm();
    }
    energy.Landmarks /= std::max<std::size_t>(1, this->Anchors.size());
    energy.Total = this->Weights.Stretch * energy.Stretch + energy.Barrier + energy.Features +
      this->Weights.Landmarks * energy.Landmarks;
    return energy;
  }

  Vector3 placeOf(const Anchor& anchor, const Points& places) const
  {
    Vector3 place = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      place += anchor.Weights[k] * places.row(anchor.Ids[k]).transpose();
    }
    return place.normalized();
  }

  // Compute the gradient of the energy, and an approximate Hessian.
  void linearize(const Points& places)
  {
    this->Matrix.clear();
    this->Gradient = Eigen::VectorXd::Zero(2 * this->Size);
    for (Index r = 0; r < this->Corners.rows(); ++r)
    {
      const auto ids = this->Corners.row(r);
      const TriangleForm stretch = triangleStretchForm(this->Metrics[r],
                           this->triangleAt(places, r, 1.0, this->Weights.Sphere)),
                         barrier = triangleStretchForm(
                           this->SphereMetrics[r], this->triangleAt(places, r, 0.0, 1.0));
      const Eigen::Matrix<double, 6, 1> slope =
        this->StretchUnit * stretch.Slope + this->BarrierUnit * barrier.Slope;
      const Eigen::Matrix<double, 6, 6> stiffness =
        this->StretchUnit * stretch.Stiffness + this->BarrierUnit * barrier.Stiffness;
      for (int i = 0; i < 3; ++i)
      {
        this->Gradient.segment<2>(2 * ids[i]) += slope.segment<2>(2 * i);
        for (int j = 0; j <= i; ++j)
        {
          this->Matrix.add(ids[i], ids[j], stiffness.block<2, 2>(2 * i, 2 * j));
        }
      }
    }
    for (Index i = 0; i < this->Size; ++i)
    {
      for (Index k = 0; k < this->Here.Features.cols(); ++k)
      {
        const double weight = 2.0 * this->Weights.Features[k] * this->Shares[i];
        const Vector2 slope = { this->Here.Slopes[0](i, k), this->Here.Slopes[1](i, k) };
        this->Gradient.segment<2>(2 * i) +=
          weight * (this->Here.Features(i, k) - this->Moving.Values(i, 3 + k)) * slope;
        this->Matrix.diagonal(i) += weight * slope * slope.transpose();
      }
    }
    for (const Anchor& anchor : this->Anchors)
    {
      const double weight =
        2.0 * this->Weights.Landmarks / static_cast<double>(this->Anchors.size());
      const Vector3 off = this->placeOf(anchor, places) - anchor.To;
      for (int i = 0; i < 3; ++i)
      {
        const Tangents& along = this->Here.At[anchor.Ids[i]].Along;
        this->Gradient.segment<2>(2 * anchor.Ids[i]) +=
          weight * anchor.Weights[i] * (along.transpose() * off);
        for (int j = 0; j <= i; ++j)
        {
          this->Matrix.add(anchor.Ids[i], anchor.Ids[j],
            weight * anchor.Weights[i] * anchor.Weights[j] *
              (along.transpose() * this->Here.At[anchor.Ids[j]].Along));
        }
      }
    }
    this->Stiffness.resize(this->Size);
    for (Index i = 0; i < this->Size; ++i)
    {
      this->Stiffness[i] = 0.5 * this->Matrix.diagonal(i).trace();
    }
  }

  Eigen::VectorXd solve(double damping)
  {
    const double floor = this->Stiffness.mean();
    for (Index i = 0; i < this->Size; ++i)
    {
      this->Matrix.diagonal(i) += damping * (this->Stiffness[i] + floor) * Matrix2::Identity();
    }
    const Eigen::SparseMatrix<double>& lower = this->Matrix.lower();
    for (Index i = 0; i < this->Size; ++i)
    {
      this->Matrix.diagonal(i) -= damping * (this->Stiffness[i] + floor) * Matrix2::Identity();
    }
    if (!this->Analyzed)
    {
      this->Factor.analyzePattern(lower);
      this->Analyzed = true;
    }
    this->Factor.factorize(lower);
    return this->Factor.info() == Eigen::Success
      ? Eigen::VectorXd(-this->Factor.solve(this->Gradient))
      : Eigen::VectorXd::Zero(2 * this->Size);
  }

  double longestOf(const Eigen::VectorXd& move) const
  {
    double longest = 0.0;
    for (Index i = 0; i < this->Size; ++i)
    {
      longest = std::max(longest, move.segment<2>(2 * i).norm());
    }
    return longest;
  }

  Points moved(const Points& places, const Eigen::VectorXd& move, double factor) const
  {
    Points result(this->Size, 3);
    for (Index i = 0; i < this->Size; ++i)
    {
      const Vector3 place =
        places.row(i).transpose() + factor * (this->Here.At[i].Along * move.segment<2>(2 * i));
      result.row(i) = place.normalized();
    }
    return result;
  }

  // Move the vertices along `move`, shortened until the energy decreases. Return whether the energy
  // decreased.
  bool goAlong(const Eigen::VectorXd& move, Points& places, RegistrationEnergy& energy)
  {
    const double longest = this->longestOf(move);
    if (!(longest > 0.0) || !std::isfinite(longest))
    {
      return false;
    }
    double factor = std::min(1.0, LongestMove / longest);
    for (int attempt = 0; attempt < 8; ++attempt, factor *= 0.5)
    {
      Points moved = this->moved(places, move, factor);
      if (!this->unfold(places, moved))
      {
        continue;
      }
      this->look(moved, this->There);
      const RegistrationEnergy other = this->energyAt(moved, this->There);
      if (other.Total < energy.Total)
      {
        energy = other;
        places = std::move(moved);
        std::swap(this->Here, this->There);
        return true;
      }
    }
    return false;
  }

  // Halve the moves of the corners of folded triangles until none is folded.
  bool unfold(const Points& places, Points& moved) const
  {
    // After the halvings, the moves of corners of folded triangles are undone completely.
    constexpr int attempts = 12, halvings = 8;
    for (int attempt = 0; attempt < attempts; ++attempt)
    {
      const double kept = attempt < halvings ? 0.5 : 0.0;
      std::vector<char> back(this->Size, 0);
      bool folded = false;
      for (Index r = 0; r < this->Corners.rows(); ++r)
      {
        const auto ids = this->Corners.row(r);
        if (orientation(moved.row(ids[0]), moved.row(ids[1]), moved.row(ids[2])) <= 0)
        {
          folded = true;
          for (int k = 0; k < 3; ++k)
          {
            back[ids[k]] = 1;
          }
        }
      }
      if (!folded)
      {
        return true;
      }
      for (Index i = 0; i < this->Size; ++i)
      {
        if (back[i])
        {
          moved.row(i) = (kept * moved.row(i) + (1.0 - kept) * places.row(i)).normalized();
        }
      }
    }
    return false;
  }

  const SampledSurface& Moving;
  const SampledSurface& Fixed;
  RegistrationWeights Weights;
  Index Size;
  const Triangles& Corners;
  Adjacency Neighbors;
  BlockMatrix Matrix;
  Lookup Here, There;
  std::vector<TriangleMetric> Metrics;
  Eigen::VectorXd Shares, Gradient, Stiffness;
  double StretchUnit = 1.0, BarrierUnit = 0.0;
  std::vector<TriangleMetric> SphereMetrics;
  std::vector<Anchor> Anchors;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Factor;
  bool Analyzed = false;
};
}

//------------------------------------------------------------------------------
RegistrationEnergy descend(const SampledSurface& moving, const SampledSurface& fixed,
  const std::vector<SpherePair>& pairs, const DescentOptions& options, Points& places,
  const Run& run)
{
  Descent descent(moving, fixed, pairs, options.Weights);
  return descent.run(places, options, run);
}
}

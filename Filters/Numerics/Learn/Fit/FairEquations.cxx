#include "Learn/Fit/FairEquations.h"

#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Cloud/LocalScale.h"
#include "Cloud/SampleRotation.h"
#include "Search/TriangleTree.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace conformal
{
namespace
{
using Entries = std::vector<Eigen::Triplet<double>>;

constexpr double MaximumCotangent = 20.0;
constexpr double ShareOfSharp = 0.01;      // root of the share of the energy around creases
constexpr double MinimumAnisotropy = 0.03; // ratio of variances by direction
constexpr double MinimumArea = 1e-3;       // around a vertex, of the mean

// Numbers of each triangle: 6 products of weights, 3 products of weights and residuals, the sum of
// squared residuals, the mass and the count.
constexpr Index SumsPerTriangle = 12;

/// Pseudorandom sign, by the mixing function of SplitMix64.
double randomSign(std::uint64_t number)
{
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return ((z ^ (z >> 31U)) & 1U) != 0U ? 1.0 : -1.0;
}

/// Equation of one sample. Rows of all samples are kept, so that only what is needed is stored.
struct Row
{
  Vector3 Barycentric; // of the foot point
  double SquareDistance, Residual;
  int Triangle, Sample;

  FootPoint foot() const
  {
    FootPoint foot;
    foot.Triangle = this->Triangle;
    foot.Barycentric = this->Barycentric;
    foot.SquareDistance = this->SquareDistance;
    return foot;
  }
};

using CornerIds = Eigen::Matrix<int, 1, 3>;

Vector3 normalAt(const CornerIds& ids, const Vector3& barycentric, const Points& normals)
{
  Vector3 normal = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    normal += barycentric[k] * Vector3(normals.row(ids[k]));
  }
  normal.stableNormalize();
  return normal;
}

/// Moves of a foot point along its normal by unit moves of the three corners
Vector3 weightsAt(const CornerIds& ids, const Vector3& barycentric, const Points& normals)
{
  const Vector3 normal = normalAt(ids, barycentric, normals);
  Vector3 weights;
  for (int k = 0; k < 3; ++k)
  {
    weights[k] = barycentric[k] * normal.dot(Vector3(normals.row(ids[k])));
  }
  return weights;
}

std::vector<Row> rowsOf(const TrainingSamples& samples, const FairSamplesOptions& options,
  const Mesh& mesh, const Points& normals, const Run& run)
{
  Steps steps(run, { 0.1, 0.9 });
  const TriangleTree tree(mesh.Positions, mesh.Triangles, steps.next());
  SampleRotation rotation(samples, options.RandomSeed);
  rotation.turn(options.SamplesPerRound);
  std::vector<Row> rows;
  rows.reserve(rotation.count());
  forEachFoot(
    samples, tree, rotation.count(), [&](Index i) { return rotation.id(i); },
    [&](Index i, const Vector3& x, const FootPoint& foot)
    {
      if (options.Belongs && !options.Belongs(x))
      {
        return;
      }
      const Vector3 normal = normalAt(mesh.Triangles.row(foot.Triangle), foot.Barycentric, normals);
      rows.push_back({ foot.Barycentric, foot.SquareDistance, normal.dot(x - foot.Position),
        foot.Triangle, static_cast<int>(rotation.id(i)) });
    },
    steps.next());
  return rows;
}

Eigen::Matrix3d fullTensor(const Eigen::Matrix<double, 1, 6>& parts)
{
  Eigen::Matrix3d tensor;
  tensor << parts[0], parts[5], parts[4], parts[5], parts[1], parts[3], parts[4], parts[3],
    parts[2];
  return tensor;
}

/// Compute an orthonormal basis of the plane of a triangle.
Eigen::Matrix<double, 3, 2> frameOf(const Eigen::Matrix3d& slopes)
{
  const Vector3 first = Vector3(slopes.col(0)).stableNormalized();
  const Vector3 normal = first.cross(Vector3(slopes.col(1))).stableNormalized();
  Eigen::Matrix<double, 3, 2> frame;
  frame << first, normal.cross(first);
  return frame;
}

/// Compute R, where the transpose of R times R is half the inverse of a variance. The mean of the
/// squares, divided by the variance, is then 1 for the two directions together.
Eigen::Matrix2d inverseRoot(const Eigen::Matrix2d& variance)
{
  const double trace = variance.trace();
  const Eigen::Matrix2d bounded =
    (variance / trace + 0.5 * MinimumAnisotropy * Eigen::Matrix2d::Identity()) /
    (1.0 + MinimumAnisotropy);
  const Eigen::Matrix2d root = Eigen::Matrix2d(0.5 * bounded.inverse()).llt().matrixU();
  return root / std::sqrt(trace);
}

/// Compute vertices of a smooth surface whose domes have the flat triangles as mean. This is
/// lowerVertices() of Surface/CurvedTriangles.h for quadratic domes and a lumped mass matrix.
Points lowered(const Mesh& mesh, const Points& normals)
{
  const Points& positions = mesh.Positions;
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(positions.rows()), areas = volumes;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const auto ids = mesh.Triangles.row(r);
    const Vector3 a = positions.row(ids[0]), b = positions.row(ids[1]), c = positions.row(ids[2]);
    const double area = 0.5 * (b - a).cross(c - a).norm();
    for (int k = 0; k < 3; ++k)
    {
      const int i = ids[next(k)], j = ids[previous(k)];
      const double height =
        (normals.row(j) - normals.row(i)).dot(positions.row(j) - positions.row(i)) / 8.0;
      // Integrals of the bubble 4 m_i m_j against m_k, and against m_i or m_j.
      volumes[ids[k]] += area * height / 15.0;
      volumes[i] += area * height * 2.0 / 15.0;
      volumes[j] += area * height * 2.0 / 15.0;
      areas[ids[k]] += area / 3.0;
    }
  }
  Points result = positions;
  for (Index i = 0; i < positions.rows(); ++i)
  {
    result.row(i) -= (areas[i] > 0.0 ? volumes[i] / areas[i] : 0.0) * normals.row(i);
  }
  return result;
}
}

//------------------------------------------------------------------------------
SampleDistances::SampleDistances(const TrainingSamples& samples, const FairSamplesOptions& options,
  const Mesh& mesh, const Points& normals, const Adjacency& neighbors, const Run& run)
  : Corners(mesh.Triangles)
  , Size(mesh.Positions.rows())
  , Sums(mesh.Triangles.rows())
  , Masses(mesh.Triangles.rows())
{
  const std::vector<Row> rows = rowsOf(samples, options, mesh, normals, run);
  LocalScale scale(this->Size, options.OutlierRatio);
  for (const Row& row : rows)
  {
    scale.add(row.foot(), this->Corners, samples.weight(row.Sample));
  }
  scale.update(neighbors, samples.reduce());
  FixedPointSums sums(SumsPerTriangle * this->Corners.rows());
  for (const Row& row : rows)
  {
    if (scale.outlying(row.foot(), this->Corners))
    {
      continue;
    }
    const Vector3 weights = weightsAt(this->Corners.row(row.Triangle), row.Barycentric, normals);
    const double weight = samples.weight(row.Sample);
    Index place = SumsPerTriangle * row.Triangle;
    for (int k = 0; k < 3; ++k)
    {
      for (int l = k; l < 3; ++l)
      {
        sums.add(place++, weight * weights[k] * weights[l]);
      }
      sums.add(place++, weight * weights[k] * row.Residual);
    }
    sums.add(place++, weight * row.Residual * row.Residual);
    sums.add(place++, weight);
    sums.add(place, 1.0);
  }
  sums.reduce(samples.reduce());
  for (Index r = 0; r < this->Corners.rows(); ++r)
  {
    OfTriangle& own = this->Sums[r];
    Index place = SumsPerTriangle * r;
    for (int k = 0; k < 3; ++k)
    {
      for (int l = k; l < 3; ++l)
      {
        own.Products(k, l) = own.Products(l, k) = sums[place++];
      }
      own.Right[k] = sums[place++];
    }
    own.Constant = sums[place++];
    this->Masses[r] = sums[place++];
    own.Count = sums[place];
    this->Count += own.Count;
    this->Mass += this->Masses[r];
  }
}

//------------------------------------------------------------------------------
SampleDistances::Sum SampleDistances::sum(const Eigen::VectorXd& precisions) const
{
  Sum sum;
  sum.Right = Eigen::VectorXd::Zero(this->Size);
  sum.Probes = Columns::Zero(this->Size, NumberOfProbes);
  Entries entries;
  entries.reserve(9 * this->Sums.size());
  for (Index r = 0; r < this->Corners.rows(); ++r)
  {
    const OfTriangle& own = this->Sums[r];
    const auto ids = this->Corners.row(r);
    const double precision = (precisions[ids[0]] + precisions[ids[1]] + precisions[ids[2]]) / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      for (int l = 0; l < 3; ++l)
      {
        entries.emplace_back(ids[k], ids[l], precision * own.Products(k, l));
      }
      sum.Right[ids[k]] += precision * own.Right[k];
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> products(own.Products);
    // The symmetric root, since rounding may flip eigenvectors.
    const Eigen::Matrix3d root = products.eigenvectors() *
      (precision * products.eigenvalues()).cwiseMax(0.0).cwiseSqrt().asDiagonal() *
      products.eigenvectors().transpose();
    for (Index p = 0; p < NumberOfProbes; ++p)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double random = randomSign(2 * ((r * NumberOfProbes + p) * 3 + k));
        for (int l = 0; l < 3; ++l)
        {
          sum.Probes(ids[l], p) += random * root(l, k);
        }
      }
    }
    sum.Constant += precision * own.Constant;
  }
  sum.Matrix.resize(this->Size, this->Size);
  sum.Matrix.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

//------------------------------------------------------------------------------
Eigen::VectorXd SampleDistances::quadraticAt(const Eigen::VectorXd& u, double factor) const
{
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(this->Size);
  for (Index r = 0; r < this->Corners.rows(); ++r)
  {
    const OfTriangle& own = this->Sums[r];
    const auto ids = this->Corners.row(r);
    const Vector3 v(u[ids[0]], u[ids[1]], u[ids[2]]);
    const double square =
      v.dot(own.Products * v) + factor * (own.Constant - 2.0 * v.dot(own.Right));
    for (int k = 0; k < 3; ++k)
    {
      squares[ids[k]] += square / 3.0;
    }
  }
  return squares;
}

//------------------------------------------------------------------------------
Eigen::VectorXd SampleDistances::squaresAt(const Eigen::VectorXd& displacements) const
{
  return this->quadraticAt(displacements, 1.0);
}

//------------------------------------------------------------------------------
Eigen::VectorXd SampleDistances::increaseAt(const Eigen::VectorXd& deviations) const
{
  return this->quadraticAt(deviations, 0.0);
}

//------------------------------------------------------------------------------
Eigen::VectorXd SampleDistances::countsAt() const
{
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(this->Size);
  for (Index r = 0; r < this->Corners.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      counts[this->Corners(r, k)] += this->Sums[r].Count / 3.0;
    }
  }
  return counts;
}

//------------------------------------------------------------------------------
CurvatureChange::CurvatureChange(const Mesh& mesh, const Points& normals)
  : Corners(mesh.Triangles)
  , Slopes(mesh.Triangles.rows())
{
  const Triangles& triangles = mesh.Triangles;
  const Points positions = lowered(mesh, normals);
  const Index size = positions.rows();
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(size);
  Entries entries;
  entries.reserve(3 * triangles.rows());
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const auto ids = triangles.row(r);
    const Vector3 p = positions.row(ids[0]), q = positions.row(ids[1]), s = positions.row(ids[2]);
    const double area = 0.5 * (q - p).cross(s - p).norm();
    for (int k = 0; k < 3; ++k)
    {
      const int i = ids[next(k)], j = ids[previous(k)];
      const Vector3 corner = positions.row(ids[k]);
      const double cosine =
        (Vector3(positions.row(i)) - corner).dot(Vector3(positions.row(j)) - corner);
      constexpr double smallest = 1e-30;
      const double cotangent =
        std::clamp(cosine / std::max(2.0 * area, smallest), -MaximumCotangent, MaximumCotangent);
      entries.emplace_back(std::min(i, j), std::max(i, j), 0.5 * cotangent);
      areas[ids[k]] += area / 3.0;
    }
  }
  areas = areas.cwiseMax(MinimumArea * areas.mean());
  const double minimumArea = MinimumArea * areas.mean();
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const auto ids = triangles.row(r);
    const Vector3 p = positions.row(ids[0]), q = positions.row(ids[1]), s = positions.row(ids[2]);
    Vector3 normal = (q - p).cross(s - p);
    const double area = 0.5 * normal.norm();
    normal.stableNormalize();
    const double root = std::sqrt(std::max(area, minimumArea));
    this->Slopes[r] << normal.cross(s - q), normal.cross(p - s), normal.cross(q - p);
    this->Slopes[r] *= 0.5 / root;
  }
  SparseMatrix weights(size, size);
  weights.setFromTriplets(entries.begin(), entries.end());
  entries.clear();
  Points laplacian = Points::Zero(size, 3);
  for (int j = 0; j < size; ++j)
  {
    for (SparseMatrix::InnerIterator entry(weights, j); entry; ++entry)
    {
      const int i = static_cast<int>(entry.row());
      const double weight = entry.value();
      for (const auto& [own, other] : { std::pair(i, j), std::pair(j, i) })
      {
        const double share = weight / areas[own];
        entries.emplace_back(own, own, share);
        entries.emplace_back(own, other, -share);
        laplacian.row(own) += share * (positions.row(own) - positions.row(other));
      }
    }
  }
  this->Change.resize(size, size);
  this->Change.setFromTriplets(entries.begin(), entries.end());
  this->Curvatures = laplacian.cwiseProduct(normals).rowwise().sum();
}

//------------------------------------------------------------------------------
Tensors CurvatureChange::squaresOf(const Eigen::VectorXd& curvatures) const
{
  Tensors squares = Tensors::Zero(curvatures.size(), 6);
  for (Index r = 0; r < this->Corners.rows(); ++r)
  {
    const auto ids = this->Corners.row(r);
    const Vector3 g = this->Slopes[r] *
      Vector3(curvatures[ids[0]], curvatures[ids[1]], curvatures[ids[2]]) / std::sqrt(3.0);
    for (int k = 0; k < 3; ++k)
    {
      for (int d = 0; d < 3; ++d)
      {
        squares(ids[k], d) += g[d] * g[d];
        squares(ids[k], 3 + d) += g[next(d)] * g[previous(d)];
      }
    }
  }
  return squares;
}

//------------------------------------------------------------------------------
Tensors CurvatureChange::squaresAt(const Eigen::VectorXd& displacements) const
{
  return this->squaresOf(this->Curvatures + this->Change * displacements);
}

//------------------------------------------------------------------------------
Tensors CurvatureChange::homogeneousSquaresAt(const Eigen::VectorXd& deviations) const
{
  return this->squaresOf(this->Change * deviations);
}

//------------------------------------------------------------------------------
CurvatureChange::Energy CurvatureChange::energy(
  const Tensors& variances, const std::vector<bool>& sharp) const
{
  const Index size = variances.rows();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size);
  Columns probes = Columns::Zero(size, NumberOfProbes);
  Entries entries;
  entries.reserve(9 * this->Slopes.size());
  for (Index r = 0; r < this->Corners.rows(); ++r)
  {
    const auto ids = this->Corners.row(r);
    const Eigen::Matrix3d& slopes = this->Slopes[r];
    Eigen::Matrix<double, 1, 6> mean = Eigen::Matrix<double, 1, 6>::Zero();
    for (const int id : ids)
    {
      mean += variances.row(id) / 3.0;
    }
    const Eigen::Matrix<double, 3, 2> frame = frameOf(slopes);
    const Eigen::Matrix2d root = inverseRoot(frame.transpose() * fullTensor(mean) * frame);
    const bool across = sharp[ids[0]] || sharp[ids[1]] || sharp[ids[2]];
    const Eigen::Matrix<double, 2, 3> rows =
      (across ? ShareOfSharp : 1.0) * root * frame.transpose() * slopes;
    const Eigen::Matrix3d products = rows.transpose() * rows;
    const Vector3 pulls = products *
      Vector3(this->Curvatures[ids[0]], this->Curvatures[ids[1]], this->Curvatures[ids[2]]);
    for (int k = 0; k < 3; ++k)
    {
      force[ids[k]] += pulls[k];
      for (int l = 0; l < 3; ++l)
      {
        entries.emplace_back(ids[k], ids[l], products(k, l));
      }
    }
    for (Index p = 0; p < NumberOfProbes; ++p)
    {
      for (int d = 0; d < 2; ++d)
      {
        const double random = randomSign(2 * ((r * NumberOfProbes + p) * 2 + d) + 1);
        for (int k = 0; k < 3; ++k)
        {
          probes(ids[k], p) += random * rows(d, k);
        }
      }
    }
  }
  Energy energy;
  energy.Change = &this->Change;
  energy.Differences.resize(size, size);
  energy.Differences.setFromTriplets(entries.begin(), entries.end());
  entries = {}; // releases the memory
  const SparseMatrix transposed = this->Change.transpose();
  energy.Force = transposed * force;
  energy.Probes = transposed * probes;
  return energy;
}

//------------------------------------------------------------------------------
SparseMatrix CurvatureChange::Energy::matrix() const
{
  const SparseMatrix transposed = this->Change->transpose(),
                     half = this->Differences * *this->Change;
  return transposed * half;
}

//------------------------------------------------------------------------------
SparseMatrix CurvatureChange::Energy::principalPart(const std::vector<int>& ids) const
{
  const SparseMatrix& change = *this->Change;
  SparseMatrix columns(change.rows(), static_cast<Index>(ids.size()));
  Index size = 0;
  for (const int id : ids)
  {
    size += change.outerIndexPtr()[id + 1] - change.outerIndexPtr()[id];
  }
  columns.reserve(size);
  for (int k = 0; k < static_cast<int>(ids.size()); ++k)
  {
    columns.startVec(k);
    for (SparseMatrix::InnerIterator entry(change, ids[k]); entry; ++entry)
    {
      columns.insertBack(entry.row(), k) = entry.value();
    }
  }
  columns.finalize();
  const SparseMatrix transposed = columns.transpose(), half = this->Differences * columns;
  return transposed * half;
}

//------------------------------------------------------------------------------
double CurvatureChange::Energy::trace() const
{
  const SparseMatrix& change = *this->Change;
  Eigen::VectorXd column = Eigen::VectorXd::Zero(change.rows()); // of C
  double trace = 0.0;
  for (Index j = 0; j < change.cols(); ++j)
  {
    for (SparseMatrix::InnerIterator entry(change, j); entry; ++entry)
    {
      column[entry.row()] = entry.value();
    }
    for (SparseMatrix::InnerIterator entry(change, j); entry; ++entry)
    {
      for (SparseMatrix::InnerIterator other(this->Differences, entry.row()); other; ++other)
      {
        trace += entry.value() * other.value() * column[other.row()];
      }
    }
    for (SparseMatrix::InnerIterator entry(change, j); entry; ++entry)
    {
      column[entry.row()] = 0.0;
    }
  }
  return trace;
}
}

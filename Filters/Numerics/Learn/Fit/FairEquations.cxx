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
#include <numeric>
#include <utility>

namespace conformal
{
namespace
{
constexpr double MaximumCotangent = 20.0;
constexpr double ShareOfSharp = 0.01;      // root of the share of the energy around creases
constexpr double MinimumAnisotropy = 0.03; // ratio of variances by direction
constexpr double MinimumArea = 1e-3;       // around a vertex, of the mean

// Numbers of each triangle: 6 products of weights, 3 products of weights and residuals, the sum of
// squared residuals, the mass and the count.
constexpr Index SumsOfFairing = 12;

/// Pseudorandom sign, by the mixing function of SplitMix64.
double randomSign(std::uint64_t number)
{
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return ((z ^ (z >> 31U)) & 1U) != 0U ? 1.0 : -1.0;
}

/// Equation of one sample. Rows of all samples are kept: only what is needed is stored, as floats.
struct Row
{
  Eigen::Vector3f Barycentric; // of the foot point
  float SquareDistance, Residual;
  int Triangle, Sample;

  FootPoint foot() const
  {
    FootPoint foot;
    foot.Triangle = this->Triangle;
    foot.Barycentric = this->Barycentric.cast<double>();
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
      const double residual = normal.dot(x - foot.Position);
      rows.push_back({ foot.Barycentric.cast<float>(), static_cast<float>(foot.SquareDistance),
        static_cast<float>(residual), foot.Triangle, static_cast<int>(rotation.id(i)) });
    },
    steps.next());
  return rows;
}

/// Places of the entries of a symmetric matrix among its six different ones
constexpr int PlaceOf[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };

Eigen::Matrix3d fullMatrix(const SymmetricMatrix& entries)
{
  Eigen::Matrix3d matrix;
  for (int k = 0; k < 3; ++k)
  {
    for (int l = 0; l < 3; ++l)
    {
      matrix(k, l) = entries[PlaceOf[k][l]];
    }
  }
  return matrix;
}

/// Compute a value for each index in [0, size) on all threads, and pass the values to a function in
/// ascending order, on one thread. The result thus does not depend on the number of threads.
template <typename Compute, typename Use>
void computeInBlocks(const Run& run, Index size, const Compute& compute, const Use& use)
{
  constexpr Index chunkSize = 1 << 14, blockSize = 1 << 9;
  std::vector<decltype(compute(Index()))> values(std::min(size, chunkSize));
  for (Index first = 0; first < size; first += chunkSize)
  {
    const Index count = std::min(chunkSize, size - first);
    forBlocks(run, count, blockSize,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          values[i] = compute(first + i);
        }
      });
    for (Index i = 0; i < count; ++i)
    {
      use(first + i, values[i]);
    }
  }
}

/// Assemble the sum of symmetric matrices of the triangles, on all threads.
/// @param[in] entry  function that returns the entry of corners k and l in the matrix of triangle r
template <typename Entry>
SparseMatrix assembled(const Triangles& corners, Index size, const Entry& entry, const Run& run)
{
  constexpr Index blockSize = 1 << 9;
  const Adjacency around = vertexTriangles(corners, size);
  SparseMatrix matrix(size, size);
  const auto forColumns = [&](const auto& body)
  {
    forBlocks(run, size, blockSize,
      [&](Index begin, Index end)
      {
        std::vector<int> rows;
        for (int j = static_cast<int>(begin); j < end; ++j)
        {
          rows.clear();
          for (const int* r = around.begin(j); r != around.end(j); ++r)
          {
            rows.insert(rows.end(), &corners(*r, 0), &corners(*r, 0) + 3);
          }
          std::sort(rows.begin(), rows.end());
          rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
          body(j, rows);
        }
      });
  };
  int* const offsets = matrix.outerIndexPtr();
  offsets[0] = 0;
  forColumns(
    [&](int j, const std::vector<int>& rows) { offsets[j + 1] = static_cast<int>(rows.size()); });
  std::partial_sum(offsets, offsets + size + 1, offsets);
  matrix.resizeNonZeros(offsets[size]);
  forColumns(
    [&](int j, const std::vector<int>& rows)
    {
      std::copy(rows.begin(), rows.end(), matrix.innerIndexPtr() + offsets[j]);
      double* const values = matrix.valuePtr() + offsets[j];
      std::fill(values, values + rows.size(), 0.0);
      for (const int* r = around.begin(j); r != around.end(j); ++r)
      {
        const int l = cornerOf(corners, *r, j);
        for (int k = 0; k < 3; ++k)
        {
          values[std::lower_bound(rows.begin(), rows.end(), corners(*r, k)) - rows.begin()] +=
            entry(*r, k, l);
        }
      }
    });
  return matrix;
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
  FixedPointSums sums(SumsOfFairing * this->Corners.rows());
  for (const Row& row : rows)
  {
    const FootPoint foot = row.foot();
    if (scale.outlying(foot, this->Corners))
    {
      continue;
    }
    const Vector3 weights = weightsAt(this->Corners.row(row.Triangle), foot.Barycentric, normals);
    const double residual = row.Residual;
    const double weight = samples.weight(row.Sample);
    Index place = SumsOfFairing * row.Triangle;
    for (int k = 0; k < 3; ++k)
    {
      for (int l = k; l < 3; ++l)
      {
        sums.add(place++, weight * weights[k] * weights[l]);
      }
      sums.add(place++, weight * weights[k] * residual);
    }
    sums.add(place++, weight * residual * residual);
    sums.add(place++, weight);
    sums.add(place, 1.0);
  }
  sums.reduce(samples.reduce());
  for (Index r = 0; r < this->Corners.rows(); ++r)
  {
    OfTriangle& own = this->Sums[r];
    Index place = SumsOfFairing * r;
    for (int k = 0; k < 3; ++k)
    {
      for (int l = k; l < 3; ++l)
      {
        own.Products[PlaceOf[k][l]] = sums[place++];
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
SampleDistances::Sum SampleDistances::sum(
  const Eigen::VectorXd& precisions, Index numberOfProbes, const Run& run) const
{
  Sum sum;
  sum.Right = Eigen::VectorXd::Zero(this->Size);
  sum.Probes = Columns::Zero(this->Size, numberOfProbes);
  const auto precisionOf = [&](Index r)
  {
    const auto ids = this->Corners.row(r);
    return (precisions[ids[0]] + precisions[ids[1]] + precisions[ids[2]]) / 3.0;
  };
  computeInBlocks(
    run, this->Corners.rows(),
    [&](Index r)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> products(
        fullMatrix(this->Sums[r].Products));
      // The symmetric root, since rounding may flip eigenvectors.
      return Eigen::Matrix3d(products.eigenvectors() *
        (precisionOf(r) * products.eigenvalues()).cwiseMax(0.0).cwiseSqrt().asDiagonal() *
        products.eigenvectors().transpose());
    },
    [&](Index r, const Eigen::Matrix3d& root)
    {
      const OfTriangle& own = this->Sums[r];
      const auto ids = this->Corners.row(r);
      const double precision = precisionOf(r);
      sum.Constant += precision * own.Constant;
      for (int k = 0; k < 3; ++k)
      {
        sum.Right[ids[k]] += precision * own.Right[k];
        for (Index p = 0; p < numberOfProbes; ++p)
        {
          const double random = randomSign(2 * ((r * NumberOfProbes + p) * 3 + k));
          for (int l = 0; l < 3; ++l)
          {
            sum.Probes(ids[l], p) += random * root(l, k);
          }
        }
      }
    });
  sum.Matrix = assembled(
    this->Corners, this->Size,
    [&](Index r, int k, int l) { return precisionOf(r) * this->Sums[r].Products[PlaceOf[k][l]]; },
    run);
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
      v.dot(fullMatrix(own.Products) * v) + factor * (own.Constant - 2.0 * v.dot(own.Right));
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
CurvatureChange::CurvatureChange(const Mesh& mesh, const Points& normals, const Run& run)
  : Corners(mesh.Triangles)
  , Places(lowered(mesh, normals))
{
  const Index size = this->Places.rows();
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(size);
  Points cotangents(this->Corners.rows(), 3); // halves of those of the angle at each corner
  computeInBlocks(
    run, this->Corners.rows(),
    [&](Index r)
    {
      const auto ids = this->Corners.row(r);
      const double area = areaVector(this->Places, this->Corners, r).norm();
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 corner = this->Places.row(ids[k]);
        const double cosine = (Vector3(this->Places.row(ids[next(k)])) - corner)
                                .dot(Vector3(this->Places.row(ids[previous(k)])) - corner);
        constexpr double smallest = 1e-30;
        cotangents(r, k) = 0.5 *
          std::clamp(cosine / std::max(2.0 * area, smallest), -MaximumCotangent, MaximumCotangent);
      }
      return area;
    },
    [&](Index r, double area)
    {
      for (int k = 0; k < 3; ++k)
      {
        areas[this->Corners(r, k)] += area / 3.0;
      }
    });
  areas = areas.cwiseMax(MinimumArea * areas.mean());
  this->SmallestArea = MinimumArea * areas.mean();
  this->Change = assembled(
    this->Corners, size,
    [&](Index r, int k, int l) { return k == l ? 0.0 : cotangents(r, 3 - k - l); }, run);
  // Divide the weights of edges by areas, and set the diagonal.
  this->Curvatures.resize(size);
  constexpr Index blockSize = 1 << 9;
  forBlocks(run, size, blockSize,
    [&](Index begin, Index end)
    {
      for (Index j = begin; j < end; ++j)
      {
        double* diagonal = nullptr;
        double sum = 0.0;
        Vector3 laplacian = Vector3::Zero();
        for (SparseMatrix::InnerIterator entry(this->Change, j); entry; ++entry)
        {
          const Index i = entry.row();
          if (i == j)
          {
            diagonal = &entry.valueRef();
            continue;
          }
          const double share = entry.value() / areas[j];
          sum += share;
          laplacian += share * Vector3(this->Places.row(j) - this->Places.row(i));
          entry.valueRef() = -(entry.value() / areas[i]);
        }
        if (diagonal)
        {
          *diagonal = sum;
        }
        this->Curvatures[j] = laplacian.dot(Vector3(normals.row(j)));
      }
    });
}

//------------------------------------------------------------------------------
Eigen::Matrix3d CurvatureChange::slopesOf(Index r) const
{
  const auto ids = this->Corners.row(r);
  const Vector3 p = this->Places.row(ids[0]), q = this->Places.row(ids[1]),
                s = this->Places.row(ids[2]);
  Vector3 normal = (q - p).cross(s - p);
  const double area = 0.5 * normal.norm();
  normal.stableNormalize();
  Eigen::Matrix3d slopes;
  slopes << normal.cross(s - q), normal.cross(p - s), normal.cross(q - p);
  return slopes * (0.5 / std::sqrt(std::max(area, this->SmallestArea)));
}

//------------------------------------------------------------------------------
Tensors CurvatureChange::squaresOf(const Eigen::VectorXd& curvatures, const Run& run) const
{
  Tensors squares = Tensors::Zero(curvatures.size(), 6);
  computeInBlocks(
    run, this->Corners.rows(),
    [&](Index r)
    {
      const auto ids = this->Corners.row(r);
      return Vector3(this->slopesOf(r) *
        Vector3(curvatures[ids[0]], curvatures[ids[1]], curvatures[ids[2]]) / std::sqrt(3.0));
    },
    [&](Index r, const Vector3& g)
    {
      for (int k = 0; k < 3; ++k)
      {
        for (int d = 0; d < 3; ++d)
        {
          squares(this->Corners(r, k), d) += g[d] * g[d];
          squares(this->Corners(r, k), 3 + d) += g[next(d)] * g[previous(d)];
        }
      }
    });
  return squares;
}

//------------------------------------------------------------------------------
Tensors CurvatureChange::squaresAt(const Eigen::VectorXd& displacements, const Run& run) const
{
  return this->squaresOf(this->Curvatures + this->Change * displacements, run);
}

//------------------------------------------------------------------------------
Tensors CurvatureChange::homogeneousSquaresAt(
  const Eigen::VectorXd& deviations, const Run& run) const
{
  return this->squaresOf(this->Change * deviations, run);
}

//------------------------------------------------------------------------------
CurvatureChange::Energy CurvatureChange::energy(const Tensors& variances,
  const std::vector<bool>& sharp, Index numberOfProbes, const Run& run) const
{
  const Index size = variances.rows();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size);
  Columns probes = Columns::Zero(size, numberOfProbes);
  std::vector<SymmetricMatrix> products(this->Corners.rows());
  using Rows = Eigen::Matrix<double, 2, 3>;
  computeInBlocks(
    run, this->Corners.rows(),
    [&](Index r)
    {
      const auto ids = this->Corners.row(r);
      const Eigen::Matrix3d slopes = this->slopesOf(r);
      Eigen::Matrix<double, 1, 6> mean = Eigen::Matrix<double, 1, 6>::Zero();
      for (const int id : ids)
      {
        mean += variances.row(id) / 3.0;
      }
      const Eigen::Matrix<double, 3, 2> frame = frameOf(slopes);
      const Eigen::Matrix2d root = inverseRoot(frame.transpose() * fullTensor(mean) * frame);
      const bool across = sharp[ids[0]] || sharp[ids[1]] || sharp[ids[2]];
      return Rows((across ? ShareOfSharp : 1.0) * root * frame.transpose() * slopes);
    },
    [&](Index r, const Rows& rows)
    {
      const auto ids = this->Corners.row(r);
      const Eigen::Matrix3d own = rows.transpose() * rows;
      const Vector3 pulls =
        own * Vector3(this->Curvatures[ids[0]], this->Curvatures[ids[1]], this->Curvatures[ids[2]]);
      for (int k = 0; k < 3; ++k)
      {
        force[ids[k]] += pulls[k];
        for (int l = k; l < 3; ++l)
        {
          products[r][PlaceOf[k][l]] = own(k, l);
        }
      }
      for (Index p = 0; p < numberOfProbes; ++p)
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
    });
  Energy energy;
  energy.Change = &this->Change;
  energy.Differences = assembled(
    this->Corners, size, [&](Index r, int k, int l) { return products[r][PlaceOf[k][l]]; }, run);
  energy.Force = this->Change.transpose() * force;
  energy.Probes = this->Change.transpose() * probes;
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

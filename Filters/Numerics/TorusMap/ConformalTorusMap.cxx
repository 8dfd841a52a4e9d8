#include "TorusMap/ConformalTorusMap.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Linear/EdgeWeights.h"
#include "Measure/Distortion.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"
#include "TorusMap/ClosedForms.h"
#include "TorusMap/FormEquations.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
using Vector2 = Eigen::Vector2d;
using Corners2 = Eigen::Matrix<double, 3, 2>;

// Positions on the torus are multiples of this number, so that differences are exact.
constexpr double Resolution = 0x1p-50;

void requireTorus(const Mesh& mesh, const Run& run)
{
  const GenusZeroReport report =
    checkGenusZero(mesh.Triangles, mesh.Positions.rows(), PointView(), run);
  if (report.numberOfHandles() != 1 || !report.InconsistentEdges.empty() ||
    !report.IsolatedPoints.empty() || !report.DegenerateTriangles.empty())
  {
    throw std::invalid_argument(
      "the surface must be closed, manifold, in one piece, consistently oriented and of genus 1");
  }
}

// Exact sign of the cross product of two vectors of multiples of Resolution. Rounding preserves the
// sequence of the two products. If they are rounded to equal numbers, their rounding errors are
// compared.
int orientation(const Vector2& a, const Vector2& b)
{
  const double left = a.x() * b.y(), right = a.y() * b.x();
  const double difference =
    left != right ? left - right : std::fma(a.x(), b.y(), -left) - std::fma(a.y(), b.x(), -right);
  return difference > 0.0 ? 1 : difference < 0.0 ? -1 : 0;
}

class Mapper
{
public:
  Mapper(const Mesh& mesh, const Run& run)
    : Places(mesh.Positions)
    , Triangles(mesh.Triangles)
  {
    this->Across = sidesAcross(this->Triangles, this->Places.rows());
    run.report(0.4);
    this->Equations.Triangles = this->Triangles;
    this->Equations.Forms = integerForms(this->Triangles, this->Places.rows(), this->Across);
    this->Equations.Weights = boundedWeights(this->Places, this->Triangles);
  }

  ConformalTorusMapResult map(const Run& run)
  {
    // The second and later attempts are rare. Each has half of the remaining progress.
    double begin = 0.8;
    Columns values = this->Equations.solve(this->Places, run.part(0.0, begin));
    ConformalTorusMapResult result;
    result.NumberOfSolves = 1;
    this->chooseTorus(values, result);
    this->place(values, result);
    const int last = 5;
    std::vector<char> isNear;
    for (int round = 0; round <= last && result.NumberOfFlippedTriangles > 0; ++round)
    {
      this->addFlipped(1 << round, isNear);
      const double end = 0.5 * (1.0 + begin);
      FormEquations positive = this->Equations;
      this->raiseWeights(isNear, round == last, positive.Weights);
      Columns other = positive.solve(this->Places, run.part(begin, end));
      begin = end;
      ++result.NumberOfSolves;
      this->place(other, result);
    }
    this->measure(result);
    return result;
  }

private:
  // Find the torus, and express forms and values by its reduced periods.
  void chooseTorus(Columns& values, ConformalTorusMapResult& result)
  {
    double degree = 0.0; // area in the plane of the coordinates, 1 or -1
    for (int t = 0; t < this->Triangles.rows(); ++t)
    {
      degree += 0.5 *
        cross(
          this->Equations.difference(values, 3 * t), this->Equations.difference(values, 3 * t + 1));
    }
    if (degree < 0.0)
    {
      const Eigen::Vector2i mirror(1, -1);
      this->change(mirror.asDiagonal(), values);
    }
    const Eigen::Matrix2d energy = this->Equations.energyMatrix(values);
    if (!(energy.determinant() > 0.0))
    {
      throw NumericalFailure("the harmonic forms of the torus are not independent");
    }
    const ReducedBasis basis = reduceBasis(energy.inverse());
    result.Torus = basis.Torus;
    this->change(basis.Change, values);
    if (this->isTurned(values))
    {
      this->change(-Eigen::Matrix2i::Identity(), values);
    }
  }

  void change(const Eigen::Matrix2i& matrix, Columns& values)
  {
    values = (values * matrix.cast<double>().transpose()).eval();
    this->Equations.Forms = (this->Equations.Forms * matrix.transpose()).eval();
  }

  // Whether a half turn makes the gradients turn counter-clockwise, seen from the positive side of
  // a coordinate axis. The moment of a coordinate u is the integral of the cross product of
  // position and gradient of u. Of both moments and three axes, the largest number decides.
  bool isTurned(const Columns& values) const
  {
    Eigen::Matrix<double, 3, 2> moments = Eigen::Matrix<double, 3, 2>::Zero();
    for (int t = 0; t < this->Triangles.rows(); ++t)
    {
      const auto ids = this->Triangles.row(t);
      const Vector3 a = this->Places.row(ids[0]), b = this->Places.row(ids[1]),
                    c = this->Places.row(ids[2]);
      const Vector3 normal = twiceAreaVector(a, b, c), center = (a + b + c) / 3.0;
      if (!(normal.norm() > 0.0))
      {
        continue;
      }
      const Vector2 toB = this->Equations.difference(values, 3 * t),
                    toC = toB + this->Equations.difference(values, 3 * t + 1);
      const Vector3 unit = normal.normalized();
      for (int i = 0; i < 2; ++i)
      {
        // The area times the gradient.
        const Vector3 gradient = 0.5 * unit.cross(toB[i] * (a - c) + toC[i] * (b - a));
        moments.col(i) += center.cross(gradient);
      }
    }
    Index row = 0, column = 0;
    moments.cwiseAbs().maxCoeff(&row, &column);
    return moments(row, column) < 0.0;
  }

  // Set the positions, and count the flipped triangles.
  void place(Columns& values, ConformalTorusMapResult& result)
  {
    const Index size = values.rows();
    const Eigen::RowVector2d origin = values.row(0);
    Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> turns(size, 2);
    result.Positions.resize(size, 2);
    for (Index v = 0; v < size; ++v)
    {
      for (int i = 0; i < 2; ++i)
      {
        const double value = std::round((values(v, i) - origin[i]) / Resolution) * Resolution;
        const double whole = std::floor(value);
        turns(v, i) = static_cast<int>(whole);
        // A second rounding is exact, since it removes leading bits only.
        result.Positions(v, i) = value - whole;
      }
    }
    this->Turns = turns;
    this->Flipped.clear();
    for (int t = 0; t < this->Triangles.rows(); ++t)
    {
      const Corners2 corners = this->corners(result.Positions, t);
      if (orientation((corners.row(1) - corners.row(0)).transpose(),
            (corners.row(2) - corners.row(0)).transpose()) <= 0)
      {
        this->Flipped.push_back(t);
      }
    }
    result.NumberOfFlippedTriangles = static_cast<Index>(this->Flipped.size());
  }

  // Corners of a triangle in the plane, by the forms.
  Corners2 corners(const TorusPositions& positions, int t) const
  {
    Corners2 result;
    Eigen::RowVector2i turns = Eigen::RowVector2i::Zero();
    for (int k = 0; k < 3; ++k)
    {
      result.row(k) = positions.row(this->Triangles(t, k)) + turns.cast<double>();
      const int side = 3 * t + k;
      turns += this->Equations.Forms.row(side) + this->Turns.row(this->Equations.to(side)) -
        this->Turns.row(this->Equations.from(side));
    }
    return result;
  }

  // Mark the vertices of flipped triangles, and some rings of neighbors around them.
  void addFlipped(int rings, std::vector<char>& isNear) const
  {
    const Adjacency neighbors = vertexNeighbors(this->Triangles, this->Places.rows());
    isNear.resize(this->Places.rows(), 0);
    std::vector<int> front, further;
    for (const int t : this->Flipped)
    {
      for (int k = 0; k < 3; ++k)
      {
        isNear[this->Triangles(t, k)] = 1;
        front.push_back(this->Triangles(t, k));
      }
    }
    for (int i = 0; i < rings; ++i)
    {
      further.clear();
      for (const int v : front)
      {
        for (const int* u = neighbors.begin(v); u != neighbors.end(v); ++u)
        {
          if (!isNear[*u])
          {
            isNear[*u] = 1;
            further.push_back(*u);
          }
        }
      }
      front.swap(further);
    }
  }

  // Raise negative weights of edges at marked vertices, or of all edges, to a positive number.
  void raiseWeights(
    const std::vector<char>& isNear, bool everywhere, std::vector<double>& weights) const
  {
    constexpr double minimum = 0.05;
    for (int side = 0; side < static_cast<int>(this->Across.size()); ++side)
    {
      const int across = this->Across[side];
      if (side < across && weights[side] + weights[across] < minimum &&
        (everywhere || isNear[this->Equations.from(side)] || isNear[this->Equations.to(side)]))
      {
        weights[side] = weights[across] = 0.5 * minimum;
      }
    }
  }

  // Measure energy and quasi-conformal errors.
  void measure(ConformalTorusMapResult& result) const
  {
    const Eigen::Matrix2d periods = result.Torus.periods();
    Eigen::Matrix2d energy = Eigen::Matrix2d::Zero();
    for (int side = 0; side < static_cast<int>(this->Across.size()); ++side)
    {
      const Corners2 ends = this->corners(result.Positions, side / 3);
      const Vector2 d = (ends.row(next(side % 3)) - ends.row(side % 3)).transpose();
      energy += this->Equations.Weights[side] * d * d.transpose();
    }
    result.Energy = 0.5 * (periods.transpose() * periods * energy).trace();
    std::vector<double> errors;
    double sum = 0.0;
    for (int t = 0; t < this->Triangles.rows(); ++t)
    {
      const Eigen::Matrix<double, 3, 2> plane =
        this->corners(result.Positions, t) * periods.transpose();
      std::array<Vector3, 3> before, after;
      for (int k = 0; k < 3; ++k)
      {
        before[k] = this->Places.row(this->Triangles(t, k));
        after[k] = Vector3(plane(k, 0), plane(k, 1), 0.0);
      }
      const double error = quasiConformalError(before, after);
      if (std::isfinite(error))
      {
        errors.push_back(error);
        sum += error;
      }
    }
    if (!errors.empty())
    {
      result.MeanQuasiConformalError = sum / static_cast<double>(errors.size());
      const auto at = errors.begin() + static_cast<std::ptrdiff_t>(0.95 * (errors.size() - 1));
      std::nth_element(errors.begin(), at, errors.end());
      result.QuasiConformalError95 = *at;
    }
  }

  const Points& Places;
  const conformal::Triangles& Triangles;
  std::vector<int> Across;
  FormEquations Equations;
  Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> Turns; // whole part of each coordinate
  std::vector<int> Flipped;
};
}

//------------------------------------------------------------------------------
ConformalTorusMapResult mapToTorus(const Mesh& mesh, const Run& run)
{
  Steps steps(run, { 0.15, 0.2, 0.65 }); // check, forms, map
  const Mesh unit = { inUnitBox(mesh.Positions), mesh.Triangles };
  requireTorus(unit, steps.next());
  Mapper mapper(unit, steps.next());
  ConformalTorusMapResult result = mapper.map(steps.next());
  const StringConstants strings = harmonicStrings(unit.Positions, unit.Triangles);
  result.NumberOfNegativeStringConstants = strings.NumberOfNegative;
  result.NumberOfInfiniteStringConstants = strings.NumberOfInfinite;
  run.report(1.0);
  return result;
}
}

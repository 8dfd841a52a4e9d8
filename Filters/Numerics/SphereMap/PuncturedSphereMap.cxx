#include "SphereMap/PuncturedSphereMap.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Linear/HarmonicExtension.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
using Complex = std::complex<double>;
using Plane = Eigen::VectorXcd;

constexpr Index TrianglesPerMatrix = 1 << 12;
constexpr int MaximumPowers = 5;
// Fraction of the vertices, the outermost ones, that belong to the cap around the puncture
constexpr double CapShare = 0.35;
// Maximum squared Beltrami coefficient caused by the puncture; larger ones are caused by the mesh
constexpr double MaximumSquared = 0.25;
// Maximum radius of the fit, divided by the radius of the border of the cap
constexpr double Fit = 1.4;

constexpr double WorstIrregularity = 1e6;

// Compute the irregularity of a triangle. It is 0 if the triangle is equilateral.
double irregularity(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  const double twiceArea = (b - a).cross(c - a).norm();
  return sides < WorstIrregularity * twiceArea ? sides / (2.0 * std::sqrt(3.0) * twiceArea) - 1.0
                                               : WorstIrregularity;
}

// Map a triangle to its own plane, with its first corner at 0.
std::array<Complex, 2> flattened(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 base = b - a, side = c - a;
  const double length = base.norm();
  return { Complex(length),
    Complex(base.dot(side), base.cross(side).norm()) / std::max(length, 1e-300) };
}

// Operations on the triangles of the map to the plane.
class PlaneMap
{
public:
  // With `isHalf`, the map is the upper half of one that is symmetric to the real axis.
  PlaneMap(
    const Points& points, const Triangles& triangles, const Run& run, Plane& map, bool isHalf)
    : IsHalf(isHalf)
    , Places(points)
    , Triangles(triangles)
    , Threads(run.unwatched())
    , Map(map)
    , VertexAreas(vertexAreas(points, triangles))
  {
    this->VertexAreas /= this->VertexAreas.sum();
  }

  // Move the center of the map to 0, and scale the map so that about half of the surface is mapped
  // to each hemisphere. The mean of |z| on the sphere is then pi/2.
  void normalize()
  {
    const Complex mean = std::conj(this->Map.dot(this->VertexAreas.cast<Complex>()));
    this->Map.array() -= this->IsHalf ? Complex(mean.real()) : mean;
    const double size = this->Map.cwiseAbs().dot(this->VertexAreas) / (2.0 * std::atan(1.0));
    if (!(size > 0.0 && std::isfinite(size)))
    {
      throw NumericalFailure("all points of the surface coincide");
    }
    this->Map /= size;
  }

  // Add sum d_k conj(z)^k, k = 1 ... powers, so that the mean of the Beltrami coefficients over the
  // sphere vanishes. Only triangles up to a radius are used; `robustly` excludes misshapen ones.
  void correct(int powers, double radius, bool robustly)
  {
    // Unused powers get coefficients of 0.
    using Matrix = Eigen::Matrix<Complex, MaximumPowers, MaximumPowers>;
    using Vector = Eigen::Matrix<Complex, MaximumPowers, 1>;
    const Index blocks = (this->Triangles.rows() + TrianglesPerMatrix - 1) / TrianglesPerMatrix;
    std::vector<Matrix> matrices(blocks, Matrix::Zero());
    std::vector<Vector> sides(blocks, Vector::Zero());
    forBlocks(this->Threads, this->Triangles.rows(), TrianglesPerMatrix,
      [&](Index begin, Index end)
      {
        Matrix& matrix = matrices[begin / TrianglesPerMatrix];
        Vector& side = sides[begin / TrianglesPerMatrix];
        for (Index r = begin; r < end; ++r)
        {
          const auto [z, weight, wanted] = this->beltrami(r);
          const double maximum = robustly ? MaximumSquared : 1.0; // flipped above 1
          if (!(weight > 0.0) || std::norm(z) > radius * radius || !(std::norm(wanted) < maximum))
          {
            continue;
          }
          Vector row;
          Complex power = 1.0;
          for (int k = 0; k < powers; ++k)
          {
            row[k] = static_cast<double>(k + 1) * power;
            power *= std::conj(z) / radius;
          }
          for (int k = 0; k < powers; ++k)
          {
            const Complex left = weight * std::conj(row[k]);
            for (int l = 0; l < powers; ++l)
            {
              matrix(k, l) += left * row[l];
            }
            side[k] += weight * wanted * std::conj(row[k]);
          }
        }
      });
    Matrix matrix = Matrix::Zero();
    Vector side = Vector::Zero();
    for (Index block = 0; block < blocks; ++block)
    {
      matrix += matrices[block];
      side += sides[block];
    }
    if (this->IsHalf) // the other half adds the conjugates
    {
      matrix = matrix.real().eval().cast<Complex>();
      side = side.real().eval().cast<Complex>();
    }
    matrix.diagonal().array() += 1e-12;
    const Vector found = matrix.ldlt().solve(side);
    if (!found.allFinite())
    {
      throw NumericalFailure("there is no triangle left to correct the map with");
    }
    for (Index v = 0; v < this->Map.size(); ++v)
    {
      const Complex z = std::conj(this->Map[v]);
      if (std::norm(z) > radius * radius)
      {
        continue;
      }
      Complex power = z;
      for (int k = 0; k < powers; ++k)
      {
        this->Map[v] += found[k] * power;
        power *= z / radius;
      }
    }
  }

private:
  struct Beltrami
  {
    Complex Center; // center of the triangle in the plane
    double Area;    // approximate area of the triangle on the sphere
    Complex Wanted; // derivative by conj(z) of the correction that makes the triangle conformal
  };

  // Compute the derivatives of z by the triangle's own plane and by its conjugate, up to a common
  // factor.
  Beltrami beltrami(Index r) const
  {
    const int a = this->Triangles(r, 0), b = this->Triangles(r, 1), c = this->Triangles(r, 2);
    const auto [base, side] =
      flattened(this->Places.row(a), this->Places.row(b), this->Places.row(c));
    const Complex p = this->Map[b] - this->Map[a], q = this->Map[c] - this->Map[a];
    const Complex byPlane = p * std::conj(side) - q * std::conj(base);
    const Complex byConjugate = base * q - side * p;
    const Complex center = (this->Map[a] + this->Map[b] + this->Map[c]) / 3.0;
    const double stretch = 1.0 / (1.0 + std::norm(center));
    const double area = std::abs(p.real() * q.imag() - p.imag() * q.real());
    const double size = std::norm(byPlane);
    return { center, size > 0.0 ? area * stretch * stretch : 0.0,
      size > 0.0 ? byConjugate * byPlane / size : Complex(0.0) };
  }

  const bool IsHalf;
  const Points& Places;
  const conformal::Triangles& Triangles;
  const Run Threads; // threads without progress reports
  Plane& Map;
  Eigen::VectorXd VertexAreas;
};

// Extend real parts (column 0) and imaginary parts (column 1) harmonically to the free vertices. On
// the border of a sheet, imaginary parts are given. `border` is empty for a closed surface.
void extend(const EdgeWeights& strings, const Points& points, const std::vector<int>& free,
  const std::vector<char>& border, Columns& values, const Run& run)
{
  if (border.empty())
  {
    extendHarmonically(strings, points, free, values, run);
    return;
  }
  std::vector<int> inside;
  std::copy_if(
    free.begin(), free.end(), std::back_inserter(inside), [&](int v) { return !border[v]; });
  Columns real = values.col(0), imaginary = values.col(1);
  extendHarmonically(strings, points, free, real, run.part(0.0, 0.5));
  extendHarmonically(strings, points, inside, imaginary, run.part(0.5, 1.0));
  values << real, imaginary;
}

// Return the radius of the border of the cap.
double capRadius(const Plane& map)
{
  std::vector<double> radii(map.size());
  for (Index v = 0; v < map.size(); ++v)
  {
    radii[v] = std::abs(map[v]);
  }
  const auto place = radii.begin() + static_cast<Index>((1.0 - CapShare) * map.size());
  std::nth_element(radii.begin(), place, radii.end());
  return std::max(1.0, *place);
}

// Map a surface without one triangle to the sphere by the plane; see punctureToSphere(). The border
// of a sheet is mapped to the real axis. `held` are the corners of the triangle, and `values` their
// positions.
Points planeToSphere(const Points& points, const Triangles& triangles, const EdgeWeights& strings,
  const std::vector<char>& border, const Eigen::RowVector3i& held, Columns& values, const Run& run)
{
  const Index size = points.rows();
  // Equations, correction, equations of about a third of the vertices, and their set-up.
  Steps steps(run, { 0.68, 0.1, 0.04, 0.17, 0.01 });
  std::vector<int> free;
  for (int v = 0; v < size; ++v)
  {
    if (v != held[0] && v != held[1] && v != held[2])
    {
      free.push_back(v);
    }
  }
  extend(strings, points, free, border, values, steps.next());
  const Run correcting = steps.next();

  Plane map = values.col(0).cast<Complex>() + Complex(0.0, 1.0) * values.col(1).cast<Complex>();
  PlaneMap plane(points, triangles, run, map, !border.empty());
  plane.normalize();
  constexpr double everywhere = 1e30;
  constexpr int rounds = 6, roundsForAll = 3;
  for (int i = 0; i < rounds; ++i)
  {
    plane.correct(1, everywhere, i >= roundsForAll);
    plane.normalize();
    correcting.report((i + 1.0) / rounds);
  }
  steps.next();
  const double radius = capRadius(map);
  free.clear();
  for (int v = 0; v < size; ++v)
  {
    if (std::abs(map[v]) > radius)
    {
      free.push_back(v);
    }
  }
  plane.correct(MaximumPowers, Fit * radius, true);
  for (Index v = 0; v < size; ++v)
  {
    const Complex w = 1.0 / map[v];
    values.row(v) << w.real(), w.imag();
  }
  extend(strings, points, free, border, values, steps.next());
  steps.next();

  Points positions(size, 3);
  for (Index v = 0; v < size; ++v)
  {
    const Complex z = map[v];
    const double square = std::norm(z);
    positions.row(v) << 2.0 * z.real(), 2.0 * z.imag(), 1.0 - square;
    positions.row(v) /= 1.0 + square;
  }
  for (int v : free)
  {
    const Eigen::RowVector2d w = values.row(v);
    const double square = w.squaredNorm();
    positions.row(v) << 2.0 * w[0], -2.0 * w[1], square - 1.0;
    positions.row(v) /= 1.0 + square;
  }
  if (!positions.allFinite())
  {
    throw NumericalFailure("the conformal map has coordinates that are not finite");
  }
  return positions;
}
}

//------------------------------------------------------------------------------
Index choosePuncture(const Points& points, const Triangles& triangles)
{
  const Index size = triangles.rows();
  const auto corner = [&](Index r, int k) { return Vector3(points.row(triangles(r, k))); };
  std::vector<double> irregularities(size), aroundVertex(points.rows(), 0.0);
  std::vector<int> valences(points.rows(), 0);
  std::vector<Vector3> middles(size);
  Vector3 center = Vector3::Zero();
  double area = 0.0;
  for (Index r = 0; r < size; ++r)
  {
    const Vector3 a = corner(r, 0), b = corner(r, 1), c = corner(r, 2);
    irregularities[r] = irregularity(a, b, c);
    middles[r] = (a + b + c) / 3.0;
    const double own = (b - a).cross(c - a).norm();
    center += own * middles[r];
    area += own;
    for (int k = 0; k < 3; ++k)
    {
      aroundVertex[triangles(r, k)] += irregularities[r];
      ++valences[triangles(r, k)];
    }
  }
  center = area > 0.0 ? Vector3(center / area) : middles[0];
  double radius = 0.0;
  for (const Vector3& middle : middles)
  {
    radius += (middle - center).norm() / static_cast<double>(size);
  }
  Index best = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (Index r = 0; r < size; ++r)
  {
    double score = irregularities[r];
    for (int k = 0; k < 3; ++k)
    {
      score += aroundVertex[triangles(r, k)] / (3.0 * valences[triangles(r, k)]);
    }
    constexpr double farness = 0.3;
    score += farness * std::max(0.0, (middles[r] - center).norm() / std::max(radius, 1e-300) - 1.0);
    if (score < minimum)
    {
      minimum = score;
      best = r;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
Index choosePuncture(
  const Points& points, const Triangles& triangles, const Points& spherePositions)
{
  Index best = 0;
  double maximum = -1.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const auto corner = [&](const Points& of, int k) { return Vector3(of.row(triangles(r, k))); };
    const auto twiceArea = [&](const Points& of)
    {
      const Vector3 a = corner(of, 0);
      return (corner(of, 1) - a).cross(corner(of, 2) - a).norm();
    };
    const double irregular = irregularity(corner(points, 0), corner(points, 1), corner(points, 2));
    if (irregular == WorstIrregularity)
    {
      continue; // the triangle has no area
    }
    const double score =
      std::pow(1.0 + irregular, -4.0) * twiceArea(spherePositions) / twiceArea(points);
    if (score > maximum)
    {
      maximum = score;
      best = r;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
Points punctureToSphere(const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, Index puncture, const Run& run)
{
  const Eigen::RowVector3i held = triangles.row(puncture);
  const auto [base, side] =
    flattened(points.row(held[0]), points.row(held[1]), points.row(held[2]));
  Columns values = Columns::Zero(points.rows(), 2);
  values.row(held[1]) << base.real(), 0.0;
  values.row(held[2]) << side.real(), -side.imag(); // mirrored: all other vertices lie inside
  return planeToSphere(points, triangles, strings, {}, held, values, run);
}

//------------------------------------------------------------------------------
Index chooseBorderPuncture(
  const Points& points, const Triangles& triangles, const std::vector<char>& border)
{
  // Angles of the sheet at its vertices: pi where the border is straight.
  std::vector<double> angles(points.rows(), 0.0), irregularities(points.rows(), 0.0);
  std::vector<int> valences(points.rows(), 0);
  const auto corner = [&](Index r, int k) { return Vector3(points.row(triangles(r, k))); };
  const auto irregularityOf = [&](Index r)
  { return irregularity(corner(r, 0), corner(r, 1), corner(r, 2)); };
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 u = corner(r, next(k)) - corner(r, k),
                    v = corner(r, previous(k)) - corner(r, k);
      const int id = triangles(r, k);
      angles[id] += std::atan2(u.cross(v).norm(), u.dot(v));
      irregularities[id] += irregularityOf(r);
      ++valences[id];
    }
  }
  Index best = -1;
  double minimum = std::numeric_limits<double>::infinity();
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    int onBorder = 0;
    double score = irregularityOf(r);
    for (int k = 0; k < 3; ++k)
    {
      const int id = triangles(r, k);
      score += irregularities[id] / (3.0 * valences[id]);
      if (border[id])
      {
        ++onBorder;
        score += std::abs(angles[id] - Pi);
      }
    }
    if (onBorder == 2 && score < minimum)
    {
      minimum = score;
      best = r;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
Points punctureToHemisphere(const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, const std::vector<char>& border, Index puncture, const Run& run)
{
  Eigen::RowVector3i held = triangles.row(puncture);
  while (border[held[2]]) // let the first two corners be on the border
  {
    held = Eigen::RowVector3i(held[1], held[2], held[0]);
  }
  // The rest of the sheet is inside of the triangle, between the border on the real axis and the
  // third corner.
  const auto [base, side] =
    flattened(points.row(held[1]), points.row(held[0]), points.row(held[2]));
  Columns values = Columns::Zero(points.rows(), 2);
  values.row(held[0]) << base.real(), 0.0;
  values.row(held[2]) << side.real(), side.imag();
  const Points positions = planeToSphere(points, triangles, strings, border, held, values, run);
  Points turned(positions.rows(), 3);
  turned << positions.col(0), -positions.col(2), positions.col(1);
  return turned;
}
}

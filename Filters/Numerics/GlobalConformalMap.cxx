#include "GlobalConformalMap.h"

#include "EdgeWeights.h"
#include "FlipRepair.h"
#include "GenusZeroCheck.h"
#include "GuYauMap.h"
#include "MoebiusTransform.h"
#include "ProgressiveSphereMap.h"
#include "PuncturedSphereMap.h"
#include "SphereOrientation.h"
#include "SurfaceShapes.h"
#include "UnitBox.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index SmallMesh = 20000; // vertices; all of these are relaxed
constexpr int SweepsOfSmallMesh = 10;
constexpr int SweepsOfMisshapen = 20;
constexpr int RingsAround = 4;           // misshapen triangles
constexpr double Misshapen = 1.5;        // Dirichlet energy over area, 1 being conformal
constexpr double LargestBadShare = 0.02; // of the triangles, to be repaired
constexpr double LimbShare = 0.01;       // of the mean area ratio, around a bad puncture

std::vector<Vector3> toVector(const Points& points)
{
  std::vector<Vector3> result(points.rows());
  for (Index v = 0; v < points.rows(); ++v)
  {
    result[v] = points.row(v);
  }
  return result;
}

Points toPoints(const std::vector<Vector3>& vectors)
{
  Points result(static_cast<Index>(vectors.size()), 3);
  for (Index v = 0; v < result.rows(); ++v)
  {
    result.row(v) = vectors[v];
  }
  return result;
}

class RobustMap
{
public:
  RobustMap(const Points& places, const Triangles& triangles, const ParallelFor& parallelFor,
    const Progress& progress)
    : Places(places)
    , Faces(triangles)
    , Threads(parallelFor)
    , Callback(progress)
    , Shapes(places, triangles)
    , Angles(places, triangles, SurfaceShapes::Weight::RegularArea)
    , Rings(triangles, places.rows())
    , Areas(vertexAreas(places, triangles))
  {
    report(progress, 0.06);
    Points cotangents(triangles.rows(), 3);
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      const auto& quarters = this->shapeOf(r).Cotangents;
      cotangents.row(r) << 4.0 * quarters[0], 4.0 * quarters[1], 4.0 * quarters[2];
    }
    this->Strings = cotangentWeights(triangles, places.rows(), cotangents);
    report(progress, 0.1);
  }

  void run(double areaBalance, GlobalConformalMapResult& result)
  {
    if (areaBalance > 0.0)
    {
      this->progressive(areaBalance, result, partOf(this->Callback, 0.1, 1.0));
    }
    else if (!this->conformal(result))
    {
      this->progressive(0.0, result, partOf(this->Callback, 0.7, 1.0));
    }
    if (result.Tier == GlobalConformalTier::Progressive)
    {
      this->place(result.Positions, false);
    }
  }

private:
  // Moebius transforms leave angles alone, rotations areas, too.
  void place(Points& positions, bool center) const
  {
    if (center)
    {
      centeringTransform(positions, this->Areas).applyTo(positions);
    }
    const Eigen::RowVector3d middle = this->Areas.transpose() * this->Places / this->Areas.sum();
    const Points directions = this->Places.rowwise() - middle;
    MoebiusTransform turn;
    turn.Rotation = closestRotation(positions, directions, this->Areas);
    turn.applyTo(positions);
  }

  SourceTriangle shapeOf(Index r) const
  {
    return this->Shapes.triangle(this->Faces(r, 0), this->Faces(r, 1), this->Faces(r, 2));
  }

  // False if no such map fits into numbers.
  bool conformal(GlobalConformalMapResult& result)
  {
    try
    {
      const Index first = choosePuncture(this->Places, this->Faces);
      Points positions = this->solve(first, result, partOf(this->Callback, 0.1, 0.4));
      bool good = this->improve(positions, result, partOf(this->Callback, 0.4, 0.45));
      if (!good || this->areaRatioAround(positions, first) < LimbShare)
      {
        const Index second = this->betterPuncture(positions);
        Points others = this->solve(second, result, partOf(this->Callback, 0.45, 0.65));
        GlobalConformalMapResult ofOthers = result;
        ofOthers.Tier = GlobalConformalTier::Harmonic;
        const bool othersGood = this->improve(others, ofOthers, partOf(this->Callback, 0.65, 0.7));
        if (othersGood && (!good || this->energyOf(others) < this->energyOf(positions)))
        {
          good = true;
          positions = others;
          result = ofOthers;
        }
      }
      if (good)
      {
        this->place(positions, true);
        good = badTriangles(toVector(positions), this->Faces).empty();
      }
      if (good)
      {
        result.Positions = positions;
      }
      return good;
    }
    catch (const std::runtime_error&)
    {
      return false; // no solution in floating point
    }
  }

  Points solve(Index puncture, GlobalConformalMapResult& result, const Progress& progress) const
  {
    ++result.NumberOfIterations;
    Points positions =
      punctureToSphere(this->Places, this->Faces, this->Strings, puncture, this->Threads, progress);
    centeringTransform(positions, this->Areas).applyTo(positions);
    return positions;
  }

  // Takes folds out and relaxes triangles; whether none is bad in the end.
  bool improve(Points& places, GlobalConformalMapResult& result, const Progress& progress) const
  {
    std::vector<Vector3> positions = toVector(places);
    const double bad = static_cast<double>(badTriangles(positions, this->Faces).size());
    if (bad > 10.0 + LargestBadShare * static_cast<double>(this->Faces.rows()))
    {
      return false;
    }
    if (bad > 0.0)
    {
      result.Tier = GlobalConformalTier::Repaired;
      if (!repairFlips(positions, this->Places, this->Faces, this->Strings, this->Rings,
            this->Angles, partOf(progress, 0.0, 0.8)))
      {
        return false;
      }
    }
    const bool all = this->Places.rows() < SmallMesh;
    relaxVertices(positions, all ? this->allVertices() : this->misshapenVertices(positions),
      this->Rings, this->Angles, AnglesOnly, all ? SweepsOfSmallMesh : SweepsOfMisshapen,
      [&, count = Index(0)]() mutable
      {
        if (++count % 1024 == 0)
        {
          report(progress, 1.0);
        }
      });
    places = toPoints(positions);
    return true;
  }

  std::vector<int> allVertices() const
  {
    std::vector<int> ids(this->Places.rows());
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
  }

  std::vector<int> misshapenVertices(const std::vector<Vector3>& positions) const
  {
    std::vector<char> chosen(positions.size(), 0);
    for (Index r = 0; r < this->Faces.rows(); ++r)
    {
      const auto ids = this->Faces.row(r);
      const Vector3 &a = positions[ids[0]], &b = positions[ids[1]], &c = positions[ids[2]];
      const auto& cotangents = this->shapeOf(r).Cotangents;
      const double dirichlet = cotangents[0] * (c - b).squaredNorm() +
        cotangents[1] * (a - c).squaredNorm() + cotangents[2] * (b - a).squaredNorm();
      if (dirichlet > Misshapen * 0.5 * determinant(a, b, c))
      {
        chosen[ids[0]] = chosen[ids[1]] = chosen[ids[2]] = 1;
      }
    }
    std::vector<int> ids;
    for (std::size_t v = 0; v < chosen.size(); ++v)
    {
      if (chosen[v])
      {
        ids.push_back(static_cast<int>(v));
      }
    }
    for (int i = 0; i < RingsAround; ++i)
    {
      for (std::size_t j = 0, size = ids.size(); j < size; ++j)
      {
        for (int other : this->Rings[ids[j]])
        {
          if (!chosen[other])
          {
            chosen[other] = 1;
            ids.push_back(other);
          }
        }
      }
    }
    return ids;
  }

  double areaRatio(const Points& positions, Index r) const
  {
    const Vector3 a = positions.row(this->Faces(r, 0));
    return 0.5 *
      (positions.row(this->Faces(r, 1)).transpose() - a)
        .cross(positions.row(this->Faces(r, 2)).transpose() - a)
        .norm() /
      this->shapeOf(r).Area;
  }

  // The largest one of the triangle and its vertices' others.
  double areaRatioAround(const Points& positions, Index puncture) const
  {
    double largest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int v = this->Faces(puncture, k);
      std::vector<Corner> corners;
      this->Shapes.cornersOf(v, this->Rings[v], corners);
      double onSphere = 0.0, onSurface = 0.0;
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        const Vector3 a = positions.row(v), b = positions.row(corners[i].Neighbor),
                      c = positions.row(corners[(i + 1) % corners.size()].Neighbor);
        onSphere += 0.5 * (b - a).cross(c - a).norm();
        onSurface += corners[i].Source.Area;
      }
      largest = std::max(largest, onSphere / onSurface);
    }
    return largest;
  }

  // Where the sphere has much room for a regular triangle.
  Index betterPuncture(const Points& positions) const
  {
    Index best = 0;
    double greatest = -1.0;
    for (Index r = 0; r < this->Faces.rows(); ++r)
    {
      const auto& cotangents = this->shapeOf(r).Cotangents;
      const double sum = 4.0 * (cotangents[0] + cotangents[1] + cotangents[2]);
      const double regularity = std::sqrt(3.0) / sum; // 1 for an equilateral triangle
      const double score = std::pow(regularity, 4.0) * this->areaRatio(positions, r);
      if (score > greatest)
      {
        greatest = score;
        best = r;
      }
    }
    return best;
  }

  double energyOf(const Points& positions) const { return stringEnergy(this->Strings, positions); }

  // With as little more balance of areas as leaves room for every triangle. Insertions that first
  // have to make room can take a second each, so few are allowed while there is another attempt.
  void progressive(
    double leastBalance, GlobalConformalMapResult& result, const Progress& progress) const
  {
    constexpr Index fewRelaxations = 10;
    constexpr double share = 0.8; // of what is left of the progress, for each attempt
    result.Tier = GlobalConformalTier::Progressive;
    double begin = 0.0, last = -1.0;
    for (double balance : { leastBalance, 0.02, 0.05, 0.2, 0.5 })
    {
      if (balance < leastBalance || balance == last)
      {
        continue;
      }
      const double end = begin + share * (1.0 - begin);
      try
      {
        result.Positions =
          this->balanced(this->Places, balance, fewRelaxations, partOf(progress, begin, end));
        return;
      }
      catch (const std::runtime_error&)
      {
        begin = end;
        last = balance;
      }
    }
    // The surface is shapeless, or too strange: as if all triangles were equal.
    result.Positions = this->balanced(Points::Zero(this->Places.rows(), 3), 0.5,
      std::numeric_limits<Index>::max(), partOf(progress, begin, 1.0));
  }

  Points balanced(
    const Points& places, double balance, Index relaxations, const Progress& progress) const
  {
    ProgressiveSphereMapOptions options;
    options.SurfaceNeedles = QuadricCollapse::Needles::Thin;
    options.AreaBalance = balance;
    options.MaximumNumberOfRelaxations = relaxations;
    return mapToSphere(places, this->Faces, options, progress).Positions;
  }

  const Points& Places;
  const Triangles& Faces;
  const ParallelFor& Threads;
  const Progress& Callback;
  SurfaceShapes Shapes, Angles;
  VertexRings Rings;
  Eigen::VectorXd Areas;
  EdgeWeights Strings;
};

void check(const GlobalConformalMapOptions& options)
{
  if (!(options.AreaBalance >= 0.0 && options.AreaBalance <= 1.0))
  {
    throw std::invalid_argument("AreaBalance must lie in [0, 1]");
  }
  if (options.MaximumNumberOfIterations < 0)
  {
    throw std::invalid_argument("MaximumNumberOfIterations must not be negative");
  }
  if (!(options.Tolerance >= 0.0))
  {
    throw std::invalid_argument("Tolerance must be a number, at least 0");
  }
}
}

//------------------------------------------------------------------------------
GlobalConformalMapResult globalConformalMap(const Points& points, const Triangles& triangles,
  const GlobalConformalMapOptions& options, const ParallelFor& parallelFor,
  const Progress& progress)
{
  check(options);
  requireGenusZero(triangles, points.rows(), partOf(progress, 0.0, 0.02));
  const Points places = inUnitBox(points);
  GlobalConformalMapResult result;
  if (options.Method == GlobalConformalMethod::GuYau)
  {
    GuYauOptions steps;
    steps.MaximumNumberOfIterations = options.MaximumNumberOfIterations;
    steps.Tolerance = options.Tolerance;
    GuYauResult map =
      mapByGuYau(places, triangles, steps, parallelFor, partOf(progress, 0.02, 1.0));
    result.Positions = std::move(map.Positions);
    result.Energy = map.Energy;
    result.NumberOfIterations = map.NumberOfIterations;
    result.Converged = map.Converged && map.NumberOfInfiniteStringConstants == 0;
    result.NumberOfNegativeStringConstants = map.NumberOfNegativeStringConstants;
    result.NumberOfInfiniteStringConstants = map.NumberOfInfiniteStringConstants;
  }
  else
  {
    const StringConstants strings = harmonicStrings(places, triangles);
    result.NumberOfNegativeStringConstants = strings.NumberOfNegative;
    result.NumberOfInfiniteStringConstants = strings.NumberOfInfinite;
    report(progress, 0.04);
    RobustMap(places, triangles, parallelFor, progress).run(options.AreaBalance, result);
    result.Energy = stringEnergy(strings.Strings, result.Positions);
    result.Converged = true;
  }
  result.NumberOfFlippedTriangles = countFlippedTriangles(result.Positions, triangles);
  result.Converged = result.Converged && result.NumberOfFlippedTriangles == 0;
  report(progress, 1.0);
  return result;
}
}

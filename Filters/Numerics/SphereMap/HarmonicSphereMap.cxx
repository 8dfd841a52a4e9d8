#include "SphereMap/HarmonicSphereMap.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Sphere/MoebiusTransform.h"
#include "SphereMap/BoundedTriangles.h"
#include "SphereMap/FlipRepair.h"
#include "SphereMap/PuncturedSphereMap.h"
#include "SphereMap/Sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index SmallMesh = 20000; // number of vertices below which all vertices are moved
constexpr int SweepsOfSmallMesh = 10;
constexpr int SweepsOfMisshapen = 20;
constexpr int RingsAround = 4; // number of rings around misshapen triangles that are also moved
// Dirichlet energy divided by area, above which a triangle is misshapen; 1 if conformal
constexpr double Misshapen = 1.5;
// Mean of this ratio up to which a map that was repaired where it is small is conformal
constexpr double MaximumMeanDistortion = 1.1;
// Maximum fraction of bad triangles for which a repair is tried
constexpr double MaximumBadShare = 0.06;
// Minimum area ratio around a puncture; a lower ratio means that the puncture is on a limb
constexpr double LimbShare = 0.01;

// Sheet whose double is mapped. Vertices and triangles of the sheet precede those of its mirror
// image.
struct Half
{
  const Mesh& Sheet;
  const std::vector<char>& Border;
  const std::vector<int>& MirrorIds; // of the double
};

class HarmonicMapper
{
public:
  // With `half`, the surface is the double of a sheet, and its map is symmetric.
  HarmonicMapper(
    const Points& places, const Triangles& triangles, const Run& run, const Half* half = nullptr)
    : Sheet(half)
    , Places(places)
    , Triangles(triangles)
    , Threads(run.unwatched())
    , Shapes(places, triangles)
    , Angles(places, triangles, BoundedTriangles::Weight::RegularArea)
    , Rings(triangles, places.rows())
    , Areas(vertexAreas(places, triangles))
  {
    Points cotangents(triangles.rows(), 3);
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      const auto& quarters = this->shapeOf(r).Cotangents;
      cotangents.row(r) << 4.0 * quarters[0], 4.0 * quarters[1], 4.0 * quarters[2];
    }
    this->Strings = cotangentWeights(triangles, places.rows(), cotangents);
    if (half)
    {
      const conformal::Triangles& own = half->Sheet.Triangles;
      this->SheetStrings =
        cotangentWeights(own, half->Sheet.Positions.rows(), cotangents.topRows(own.rows()));
    }
  }

  HarmonicSphereMap run(Steps& steps) const
  {
    const Index puncture = this->firstPuncture();
    if (puncture < 0)
    {
      return {};
    }
    HarmonicSphereMap map = this->attempt(puncture, steps.next());
    const bool solved = map.Positions.rows() > 0;
    if (solved && (!map.OneToOne || this->areaRatioAround(map.Positions, puncture) < LimbShare))
    {
      const Index better = this->betterPuncture(map.Positions);
      HarmonicSphereMap other = this->attempt(better, steps.next());
      if (other.OneToOne &&
        (!map.OneToOne ||
          stringEnergy(this->Strings, other.Positions) <
            stringEnergy(this->Strings, map.Positions)))
      {
        map = std::move(other);
      }
      map.NumberOfSolves = 2;
    }
    return map;
  }

private:
  Index firstPuncture() const
  {
    return this->Sheet ? chooseBorderPuncture(this->Sheet->Sheet.Positions,
                           this->Sheet->Sheet.Triangles, this->Sheet->Border)
                       : choosePuncture(this->Places, this->Triangles);
  }

  // Choose the triangle that a map enlarges most.
  Index betterPuncture(const Points& positions) const
  {
    if (!this->Sheet)
    {
      return choosePuncture(this->Places, this->Triangles, positions);
    }
    const Mesh& sheet = this->Sheet->Sheet;
    conformal::Triangles atBorder(sheet.Triangles.rows(), 3);
    std::vector<Index> ids;
    for (Index r = 0; r < sheet.Triangles.rows(); ++r)
    {
      const auto row = sheet.Triangles.row(r);
      if (this->Sheet->Border[row[0]] + this->Sheet->Border[row[1]] + this->Sheet->Border[row[2]] ==
        2)
      {
        atBorder.row(static_cast<Index>(ids.size())) = row;
        ids.push_back(r);
      }
    }
    return ids[choosePuncture(
      sheet.Positions, atBorder.topRows(static_cast<Index>(ids.size())), positions)];
  }

  // Map by linear equations.
  Points solved(Index puncture, const Run& run) const
  {
    if (!this->Sheet)
    {
      return punctureToSphere(this->Places, this->Triangles, this->Strings, puncture, run);
    }
    Points positions(this->Places.rows(), 3);
    positions.topRows(this->Sheet->Sheet.Positions.rows()) =
      punctureToHemisphere(this->Sheet->Sheet.Positions, this->Sheet->Sheet.Triangles,
        this->SheetStrings, this->Sheet->Border, puncture, run);
    this->mirror(positions);
    return positions;
  }

  // Move the border of a sheet to the equator, and compute the other half from that of the sheet.
  void mirror(Points& positions) const
  {
    for (Index v = 0; this->Sheet && v < this->Sheet->Sheet.Positions.rows(); ++v)
    {
      if (this->Sheet->Border[v])
      {
        positions(v, 2) = 0.0;
        positions.row(v).normalize();
      }
      else
      {
        positions.row(this->Sheet->MirrorIds[v]) << positions(v, 0), positions(v, 1),
          -positions(v, 2);
      }
    }
  }

  void center(Points& positions) const
  {
    centeringTransform(positions, this->Areas).applyTo(positions);
    this->mirror(positions);
  }

  // Whether improve() may move a vertex.
  bool isFree(Index v) const
  {
    return !this->Sheet || (v < this->Sheet->Sheet.Positions.rows() && !this->Sheet->Border[v]);
  }

  SourceTriangle shapeOf(Index r) const
  {
    return this->Shapes.triangle(
      this->Triangles(r, 0), this->Triangles(r, 1), this->Triangles(r, 2));
  }

  // Map with one puncture. If the equations have no finite solution, the result has no positions.
  HarmonicSphereMap attempt(Index puncture, const Run& run) const
  {
    Steps steps(run, { 0.9, 0.02, 0.06, 0.02 }); // equations, center, repair, center
    HarmonicSphereMap map;
    map.NumberOfSolves = 1;
    try
    {
      map.Positions = this->solved(puncture, steps.next());
      steps.next();
      this->center(map.Positions);
      if (this->improve(map, steps.next()))
      {
        steps.next();
        this->mirror(map.Positions);
        this->center(map.Positions);
        map.OneToOne = badTriangles(toVectors(map.Positions), this->Triangles).empty();
      }
    }
    catch (const NumericalFailure&)
    {
      map.Positions.resize(0, 3);
    }
    return map;
  }

  // Remove folds and relax triangles. Return false if too many triangles are bad, or folds remain.
  bool improve(HarmonicSphereMap& map, const Run& run) const
  {
    std::vector<Vector3> positions = toVectors(map.Positions);
    const double bad = static_cast<double>(badTriangles(positions, this->Triangles).size());
    if (bad > 10.0 + MaximumBadShare * static_cast<double>(this->Triangles.rows()))
    {
      return false;
    }
    if (bad > 0.0)
    {
      map.Repaired = true;
      if (!this->repair(positions, run.part(0.0, 0.8)))
      {
        return false;
      }
    }
    const bool all = this->Places.rows() < SmallMesh;
    const std::vector<int> ids = all ? this->allVertices() : this->misshapenVertices(positions);
    const int sweeps = all ? SweepsOfSmallMesh : SweepsOfMisshapen;
    const double total = static_cast<double>(ids.size()) * sweeps;
    const double begin = bad > 0.0 ? 0.8 : 0.0;
    relaxVertices(positions, ids, this->Rings, this->Angles, AnglesOnly, sweeps,
      [&, count = Index(0)]() mutable
      {
        if (++count % 1024 == 0)
        {
          run.report(begin + (1.0 - begin) * static_cast<double>(count) / total);
        }
      });
    map.Positions = toPoints(positions);
    return true;
  }

  // Remove folds. Where the map is too small for the usual repair, another one is accepted if the
  // whole map stays conformal.
  bool repair(std::vector<Vector3>& positions, const Run& run) const
  {
    const std::vector<Vector3> before = positions;
    const auto repaired = [&](double minimumHeight, const Run& own)
    {
      return repairFlips(positions, this->Places, this->Triangles, this->Strings, this->Rings,
        this->Angles, minimumHeight, own);
    };
    if (repaired(std::numeric_limits<double>::infinity(), run.part(0.0, 0.5)))
    {
      return true;
    }
    positions = before;
    return repaired(MinimumSafeHeight, run.part(0.5, 1.0)) &&
      this->meanDistortion(positions) < MaximumMeanDistortion;
  }

  // Dirichlet energy divided by area, of a triangle of the map.
  double distortion(const std::vector<Vector3>& positions, Index r) const
  {
    const auto ids = this->Triangles.row(r);
    const Vector3 &a = positions[ids[0]], &b = positions[ids[1]], &c = positions[ids[2]];
    const auto& cotangents = this->shapeOf(r).Cotangents;
    const double dirichlet = cotangents[0] * (c - b).squaredNorm() +
      cotangents[1] * (a - c).squaredNorm() + cotangents[2] * (b - a).squaredNorm();
    return 2.0 * dirichlet / determinant(a, b, c);
  }

  // Mean over the surface, not over the map, where limbs are small.
  double meanDistortion(const std::vector<Vector3>& positions) const
  {
    double sum = 0.0, area = 0.0;
    for (Index r = 0; r < this->Triangles.rows(); ++r)
    {
      const double own = this->shapeOf(r).Area;
      sum += own * this->distortion(positions, r);
      area += own;
    }
    return sum / area;
  }

  std::vector<int> allVertices() const
  {
    std::vector<int> ids(this->Places.rows());
    std::iota(ids.begin(), ids.end(), 0);
    return this->freeOf(ids);
  }

  std::vector<int> misshapenVertices(const std::vector<Vector3>& positions) const
  {
    std::vector<char> chosen(positions.size(), 0);
    for (Index r = 0; r < this->Triangles.rows(); ++r)
    {
      if (this->distortion(positions, r) > Misshapen)
      {
        for (const int v : this->Triangles.row(r))
        {
          chosen[v] = 1;
        }
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
    return this->freeOf(ids);
  }

  std::vector<int> freeOf(std::vector<int> ids) const
  {
    ids.erase(
      std::remove_if(ids.begin(), ids.end(), [&](int v) { return !this->isFree(v); }), ids.end());
    return ids;
  }

  // Compute the ratio of areas on the sphere and on the surface around each corner of the triangle,
  // and return the maximum.
  double areaRatioAround(const Points& positions, Index puncture) const
  {
    double maximum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int v = this->Triangles(puncture, k);
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
      maximum = std::max(maximum, onSphere / onSurface);
    }
    return maximum;
  }

  const Half* const Sheet; // null for a closed surface
  const Points& Places;
  const conformal::Triangles& Triangles;
  const Run Threads; // threads without progress reports
  EdgeWeights SheetStrings;
  BoundedTriangles Shapes, Angles;
  VertexRings Rings;
  Eigen::VectorXd Areas;
  EdgeWeights Strings;
};
}

//------------------------------------------------------------------------------
HarmonicSphereMap mapHarmonically(const Mesh& mesh, const Run& run)
{
  const Points& points = mesh.Positions;
  const Triangles& triangles = mesh.Triangles;
  Steps steps(run, { 0.06, 0.84, 0.1 }); // tables, first attempt, rare second attempt
  steps.next();
  const HarmonicMapper mapper(points, triangles, run);
  return mapper.run(steps);
}

//------------------------------------------------------------------------------
HarmonicSphereMap mapSheetHarmonically(
  const Mesh& sheet, const std::vector<char>& border, const Run& run)
{
  Steps steps(run, { 0.06, 0.84, 0.1 }); // tables, first attempt, rare second attempt
  steps.next();
  const DoubledSheet whole = doubled(sheet, border);
  const Half half{ sheet, border, whole.MirrorIds };
  const HarmonicMapper mapper(whole.Positions, whole.Triangles, run, &half);
  HarmonicSphereMap map = mapper.run(steps);
  if (map.Positions.rows() > 0)
  {
    map.Positions.conservativeResize(sheet.Positions.rows(), 3);
  }
  return map;
}
}

#include "Repair/GenusZeroRepair.h"

#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Repair/HandleLoops.h"
#include "Repair/LoopCap.h"
#include "Repair/UnionOfParts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
void requireFinite(const PointView& points, const Triangles& triangles)
{
  std::vector<char> isBad(points.size(), 0);
  for (Index i = 0; i < triangles.size(); ++i)
  {
    const int id = triangles.data()[i];
    isBad[id] = !points[id].allFinite();
  }
  const auto bad = std::count(isBad.begin(), isBad.end(), 1);
  if (bad > 0)
  {
    throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(points.size()) +
      " points of the surface are not finite");
  }
}

// Record the location of a loop before it is closed.
RepairLoop describeLoop(
  const GluedSurface& surface, const std::vector<int>& loop, const LoopCap& cap, double wholeArea)
{
  RepairLoop described;
  described.Positions.resize(static_cast<Index>(loop.size()), 3);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    described.Positions.row(static_cast<Index>(i)) = surface.Positions[surface.from(loop[i])];
  }
  const double area = areaOf(cap, cornersOfCap(surface, loop));
  described.AreaFraction = wholeArea > 0.0 ? area / wholeArea : 0.0;
  return described;
}

double surfaceArea(const GluedSurface& surface)
{
  double area = 0.0;
  for (int side = 0; side < surface.numberOfSides(); side += 3)
  {
    const Vector3 a = surface.Positions[surface.from(side)];
    area += 0.5 *
      (surface.Positions[surface.from(side + 1)] - a)
        .cross(surface.Positions[surface.from(side + 2)] - a)
        .norm();
  }
  return area;
}

// Compute six times the volume.
double volumeOf(const GluedSurface& surface)
{
  const Vector3 origin = surface.Positions.front();
  double volume = 0.0;
  for (int side = 0; side < surface.numberOfSides(); side += 3)
  {
    const Vector3 a = surface.Positions[surface.from(side)] - origin,
                  b = surface.Positions[surface.from(side + 1)] - origin,
                  c = surface.Positions[surface.from(side + 2)] - origin;
    volume += a.dot(b.cross(c));
  }
  return volume;
}

void fillHoles(GluedSurface& surface, double area, double maximumFraction,
  std::vector<RepairLoop>& done, const Run& run)
{
  const std::vector<std::vector<int>> loops = openLoops(surface);
  for (const std::vector<int>& loop : loops)
  {
    run.report(static_cast<double>(done.size()) / static_cast<double>(loops.size()));
    const LoopCap cap = capFor(surface, loop);
    RepairLoop described = describeLoop(surface, loop, cap, area);
    const bool isOpen = described.AreaFraction > maximumFraction;
    described.Type = isOpen ? RepairLoopType::OpenHole : RepairLoopType::FilledHole;
    done.push_back(std::move(described));
    closeLoop(surface, loop, cap, isOpen ? GluedSurface::Temporary : GluedSurface::Added);
  }
}

void turnOver(GluedSurface& surface)
{
  // Side k becomes side 2 - k, as corners 1 and 2 are swapped.
  const auto turned = [](int side) { return side - side % 3 + 2 - side % 3; };
  std::vector<int> across(surface.Across.size());
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    across[turned(side)] = turned(surface.Across[side]);
  }
  surface.Across = across;
  for (int side = 0; side < surface.numberOfSides(); side += 3)
  {
    std::swap(surface.Corners[side + 1], surface.Corners[side + 2]);
  }
}

// Compute the lengths of all sides. Fillings of holes that remain open are expensive, so that loops
// cross them only if there is no other path.
std::vector<double> sideLengths(const GluedSurface& surface)
{
  constexpr double detour = 1e6;
  const auto isTemporary = [&](int side)
  { return surface.TriangleIds[side / 3] == GluedSurface::Temporary; };
  std::vector<double> lengths(surface.numberOfSides());
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    const int across = surface.Across[side];
    if (side < across)
    {
      const double length =
        (surface.Positions[surface.to(side)] - surface.Positions[surface.from(side)]).norm();
      lengths[side] = lengths[across] =
        length * (isTemporary(side) && isTemporary(across) ? detour : 1.0);
    }
  }
  return lengths;
}

// Return whether a loop passes through the opening of a handle. A loop around a handle encloses the
// inside of the body. A loop through a handle encloses the outside: the center of the loop is on
// the side of the normals.
bool isTunnel(const GluedSurface& surface, const std::vector<int>& loop)
{
  Vector3 middle = Vector3::Zero();
  for (const int side : loop)
  {
    middle += surface.Positions[surface.from(side)] / static_cast<double>(loop.size());
  }
  double outside = 0.0;
  for (const int side : loop)
  {
    const Vector3 a = surface.Positions[surface.from(side)],
                  b = surface.Positions[surface.to(side)];
    for (const int triangle : { side / 3, surface.Across[side] / 3 })
    {
      const Vector3 p = surface.Positions[surface.from(3 * triangle)];
      const Vector3 normal = (surface.Positions[surface.from(3 * triangle + 1)] - p)
                               .cross(surface.Positions[surface.from(3 * triangle + 2)] - p)
                               .normalized();
      outside += (b - a).norm() * normal.dot(middle - 0.5 * (a + b));
    }
  }
  return outside > 0.0;
}

void openHandles(GluedSurface& surface, double area, std::vector<RepairLoop>& done, const Run& run)
{
  double begin = 0.0;
  while (numberOfHandles(surface) > 0)
  {
    // The first search finds most handles. The number of searches is not known.
    const double found = 0.4 * begin + 0.6, end = 0.2 * begin + 0.8;
    const std::vector<HandleLoop> loops =
      findHandleLoops(surface, sideLengths(surface), run.part(begin, found));
    const Run ofCuts = run.part(found, end);
    std::size_t cut = 0;
    begin = end;
    for (const HandleLoop& loop : loops)
    {
      ofCuts.report(static_cast<double>(cut++) / static_cast<double>(loops.size()));
      const bool fills = isTunnel(surface, loop.Sides);
      const std::vector<int> right = cutAlong(surface, loop.Sides);
      const LoopCap cap = capFor(surface, loop.Sides);
      RepairLoop described = describeLoop(surface, loop.Sides, cap, area);
      described.Type = fills ? RepairLoopType::FilledTunnel : RepairLoopType::CutHandle;
      done.push_back(std::move(described));
      closeLoop(surface, loop.Sides, cap);
      closeLoop(surface, right, capFor(surface, right));
    }
  }
}

// Glue the triangles, after parts that overlap were joined. The ids of triangles are those of
// `united`.
GluedSurface glueUnion(
  const PointView& points, const UnionOfParts& united, GluingReport& report, const Run& run)
{
  if (united.NumberOfPartsJoined == 0)
  {
    return glueTriangles(points, united.Triangles, report, run);
  }
  GluedSurface surface = glueTriangles(united.Positions, united.Triangles, report, run);
  report.NumberOfRepeatedPoints = united.Gluing.NumberOfRepeatedPoints;
  report.NumberOfDuplicates = united.Gluing.NumberOfDuplicates;
  report.NumberOfNonManifoldEdges = united.Gluing.NumberOfNonManifoldEdges;
  for (const int id : surface.TriangleIds)
  {
    report.NumberOfTurnedTriangles += united.IsTurned[id];
  }
  const std::size_t firstAdded = united.PointIds.size() - united.Parents.size();
  for (int v = 0; v < surface.numberOfVertices(); ++v)
  {
    const auto vertex = static_cast<std::size_t>(surface.PointIds[v]);
    surface.PointIds[v] = united.PointIds[vertex];
    if (vertex >= firstAdded)
    {
      const std::array<int, 2>& ends = united.Parents[vertex - firstAdded];
      surface.Parents[v].assign(ends.begin(), ends.end());
    }
  }
  report.NumberOfSeparatedPoints = numberOfSeparatedPoints(surface);
  return surface;
}

// Assemble the result: original vertices and triangles first, then pieces and added ones.
void collect(const GluedSurface& surface, const UnionOfParts& united, GenusZeroRepairResult& result)
{
  const auto isWhole = [&](int id) { return id >= 0 && id < united.NumberOfWholeTriangles; };
  std::vector<int> triangles, vertices(surface.PointIds.size()), places(surface.PointIds.size());
  for (int r = 0; r < surface.numberOfTriangles(); ++r)
  {
    if (surface.TriangleIds[r] != GluedSurface::Temporary)
    {
      triangles.push_back(r);
    }
  }
  const auto firstAdded = std::stable_partition(
    triangles.begin(), triangles.end(), [&](int r) { return isWhole(surface.TriangleIds[r]); });
  result.NumberOfTrianglesUntouched = firstAdded - triangles.begin();
  result.NumberOfTrianglesAdded = triangles.end() - firstAdded;
  std::iota(vertices.begin(), vertices.end(), 0);
  std::stable_partition(
    vertices.begin(), vertices.end(), [&](int v) { return surface.PointIds[v] >= 0; });
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    places[vertices[i]] = static_cast<int>(i);
  }

  result.Triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.Triangles(static_cast<Index>(i), k) = places[surface.from(3 * triangles[i] + k)];
    }
    const int id = surface.TriangleIds[triangles[i]];
    result.TriangleIds.push_back(id >= 0 ? united.TriangleIds[id] : id);
  }
  const std::vector<int> kept =
    dropIsolatedPoints(result.Triangles, static_cast<Index>(vertices.size()));
  result.Positions.resize(static_cast<Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    const int v = vertices[kept[i]];
    result.Positions.row(static_cast<Index>(i)) = surface.Positions[v];
    result.PointIds.push_back(surface.PointIds[v]);
    if (surface.PointIds[v] == GluedSurface::Added)
    {
      result.Parents.push_back(surface.Parents[v]);
    }
  }
}
}

//------------------------------------------------------------------------------
Index GenusZeroRepairResult::count(RepairLoopType type) const
{
  return std::count_if(this->Loops.begin(), this->Loops.end(),
    [=](const RepairLoop& loop) { return loop.Type == type; });
}

//------------------------------------------------------------------------------
GenusZeroRepairResult repairGenusZero(const PointView& points, const Triangles& triangles,
  const GenusZeroRepairOptions& options, const Run& run)
{
  if (!(options.MaximumHoleArea >= 0.0 && options.MaximumHoleArea <= 1.0))
  {
    throw std::invalid_argument("MaximumHoleArea must be in [0, 1]");
  }
  if (triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  // Relative costs of check, union, gluing, holes, handles, check.
  Steps steps(run, { 0.25, 0.02, 0.23, 0.02, 0.2, 0.28 });
  GenusZeroReport report = checkGenusZero(triangles, points.size(), {}, steps.next());
  requireFinite(points, triangles);
  GenusZeroRepairResult result;
  Triangles merged = triangles;
  result.NumberOfPointsMerged = mergeCoincidentBoundaryPoints(merged, points, report);
  const bool isOnePart =
    result.NumberOfPointsMerged == 0 && report.manifold() && report.NumberOfComponents == 1;
  const Run ofUnion = steps.next();
  const UnionOfParts united =
    isOnePart ? unchangedPart(triangles) : uniteParts(points, merged, ofUnion);
  result.NumberOfPartsJoined = united.NumberOfPartsJoined;
  GluedSurface surface = glueUnion(points, united, result.Gluing, steps.next());
  if (surface.TriangleIds.empty())
  {
    throw std::invalid_argument("every triangle of the surface has a repeated point");
  }
  const Index whole = surface.numberOfTriangles();
  const double area = surfaceArea(surface);
  fillHoles(surface, area, options.MaximumHoleArea, result.Loops, steps.next());
  while (splitDoubleEdges(surface) > 0)
  {
  }
  if (volumeOf(surface) < 0.0)
  {
    turnOver(surface);
    result.Gluing.NumberOfTurnedTriangles = whole - result.Gluing.NumberOfTurnedTriangles;
  }
  openHandles(surface, area, result.Loops, steps.next());
  const Run last = steps.next();
  collect(surface, united, result);
  report = checkGenusZero(result.Triangles, result.Positions.rows(), {}, last);
  result.EulerNumber = report.EulerNumber;
  result.IsGenusZero = report.isGenusZero() && report.InconsistentEdges.empty();
  return result;
}
}

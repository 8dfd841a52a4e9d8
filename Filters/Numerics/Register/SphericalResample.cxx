#include "Register/SphericalResample.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"
#include "Sphere/SphereCoverage.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Weights below this minimum are treated as 0. In files, sphere positions may be rounded to floats.
constexpr double MinimumWeight = 1e-7;

using Parts = std::vector<std::pair<int, double>>;

/// Check that a surface is closed and that its map covers the sphere once.
/// @return number of folded triangles of the map
Index requireCover(const MappedMesh& mesh, const char* what, const Run& run)
{
  const Index open = countOpenEdges(mesh.Triangles, mesh.SpherePositions.rows(), run.unwatched());
  if (open > 0)
  {
    throw std::invalid_argument(std::string("the ") + what +
      " is open, or its triangles are not oriented consistently, at " + std::to_string(open) +
      " edges, but must be closed. vtkGenusZeroCheck shows where.");
  }
  Triangles turned = mesh.Triangles;
  const SphereCoverage coverage = turnToCover(mesh.SpherePositions, turned, run.unwatched());
  if (coverage.Degree != 1)
  {
    throw std::invalid_argument(std::string("the map to the sphere of the ") + what +
      " covers the sphere " + std::to_string(coverage.Degree) + " times instead of once");
  }
  return coverage.NumberOfFolds;
}

/// Find the closest triangle for each direction. Return the corners of this triangle and their
/// barycentric weights.
std::vector<Parts> partsAt(const MappedMesh& source, const Points& directions, const Run& run)
{
  Steps steps(run, { 0.5, 0.5 }); // progress: tree, foot points
  const TriangleTree tree(source.SpherePositions, source.Triangles, steps.next());
  std::vector<Parts> parts(directions.rows());
  forBlocksReporting(steps.next(), directions.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const FootPoint foot = tree.closestPoint(directions.row(i));
        for (int k = 0; k < 3; ++k)
        {
          if (foot.Barycentric[k] > MinimumWeight)
          {
            parts[i].emplace_back(source.Triangles(foot.Triangle, k), foot.Barycentric[k]);
          }
        }
      }
    });
  return parts;
}

/// Return the reverse weights: for each target point, the source points in the triangles around the
/// target point.
std::vector<Parts> partsBack(const MappedMesh& source, const MappedMesh& target, const Run& run)
{
  std::vector<char> isUsed(source.SpherePositions.rows(), 0);
  for (Index k = 0; k < source.Triangles.size(); ++k)
  {
    isUsed[source.Triangles.data()[k]] = 1;
  }
  const std::vector<Parts> rows = partsAt(target, source.SpherePositions, run);
  std::vector<Parts> columns(target.SpherePositions.rows());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    for (const auto& [id, weight] : rows[i])
    {
      if (isUsed[i] != 0)
      {
        columns[id].emplace_back(static_cast<int>(i), weight);
      }
    }
  }
  return columns;
}

bool namesAllOf(const Parts& parts, const Parts& others)
{
  return std::all_of(others.begin(), others.end(),
    [&](const auto& other)
    {
      return std::any_of(
        parts.begin(), parts.end(), [&](const auto& part) { return part.first == other.first; });
    });
}

/// Scale the weights of each target point by its area. Then scale the weights of each source point
/// so that their sum is its area.
void scaleByAreas(std::vector<Parts>& rows, const MappedMesh& source, const MappedMesh& target)
{
  const Eigen::VectorXd sourceAreas = vertexAreas(source.Positions, source.Triangles),
                        targetAreas = vertexAreas(target.Positions, target.Triangles);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(sourceAreas.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    for (const auto& [id, weight] : rows[i])
    {
      sums[id] += weight * targetAreas[static_cast<Index>(i)];
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const double area = targetAreas[static_cast<Index>(i)];
    Parts scaled = rows[i];
    double sum = 0.0;
    for (auto& [id, weight] : scaled)
    {
      weight *= sums[id] > 0.0 ? area * sourceAreas[id] / sums[id] : 0.0;
      sum += weight;
    }
    if (sum > 0.0) // otherwise, all involved areas are 0
    {
      rows[i] = std::move(scaled);
    }
  }
}
}

//------------------------------------------------------------------------------
SphericalResampling resampleSurface(const MappedMesh& source, const MappedMesh& target,
  const SphericalResampleOptions& options, const Run& run)
{
  const bool isAdaptive = options.Method == ResampleMethod::AreaAdaptive;
  // Progress: checks of the maps, forward weights, reverse weights, areas.
  Steps steps(run, { 0.15, 0.8, isAdaptive ? 0.8 : 0.0, isAdaptive ? 0.4 : 0.05 });
  steps.next();
  SphericalResampling result;
  result.NumberOfFolds = requireCover(source, "source", run);
  std::vector<Parts> rows = partsAt(source, target.SpherePositions, steps.next());
  const Run backwards = steps.next();
  if (isAdaptive)
  {
    requireCover(target, "target", run);
    const std::vector<Parts> back = partsBack(source, target, backwards);
    steps.next();
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      if (!namesAllOf(rows[i], back[i]))
      {
        rows[i] = back[i];
      }
    }
    scaleByAreas(rows, source, target);
  }
  else
  {
    steps.next();
  }
  for (const Parts& parts : rows)
  {
    result.Weights.add(parts);
  }
  return result;
}
}

#include "Register/ConsistentRemesh.h"

#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Sphere/AdaptiveSphere.h"
#include "Sphere/MeanMetricMesh.h"
#include "Sphere/SphereCoverage.h"
#include "Sphere/SphereDensity.h"
#include "Sphere/SphereLocator.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace conformal
{
namespace
{
struct Placed
{
  conformal::Triangles Triangles; // counter-clockwise on the sphere seen from outside
  // Whether the map is mirrored: Triangles are then clockwise on the surface seen from outside.
  bool IsMirrored = false;
};

Placed placed(const MappedMesh& surface, std::size_t number, const Run& run)
{
  const Index open = countOpenEdges(surface.Triangles, surface.Positions.rows(), run.unwatched());
  if (open > 0)
  {
    throw std::invalid_argument("surface " + std::to_string(number) +
      " is open, or its triangles are not oriented consistently, at " + std::to_string(open) +
      " edges, but must be closed. vtkGenusZeroCheck shows where.");
  }
  Placed result;
  result.Triangles = turnedToCoverOnce(surface.SpherePositions, surface.Triangles,
    "the map to the sphere of surface " + std::to_string(number), run.unwatched());
  result.IsMirrored = signedVolume(surface.Positions, result.Triangles) < 0.0;
  return result;
}

// Build a mesh of the sphere whose points are dense where the surfaces are large on average.
Mesh denseSphere(const std::vector<MappedMesh>& surfaces, Index numberOfPoints, const Run& run)
{
  AdaptiveSphereOptions sphere;
  sphere.NumberOfPoints = numberOfPoints;
  // Progress: the density of each surface, then the mean density, then the sphere mesh.
  std::vector<double> shares(surfaces.size(), 0.2 / static_cast<double>(surfaces.size()));
  shares.insert(shares.end(), { 0.1, 0.7 });
  Steps steps(run, shares);
  std::vector<SphereDensity> densities;
  densities.reserve(surfaces.size());
  for (const MappedMesh& surface : surfaces)
  {
    densities.push_back(
      densityOnSurface(surface, std::vector<double>(surface.Positions.rows(), 1.0), steps.next()));
  }
  const SphereDensity density = equalShares(densities, steps.next());
  return makeAdaptiveSphere(density, sphere, steps.next());
}

Mesh commonSphere(const std::vector<MappedMesh>& surfaces,
  const std::vector<LocatedSurface>& located, const ConsistentRemeshOptions& options,
  const Run& run)
{
  if (options.MeshType == RemeshMeshType::Geodesic)
  {
    return makeGeodesicSphere(options.Frequency, run);
  }
  Steps steps(run, { 0.3, 0.7 });
  const Mesh start = denseSphere(surfaces, options.NumberOfPoints, steps.next());
  return remeshByMeanMetric(located, start, options.NumberOfPoints, steps.next());
}

void sample(const LocatedSurface& located, ConsistentMeshes& meshes, const Run& run)
{
  const MappedMesh& surface = *located.Surface;
  const Triangles& triangles = *located.Triangles;
  const Points& directions = meshes.Sphere.Positions;
  Steps steps(run, { 0.7, 0.3 }); // progress: positions, weights
  std::vector<SphereLocation> locations(directions.rows());
  Points positions(directions.rows(), 3);
  forBlocksReporting(steps.next(), directions.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        locations[i] = located.Locator->locate(directions.row(i));
        const auto ids = triangles.row(locations[i].Triangle);
        const Vector3& l = locations[i].Barycentric;
        positions.row(i) = l[0] * surface.Positions.row(ids[0]) +
          l[1] * surface.Positions.row(ids[1]) + l[2] * surface.Positions.row(ids[2]);
      }
    });
  steps.next();
  ResampleWeights weights;
  for (const SphereLocation& location : locations)
  {
    const auto ids = triangles.row(location.Triangle);
    weights.add({ { ids[0], location.Barycentric[0] }, { ids[1], location.Barycentric[1] },
      { ids[2], location.Barycentric[2] } });
  }
  meshes.Positions.push_back(std::move(positions));
  meshes.Weights.push_back(std::move(weights));
}
}

//------------------------------------------------------------------------------
ConsistentMeshes remeshConsistently(
  const std::vector<MappedMesh>& surfaces, const ConsistentRemeshOptions& options, const Run& run)
{
  if (surfaces.empty())
  {
    throw std::invalid_argument("there is no surface to remesh");
  }
  const bool isAdaptive = options.MeshType == RemeshMeshType::Adaptive;
  // Progress: checks of the maps, locators, then the sphere mesh, then each surface.
  std::vector<double> shares = { 0.2, 0.4, isAdaptive ? 8.0 : 0.05 };
  shares.insert(shares.end(), surfaces.size(), 0.75 / static_cast<double>(surfaces.size()));
  Steps steps(run, shares);
  const Run checking = steps.next();
  std::vector<Placed> all;
  for (const MappedMesh& surface : surfaces)
  {
    all.push_back(placed(surface, all.size(), run));
    if (all.back().IsMirrored != all.front().IsMirrored)
    {
      throw std::invalid_argument("the map to the sphere of surface " +
        std::to_string(all.size() - 1) +
        (all.back().IsMirrored ? " mirrors it" : " does not mirror it") +
        ", unlike that of surface 0; mirror one of the surfaces or of the maps");
    }
    checking.report(static_cast<double>(all.size()) / static_cast<double>(surfaces.size()));
  }
  const Run placing = steps.next();
  std::vector<SphereLocator> locators;
  std::vector<LocatedSurface> located;
  locators.reserve(surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    locators.emplace_back(surfaces[s].SpherePositions, all[s].Triangles, run.unwatched());
    located.push_back({ &surfaces[s], &all[s].Triangles, &locators.back() });
    placing.report(static_cast<double>(s + 1) / static_cast<double>(surfaces.size()));
  }
  ConsistentMeshes meshes;
  meshes.Sphere = commonSphere(surfaces, located, options, steps.next());
  for (const LocatedSurface& surface : located)
  {
    sample(surface, meshes, steps.next());
  }
  if (all.front().IsMirrored)
  {
    meshes.Sphere.Triangles.col(1).swap(meshes.Sphere.Triangles.col(2));
  }
  return meshes;
}
}

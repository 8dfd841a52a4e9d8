#include "Sphere/SphereDensity.h"

#include "Base/Steps.h"
#include "Mesh/MeshTopology.h"
#include "Sphere/SphereCoverage.h"
#include "Sphere/SphereLocator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
constexpr double MinimumArea = 1e-24; // of the sphere, around a vertex

/// Compute a third of the area of the triangles around each vertex.
std::vector<double> vertexAreas(const Points& points, const Triangles& triangles)
{
  std::vector<double> areas(points.rows(), 0.0);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const double third = areaVector(points, triangles, r).norm() / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      areas[triangles(r, k)] += third;
    }
  }
  return areas;
}
}

//------------------------------------------------------------------------------
std::vector<double> densitiesOf(const SphereDensity& density, const Run& run)
{
  if (!density.At || density.Directions.rows() == 0 ||
    density.Directions.rows() != static_cast<Index>(density.Areas.size()))
  {
    throw std::invalid_argument("a density needs directions, and an area for each of them");
  }
  std::vector<double> densities(density.Directions.rows());
  forBlocksReporting(run, density.Directions.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        densities[i] = density.At(density.Directions.row(i));
      }
    });
  const auto isBad = [](double value) { return !(value >= 0.0) || !std::isfinite(value); };
  if (std::any_of(densities.begin(), densities.end(), isBad) ||
    std::any_of(density.Areas.begin(), density.Areas.end(), isBad))
  {
    throw std::invalid_argument("a density must be finite and not negative");
  }
  return densities;
}

//------------------------------------------------------------------------------
double integralOf(const SphereDensity& density, const std::vector<double>& densities)
{
  const double sum =
    std::inner_product(density.Areas.begin(), density.Areas.end(), densities.begin(), 0.0);
  if (!(sum > 0.0) || !std::isfinite(sum))
  {
    throw std::invalid_argument("a density must be above 0 somewhere, and finite");
  }
  return sum;
}

//------------------------------------------------------------------------------
bool isAnywhere(const SphereDensity& density, const Run& run)
{
  const std::vector<double> densities = densitiesOf(density, run);
  return std::inner_product(density.Areas.begin(), density.Areas.end(), densities.begin(), 0.0) >
    0.0;
}

//------------------------------------------------------------------------------
SphereDensity densityOnSurface(
  const MappedMesh& surface, const std::vector<double>& weights, const Run& run)
{
  Steps steps(run, { 0.2, 0.8 }); // cover, locator
  steps.next();
  struct Located
  {
    conformal::Triangles Triangles;
    std::vector<double> Densities;
    SphereLocator Locator;
  };
  const auto located = std::make_shared<Located>();
  located->Triangles =
    turnedToCoverOnce(surface.SpherePositions, surface.Triangles, "the map to the sphere", run);
  SphereDensity density;
  density.Directions = surface.SpherePositions;
  density.Areas = vertexAreas(surface.SpherePositions, surface.Triangles);
  const std::vector<double> areas = vertexAreas(surface.Positions, surface.Triangles);
  located->Densities.resize(areas.size());
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    located->Densities[v] = weights[v] * areas[v] / std::max(density.Areas[v], MinimumArea);
  }
  located->Locator = SphereLocator(surface.SpherePositions, located->Triangles, steps.next());
  density.At = [located](const Vector3& direction)
  {
    const SphereLocation location = located->Locator.locate(direction);
    double sum = 0.0;
    for (int k = 0; k < 3 && location.Triangle >= 0; ++k)
    {
      sum += location.Barycentric[k] * located->Densities[located->Triangles(location.Triangle, k)];
    }
    return sum;
  };
  return density;
}

//------------------------------------------------------------------------------
std::vector<double> vertexBending(const Mesh& surface)
{
  const Triangles neighbors = triangleNeighbors(surface.Triangles, surface.Positions.rows());
  std::vector<double> bending(surface.Positions.rows(), 0.0);
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    const Vector3 normal = areaVector(surface.Positions, surface.Triangles, r);
    for (int k = 0; k < 3; ++k)
    {
      if (neighbors(r, k) < r) // also without a neighbor
      {
        continue;
      }
      const int a = surface.Triangles(r, k), b = surface.Triangles(r, next(k));
      const Vector3 other = areaVector(surface.Positions, surface.Triangles, neighbors(r, k));
      const double angle = std::atan2(normal.cross(other).norm(), normal.dot(other));
      const double half =
        0.5 * angle * (surface.Positions.row(b) - surface.Positions.row(a)).norm();
      bending[a] += half;
      bending[b] += half;
    }
  }
  const std::vector<double> areas = vertexAreas(surface.Positions, surface.Triangles);
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    bending[v] = areas[v] > 0.0 ? bending[v] / areas[v] : 0.0;
  }
  return bending;
}

//------------------------------------------------------------------------------
std::vector<double> weightsByBending(const Mesh& surface)
{
  std::vector<double> weights = vertexBending(surface);
  const std::vector<double> areas = vertexAreas(surface.Positions, surface.Triangles);
  const double all = std::inner_product(areas.begin(), areas.end(), weights.begin(), 0.0);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (double& weight : weights)
  {
    weight = 1.0 + (all > 0.0 ? weight * area / all : 0.0);
  }
  return weights;
}

//------------------------------------------------------------------------------
std::vector<double> vertexMeans(const Mesh& surface, const std::vector<double>& values)
{
  std::vector<double> sums(surface.Positions.rows(), 0.0);
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    const double share =
      areaVector(surface.Positions, surface.Triangles, r).norm() / 3.0 * values[r];
    for (int k = 0; k < 3; ++k)
    {
      sums[surface.Triangles(r, k)] += share;
    }
  }
  const std::vector<double> areas = vertexAreas(surface.Positions, surface.Triangles);
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    sums[v] = areas[v] > 0.0 ? sums[v] / areas[v] : 0.0;
  }
  return sums;
}

//------------------------------------------------------------------------------
SphereDensity equalShares(const std::vector<SphereDensity>& densities, const Run& run)
{
  struct Part
  {
    std::function<double(const Vector3&)> At;
    double Integral;
  };
  Steps steps(run, std::vector<double>(densities.size(), 1.0));
  std::vector<Part> parts;
  SphereDensity all;
  for (const SphereDensity& density : densities)
  {
    parts.push_back({ density.At, integralOf(density, densitiesOf(density, steps.next())) });
    const Index before = all.Directions.rows();
    all.Directions.conservativeResize(before + density.Directions.rows(), 3);
    all.Directions.bottomRows(density.Directions.rows()) = density.Directions;
    all.Areas.insert(all.Areas.end(), density.Areas.begin(), density.Areas.end());
  }
  all.At = [parts](const Vector3& direction)
  {
    double sum = 0.0;
    for (const Part& part : parts)
    {
      sum += part.At(direction) / part.Integral;
    }
    return sum;
  };
  return all;
}
}

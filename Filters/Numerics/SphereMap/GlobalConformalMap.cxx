#include "SphereMap/GlobalConformalMap.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/GenusZeroCheck.h"
#include "Sphere/MoebiusTransform.h"
#include "Sphere/SphereOrientation.h"
#include "SphereMap/GuYauMap.h"
#include "SphereMap/HarmonicSphereMap.h"
#include "SphereMap/ProgressiveSphereMap.h"

#include <algorithm>
#include <stdexcept>

namespace conformal
{
namespace
{
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
    throw std::invalid_argument("Tolerance must not be negative or NaN");
  }
}

// Map progressively with the smallest balance of areas at which no triangle is too small. An
// insertion before which vertices nearby are moved takes up to a second. Only a few of these
// insertions are allowed before the last attempt.
Points progressive(const Mesh& mesh, double minimumBalance, const Run& run)
{
  constexpr Index fewRelaxations = 10;
  constexpr double share = 0.8; // fraction of the remaining progress for each attempt
  // A map that shall be conformal needs no minimum of an energy of areas.
  const SphereMapFinish finish =
    minimumBalance > 0.0 ? SphereMapFinish::Minimum : SphereMapFinish::Sweeps;
  double begin = 0.0, last = -1.0;
  for (double balance : { minimumBalance, 0.02, 0.05, 0.2, 0.5 })
  {
    if (balance < minimumBalance || balance == last)
    {
      continue;
    }
    const double end = begin + share * (1.0 - begin);
    try
    {
      ProgressiveSphereMapOptions options;
      options.SurfaceNeedles = QuadricCollapse::Needles::Thin;
      options.AreaBalance = balance;
      options.Finish = finish;
      options.MaximumNumberOfRelaxations = fewRelaxations;
      return mapToSphere(mesh, options, run.part(begin, end)).Positions;
    }
    catch (const NumericalFailure&)
    {
      begin = end;
      last = balance;
    }
  }
  ProgressiveSphereMapOptions options;
  options.AreaBalance = std::max(0.5, minimumBalance);
  options.Finish = finish;
  options.ConnectivityFirst = true;
  return mapToSphere(mesh, options, run.part(begin, 1.0)).Positions;
}

// Rotate to the best agreement with directions from the center of the surface.
void turnToMesh(Points& positions, const Mesh& mesh)
{
  const Eigen::VectorXd areas = vertexAreas(mesh.Positions, mesh.Triangles);
  const Eigen::RowVector3d middle = areas.transpose() * mesh.Positions / areas.sum();
  MoebiusTransform rotation;
  rotation.Rotation = closestRotation(positions, mesh.Positions.rowwise() - middle, areas);
  rotation.applyTo(positions);
}

void mapRobustly(
  const Mesh& mesh, double areaBalance, GlobalConformalMapResult& result, const Run& run)
{
  const bool conformal = areaBalance == 0.0;
  if (conformal)
  {
    HarmonicSphereMap map = mapHarmonically(mesh, run.part(0.0, 0.95));
    result.NumberOfIterations = map.NumberOfSolves;
    result.Converged = map.OneToOne;
    result.Tier = map.Repaired ? GlobalConformalTier::Repaired : GlobalConformalTier::Harmonic;
    result.Positions = std::move(map.Positions);
  }
  if (!result.Converged)
  {
    result.Tier = GlobalConformalTier::Progressive;
    result.Positions = progressive(mesh, areaBalance, run.part(conformal ? 0.95 : 0.0, 1.0));
    result.Converged = true;
  }
  turnToMesh(result.Positions, mesh);
}
}

//------------------------------------------------------------------------------
GlobalConformalMapResult globalConformalMap(
  const Mesh& mesh, const GlobalConformalMapOptions& options, const Run& run)
{
  const Points& points = mesh.Positions;
  const Triangles& triangles = mesh.Triangles;
  check(options);
  const bool published = options.Method == GlobalConformalMethod::GuYau;
  Steps steps(run, { 0.07, 0.03, 0.89, 0.01 }); // check, box and strings, map, figures
  requireGenusZero(triangles, points.rows(), steps.next());
  steps.next();
  const Mesh unit = { inUnitBox(points), triangles };
  GlobalConformalMapResult result;
  if (published)
  {
    GuYauOptions guYau;
    guYau.MaximumNumberOfIterations = options.MaximumNumberOfIterations;
    guYau.Tolerance = options.Tolerance;
    GuYauResult map = mapByGuYau(unit, guYau, steps.next());
    result.Positions = std::move(map.Positions);
    result.Energy = map.Energy;
    result.NumberOfIterations = map.NumberOfIterations;
    result.Converged = map.Converged && map.NumberOfInfiniteStringConstants == 0;
    result.NumberOfNegativeStringConstants = map.NumberOfNegativeStringConstants;
    result.NumberOfInfiniteStringConstants = map.NumberOfInfiniteStringConstants;
  }
  else
  {
    const StringConstants strings = harmonicStrings(unit.Positions, triangles);
    result.NumberOfNegativeStringConstants = strings.NumberOfNegative;
    result.NumberOfInfiniteStringConstants = strings.NumberOfInfinite;
    mapRobustly(unit, options.AreaBalance, result, steps.next());
    result.Energy = stringEnergy(strings.Strings, result.Positions);
  }
  steps.next();
  result.NumberOfFlippedTriangles = countFlippedTriangles(result.Positions, triangles);
  result.Converged = result.Converged && result.NumberOfFlippedTriangles == 0;
  run.report(1.0);
  return result;
}
}

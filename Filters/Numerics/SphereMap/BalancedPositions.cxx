#include "SphereMap/BalancedPositions.h"

#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/VertexRings.h"
#include "Sphere/AdaptiveSphere.h"
#include "Sphere/Resampling.h"
#include "Sphere/SphereDensity.h"
#include "Sphere/SphereOrientation.h"
#include "SphereMap/FlipRepair.h"
#include "SphereMap/GlobalConformalMap.h"

#include <vector>

namespace conformal
{
namespace
{
// Compromise between cost and detail.
constexpr Index NumberOfSamples = 8000;

// The interpolated map is linear in the triangles of the samples. Where it bends at their edges, it
// flips some of the smaller triangles of a surface.
void removeFlips(Points& positions, const MappedMesh& mesh, const Run& run)
{
  const Index size = positions.rows();
  if (countFlippedTriangles(positions, mesh.Triangles) == 0 ||
    !checkGenusZero(mesh.Triangles, size).isGenusZero())
  {
    return;
  }
  std::vector<Vector3> moved = toVectors(positions);
  evenOutFlips(moved, mesh.Triangles, VertexRings(mesh.Triangles, size), run);
  positions = toPoints(moved);
}
}

//------------------------------------------------------------------------------
Points balancedPositions(const MappedMesh& surface, double areaBalance, const Run& run)
{
  // Relative costs of density, samples, positions, map, interpolation and removal of flips.
  Steps steps(run, { 0.05, 0.25, 0.05, 0.5, 0.05, 0.1 });
  MappedMesh mapped = surface;
  mapped.Triangles = turnedOutward(surface.Triangles, surface.SpherePositions);
  if (mapped.Triangles.rows() > 0 && mapped.Triangles != surface.Triangles)
  {
    mapped.Triangles = surface.Triangles;
    mapped.SpherePositions.col(0) *= -1.0;
  }
  const SphereDensity density =
    densityOnSurface(mapped, std::vector<double>(mapped.Positions.rows(), 1.0), steps.next());
  AdaptiveSphereOptions sampling;
  sampling.NumberOfPoints = NumberOfSamples;
  const Mesh sphere = makeAdaptiveSphere(density, sampling, steps.next());
  const Mesh samples = { resample(mapped.SpherePositions, mapped.Positions, mapped.Triangles,
                           sphere.Positions, steps.next()),
    sphere.Triangles };
  GlobalConformalMapOptions options;
  options.AreaBalance = areaBalance;
  const GlobalConformalMapResult map = globalConformalMap(samples, options, steps.next());
  Points positions = resample(
    sphere.Positions, map.Positions, sphere.Triangles, mapped.SpherePositions, steps.next());
  positions.rowwise().normalize();
  removeFlips(positions, mapped, steps.next());
  return positions;
}
}

#include "Learn/SurfaceStart.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshDecimation.h"
#include "SphereMap/ProgressiveSphereMap.h"

#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index ThinnedVertices = 12000; // more do not show in the learned surface

// In nanoseconds as in Steps: of thinning for each vertex, of the map.
constexpr double WorkOfThinning = 10000.0, WorkOfMap = 800e6;
}

std::optional<MappedMesh> thinAndMap(const Mesh& surface, double areaBalance, const Run& run)
{
  const auto size = static_cast<double>(surface.Positions.rows());
  Steps steps(run, { WorkOfThinning * size, WorkOfMap });
  DecimatedMesh thinned = decimate(surface, ThinnedVertices, steps.next());
  ProgressiveSphereMapOptions options;
  options.AreaBalance = areaBalance;
  try
  {
    Points map = mapToSphere(thinned, options, steps.next()).Positions;
    return MappedMesh{ std::move(static_cast<Mesh&>(thinned)), std::move(map) };
  }
  catch (const NumericalFailure&)
  {
    return {};
  }
}

Points withPointsBetween(const Mesh& surface, Index wanted)
{
  const double share =
    surfaceArea(surface.Positions, surface.Triangles) / static_cast<double>(wanted);
  std::vector<double> between;
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    const Vector3 a = surface.Positions.row(surface.Triangles(r, 0)),
                  ab = Vector3(surface.Positions.row(surface.Triangles(r, 1))) - a,
                  ac = Vector3(surface.Positions.row(surface.Triangles(r, 2))) - a;
    // Cut into n^2 equal triangles, each with a point in its middle.
    const int n = static_cast<int>(std::sqrt(0.5 * ab.cross(ac).norm() / share));
    const auto add = [&](double u, double v)
    {
      const Vector3 x = a + u / n * ab + v / n * ac;
      between.insert(between.end(), x.data(), x.data() + 3);
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        add(i + 1.0 / 3.0, j + 1.0 / 3.0);
        if (i + j + 1 < n)
        {
          add(i + 2.0 / 3.0, j + 2.0 / 3.0);
        }
      }
    }
  }
  const auto count = static_cast<Index>(between.size()) / 3;
  Points points(surface.Positions.rows() + count, 3);
  points << surface.Positions, Eigen::Map<const Points>(between.data(), count, 3);
  return points;
}

double workOfThinAndMap(double numberOfVertices)
{
  return WorkOfThinning * numberOfVertices + WorkOfMap;
}
}

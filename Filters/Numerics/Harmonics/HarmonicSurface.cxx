#include "Harmonics/HarmonicSurface.h"

#include "Base/Steps.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Mesh/GeodesicSphere.h"

#include <algorithm>

namespace conformal
{
namespace
{
// Compute three times the enclosed volume. The result is positive if triangles are
// counter-clockwise seen from outside.
double enclosedVolume(const Points& positions, const Triangles& triangles)
{
  double volume = 0.0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const Vector3 first = positions.row(triangles(t, 0));
    volume += first.dot(areaVector(positions, triangles, t));
  }
  return volume;
}
}

//------------------------------------------------------------------------------
HarmonicSurface makeHarmonicSurface(const Columns& coefficients, int frequency, const Run& run)
{
  Steps steps(run, { 0.05, 0.95 }); // progress: sphere, harmonics
  HarmonicSurface surface;
  Mesh sphere = makeGeodesicSphere(frequency, steps.next());
  const Columns values = evaluateHarmonics(coefficients, sphere.Positions, steps.next());
  surface.Positions = values.leftCols(3);
  surface.Values = values.rightCols(values.cols() - 3);
  surface.SpherePositions = std::move(sphere.Positions);
  surface.Triangles = std::move(sphere.Triangles);
  const Points centered =
    surface.Positions.rowwise() - Eigen::RowVector3d(surface.Positions.colwise().mean());
  if (enclosedVolume(centered, surface.Triangles) < 0.0)
  {
    surface.Triangles.col(1).swap(surface.Triangles.col(2));
  }
  return surface;
}

//------------------------------------------------------------------------------
Columns upToDegree(const Columns& coefficients, int degree)
{
  return coefficients.topRows(std::min(coefficients.rows(), numberOfHarmonics(degree)));
}
}

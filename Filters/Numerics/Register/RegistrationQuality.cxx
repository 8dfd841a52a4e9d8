#include "Register/RegistrationQuality.h"

#include "Linear/EdgeWeights.h"
#include "Measure/TriangleStretch.h"
#include "Mesh/GeodesicSphere.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
TriangleMetric metricOf(
  const Points& positions, const Points& sphere, const Triangles& triangles, Index r)
{
  constexpr double share = 0.02; // of the sphere's metric, as in the last descent
  const auto ids = triangles.row(r);
  const Vector3 p = positions.row(ids[1]) - positions.row(ids[0]),
                q = positions.row(ids[2]) - positions.row(ids[0]),
                m = sphere.row(ids[1]) - sphere.row(ids[0]),
                n = sphere.row(ids[2]) - sphere.row(ids[0]);
  return { p.dot(p) + share * m.dot(m), p.dot(q) + share * m.dot(n), q.dot(q) + share * n.dot(n) };
}

// Subtract the weighted mean, and return the weighted variance.
double center(Eigen::Ref<Eigen::VectorXd> values, const Eigen::VectorXd& weights)
{
  values.array() -= weights.dot(values);
  return weights.dot(values.cwiseAbs2());
}
}

//------------------------------------------------------------------------------
double featureAgreement(const PreparedSurface& moving, const PreparedSurface& fixed,
  const Points& places, const std::vector<double>& weights)
{
  Eigen::VectorXd areas = vertexAreas(moving.mesh().Positions, moving.mesh().Triangles);
  areas /= areas.sum();
  const Rows here = moving.featuresAt(moving.mesh().SpherePositions),
             there = fixed.featuresAt(places);
  double sum = 0.0, agreement = 0.0;
  for (Index k = 0; k < here.cols(); ++k)
  {
    Eigen::VectorXd a = here.col(k), b = there.col(k);
    const double first = center(a, areas), second = center(b, areas);
    constexpr double flat = 1e-20; // features have variance 1 on their surface, or are constant
    double correlation = first > flat || second > flat ? 0.0 : 1.0;
    if (first > flat && second > flat)
    {
      correlation = areas.dot(a.cwiseProduct(b)) / std::sqrt(first * second);
    }
    agreement += weights[k] * correlation;
    sum += weights[k];
  }
  return sum > 0.0 ? agreement / sum : 1.0;
}

//------------------------------------------------------------------------------
double registrationStretch(const PreparedSurface& moving, const PreparedSurface& fixed,
  const Points& places, int frequency, const Run& run)
{
  constexpr int highest = 128;
  const double asMany = std::sqrt(static_cast<double>(places.rows()) / 10.0);
  const Mesh sphere = makeGeodesicSphere(
    std::max(frequency, static_cast<int>(std::ceil(std::min<double>(asMany, highest)))));
  const SphereGrid map(Mesh{ places, moving.mesh().Triangles });
  const Points here = sampleAt(map, moving.mesh().Positions, sphere.Positions, run),
               there = fixed.positionsAt(sphere.Positions);
  double energy = 0.0, area = 0.0;
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    const TriangleMetric rest = metricOf(here, sphere.Positions, sphere.Triangles, r),
                         now = metricOf(there, sphere.Positions, sphere.Triangles, r);
    energy += triangleStretch(rest, now);
    area += 0.5 * (areaOf(rest) + areaOf(now));
  }
  // The energy of a triangle is 4 times the excess over 1, times the mean area.
  return 1.0 + energy / (4.0 * area);
}
}

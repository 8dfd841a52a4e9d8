#include "Learn/OpenSurface.h"

#include "Base/Steps.h"
#include "Border/BorderCurve.h"
#include "Border/BorderPolish.h"
#include "Border/SheetCut.h"
#include "Learn/Fit/SurfaceSupport.h"
#include "Mesh/GenusZeroCheck.h"
#include "Search/PointTree.h"
#include "SphereMap/Sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
/// Return the samples of all ranks within a distance of the curves.
Points samplesNear(const TrainingSamples& samples, const std::vector<BorderCurve>& borders,
  double reach, const Run& run)
{
  std::vector<double> coordinates;
  for (const BorderCurve& border : borders)
  {
    coordinates.insert(coordinates.end(), border.Positions.data(),
      border.Positions.data() + border.Positions.size());
  }
  const PointTree tree(PointView(coordinates.data(), static_cast<Index>(coordinates.size() / 3)));
  std::vector<char> isNear(samples.size(), 0);
  forBlocksReporting(run, samples.size(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        isNear[i] = tree.nearest(samples[i]).SquareDistance <= reach * reach;
      }
    });
  std::vector<double> own;
  for (Index i = 0; i < samples.size(); ++i)
  {
    if (isNear[i])
    {
      const Vector3 x = samples[i];
      own.insert(own.end(), x.data(), x.data() + 3);
    }
  }
  const std::vector<double> all = gather(samples.reduce(), own);
  return Eigen::Map<const Points>(all.data(), static_cast<Index>(all.size()) / 3, 3);
}

std::vector<double> interpolated(
  const std::vector<double>& values, const std::vector<CutVertex>& vertices)
{
  std::vector<double> result;
  result.reserve(values.empty() ? 0 : vertices.size());
  for (const CutVertex& v : vertices)
  {
    if (!values.empty())
    {
      result.push_back((1.0 - v.Weight) * values[v.First] + v.Weight * values[v.Second]);
    }
  }
  return result;
}

std::vector<bool> bareVerticesOf(const std::vector<double>& support)
{
  std::vector<bool> bare;
  bare.reserve(support.size());
  for (const double value : support)
  {
    bare.push_back(value < HalfSupport);
  }
  return bare;
}
}

namespace
{
/// Split edges between vertices of the border. In the map, the border is a great circle, so that
/// such an edge would be on the border.
void splitChords(ConformalSOMResult& result)
{
  SplitSheet split =
    withSplitChords(result, borderVertices(result.Triangles, result.Positions.rows()));
  for (std::vector<double>* values : { &result.Supported, &result.StandardError })
  {
    for (const auto& [first, second] : split.Ends)
    {
      if (!values->empty())
      {
        values->push_back(0.5 * ((*values)[first] + (*values)[second]));
      }
    }
  }
  result.Positions = std::move(split.Positions);
  result.Triangles = std::move(split.Triangles);
}
}

bool openSurface(const TrainingSamples& samples, const BorderOptions& options,
  ConformalSOMResult& result, const Run& run)
{
  const OpenParts parts = findOpenParts(result, result.Supported, options);
  const std::vector<BorderCurve> first =
    parts.any() ? firstBorders(result, parts.Marks, result.Supported) : std::vector<BorderCurve>();
  if (first.empty())
  {
    return false;
  }
  Steps steps(run, { 0.3, 0.6, 0.1 }); // progress: samples, curves, cut
  const BorderSurface surface(result, run);
  // The spacing is at most that of samples spread over the whole surface.
  const double spacing = std::sqrt(
    surfaceArea(result.Positions, result.Triangles) / static_cast<double>(samples.totalSize()));
  const Points near = samplesNear(samples, first, reachOfFit(surface, spacing), steps.next());
  const std::vector<BorderCurve> borders = fitBorders(first, surface, near, steps.next());
  steps.next();
  const CutSheet sheet = cutSheet(surface, parts.Marks, borders);
  if (sheet.Triangles.rows() == 0)
  {
    return true;
  }
  result.Supported = interpolated(result.Supported, sheet.Vertices);
  result.StandardError = interpolated(result.StandardError, sheet.Vertices);
  result.Positions = sheet.Positions;
  result.Triangles = sheet.Triangles;
  splitChords(result);
  polishBorder(result.Positions, result.Triangles, near, run.unwatched());
  result.OpenFraction = parts.Fraction;
  result.DroppedFraction = parts.IslandFraction + sheet.DroppedFraction;
  result.NumberOfBorders =
    checkGenusZero(result.Triangles, result.Positions.rows()).NumberOfBoundaryLoops;
  result.UnsupportedFraction =
    areaFraction(result.Positions, result.Triangles, bareVerticesOf(result.Supported));
  return true;
}
}

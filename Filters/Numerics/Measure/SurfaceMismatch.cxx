#include "Measure/SurfaceMismatch.h"

#include "Base/AcrossProcesses.h"
#include "Base/Random.h"
#include "Base/Steps.h"
#include "Measure/MeanCurvature.h"
#include "Mesh/GenusZeroCheck.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
// Frame with the center of the reference at the origin and the unit of length 1.
struct Frame
{
  Vector3 Center = Vector3::Zero();
  double Unit = 1.0;
  double HalfDiagonal = 0.0; // of the reference, in this frame

  Vector3 operator()(const Vector3& x) const { return (x - this->Center) / this->Unit; }
  Points operator()(const PointView& points) const
  {
    Points moved(points.size(), 3);
    for (Index i = 0; i < points.size(); ++i)
    {
      moved.row(i) = (*this)(points[i]);
    }
    return moved;
  }
};

Frame frameOf(const PointView& reference, Index total, MismatchUnit unit, const Reduce& reduce)
{
  Box box;
  for (Index i = 0; i < reference.size(); ++i)
  {
    box.extend(reference[i]);
  }
  {
    const std::vector<double> ends = maximum(reduce,
      { -box.Lower[0], -box.Lower[1], -box.Lower[2], box.Upper[0], box.Upper[1], box.Upper[2] });
    box.Lower = -Eigen::Map<const Vector3>(ends.data());
    box.Upper = Eigen::Map<const Vector3>(ends.data() + 3);
  }
  // Sum halves, since the sum may overflow.
  const Vector3 middle = 0.5 * box.Lower + 0.5 * box.Upper;
  Frame frame;
  Vector3 sum = Vector3::Zero();
  inTurn(reduce, sum.data(), 3,
    [&]()
    {
      for (Index i = 0; i < reference.size(); ++i)
      {
        sum += (reference[i] - middle) / static_cast<double>(total);
      }
    });
  frame.Center = middle + sum;
  if (unit == MismatchUnit::MaxRadius)
  {
    frame.Unit = 0.0;
    for (Index i = 0; i < reference.size(); ++i)
    {
      frame.Unit = std::max(frame.Unit, (reference[i] - frame.Center).stableNorm());
    }
    frame.Unit = maximum(reduce, { frame.Unit })[0];
  }
  else if (unit == MismatchUnit::HalfDiagonal)
  {
    frame.Unit = (box.Upper - middle).stableNorm();
  }
  if (!(frame.Unit > 0.0))
  {
    throw std::invalid_argument("all points of the reference coincide, so there is no unit of "
                                "length; set LengthUnit to None");
  }
  frame.HalfDiagonal = (box.Upper - middle).stableNorm() / frame.Unit;
  return frame;
}

void requireFinite(const PointView& points, const char* what, const Reduce& reduce)
{
  std::int64_t bad = 0, size = points.size();
  for (Index i = 0; i < points.size(); ++i)
  {
    bad += !points[i].allFinite();
  }
  reduce.sum(&bad, 1);
  reduce.sum(&size, 1);
  if (bad > 0)
  {
    throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(size) +
      " points of the " + what + " are not finite");
  }
}

// Represent points as degenerate triangles of one corner, which the tree supports.
Triangles asTriangles(const std::vector<int>& vertices)
{
  Triangles triangles(static_cast<Index>(vertices.size()), 3);
  for (Index i = 0; i < triangles.rows(); ++i)
  {
    triangles.row(i).setConstant(vertices[i]);
  }
  return triangles;
}

TriangleTree treeOf(const Points& points, const Triangles& triangles, const Run& run)
{
  if (triangles.rows() > 0)
  {
    return TriangleTree(points, triangles, run);
  }
  std::vector<int> all(points.rows());
  for (int v = 0; v < points.rows(); ++v)
  {
    all[v] = v;
  }
  return TriangleTree(points, asTriangles(all), run);
}

// Positions on a mesh, with the triangles that contain them.
struct Spread
{
  Points Positions;
  std::vector<int> Triangles;
};

// Spread points evenly over the area of a mesh, or over its triangles if it has no area.
Spread spreadSamples(const Points& points, const Triangles& triangles, int count, int seed)
{
  const auto corner = [&](Index r, int k) { return Vector3(points.row(triangles(r, k))); };
  std::vector<double> areaUpTo(triangles.rows());
  for (bool byArea : { true, false })
  {
    double sum = 0.0;
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      const Vector3 a = corner(r, 0);
      sum += byArea ? (corner(r, 1) - a).cross(corner(r, 2) - a).norm() : 1.0;
      areaUpTo[r] = sum;
    }
    if (sum > 0.0)
    {
      break;
    }
  }
  // Place samples at equal steps of the area. Inside triangles, use the additive recurrence of the
  // plastic number. Any part of this sequence fills the unit square evenly, for large and small
  // triangles. Only the starts of the steps and of the sequence are random.
  Random random(static_cast<std::uint64_t>(seed));
  constexpr double plastic = 1.32471795724474602596;
  const double step = random.uniform(), startU = random.uniform(), startV = random.uniform();
  double whole = 0.0;
  Spread samples = { Points(count, 3), std::vector<int>(count) };
  for (int i = 0; i < count; ++i)
  {
    const double area = (i + step) / count * areaUpTo.back();
    const auto found = std::upper_bound(areaUpTo.begin(), areaUpTo.end() - 1, area);
    const Index r = found - areaUpTo.begin();
    double u = std::modf(startU + i / plastic, &whole);
    double v = std::modf(startV + i / (plastic * plastic), &whole);
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const Vector3 a = corner(r, 0);
    samples.Positions.row(i) = a + u * (corner(r, 1) - a) + v * (corner(r, 2) - a);
    samples.Triangles[i] = static_cast<int>(r);
  }
  return samples;
}

// Compute square distances of points to a mesh.
// @param[out] feet  triangles that contain the closest points; may be null
template <typename Query>
std::vector<double> squareDistances(const TriangleTree& tree, Index size, const Query& query,
  const Run& run, std::vector<int>* feet = nullptr)
{
  // Searches from points far away are long, so that reports need to come after a few blocks.
  constexpr Index blockSize = 1 << 9, chunkSize = 16 * blockSize;
  std::vector<double> squares(size);
  if (feet)
  {
    feet->resize(size);
  }
  for (Index start = 0; start < size; start += chunkSize)
  {
    const Index length = std::min(chunkSize, size - start);
    forBlocks(run, length, blockSize,
      [&](Index begin, Index end)
      {
        int hint = -1; // consecutive points are often neighbors in space
        for (Index i = start + begin; i < start + end; ++i)
        {
          const FootPoint foot = tree.closestPoint(query(i), hint);
          hint = foot.Triangle;
          squares[i] = foot.SquareDistance;
          if (feet)
          {
            (*feet)[i] = foot.Triangle;
          }
        }
      });
    run.report(static_cast<double>(start + length) / static_cast<double>(size));
  }
  return squares;
}

Vector3 normalOf(const Points& points, const Triangles& triangles, int r)
{
  const Vector3 a = points.row(triangles(r, 0)), b = points.row(triangles(r, 1)),
                c = points.row(triangles(r, 2));
  return (b - a).stableNormalized().cross((c - a).stableNormalized()).stableNormalized();
}

// Root mean square angle between the planes of pairs of triangles [degrees]. Pairs without a
// reference triangle, or with a triangle of zero area, are left out.
double normalAngle(const Points& model, const Triangles& modelTriangles,
  const std::vector<int>& ofModel, const Points& reference, const Triangles& referenceTriangles,
  const std::vector<int>& ofReference)
{
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < ofModel.size(); ++i)
  {
    if (ofReference[i] < 0)
    {
      continue; // distances beyond the range of doubles
    }
    const Vector3 n = normalOf(model, modelTriangles, ofModel[i]),
                  m = normalOf(reference, referenceTriangles, ofReference[i]);
    if (!n.isZero(0.0) && !m.isZero(0.0))
    {
      const double angle = std::atan2(n.cross(m).norm(), std::abs(n.dot(m)));
      sum += angle * angle;
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(sum / count) * 180.0 / Pi : 0.0;
}

// Triangles that are neighbors by shared points and oriented consistently. Points of a border that
// coincide are merged, such as those of a soup, which has three points for each triangle.
Triangles connectedTriangles(const Points& points, const Triangles& triangles, const Run& run)
{
  Triangles connected = triangles;
  const GenusZeroReport report = checkGenusZero(triangles, points.rows(), {}, run);
  if (!report.BoundaryEdges.empty())
  {
    mergeCoincidentBoundaryPoints(connected, points, report);
  }
  orientConsistently(connected);
  return connected;
}

// Root mean square difference of mean curvatures at samples of the model and at the closest
// triangles of the reference. A reference with the opposite orientation has the opposite curvature.
// A pair of triangles that are perpendicular to each other, of area zero, or of a curvature beyond
// the range of doubles is left out.
double curvatureError(const Points& model, const Triangles& givenTriangles, const Spread& samples,
  const Points& reference, const Triangles& givenOfReference, const std::vector<int>& feet,
  double radius, const Run& run)
{
  Steps steps(run, { 0.15, 0.15, 0.7 }); // neighbors of the model and of the reference, curvatures
  const Triangles modelTriangles = connectedTriangles(model, givenTriangles, steps.next()),
                  referenceTriangles =
                    connectedTriangles(reference, givenOfReference, steps.next());
  const Run measuring = steps.next();
  const MeanCurvature ofModel(model, modelTriangles, run.unwatched()),
    ofReference(reference, referenceTriangles, run.unwatched());
  const Index all = static_cast<Index>(feet.size());
  const Index count = std::min<Index>(all, MaximumCurvatureSamples);
  Eigen::VectorXd squares = Eigen::VectorXd::Constant(count, -1.0);
  // Disks can contain a fourth of the triangles, so that reports need to come after a few samples.
  constexpr Index chunkSize = 64;
  std::vector<std::array<MeanCurvature::Memory, 2>> memories(chunkSize);
  for (Index start = 0; start < count; start += chunkSize)
  {
    const Index length = std::min(chunkSize, count - start);
    forBlocks(measuring, length, 1,
      [&](Index begin, Index end)
      {
        for (Index j = start + begin; j < start + end; ++j)
        {
          auto& [memory, memoryOfReference] = memories[j - start];
          const Index i = j * all / count;
          const int r = samples.Triangles[i], s = feet[i];
          const double cosine = s < 0
            ? 0.0
            : normalOf(model, modelTriangles, r).dot(normalOf(reference, referenceTriangles, s));
          if (cosine == 0.0)
          {
            continue;
          }
          const Vector3 x = samples.Positions.row(i);
          const double difference = ofModel.over(x, r, radius, memory) -
            (cosine > 0.0 ? 1.0 : -1.0) * ofReference.over(x, s, radius, memoryOfReference);
          if (std::isfinite(difference * difference))
          {
            squares[j] = difference * difference;
          }
        }
      });
    measuring.report(static_cast<double>(start + length) / static_cast<double>(count));
  }
  double sum = 0.0, measured = 0.0;
  for (Index j = 0; j < count; ++j)
  {
    sum += std::max(squares[j], 0.0);
    measured += squares[j] >= 0.0 ? 1.0 : 0.0;
  }
  return measured > 0.0 ? std::sqrt(sum / measured) : 0.0;
}

// Statistics of values distributed over ranks, or held once.
double meanOf(const std::vector<double>& values, Index total, const Reduce& reduce = {})
{
  double sum = 0.0;
  inTurn(reduce, &sum, 1,
    [&]()
    {
      for (double value : values)
      {
        sum += value;
      }
    });
  return sum / static_cast<double>(total);
}

// Compute the maximum of values that are at least 0.
double maximumOf(const std::vector<double>& values, const Reduce& reduce = {})
{
  double ofOwn = 0.0;
  for (double value : values)
  {
    ofOwn = std::max(ofOwn, value);
  }
  return maximum(reduce, { ofOwn })[0];
}

// Compute square distances to the whole cloud from those to its parts.
std::vector<double> toNearestPart(const Reduce& reduce, std::vector<double> squares)
{
  const std::vector<Minimum> nearest = minimum(reduce, squares);
  std::transform(nearest.begin(), nearest.end(), squares.begin(),
    [](const Minimum& part) { return part.Value; });
  return squares;
}

std::vector<double> rootsTimes(std::vector<double> squares, double unit)
{
  for (double& value : squares)
  {
    value = std::sqrt(value) * unit;
  }
  return squares;
}

void requireUsable(
  const Triangles& modelTriangles, Index totalOfReference, const SurfaceMismatchOptions& options)
{
  if (modelTriangles.rows() == 0)
  {
    throw std::invalid_argument("the model has no triangles");
  }
  if (totalOfReference == 0)
  {
    throw std::invalid_argument("the reference has no points");
  }
  if (options.NumberOfSamples < 1)
  {
    throw std::invalid_argument("the number of samples must be positive");
  }
}

double fractionAbove(const std::vector<double>& values, double limit)
{
  return static_cast<double>(std::count_if(
           values.begin(), values.end(), [limit](double value) { return value > limit; })) /
    static_cast<double>(values.size());
}

// Throw unless distances of this maximum, and their mean squares, are finite and no square is lost.
// @param[in] square  square of the unit of the measures
void requireSquares(const SurfaceMismatch& result, double square, double maximumDistance)
{
  constexpr double minimumSquare = 0x1p-960; // smaller squares would lose digits
  if (!std::isfinite(maximumDistance) || square < minimumSquare ||
    !std::isfinite(result.MeanSquarePointToVertex + result.MeanSquareSurfaceToPoint))
  {
    throw std::invalid_argument(std::string("the distances are too ") +
      (square < minimumSquare ? "small" : "large") + " to be squared; use another LengthUnit");
  }
}
}

//------------------------------------------------------------------------------
SurfaceMismatch measureSurfaceMismatch(const PointView& modelPoints,
  const Triangles& modelTriangles, const PointView& referencePoints,
  const Triangles& referenceTriangles, const SurfaceMismatchOptions& options, const Reduce& reduce,
  const Run& run)
{
  std::int64_t totals[] = { referencePoints.size(), referenceTriangles.rows() };
  reduce.sum(totals, 2);
  const Index total = totals[0];
  const bool isCloud = totals[1] == 0;
  requireUsable(modelTriangles, total, options);
  const Index size = referencePoints.size();
  // Points, then a tree and a search each: from the reference to the model's triangles and to its
  // vertices, from samples and from vertices of the model to the reference; then the figures and
  // curvatures.
  Steps steps(run, { 0.02, 0.21, 0.12, 0.11, 0.12, 0.21, 0.02, 0.05, 0.12, 0.02, 0.1 });
  steps.next();
  requireFinite(modelPoints, "model", {});
  requireFinite(referencePoints, "reference", reduce);

  const Frame frame = frameOf(referencePoints, total, options.LengthUnit, reduce);
  const Points model = frame(modelPoints);
  const auto data = [&](Index i) { return frame(referencePoints[i]); };

  SurfaceMismatch result;
  const double distanceUnit = frame.Unit * options.CoordinateUnit;
  const bool inUsersUnit = options.LengthUnit == MismatchUnit::None;
  const double figureUnit = inUsersUnit ? options.CoordinateUnit : 1.0;
  const double square = figureUnit * figureUnit;
  result.LengthUnit = inUsersUnit ? 1.0 : distanceUnit;
  const auto measure = [&](const TriangleTree& tree, Index count, const auto& query)
  { return squareDistances(tree, count, query, steps.next()); };
  const std::vector<double> forward =
    measure(TriangleTree(model, modelTriangles, steps.next()), size, data);
  result.MeanSquarePointToSurface = square * meanOf(forward, total, reduce);
  const std::vector<int> vertices = usedVertices(modelTriangles, model.rows());
  result.MeanSquarePointToVertex = square *
    meanOf(
      measure(TriangleTree(model, asTriangles(vertices), steps.next()), size, data), total, reduce);

  // Closest points on edges may differ by rounding between triangles, and so between trees of parts
  // of the triangles. Points have one nearest distance.
  Points referenceFrame = frame(referencePoints);
  Triangles triangles = referenceTriangles;
  if (!isCloud)
  {
    triangles = gatherTriangles(reduce, triangles, size);
    referenceFrame = gatherRows(reduce, referenceFrame);
  }
  const TriangleTree reference = treeOf(referenceFrame, triangles, steps.next());
  steps.next();
  const Reduce overParts = isCloud ? reduce : Reduce();
  const Spread samples =
    spreadSamples(model, modelTriangles, options.NumberOfSamples, options.RandomSeed);
  std::vector<int> feet;
  const std::vector<double> back = toNearestPart(overParts,
    squareDistances(
      reference, samples.Positions.rows(),
      [&](Index i) { return Vector3(samples.Positions.row(i)); }, steps.next(), &feet));
  const std::vector<double> fromVertices = toNearestPart(
    overParts, measure(reference, model.rows(), [&](Index i) { return Vector3(model.row(i)); }));
  steps.next();
  result.MeanSquareSurfaceToPoint = square * meanOf(back, samples.Positions.rows());
  result.HasNormalAngle = !isCloud;
  if (result.HasNormalAngle)
  {
    result.RootMeanSquareNormalAngle =
      normalAngle(model, modelTriangles, samples.Triangles, referenceFrame, triangles, feet);
    result.RootMeanSquareCurvatureError =
      curvatureError(model, modelTriangles, samples, referenceFrame, triangles, feet,
        options.CurvatureRadius * frame.HalfDiagonal, steps.next()) /
      figureUnit;
  }
  const double web = WebDistance / figureUnit;
  result.WebFraction = fractionAbove(back, web * web);
  double farthest = std::max(maximumOf(forward, reduce), maximumOf(back));
  for (int v : vertices)
  {
    farthest = std::max(farthest, fromVertices[v]);
  }
  result.HausdorffDistance = std::sqrt(farthest) * figureUnit;
  result.ModelDistances = rootsTimes(fromVertices, distanceUnit);
  result.ReferenceDistances = rootsTimes(forward, distanceUnit);
  requireSquares(result, square, std::sqrt(farthest) * distanceUnit + distanceUnit);
  run.report(1.0);
  return result;
}
}

#include "Cloud/GroundPlane.h"

#include "Base/Random.h"
#include "Cloud/CloudParts.h"
#include "Cloud/SampleSpacing.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace conformal
{
namespace
{
constexpr Index WantedSamples = 20000;
constexpr int Candidates = 400;

struct Plane
{
  Vector3 Normal = Vector3::Zero();
  double Offset = 0.0;
  double height(const Vector3& x) const { return this->Normal.dot(x) - this->Offset; }
};

/// Plane of least squares through some of the points.
Plane planeThrough(const Points& points, const std::vector<int>& ids)
{
  Vector3 center = Vector3::Zero();
  for (const int i : ids)
  {
    center += points.row(i).transpose();
  }
  center /= static_cast<double>(ids.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const int i : ids)
  {
    const Vector3 d = points.row(i).transpose() - center;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Vector3 normal = axes.eigenvectors().col(0);
  return { normal, normal.dot(center) };
}

std::vector<int> pointsIn(const Plane& plane, const Points& points, double tolerance)
{
  std::vector<int> ids;
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    if (std::abs(plane.height(points.row(i))) <= tolerance)
    {
      ids.push_back(i);
    }
  }
  return ids;
}

/// Standard deviation of the heights of points in a plane, from their median magnitude. Points of
/// the object near the plane thus have little effect.
double noiseOf(const Plane& plane, const Points& points, const std::vector<int>& inPlane)
{
  constexpr double deviations = 1.4826; // of a normal distribution, per median magnitude
  std::vector<double> heights;
  heights.reserve(inPlane.size());
  for (const int i : inPlane)
  {
    heights.push_back(std::abs(plane.height(points.row(i))));
  }
  if (heights.empty())
  {
    return 0.0;
  }
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return deviations * *middle;
}

/// Plane with the most points. Each candidate is the plane of a point and of its neighbors.
Plane largestPlane(const Points& points, const SampleSpacing& spacing, double tolerance)
{
  constexpr int neighbors = 40, refinements = 8;
  Random random(1);
  Plane best;
  std::size_t most = 0;
  std::vector<Neighbor> around;
  for (int k = 0; k < Candidates; ++k)
  {
    const Vector3 seed = points.row(random.index(points.rows()));
    spacing.tree().nearest(seed, neighbors, around);
    std::vector<int> ids;
    ids.reserve(around.size());
    for (const Neighbor& neighbor : around)
    {
      ids.push_back(neighbor.Id);
    }
    const Plane plane = planeThrough(points, ids);
    const std::size_t count = pointsIn(plane, points, tolerance).size();
    if (count > most)
    {
      most = count;
      best = plane;
    }
  }
  // In later refinements, only points within three standard deviations are used.
  constexpr double deviations = 3.0, least = 1e-6;
  for (int k = 0; k < refinements; ++k)
  {
    const double noise = noiseOf(best, points, pointsIn(best, points, tolerance));
    const std::vector<int> ids =
      pointsIn(best, points, std::min(tolerance, deviations * noise + least * tolerance));
    best = ids.size() >= 3 ? planeThrough(points, ids) : best;
  }
  return best;
}

/// Picture of the plane in square cells: which of them have samples of the plane, and which are in
/// the outline of the object.
class Footprint
{
public:
  Footprint(const Plane& plane, double cell)
    : Cell(cell)
    , Right(plane.Normal.unitOrthogonal())
    , Up(plane.Normal.cross(this->Right))
  {
  }

  using Place = std::array<int, 2>;

  Place placeOf(const Vector3& x) const
  {
    return { static_cast<int>(std::floor(x.dot(this->Right) / this->Cell)),
      static_cast<int>(std::floor(x.dot(this->Up) / this->Cell)) };
  }

  void addObject(const Vector3& x) { this->Object.push_back(this->placeOf(x)); }
  void addGround(const Vector3& x) { this->Ground.push_back(this->placeOf(x)); }

  /// Return the share of the plane's cells outside of the outline, in each of four quadrants around
  /// the middle of the object. A cell is in the outline if the object has cells on both sides of
  /// it, in its row or in its column.
  std::array<double, 4> outside()
  {
    std::sort(this->Ground.begin(), this->Ground.end());
    this->Ground.erase(std::unique(this->Ground.begin(), this->Ground.end()), this->Ground.end());
    Place low{ 0, 0 }, high{ 0, 0 };
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto [first, last] = std::minmax_element(this->Object.begin(), this->Object.end(),
        [&](const Place& a, const Place& b) { return a[axis] < b[axis]; });
      low[axis] = (*first)[axis];
      high[axis] = (*last)[axis];
    }
    // Range of the object's cells in each row and in each column, with one cell more.
    std::array<std::vector<Place>, 2> ranges;
    for (int axis = 0; axis < 2; ++axis)
    {
      ranges[axis].assign(high[axis] - low[axis] + 1, Place{ 1, 0 }); // empty
      for (const Place& place : this->Object)
      {
        Place& range = ranges[axis][place[axis] - low[axis]];
        const int at = place[1 - axis];
        range = range[0] > range[1]
          ? Place{ at - 1, at + 1 }
          : Place{ std::min(range[0], at - 1), std::max(range[1], at + 1) };
      }
    }
    std::array<double, 4> shares{};
    for (const Place& place : this->Ground)
    {
      bool isInside = false;
      for (int axis = 0; axis < 2; ++axis)
      {
        const int line = place[axis] - low[axis];
        if (line >= 0 && line < static_cast<int>(ranges[axis].size()))
        {
          const Place& range = ranges[axis][line];
          isInside |= place[1 - axis] >= range[0] && place[1 - axis] <= range[1];
        }
      }
      if (!isInside)
      {
        const int quadrant =
          (2 * place[0] > low[0] + high[0] ? 1 : 0) + (2 * place[1] > low[1] + high[1] ? 2 : 0);
        shares[quadrant] += 1.0 / static_cast<double>(this->Ground.size());
      }
    }
    return shares;
  }

  /// Return the larger side of the object's outline.
  double width() const
  {
    double width = 0.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto [first, last] = std::minmax_element(this->Object.begin(), this->Object.end(),
        [&](const Place& a, const Place& b) { return a[axis] < b[axis]; });
      width = std::max(width, this->Cell * ((*last)[axis] - (*first)[axis] + 1));
    }
    return width;
  }

private:
  double Cell;
  Vector3 Right, Up;
  std::vector<Place> Object, Ground;
};

/// Test whether a plane is a ground, see findGround().
bool isGround(const Plane& plane, const Points& points, const std::vector<int>& inPlane,
  const Ground& ground, const Points& above, double spacing)
{
  constexpr double leastShare = 0.1, mostBelow = 0.01, leastOutside = 0.4, leastInQuadrant = 0.04;
  constexpr double leastHeight = 0.15, cell = 3.0;
  const auto total = static_cast<double>(points.rows());
  double below = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    below += plane.height(points.row(i)) < -3.0 * ground.Height;
  }
  if (static_cast<double>(inPlane.size()) < leastShare * total || below > mostBelow * total)
  {
    return false;
  }
  Footprint footprint(plane, cell * spacing);
  double height = 0.0;
  for (Index i = 0; i < above.rows(); ++i)
  {
    if (ground.Part->IsObject[i])
    {
      footprint.addObject(above.row(i));
      height = std::max(height, plane.height(above.row(i)));
    }
  }
  for (const int i : inPlane)
  {
    footprint.addGround(points.row(i));
  }
  const std::array<double, 4> outside = footprint.outside();
  const auto sides = std::count_if(
    outside.begin(), outside.end(), [](double share) { return share >= leastInQuadrant; });
  return outside[0] + outside[1] + outside[2] + outside[3] >= leastOutside && sides >= 3 &&
    height >= leastHeight * footprint.width();
}
}

//------------------------------------------------------------------------------
bool Ground::hasObjectAt(const Vector3& x) const
{
  if (this->Normal.dot(x) - this->Offset <= this->Height)
  {
    return false;
  }
  const Neighbor nearest = this->Part->Tree.nearest(x);
  return nearest.SquareDistance <= this->Reach * this->Reach && this->Part->IsObject[nearest.Id];
}

//------------------------------------------------------------------------------
Ground findGround(const TrainingSamples& samples, RemoveGround mode)
{
  constexpr double fewest = 0.05, reach = 4.0;
  Ground ground;
  const Index minimumSamples = mode == RemoveGround::Automatic ? 500 : 50;
  if (mode == RemoveGround::Off || samples.totalSize() < minimumSamples || samples.dimension() < 3)
  {
    return ground;
  }
  const Points points = selectedSamples(samples, WantedSamples);
  const SampleSpacing spacings(points);
  const double spacing = spacings.median();
  if (!(spacing > 0.0)) // Most points coincide.
  {
    return ground;
  }
  Plane plane = largestPlane(points, spacings, spacing);
  double sum = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const double height = plane.height(points.row(i));
    sum += std::abs(height) > spacing ? height : 0.0;
  }
  if (sum < 0.0)
  {
    plane = { -plane.Normal, -plane.Offset };
  }
  const std::vector<int> inPlane = pointsIn(plane, points, spacing);
  if (static_cast<double>(inPlane.size()) < fewest * static_cast<double>(points.rows()))
  {
    return ground;
  }
  const double noise = noiseOf(plane, points, inPlane);
  const double full = spacing *
    std::sqrt(static_cast<double>(points.rows()) / static_cast<double>(samples.totalSize()));
  ground.Normal = plane.Normal;
  ground.Offset = plane.Offset;
  ground.Height = std::max(4.0 * noise, 1.5 * full);
  ground.Reach = reach * spacing;

  std::vector<double> coordinates;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (plane.height(points.row(i)) > ground.Height)
    {
      coordinates.insert(coordinates.end(), points.row(i).data(), points.row(i).data() + 3);
    }
  }
  const Points above =
    Eigen::Map<const Points>(coordinates.data(), static_cast<Index>(coordinates.size()) / 3, 3);
  if (above.rows() == 0)
  {
    return {};
  }
  auto parts = std::make_shared<Ground::Parts>();
  const SampleSpacing ofAbove(above);
  parts->Tree = ofAbove.tree();
  const std::vector<int> names = partsOfCloud(above, ofAbove, ground.Reach);
  std::vector<int> sizes(names.size(), 0);
  for (const int name : names)
  {
    ++sizes[name];
  }
  const auto largest =
    static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (const int name : names)
  {
    parts->IsObject.push_back(name == largest);
  }
  ground.Part = parts;
  // The feet of a table or chair are alike, and its plate is no ground.
  const auto alike =
    std::count_if(sizes.begin(), sizes.end(), [&](int size) { return 2 * size > sizes[largest]; });
  const bool isFoot = alike > 2;
  if (mode == RemoveGround::Automatic &&
    (isFoot || !isGround(plane, points, inPlane, ground, above, spacing)))
  {
    return {};
  }
  return ground;
}
}

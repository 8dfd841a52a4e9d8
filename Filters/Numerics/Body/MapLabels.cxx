#include "Body/MapLabels.h"

#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Search/TriangleTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace conformal
{
namespace
{
constexpr int NoPixel = -1;

// Pixel at a position in pixels.
Index pixelAt(const MapImage& image, const Vector2& pixels)
{
  const auto along = [](double x, Index size)
  { return std::clamp<Index>(static_cast<Index>(x), 0, size - 1); };
  return along(pixels[1], image.Grid.Height) * image.Grid.Width +
    along(pixels[0], image.Grid.Width);
}

// Labels of all pixels. A pixel whose middle is beyond the outline of the map shows a part of the
// map too; it gets the label of a neighbor in the map.
std::vector<int> extended(const MapImage& image, const std::vector<int>& labels)
{
  std::vector<int> result = labels;
  const Index width = image.Grid.Width, height = image.Grid.Height;
  constexpr int neighbors[8][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 }, { 1, 1 }, { -1, 1 },
    { 1, -1 }, { -1, -1 } };
  Vector3 n;
  for (Index p = 0; p < image.Grid.size(); ++p)
  {
    if (image.directionOf(p, n))
    {
      continue;
    }
    result[p] = 0;
    for (const auto& step : neighbors)
    {
      const Index i = p % width + step[0], j = p / width + step[1];
      if (i >= 0 && i < width && j >= 0 && j < height && image.directionOf(j * width + i, n))
      {
        result[p] = labels[j * width + i];
        break;
      }
    }
  }
  return result;
}

// Sums over the parts of one label.
struct LabelMoments
{
  double Area = 0.0;
  Vector3 First = Vector3::Zero();
  Eigen::Matrix3d Second = Eigen::Matrix3d::Zero();

  void add(double area, const Vector3& position)
  {
    this->Area += area;
    this->First += area * position;
    this->Second += area * position * position.transpose();
  }
  void add(const LabelMoments& other)
  {
    this->Area += other.Area;
    this->First += other.First;
    this->Second += other.Second;
  }
};

using MomentsOfLabels = std::map<int, LabelMoments>;

// Divide triangles into parts of one label.
class Division
{
public:
  Division(const MappedMesh& body, const MapImage& image, const std::vector<int>& labels)
    : Body(body)
    , Image(image)
    , Labels(labels)
  {
  }

  // Add a piece of a triangle that is divided into 4^level pieces.
  void add(Index triangle, Index piece, int level, MomentsOfLabels& sums) const
  {
    Part part;
    for (int k = 0; k < 3; ++k)
    {
      part.Corners[k] = this->at(triangle, Vector3::Unit(k));
    }
    part.Area = areaVector(this->Body.Positions, this->Body.Triangles, triangle).norm();
    for (int l = level - 1; l >= 0; --l)
    {
      part = this->quarters(triangle, part)[(piece >> (2 * l)) & 3];
    }
    if (part.Area > 0.0)
    {
      this->divide(triangle, part, level, sums);
    }
  }

private:
  struct Corner
  {
    Vector3 Weights, Direction;
    Vector2 Pixels;
    int Label = 0;
  };
  struct Part
  {
    std::array<Corner, 3> Corners;
    double Area = 0.0;
  };

  Corner at(Index triangle, const Vector3& weights) const
  {
    Corner corner;
    corner.Weights = weights;
    Vector3 n = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      n +=
        weights[k] * this->Body.SpherePositions.row(this->Body.Triangles(triangle, k)).transpose();
    }
    const double length = n.norm();
    corner.Direction = length > 0.0 ? Vector3(n / length) : Vector3(0, 0, 1);
    corner.Pixels = this->Image.toPixels(corner.Direction);
    corner.Label = this->Labels[pixelAt(this->Image, corner.Pixels)];
    return corner;
  }

  Vector3 positionOf(Index triangle, const Vector3& weights) const
  {
    Vector3 position = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      position +=
        weights[k] * this->Body.Positions.row(this->Body.Triangles(triangle, k)).transpose();
    }
    return position;
  }

  // Divide a part at the middles of its sides.
  std::array<Part, 4> quarters(Index triangle, const Part& part) const
  {
    const auto& c = part.Corners;
    std::array<Corner, 3> middles;
    for (int k = 0; k < 3; ++k)
    {
      middles[k] =
        this->at(triangle, 0.5 * (c[next(k)].Weights + c[previous(k)].Weights)); // opposite to k
    }
    const double area = 0.25 * part.Area;
    std::array<Part, 4> result = { { { middles, area } } };
    for (int k = 0; k < 3; ++k)
    {
      result[k + 1] = { { c[k], middles[previous(k)], middles[next(k)] }, area };
    }
    return result;
  }

  void divide(Index triangle, const Part& part, int level, MomentsOfLabels& sums) const
  {
    constexpr int deepest = 16;
    constexpr double finest = 0.125;
    const auto& c = part.Corners;
    const Vector3 middle = (c[0].Weights + c[1].Weights + c[2].Weights) / 3.0;
    double pixels = 0.0, angle = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      pixels = std::max(pixels, (c[k].Pixels - c[next(k)].Pixels).norm());
      angle = std::max(angle, (c[k].Direction - c[next(k)].Direction).norm());
    }
    // At seams of the map, distances in pixels stay large, but angles become small.
    const double size = std::min(pixels, this->Image.pixelsOfAngle(c[0].Direction, angle));
    const int label = this->at(triangle, middle).Label;
    const bool isUniform =
      size <= 1.0 && c[0].Label == label && c[1].Label == label && c[2].Label == label;
    if (isUniform || size <= finest || level == deepest)
    {
      sums[label].add(part.Area, this->positionOf(triangle, middle));
      return;
    }
    for (const Part& quarter : this->quarters(triangle, part))
    {
      this->divide(triangle, quarter, level + 1, sums);
    }
  }

  const MappedMesh& Body;
  const MapImage& Image;
  const std::vector<int>& Labels;
};

MomentsOfLabels areaMoments(
  const MappedMesh& body, const MapImage& image, const std::vector<int>& labels, const Run& run)
{
  const Division division(body, image, labels);
  // The cost of a block is that of its pixels. Large triangles are therefore divided among blocks.
  constexpr Index pixelsOfBlock = 128;
  constexpr int maximumLevel = 8;
  int level = 0;
  const auto pieces = [&]() { return body.Triangles.rows() << (2 * level); };
  while (level < maximumLevel && pieces() * pixelsOfBlock < image.Grid.size())
  {
    ++level;
  }
  const Index size = pieces();
  const Index blockSize = std::clamp<Index>(pixelsOfBlock * size / image.Grid.size(), 1, Index(64));
  std::vector<MomentsOfLabels> parts((size + blockSize - 1) / blockSize);
  forBlocksReporting(run, size, blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Index triangle = i >> (2 * level);
        division.add(triangle, i - (triangle << (2 * level)), level, parts[begin / blockSize]);
      }
    });
  MomentsOfLabels sums;
  for (const MomentsOfLabels& part : parts)
  {
    for (const auto& [label, moments] : part)
    {
      sums[label].add(moments);
    }
  }
  return sums;
}

// Pairs of neighboring pixels, also across the outline of the map.
class Neighborhood
{
public:
  Neighborhood(const MapImage& image, const Points& positions, std::vector<unsigned char> isInMap)
    : Image(image)
    , Positions(positions)
    , IsInMap(std::move(isInMap))
  {
  }

  bool isInMap(Index pixel) const { return this->IsInMap[pixel] != 0; }

  struct Pair
  {
    Index Other = NoPixel;
    bool IsAcrossOutline = false;
  };

  // The neighbor of a pixel, `steps` pixels away.
  Pair neighbor(Index pixel, int right, int up) const
  {
    const Index width = this->Image.Grid.Width, height = this->Image.Grid.Height;
    const Index i = pixel % width + right, j = pixel / width + up;
    if (i >= 0 && i < width && j >= 0 && j < height && this->IsInMap[j * width + i])
    {
      return { j * width + i, false };
    }
    // Continue the line through the pixel and its opposite neighbor on the sphere.
    const Index k = pixel % width - right, l = pixel / width - up;
    Vector3 here, before;
    if (k < 0 || k >= width || l < 0 || l >= height || !this->Image.directionOf(pixel, here) ||
      !this->Image.directionOf(l * width + k, before))
    {
      return {};
    }
    const Vector3 beyond = 2.0 * here.dot(before) * here - before;
    const Index other = pixelAt(this->Image, this->Image.toPixels(beyond));
    // A pixel whose middle is beyond the outline has the label of the map that it shows.
    Vector3 direction;
    const bool isHole = !this->IsInMap[other] && this->Image.directionOf(other, direction);
    return { isHole || other == pixel ? NoPixel : other, true };
  }

  Vector3 between(Index pixel, const Pair& pair) const
  {
    return (this->Positions.row(pair.Other) - this->Positions.row(pixel)).transpose();
  }

private:
  const MapImage& Image;
  const Points& Positions;
  std::vector<unsigned char> IsInMap;
};

// Perimeters and neighbors of all labels.
struct Contacts
{
  std::map<int, double> Perimeters;
  std::map<int, std::set<int>> Neighbors;
};

// Step between two pixels, in pixels.
struct PixelStep
{
  int Right = 0, Up = 0;
  PixelStep operator+(const PixelStep& other) const
  {
    return { this->Right + other.Right, this->Up + other.Up };
  }
  PixelStep times(int factor) const { return { factor * this->Right, factor * this->Up }; }
};
constexpr int Directions = 8;
using EvenSteps = std::array<PixelStep, Directions>;

// Step on the surface, as the mean of the steps to both sides, which has the direction at the pixel
// itself; zero if neither side is in the map.
Vector3 onSurface(const Neighborhood& pixels, Index p, const PixelStep& step)
{
  const auto ahead = pixels.neighbor(p, step.Right, step.Up),
             behind = pixels.neighbor(p, -step.Right, -step.Up);
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  if (ahead.Other >= 0 && !ahead.IsAcrossOutline)
  {
    sum += pixels.between(p, ahead);
    count += 1.0;
  }
  if (behind.Other >= 0 && !behind.IsAcrossOutline)
  {
    sum -= pixels.between(p, behind);
    count += 1.0;
  }
  return count > 0.0 ? Vector3(sum / count) : sum;
}

double areaOf(const Neighborhood& pixels, Index p)
{
  return onSurface(pixels, p, { 1, 0 }).cross(onSurface(pixels, p, { 0, 1 })).norm();
}

// Choose steps from a pixel whose directions on the surface are about evenly spaced. They are sums
// of a and b, which are a reduced basis of the lattice of pixels, that of Gauss. Where pixels are
// oblong, a is repeated until it is about as long as b.
EvenSteps evenSteps(const Vector3& right, const Vector3& up)
{
  constexpr int rounds = 8, farthest = 3, mostRepeated = 8;
  PixelStep a = { 1, 0 }, b = { 0, 1 };
  Vector3 x = right, y = up;
  for (int i = 0; i < rounds; ++i)
  {
    if (y.squaredNorm() < x.squaredNorm())
    {
      std::swap(a, b);
      std::swap(x, y);
    }
    const double fraction = std::round(x.dot(y) / x.squaredNorm());
    if (!(std::abs(fraction) >= 1.0 && std::abs(fraction) <= farthest))
    {
      break;
    }
    const PixelStep shorter = b + a.times(-static_cast<int>(fraction));
    if (std::abs(shorter.Right) > farthest || std::abs(shorter.Up) > farthest)
    {
      break;
    }
    b = shorter;
    y -= fraction * x;
  }
  const double ratio = std::round(y.norm() / x.norm());
  a = a.times(ratio >= 1.0 ? static_cast<int>(std::min<double>(ratio, mostRepeated)) : 1);
  const PixelStep back = a.times(-1);
  EvenSteps steps = { a, a + a + b, a + b, a + b + b, b, b + b + back, b + back, b + back + back };
  // Pairs are counted from one side, and neighboring pixels must agree about the side.
  for (PixelStep& step : steps)
  {
    step = step.times(step.Up < 0 || (step.Up == 0 && step.Right < 0) ? -1 : 1);
  }
  return steps;
}

// Factors w_k s_k pi / 2 of steps on the surface, for pixels with the sides `right` and `up`.
std::array<double, Directions> croftonFactors(
  const Vector3& right, const Vector3& up, const std::array<Vector3, Directions>& steps)
{
  const Vector3 normal = right.cross(up);
  const double area = normal.norm();
  std::array<double, Directions> factors = {};
  if (!(area > 0.0))
  {
    return factors;
  }
  const Vector3 x = right.normalized(), y = normal.cross(x) / area;
  std::array<std::pair<double, int>, Directions> angles;
  for (int k = 0; k < Directions; ++k)
  {
    const double angle = std::atan2(steps[k].dot(y), steps[k].dot(x));
    angles[k] = { angle < 0.0 ? angle + Pi : angle, k };
  }
  std::sort(angles.begin(), angles.end());
  for (int k = 0; k < Directions; ++k)
  {
    const double before = k > 0 ? angles[k - 1].first : angles.back().first - Pi;
    const double after = k + 1 < Directions ? angles[k + 1].first : angles[0].first + Pi;
    const double share = 0.5 * (after - before) / Pi, length = steps[angles[k].second].norm();
    factors[angles[k].second] = length > 0.0 ? 0.5 * Pi * share * area / length : 0.0;
  }
  return factors;
}

// Add the share of one pixel to the perimeters.
void addPerimeters(const Neighborhood& pixels, const std::vector<int>& labels, Index p,
  std::map<int, double>& perimeters)
{
  const Vector3 right = onSurface(pixels, p, { 1, 0 }), up = onSurface(pixels, p, { 0, 1 });
  const EvenSteps steps = evenSteps(right, up);
  const double area = right.cross(up).norm();
  std::array<double, Directions> factors = { -1.0 };
  for (int k = 0; k < Directions; ++k)
  {
    for (const int side : { 1, -1 })
    {
      const auto pair = pixels.neighbor(p, side * steps[k].Right, side * steps[k].Up);
      // Pairs in the map are counted from one side; pairs across its outline from both.
      if (pair.Other < 0 || (side < 0 && !pair.IsAcrossOutline) || labels[p] == labels[pair.Other])
      {
        continue;
      }
      if (factors[0] < 0.0)
      {
        std::array<Vector3, Directions> lengths;
        for (int j = 0; j < Directions; ++j)
        {
          lengths[j] = onSurface(pixels, p, steps[j]);
          if (lengths[j].isZero(0.0))
          {
            lengths[j] = steps[j].Right * right + steps[j].Up * up;
          }
        }
        factors = croftonFactors(right, up, lengths);
      }
      // The area of a pixel is the mean of both ends.
      const double share = pair.IsAcrossOutline || !(area > 0.0)
        ? 0.5
        : 0.5 * (1.0 + areaOf(pixels, pair.Other) / area);
      const double length = factors[k] * share;
      perimeters[labels[p]] += length;
      perimeters[labels[pair.Other]] += length;
    }
  }
}

// Add the labels that touch that of one pixel.
void addNeighbors(const Neighborhood& pixels, const std::vector<int>& labels, Index p,
  std::map<int, std::set<int>>& neighbors)
{
  constexpr std::array<PixelStep, 4> steps = { { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 } } };
  const auto touch = [&](int a, int b)
  {
    if (a != b && a != 0 && b != 0)
    {
      neighbors[a].insert(b);
      neighbors[b].insert(a);
    }
  };
  for (int k = 0; k < 4; ++k)
  {
    for (const int side : { 1, -1 })
    {
      const PixelStep step = steps[k].times(side);
      const auto pair = pixels.neighbor(p, step.Right, step.Up);
      if (pair.Other < 0 || (side < 0 && !pair.IsAcrossOutline))
      {
        continue;
      }
      touch(labels[p], labels[pair.Other]);
      if (labels[pair.Other] == 0 && k % 2 == 0)
      {
        const auto second = pixels.neighbor(p, 2 * step.Right, 2 * step.Up);
        touch(labels[p], second.Other >= 0 ? labels[second.Other] : 0);
      }
    }
  }
}

Contacts findContacts(
  const MapImage& image, const Neighborhood& pixels, const std::vector<int>& labels, const Run& run)
{
  Contacts contacts;
  const Index size = image.Grid.size();
  for (Index p = 0; p < size; ++p)
  {
    if (p % image.Grid.Width == 0)
    {
      run.report(double(p) / double(size));
    }
    if (pixels.isInMap(p))
    {
      addPerimeters(pixels, labels, p, contacts.Perimeters);
      addNeighbors(pixels, labels, p, contacts.Neighbors);
    }
  }
  return contacts;
}

void measureShape(LabelMeasure& measure, const LabelMoments& moments, const TriangleTree& tree)
{
  measure.Area = moments.Area;
  const Vector3 mean = moments.First / moments.Area;
  const FootPoint foot = tree.closestPoint(mean);
  measure.Centroid = foot.Triangle >= 0 ? foot.Position : mean;
  const Eigen::Matrix3d covariance = moments.Second / moments.Area - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const double longest = solver.eigenvalues()[2], second = solver.eigenvalues()[1];
  // Below this share, differences of squares have no digits.
  const double least = 1e-13 * (moments.Second.trace() / moments.Area);
  if (longest > least)
  {
    measure.LongAxis = solver.eigenvectors().col(2);
    Index largest = 0;
    measure.LongAxis.cwiseAbs().maxCoeff(&largest);
    measure.LongAxis *= measure.LongAxis[largest] < 0.0 ? -1.0 : 1.0;
    measure.Elongation = std::sqrt(longest / std::max(second, least));
  }
}
}

//------------------------------------------------------------------------------
MapLabels measureMapLabels(
  const MappedMesh& given, const MapImage& image, const std::vector<int>& labels, const Run& run)
{
  const Index size = image.Grid.size();
  if (size < 1 || given.Triangles.rows() == 0 || static_cast<Index>(labels.size()) != size)
  {
    throw std::invalid_argument("labels need a surface with triangles, and a map with as many "
                                "pixels as labels");
  }
  requireFiniteTriangles(given.Positions, given.Triangles);
  Vector3 middle;
  const MappedMesh body = movedToOrigin(given, middle);
  Steps steps(run, { 0.3, 0.5, 0.15, 0.05 }); // pixels, areas, perimeters, centroids
  Points positions = Points::Zero(size, 3);
  std::vector<unsigned char> isInMap(size, 0);
  paintMap(
    body, image,
    [&](Index first, const std::vector<SurfacePlace>& places)
    {
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const Index pixel = first + static_cast<Index>(i);
        isInMap[pixel] = places[i].Ids[0] >= 0;
        for (int k = 0; k < 3 && isInMap[pixel]; ++k)
        {
          positions.row(pixel) += places[i].Weights[k] * body.Positions.row(places[i].Ids[k]);
        }
      }
    },
    steps.next());
  const std::vector<int> onMap = extended(image, labels);
  const MomentsOfLabels moments = areaMoments(body, image, onMap, steps.next());
  std::map<int, Index> counts;
  for (Index p = 0; p < size; ++p)
  {
    counts[labels[p]] += isInMap[p];
  }
  const Neighborhood pixels(image, positions, std::move(isInMap));
  const Contacts contacts = findContacts(image, pixels, onMap, steps.next());
  const TriangleTree tree(body.Positions, body.Triangles, steps.next());
  MapLabels result;
  for (const auto& [label, sums] : moments)
  {
    if (label == 0)
    {
      continue;
    }
    LabelMeasure measure;
    measure.Label = label;
    measure.NumberOfPixels = counts[label];
    measureShape(measure, sums, tree);
    measure.Centroid += middle;
    const auto perimeter = contacts.Perimeters.find(label);
    measure.Perimeter = perimeter != contacts.Perimeters.end() ? perimeter->second : 0.0;
    const auto neighbors = contacts.Neighbors.find(label);
    measure.NumberOfNeighbors =
      neighbors != contacts.Neighbors.end() ? static_cast<int>(neighbors->second.size()) : 0;
    result.Measures.push_back(measure);
  }
  result.VertexLabels.resize(body.Positions.rows());
  for (Index v = 0; v < body.Positions.rows(); ++v)
  {
    result.VertexLabels[v] = onMap[pixelAt(image, image.toPixels(body.SpherePositions.row(v)))];
  }
  return result;
}
}

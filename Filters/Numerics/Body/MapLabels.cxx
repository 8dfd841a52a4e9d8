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
constexpr int Outside = -1;

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
struct Moments
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
  void add(const Moments& other)
  {
    this->Area += other.Area;
    this->First += other.First;
    this->Second += other.Second;
  }
};

using MomentsOfLabels = std::map<int, Moments>;

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

  void add(Index triangle, MomentsOfLabels& sums) const
  {
    Part part;
    for (int k = 0; k < 3; ++k)
    {
      part.Corners[k] = this->at(triangle, Vector3::Unit(k));
    }
    part.Area = areaVector(this->Body.Positions, this->Body.Triangles, triangle).norm();
    if (part.Area > 0.0)
    {
      this->divide(triangle, part, 0, sums);
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
    std::array<Corner, 3> middles;
    for (int k = 0; k < 3; ++k)
    {
      middles[k] =
        this->at(triangle, 0.5 * (c[next(k)].Weights + c[previous(k)].Weights)); // opposite to k
    }
    const double quarter = 0.25 * part.Area;
    this->divide(triangle, { middles, quarter }, level + 1, sums);
    for (int k = 0; k < 3; ++k)
    {
      this->divide(
        triangle, { { c[k], middles[previous(k)], middles[next(k)] }, quarter }, level + 1, sums);
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
  constexpr Index blockSize = 64;
  const Index size = body.Triangles.rows(), blocks = (size + blockSize - 1) / blockSize;
  std::vector<MomentsOfLabels> parts(blocks);
  forBlocksReporting(run, size, blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        division.add(r, parts[begin / blockSize]);
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
    Index Other = Outside;
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
    return { this->IsInMap[other] && other != pixel ? other : Outside, true };
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

constexpr std::array<std::array<int, 2>, 4> Steps4 = { { { 1, 0 }, { 1, 1 }, { 0, 1 },
  { -1, 1 } } };

// Factors w_k s_k pi / 2 of the four directions, for steps e1 to the right and e2 up.
std::array<double, 4> croftonFactors(const Vector3& e1, const Vector3& e2)
{
  const double area = e1.cross(e2).norm();
  std::array<double, 4> factors = { 0.0, 0.0, 0.0, 0.0 };
  if (!(area > 0.0))
  {
    return factors;
  }
  const Vector3 x = e1.normalized(), y = (e2 - e2.dot(x) * x).normalized();
  std::array<double, 4> angles;
  std::array<double, 4> lengths;
  for (int k = 0; k < 4; ++k)
  {
    const Vector3 d = Steps4[k][0] * e1 + Steps4[k][1] * e2;
    angles[k] = std::atan2(d.dot(y), d.dot(x)); // ascending, in [0, pi)
    lengths[k] = d.norm();
  }
  for (int k = 0; k < 4; ++k)
  {
    const double before = k > 0 ? angles[k - 1] : angles[3] - Pi;
    const double after = k < 3 ? angles[k + 1] : angles[0] + Pi;
    const double share = 0.5 * (after - before) / Pi;
    factors[k] = 0.5 * Pi * share * area / lengths[k];
  }
  return factors;
}

Contacts findContacts(
  const MapImage& image, const Neighborhood& pixels, const std::vector<int>& labels, const Run& run)
{
  Contacts contacts;
  const auto touch = [&](int a, int b)
  {
    if (a != b && a != 0 && b != 0)
    {
      contacts.Neighbors[a].insert(b);
      contacts.Neighbors[b].insert(a);
    }
  };
  const Index size = image.Grid.size();
  for (Index p = 0; p < size; ++p)
  {
    if (p % image.Grid.Width == 0)
    {
      run.report(double(p) / double(size));
    }
    if (!pixels.isInMap(p))
    {
      continue;
    }
    const auto stepOf = [&](int right, int up)
    {
      const auto pair = pixels.neighbor(p, right, up);
      if (pair.Other >= 0 && !pair.IsAcrossOutline)
      {
        return pixels.between(p, pair);
      }
      const auto other = pixels.neighbor(p, -right, -up);
      return other.Other >= 0 ? Vector3(-pixels.between(p, other)) : Vector3(Vector3::Zero());
    };
    std::array<double, 4> factors = { -1.0, 0.0, 0.0, 0.0 };
    for (int k = 0; k < 4; ++k)
    {
      for (const int side : { 1, -1 })
      {
        const auto pair = pixels.neighbor(p, side * Steps4[k][0], side * Steps4[k][1]);
        // Pairs in the map are counted from one side; pairs across its outline from both.
        if (pair.Other < 0 || (side < 0 && !pair.IsAcrossOutline))
        {
          continue;
        }
        const int a = labels[p], b = labels[pair.Other];
        if (a != b)
        {
          if (factors[0] < 0.0)
          {
            factors = croftonFactors(stepOf(1, 0), stepOf(0, 1));
          }
          const double length = factors[k] * (pair.IsAcrossOutline ? 0.5 : 1.0);
          contacts.Perimeters[a] += length;
          contacts.Perimeters[b] += length;
        }
        touch(a, b);
        if (b == 0 && k % 2 == 0)
        {
          const auto second = pixels.neighbor(p, 2 * side * Steps4[k][0], 2 * side * Steps4[k][1]);
          touch(a, second.Other >= 0 ? labels[second.Other] : 0);
        }
      }
    }
  }
  return contacts;
}

void measureShape(LabelMeasure& measure, const Moments& moments, const TriangleTree& tree)
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
  const MappedMesh& body, const MapImage& image, const std::vector<int>& labels, const Run& run)
{
  const Index size = image.Grid.size();
  if (size < 1 || body.Triangles.rows() == 0 || static_cast<Index>(labels.size()) != size)
  {
    throw std::invalid_argument("labels need a surface with triangles, and a map with as many "
                                "pixels as labels");
  }
  requireFiniteTriangles(body.Positions, body.Triangles);
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
  const Contacts contacts = findContacts(image, pixels, labels, steps.next());
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

#include "TriangleMap/FlatMap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace conformal
{

namespace
{
// Dilatation above which the affine map is used. Measured: with a smaller limit, more triangles
// bend; with a larger limit, points concentrate in corners.
constexpr double MaximumDilatation = 1.5;

/// Return the barycentric coordinates of a point on an edge.
Vector3 pointOfEdge(int edge, const EdgeShares& shares)
{
  Vector3 point = Vector3::Zero();
  point[next(edge)] = shares.First;
  point[previous(edge)] = shares.Second;
  return point;
}

/// Normalize two positive weights to sum 1.
EdgeShares sharesOf(double first, double second)
{
  const double sum = first + second;
  return { first / sum, second / sum };
}

/// Compute the edge lengths of a triangle as shares of their sum. The last digits, which depend on
/// the position of the triangle, are removed.
std::array<long, 3> roundedLengths(const Points& points, const Triangles& triangles, Index triangle)
{
  Vector3 lengths;
  for (int k = 0; k < 3; ++k)
  {
    lengths[k] =
      (points.row(triangles(triangle, next(k))) - points.row(triangles(triangle, previous(k))))
        .norm();
  }
  const double sum = lengths.sum(), digits = 1e9;
  if (!(sum > 0.0) || !std::isfinite(sum))
  {
    return {};
  }
  lengths *= digits / sum;
  return { std::lround(lengths[0]), std::lround(lengths[1]), std::lround(lengths[2]) };
}

/// Sort edges by length. The result depends neither on the first corner nor on the numbering of
/// vertices. Edges of equal length on the sphere and in the model are ordered by the id of the
/// opposite corner.
std::array<unsigned char, 3> orderOf(
  const Points& sphere, const Points& model, const Triangles& triangles, Index triangle)
{
  const std::array<long, 3> first = roundedLengths(sphere, triangles, triangle),
                            second = roundedLengths(model, triangles, triangle);
  const auto key = [&](int k)
  { return std::make_tuple(first[k], second[k], triangles(triangle, k)); };
  std::array<unsigned char, 3> order{ 0, 1, 2 };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  return order;
}
}

//------------------------------------------------------------------------------
// Near an end of the edge, both maps are powers of the coordinate s of the half disk.
FlatMap::Edge FlatMap::own(int edge, TriangleMap& network, TriangleMap& model)
{
  double power[2], factor[2];
  for (const bool atSecond : { false, true })
  {
    const int k = TriangleMap::corner(edge, atSecond);
    power[atSecond] = model.shape().angles()[k] / network.shape().angles()[k];
    factor[atSecond] =
      model.logFactor(edge, atSecond) - power[atSecond] * network.logFactor(edge, atSecond);
  }
  return { power[0], power[1], 0.25 * (factor[0] - factor[1]) };
}

//------------------------------------------------------------------------------
FlatMap::FlatMap(const Points& sphere, const Points& model, const Triangles& triangles,
  const Triangles& neighbors, SeamMode seamMode, const Run& run)
  : Slides(seamMode == SeamMode::EdgeMatched)
  , Network(sphere, triangles, run)
  , Model(triangles.rows())
  , All(triangles.rows())
  , Order(triangles.rows())
{
  std::vector<std::array<Edge, 3>> own(this->Slides ? triangles.rows() : 0);
  forBlocksReporting(run, triangles.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        if (this->Slides)
        {
          this->Order[r] = orderOf(sphere, model, triangles, r);
        }
        TriangleShape& shape = this->Model[r];
        shape = TriangleShape(
          model.row(triangles(r, 0)), model.row(triangles(r, 1)), model.row(triangles(r, 2)));
        if (this->degenerate(r))
        {
          continue;
        }
        TriangleMap network = this->Network.map(r);
        this->All[r].Affine =
          this->Slides && !(network.shape().dilatation(shape) <= MaximumDilatation);
        if (this->Slides && !this->All[r].Affine)
        {
          TriangleMap ofModel(shape);
          for (int edge = 0; edge < 3; ++edge)
          {
            own[r][edge] = FlatMap::own(edge, network, ofModel);
          }
        }
      }
    });
  if (!this->Slides)
  {
    return;
  }
  forBlocks(run, triangles.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        for (int edge = 0; edge < 3; ++edge)
        {
          const Index other = neighbors(r, next(edge));
          const int end = triangles(r, next(edge)); // its second end in that triangle
          int there = 0;
          while (triangles(other, previous(there)) != end)
          {
            ++there;
          }
          const Edge &a = own[r][edge], &b = own[other][there];
          this->All[r].Of[edge] = { 0.5 * (a.AtFirst + b.AtSecond), 0.5 * (a.AtSecond + b.AtFirst),
            0.5 * (a.HalfFactor - b.HalfFactor) };
        }
      }
    });
}

//------------------------------------------------------------------------------
EdgeShares FlatMap::Edge::image(const EdgeShares& t) const
{
  const double first = this->AtSecond * std::log(t.First) - this->HalfFactor,
               second = this->AtFirst * std::log(t.Second) + this->HalfFactor;
  const double ratio = std::exp(-std::abs(first - second));
  const double larger = 1.0 / (1.0 + ratio), smaller = ratio * larger;
  return first > second ? EdgeShares{ larger, smaller } : EdgeShares{ smaller, larger };
}

//------------------------------------------------------------------------------
FlatMap::Triangle::Triangle(const FlatMap& map, Index id)
  : Map(&map)
  , Id(id)
  , Affine(map.All[id].Affine)
{
  if (!this->Affine)
  {
    this->Network = map.Network.map(id);
    this->Model = TriangleMap(map.Model[id]);
  }
}

//------------------------------------------------------------------------------
Vector3 FlatMap::Triangle::base(const Vector3& barycentric, Eigen::Matrix3d* derivative)
{
  if (this->Affine)
  {
    if (derivative)
    {
      derivative->setIdentity();
    }
    return barycentric;
  }
  const HalfDiskPoint point = this->Network.toHalfDisk(barycentric);
  if (derivative)
  {
    *derivative = this->Network.shape().mapDerivative(this->Model.shape(), point);
  }
  return this->Model.fromHalfDisk(point);
}

//------------------------------------------------------------------------------
// Find the position on the edge of the network for a position on the edge of the model, by the map
// of the triangle.
EdgeShares FlatMap::Triangle::networkShares(int edge, const EdgeShares& model, double* rate)
{
  if (this->Affine)
  {
    if (rate)
    {
      *rate = 1.0;
    }
    return model;
  }
  const EdgePoint point = this->Model.toHalfDisk(edge, model);
  const EdgeShares network = this->Network.fromHalfDisk(edge, point);
  if (rate)
  {
    const double ofNetwork = point.AtSecond ? network.First : network.Second,
                 ofModel = point.AtSecond ? model.First : model.Second;
    *rate = ofNetwork * this->Network.logSlope(edge, point) /
      (ofModel * this->Model.logSlope(edge, point));
  }
  return network;
}

//------------------------------------------------------------------------------
bool FlatMap::Triangle::slides(int edge, const Vector3& barycentric) const
{
  return barycentric[next(edge)] > 0.0 && barycentric[previous(edge)] > 0.0 &&
    !(this->Affine && this->Map->All[this->Id].Of[edge].identity());
}

//------------------------------------------------------------------------------
FlatMap::Triangle::Slid FlatMap::Triangle::slid(
  int edge, const EdgeShares& place, double share, bool differentiate)
{
  const Edge& of = this->Map->All[this->Id].Of[edge];
  const double d = 1.0 - share, way = share * share, size = 1.0 + 2.0 * d;
  const EdgeShares at{ (place.First + d) / size, (place.Second + d) / size };
  double ownRate = 1.0;
  const EdgeShares t = this->networkShares(edge, at, differentiate ? &ownRate : nullptr);
  const EdgeShares image = of.image(t);
  const EdgeShares h =
    sharesOf(place.First * image.First * at.Second, place.Second * image.Second * at.First);
  Slid result;
  result.Place = { place.First + way * (h.First - place.First),
    place.Second + way * (h.Second - place.Second) };
  if (differentiate)
  {
    // Logarithmic derivatives of o(e(t)) / o(b') by b', and of o(h) by b and by d.
    const double ofRatio =
      (of.AtFirst / t.Second + of.AtSecond / t.First) * ownRate - 1.0 / (at.First * at.Second);
    const double withPlace = 1.0 / (place.First * place.Second) + ofRatio / size;
    const double withDistance = ofRatio * (place.First - place.Second) / (size * size);
    const double spread = h.First * h.Second;
    result.WithPlace = 1.0 + way * (spread * withPlace - 1.0);
    result.WithShare = 2.0 * share * (h.Second - place.Second) - way * spread * withDistance;
  }
  return result;
}

//------------------------------------------------------------------------------
void FlatMap::Triangle::slide(int edge, Vector3& barycentric, Eigen::Matrix3d* derivative)
{
  if (!this->slides(edge, barycentric))
  {
    return;
  }
  double &first = barycentric[next(edge)], &second = barycentric[previous(edge)];
  const double share = first + second;
  const EdgeShares place = sharesOf(first, second);
  const Slid moved = this->slid(edge, place, share, derivative != nullptr);
  if (derivative)
  {
    const Eigen::RowVector3d dFirst = derivative->row(next(edge)),
                             dSecond = derivative->row(previous(edge));
    const Eigen::RowVector3d dShare = dFirst + dSecond;
    const Eigen::RowVector3d dPlace = (dSecond - place.Second * dShare) / share;
    const Eigen::RowVector3d dMoved = moved.WithPlace * dPlace + moved.WithShare * dShare;
    derivative->row(previous(edge)) = moved.Place.Second * dShare + share * dMoved;
    derivative->row(next(edge)) = moved.Place.First * dShare - share * dMoved;
  }
  first = share * moved.Place.First;
  second = share * moved.Place.Second;
}

//------------------------------------------------------------------------------
// Newton's method for the logarithm of the odds, in which a slide is nearly linear; a bracket
// ensures convergence.
void FlatMap::Triangle::slideBack(int edge, Vector3& barycentric)
{
  if (!this->slides(edge, barycentric))
  {
    return;
  }
  double &first = barycentric[next(edge)], &second = barycentric[previous(edge)];
  const double share = first + second;
  const EdgeShares wanted = sharesOf(first, second);
  const double logit = std::log(wanted.Second / wanted.First);
  double low = -std::numeric_limits<double>::infinity(), high = -low, guess = logit;
  EdgeShares place = wanted;
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    const Slid got = this->slid(edge, place, share, true);
    const double miss = std::log(got.Place.Second / got.Place.First) - logit;
    (miss > 0.0 ? high : low) = guess;
    const double slope =
      got.WithPlace * place.First * place.Second / (got.Place.First * got.Place.Second);
    double better = guess - miss / slope;
    if (!(better >= low && better <= high))
    {
      better = std::isfinite(low + high) ? 0.5 * (low + high) : guess - std::copysign(1.0, miss);
    }
    const double step = std::abs(better - guess);
    guess = better;
    place = guess > 0.0 ? sharesOf(std::exp(-guess), 1.0) : sharesOf(1.0, std::exp(guess));
    if (step < 1e-8) // the remaining error is about the square of the step
    {
      break;
    }
  }
  first = share * place.First;
  second = share * place.Second;
}

//------------------------------------------------------------------------------
Vector3 FlatMap::Triangle::toModel(const Vector3& barycentric, Eigen::Matrix3d* derivative)
{
  Vector3 at = barycentric;
  if (derivative)
  {
    // No derivative exists at a corner: the exponents of the two maps differ.
    const double minimumDistance = 1e-6;
    at = at.cwiseMax(minimumDistance);
    at /= at.sum();
  }
  Vector3 image = this->base(at, derivative);
  if (!this->Map->Slides)
  {
    return derivative ? this->base(barycentric, nullptr) : image;
  }
  if (!derivative && barycentric.minCoeff() == 0.0)
  {
    int edge = 0;
    barycentric.minCoeff(&edge);
    const double first = barycentric[next(edge)], second = barycentric[previous(edge)];
    return first > 0.0 && second > 0.0
      ? pointOfEdge(edge, this->Map->All[this->Id].Of[edge].image({ first, second }))
      : barycentric;
  }
  for (const int edge : this->Map->Order[this->Id])
  {
    this->slide(edge, image, derivative);
  }
  return at == barycentric ? image : this->toModel(barycentric);
}

//------------------------------------------------------------------------------
Vector3 FlatMap::Triangle::toNetwork(const Vector3& barycentric)
{
  Vector3 image = barycentric;
  if (this->Map->Slides)
  {
    const auto& order = this->Map->Order[this->Id];
    for (auto edge = order.rbegin(); edge != order.rend(); ++edge)
    {
      this->slideBack(*edge, image);
    }
  }
  return this->Affine ? image : this->Network.fromHalfDisk(this->Model.shape().toHalfDisk(image));
}
}

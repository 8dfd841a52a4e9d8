#include "Surface/CurvedSeamlessSurface.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TriangleSubdivision.h"
#include "Mesh/VertexNormals.h"
#include "Sphere/SphereCoverage.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
void requireDifferentiable(const CurvedSeamlessSurface& surface, const char* what)
{
  if (!surface.differentiable())
  {
    throw std::invalid_argument(std::string("with DomeHeight Published or Scaled there is no ") +
      what + "; use DomeHeight None, Curvature or Fitted");
  }
}

/// Compute |J u x J v|, where u, v and p are orthonormal. The cofactors of J map u x v = p to J u x
/// J v.
double areaElement(const Eigen::Matrix3d& j, const Vector3& p)
{
  Eigen::Matrix3d cofactors;
  cofactors << j.col(1).cross(j.col(2)), j.col(2).cross(j.col(0)), j.col(0).cross(j.col(1));
  return (cofactors * p).norm();
}

/// Interpolate numbers of the vertices linearly at the point of an image. The result is never
/// beyond the numbers of the three vertices.
double interpolate(const double* numbers, const CurvedSeamlessSurface& surface,
  const CurvedSeamlessSurface::Image& image)
{
  const auto ids = surface.triangles().row(image.Triangle);
  const Vector3 corners(numbers[ids[0]], numbers[ids[1]], numbers[ids[2]]);
  return std::clamp(image.Barycentric.dot(corners), corners.minCoeff(), corners.maxCoeff());
}

/// Return the triangles, counter-clockwise on the sphere. If necessary, all of them are reversed.
/// Throw if the map does not cover the sphere exactly once.
conformal::Triangles trianglesOfMap(
  const Points& sphere, const conformal::Triangles& triangles, const Run& run)
{
  conformal::Triangles turned = triangles;
  const SphereCoverage coverage = turnToCover(sphere, turned, run);
  if (coverage.Degree != 1 || coverage.NumberOfFolds > 0)
  {
    throw std::invalid_argument("the map must cover the sphere exactly once, but it covers it " +
      std::to_string(coverage.Degree) + " times with " + std::to_string(coverage.NumberOfFolds) +
      " triangles folded over");
  }
  return turned;
}

/// Extrapolate vertex normals to the border. The mean normal of the triangles on one side of a
/// border vertex is the normal inside of the border, at 0.44 of the height of a triangle if the
/// triangles are equilateral. The neighbors inside are at a whole height.
void extrapolateToBorder(
  Points& normals, const conformal::Triangles& triangles, const conformal::Triangles& neighbors)
{
  constexpr double share = 0.44 / (1.0 - 0.44), nearlyUnit = 0.99;
  std::vector<char> onBorder(normals.rows(), 0);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (neighbors(r, k) < 0)
      {
        onBorder[triangles(r, k)] = onBorder[triangles(r, next(k))] = 1;
      }
    }
  }
  const Points own = normals;
  Points inside = Points::Zero(normals.rows(), 3);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangles(r, k), b = triangles(r, next(k));
      if (onBorder[a] != onBorder[b])
      {
        inside.row(onBorder[a] ? a : b) += own.row(onBorder[a] ? b : a);
      }
    }
  }
  for (Index v = 0; v < normals.rows(); ++v)
  {
    const Vector3 n = own.row(v), m = Vector3(inside.row(v)).stableNormalized();
    if (onBorder[v] && n.norm() > nearlyUnit && m.dot(n) > 0.0)
    {
      normals.row(v) = (n + share * (n - m)).normalized();
    }
  }
}
}

//------------------------------------------------------------------------------
void copyUnitVectors(const PointView& vectors, const char* what, double* units, const Run& run)
{
  std::atomic<Index> bad{ vectors.size() }; // index of the first bad vector
  forBlocks(run, vectors.size(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 unit = unitVector(vectors[i]);
        Eigen::Map<Vector3>(units + 3 * i) = unit;
        if (!unit.allFinite())
        {
          Index first = bad;
          while (i < first && !bad.compare_exchange_weak(first, i))
          {
          }
          return;
        }
      }
    });
  if (bad < vectors.size())
  {
    throw std::invalid_argument(
      std::string(what) + " " + std::to_string(bad) + " is zero or not finite");
  }
}

//------------------------------------------------------------------------------
Points unitVectors(const PointView& vectors, const char* what, const Run& run)
{
  Points units(vectors.size(), 3);
  copyUnitVectors(vectors, what, units.data(), run);
  return units;
}

//------------------------------------------------------------------------------
CurvedSeamlessSurface::CurvedSeamlessSurface(const MappedMesh& model,
  const CurvedSeamlessSurfaceOptions& options, const TrainingSamples* cloud, const Run& run)
  : CurvedSeamlessSurface(CappedSheet{ model, 0, 0 }, options, cloud, run)
{
}

//------------------------------------------------------------------------------
CurvedSeamlessSurface::CurvedSeamlessSurface(const CappedSheet& model,
  const CurvedSeamlessSurfaceOptions& options, const TrainingSamples* cloud, const Run& run)
  : Options(options)
  , Sphere(unitVectors(model.SpherePositions, "sphere position", run))
  , Model(model.Positions)
  , Triangles(trianglesOfMap(this->Sphere, model.Triangles, run))
  , CapVertices(model.NumberOfCapVertices)
  , CapTriangles(model.NumberOfCapTriangles)
{
  const bool isFitted = options.DomeHeight == DomeHeight::Fitted;
  const bool isMatched = options.SeamMode == SeamMode::EdgeMatched;
  // Points, neighbors, locator, flat maps, heights, degenerate triangles.
  Steps steps(run, { 0.02, 0.05, 0.3, isMatched ? 1.1 : 0.37, isFitted ? 20.0 : 0.22, 0.04 });
  steps.next();
  if (this->Sphere.rows() != this->Model.rows() || !this->Model.allFinite())
  {
    throw std::invalid_argument("the model needs one finite position for each sphere position");
  }
  if (!(options.VertexShift >= 0.0 && options.VertexShift <= MaximumVertexShift))
  {
    throw std::invalid_argument("VertexShift must lie in [0, 2]");
  }
  const Vector3 mean = this->Model.colwise().mean();
  Points centered = this->Model.rowwise() - mean.transpose();
  this->HeightUnit = centered.rowwise().stableNorm().maxCoeff();
  if (this->HeightUnit > 0.0)
  {
    centered /= this->HeightUnit;
  }
  const double rounding = 1e-12;
  this->InsideOut = !this->isSheet() && signedVolume(centered, this->Triangles) < -rounding;
  steps.next();
  const Adjacency around = vertexTriangles(this->Triangles, this->Model.rows());
  this->Neighbors = triangleNeighbors(this->Triangles, around, run);
  this->Locator = SphereLocator(this->Sphere, this->Triangles, this->Neighbors, steps.next());
  this->Flat = FlatMap(
    this->Sphere, this->Model, this->Triangles, this->Neighbors, options.SeamMode, steps.next());
  const Run curving = steps.next();
  if (this->differentiable())
  {
    this->curve(cloud, curving);
  }
  else
  {
    this->Domes = SphereDomes(this->Sphere, this->Model, this->Triangles, this->Neighbors,
      this->Flat, this->InsideOut, curving);
    this->scaleDomes();
  }
  steps.next();
  this->Degenerate.resize(this->Triangles.rows(), 0);
  for (Index r = 0; r < this->Triangles.rows(); ++r)
  {
    this->Degenerate[r] |=
      this->Flat.degenerate(r) || !(this->differentiable() || this->Domes.defined(r));
  }
}

//------------------------------------------------------------------------------
void CurvedSeamlessSurface::curve(const TrainingSamples* cloud, const Run& run)
{
  const conformal::Triangles triangles = this->Triangles.topRows(this->numberOfTriangles());
  const Adjacency around = vertexTriangles(triangles, this->Model.rows());
  Points normals = Points::Zero(this->Model.rows(), 3);
  if (this->Options.DomeHeight != DomeHeight::None)
  {
    normals = this->Options.DomeHeight == DomeHeight::Fitted
      ? vertexNormals(this->Model, triangles, around, run)
      : curvingNormals(this->Model, triangles, around, this->neighborsWithoutCaps(), run);
  }
  if (this->isSheet() && this->Options.DomeHeight != DomeHeight::None)
  {
    extrapolateToBorder(normals, triangles, this->neighborsWithoutCaps());
  }
  this->Curved = CurvedTriangles(this->Model, normals, triangles);
  if (this->Options.VertexShift > 0.0 && this->Options.DomeHeight != DomeHeight::None)
  {
    const Points lowered = lowerVertices(this->Curved, around, this->Options.VertexShift, run);
    this->Curved = CurvedTriangles(lowered, normals, triangles);
  }
  if (this->Options.DomeHeight == DomeHeight::Fitted)
  {
    if (!cloud || cloud->empty())
    {
      throw std::invalid_argument(
        "DomeHeight Fitted needs a cloud of points to fit the surface to");
    }
    this->Curved = fitCurvedTriangles(this->Curved, *cloud, this->Options.Fit, run);
  }
  this->Degenerate = flattenFolds(this->Curved, run);
}

//------------------------------------------------------------------------------
Triangles CurvedSeamlessSurface::neighborsWithoutCaps() const
{
  conformal::Triangles neighbors = this->Neighbors.topRows(this->numberOfTriangles());
  for (Index i = 0; i < neighbors.size(); ++i)
  {
    int& neighbor = neighbors.data()[i];
    neighbor = neighbor < this->numberOfTriangles() ? neighbor : -1;
  }
  return neighbors;
}

//------------------------------------------------------------------------------
// Compute the factor of the dome heights at each vertex. For Scaled domes, it is the square root of
// the area around the vertex in the model, divided by the area in the network. For Published domes,
// it is the largest radius of the model.
void CurvedSeamlessSurface::scaleDomes()
{
  this->Scales.assign(this->Model.rows(), this->HeightUnit);
  if (this->Options.DomeHeight != DomeHeight::Scaled)
  {
    return;
  }
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(this->Model.rows());
  Eigen::VectorXd solidAngles = areas;
  const auto area = [&](const Points& points, Index r, double unit)
  {
    const Vector3 a = points.row(this->Triangles(r, 0)) / unit,
                  b = points.row(this->Triangles(r, 1)) / unit,
                  c = points.row(this->Triangles(r, 2)) / unit;
    return (b - a).cross(c - a).norm();
  };
  const double unit = this->HeightUnit > 0.0 ? this->HeightUnit : 1.0;
  for (Index r = 0; r < this->Triangles.rows(); ++r)
  {
    const double ofModel = area(this->Model, r, unit), ofSphere = area(this->Sphere, r, 1.0);
    for (int k = 0; k < 3; ++k)
    {
      areas[this->Triangles(r, k)] += ofModel;
      solidAngles[this->Triangles(r, k)] += ofSphere;
    }
  }
  for (std::size_t i = 0; i < this->Scales.size(); ++i)
  {
    this->Scales[i] = solidAngles[i] > 0.0 ? unit * std::sqrt(areas[i] / solidAngles[i]) : 0.0;
  }
}

//------------------------------------------------------------------------------
Vector3 CurvedSeamlessSurface::onSphere(Index triangle, const Vector3& barycentric) const
{
  Vector3 flat = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    flat += barycentric[k] * this->Sphere.row(this->Triangles(triangle, k)).transpose();
  }
  return flat.normalized();
}

//------------------------------------------------------------------------------
// Compute the derivative of the barycentric coordinates of p' by p. Each row belongs to one
// coordinate.
Eigen::Matrix3d CurvedSeamlessSurface::projection(Index triangle, const Vector3& direction) const
{
  Eigen::Matrix3d slopes;
  Vector3 sides;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 a = this->Sphere.row(this->Triangles(triangle, next(k))),
                  b = this->Sphere.row(this->Triangles(triangle, previous(k)));
    slopes.row(k) = a.cross(b - a); // derivative of det(a, b, p) by p
    sides[k] = (a - direction).cross(b - direction).dot(direction);
  }
  const double sum = sides.sum();
  return (slopes - sides / sum * slopes.colwise().sum()) / sum;
}

//------------------------------------------------------------------------------
// Locate a direction in a triangle that is not on a cap. Rounding may move directions on the border
// to a cap.
SphereLocation CurvedSeamlessSurface::Evaluator::locate(const Vector3& direction) const
{
  constexpr double rounding = 1e-6; // barycentric
  const CurvedSeamlessSurface& s = this->Surface;
  SphereLocation location = s.Locator.locate(direction, this->Last);
  const Index sheet = s.numberOfTriangles();
  if (location.Triangle < sheet)
  {
    return location;
  }
  const int cap = location.Triangle;
  for (int k = 0; k < 3; ++k)
  {
    const int inside = s.Neighbors(cap, k);
    const double beyond = location.Barycentric[previous(k)];
    if (inside >= sheet || beyond > rounding)
    {
      continue;
    }
    const int first = s.Triangles(cap, k);
    SphereLocation onBorder;
    onBorder.Triangle = inside;
    for (int m = 0; m < 3; ++m)
    {
      const int id = s.Triangles(inside, m);
      onBorder.Barycentric[m] = id == first ? location.Barycentric[k]
        : id == s.Triangles(cap, next(k))   ? location.Barycentric[next(k)]
                                            : 0.0;
    }
    onBorder.Barycentric /= onBorder.Barycentric.sum();
    return onBorder;
  }
  throw std::invalid_argument("a direction is beyond the border of the surface");
}

//------------------------------------------------------------------------------
void CurvedSeamlessSurface::Evaluator::moveTo(Index triangle)
{
  if (triangle != this->Last)
  {
    this->Last = static_cast<int>(triangle);
    this->Flat.emplace(this->Surface.Flat, triangle);
    if (this->Surface.differentiable())
    {
      this->Curved = this->Surface.Curved[triangle];
      if (this->Surface.Options.DomeHeight != DomeHeight::None)
      {
        this->Shading = ShadingNormals(this->Curved);
      }
    }
  }
}

//------------------------------------------------------------------------------
CurvedSeamlessSurface::Image CurvedSeamlessSurface::Evaluator::onDomes(
  Index triangle, const Vector3& p, const Vector3& q) const
{
  const CurvedSeamlessSurface& s = this->Surface;
  const auto ids = s.Triangles.row(triangle);
  Image image;
  image.Position =
    q[0] * s.Model.row(ids[0]) + q[1] * s.Model.row(ids[1]) + q[2] * s.Model.row(ids[2]);
  image.Normal = s.Domes.normal(triangle);
  image.Triangle = static_cast<int>(triangle);
  const double height = s.Domes.height(triangle, p);
  if (height > 0.0)
  {
    const double scale =
      p[0] * s.Scales[ids[0]] + p[1] * s.Scales[ids[1]] + p[2] * s.Scales[ids[2]];
    image.Position += scale * height * s.Domes.direction(triangle, q);
  }
  return image;
}

//------------------------------------------------------------------------------
CurvedSeamlessSurface::Image CurvedSeamlessSurface::Evaluator::evaluate(
  const Vector3& direction, Eigen::Matrix3d* derivative)
{
  const CurvedSeamlessSurface& s = this->Surface;
  if (derivative)
  {
    requireDifferentiable(s, "derivative");
  }
  const SphereLocation location = this->locate(direction);
  const int r = location.Triangle;
  if (r < 0)
  {
    throw std::invalid_argument("not a unit vector");
  }
  this->moveTo(r);
  Eigen::Matrix3d ofMap;
  const Vector3& p = location.Barycentric;
  const Vector3 q = this->Flat->toModel(p, derivative ? &ofMap : nullptr);
  Image image;
  if (!s.differentiable())
  {
    image = this->onDomes(r, p, q);
    image.Barycentric = p;
    return image;
  }
  image.Triangle = r;
  image.Barycentric = p;
  image.Position = this->Curved.position(q);
  image.Normal =
    s.Options.DomeHeight == DomeHeight::None ? this->Curved.surfaceNormal(q) : this->Shading(q);
  if (s.InsideOut)
  {
    image.Normal = -image.Normal;
  }
  if (derivative && s.Flat.degenerate(r))
  {
    derivative->setZero();
  }
  else if (derivative)
  {
    *derivative = this->Curved.derivative(q) * ofMap * s.projection(r, direction);
  }
  return image;
}

//------------------------------------------------------------------------------
Vector3 CurvedSeamlessSurface::Evaluator::direction(Index triangle, const Vector3& barycentric)
{
  this->moveTo(triangle);
  return this->Surface.onSphere(triangle, this->Flat->toNetwork(barycentric));
}

//------------------------------------------------------------------------------
CurvedSeamlessInverse::CurvedSeamlessInverse(const CurvedSeamlessSurface& surface, const Run& run)
  : Tree(surface.curvedTriangles(), run)
{
  requireDifferentiable(surface, "inverse");
}

//------------------------------------------------------------------------------
CurvedSeamlessInverse::Foot CurvedSeamlessInverse::evaluate(
  const Vector3& point, CurvedSeamlessSurface::Evaluator& evaluator, int hint) const
{
  Foot foot;
  foot.OnSurface = this->Tree.closestPoint(point, hint);
  foot.Direction = evaluator.direction(foot.OnSurface.Triangle, foot.OnSurface.Barycentric);
  return foot;
}

//------------------------------------------------------------------------------
void evaluate(const CurvedSeamlessSurface& surface, const PointView& directions,
  const SurfaceSamples& samples, const Run& run)
{
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  if (samples.differentiates())
  {
    requireDifferentiable(surface, "derivative");
  }
  forBlocksReporting(run, directions.size(), HeavyBlock,
    [&](Index begin, Index end)
    {
      CurvedSeamlessSurface::Evaluator evaluator(surface);
      for (Index i = begin; i < end; ++i)
      {
        Eigen::Matrix3d derivative;
        const CurvedSeamlessSurface::Image image =
          evaluator.evaluate(directions[i], samples.differentiates() ? &derivative : nullptr);
        if (samples.Positions)
        {
          Eigen::Map<Vector3>(samples.Positions + 3 * i) = image.Position;
        }
        if (samples.Normals)
        {
          Eigen::Map<Vector3>(samples.Normals + 3 * i) = image.Normal;
        }
        if (samples.Derivatives)
        {
          Eigen::Map<RowMajor>(samples.Derivatives + 9 * i) = derivative;
        }
        if (samples.Metrics)
        {
          Eigen::Map<RowMajor>(samples.Metrics + 9 * i) = derivative.transpose() * derivative;
        }
        if (samples.AreaElements)
        {
          samples.AreaElements[i] = areaElement(derivative, directions[i]);
        }
        if (samples.Degenerate)
        {
          samples.Degenerate[i] = surface.degenerate()[image.Triangle];
        }
        if (samples.Numbers)
        {
          samples.Numbers[i] = interpolate(samples.VertexNumbers, surface, image);
        }
      }
    });
}

//------------------------------------------------------------------------------
Mesh subdividedNetwork(const CurvedSeamlessSurface& surface, int subdivisions, const Run& run)
{
  Mesh network;
  network.Positions = surface.sphere().topRows(surface.numberOfVertices());
  network.Triangles = surface.triangles().topRows(surface.numberOfTriangles());
  const Index numberOfVertices = network.Positions.rows();
  Mesh fine = subdivide(network, subdivisions, run);
  forBlocks(run, fine.Positions.rows() - numberOfVertices, HeavyBlock,
    [&](Index begin, Index end)
    { fine.Positions.middleRows(numberOfVertices + begin, end - begin).rowwise().normalize(); });
  return fine;
}

//------------------------------------------------------------------------------
void invert(const CurvedSeamlessSurface& surface, const PointView& points, double* directions,
  double* feet, const Run& run)
{
  for (Index i = 0; i < points.size(); ++i)
  {
    if (!points[i].allFinite())
    {
      throw std::invalid_argument("point " + std::to_string(i) + " is not finite");
    }
  }
  const CurvedSeamlessInverse inverse(surface, run);
  forBlocksReporting(run, points.size(), HeavyBlock,
    [&](Index begin, Index end)
    {
      CurvedSeamlessSurface::Evaluator evaluator(surface);
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        const CurvedSeamlessInverse::Foot foot = inverse.evaluate(points[i], evaluator, hint);
        hint = foot.OnSurface.Triangle;
        Eigen::Map<Vector3>(directions + 3 * i) = foot.Direction;
        if (feet)
        {
          Eigen::Map<Vector3>(feet + 3 * i) = foot.OnSurface.Position;
        }
      }
    });
}

//------------------------------------------------------------------------------
CurvedSeamlessSurfaceResult buildCurvedSeamlessSurface(const MappedMesh& model,
  const Points& directions, const CurvedSeamlessSurfaceOptions& options,
  const TrainingSamples* cloud, const Run& run)
{
  run.report(0.0);
  const double shareOfMesh = options.DomeHeight == DomeHeight::Fitted ? 0.95 : 0.5;
  const CurvedSeamlessSurface surface(model, options, cloud, run.part(0.0, shareOfMesh));
  CurvedSeamlessSurfaceResult result;
  result.Directions = unitVectors(directions, "direction", run);
  result.Positions.resize(directions.rows(), 3);
  result.Normals.resize(directions.rows(), 3);
  result.Degenerate.resize(directions.rows());
  result.NumberOfDegeneratePatches = surface.numberOfDegeneratePatches();
  SurfaceSamples samples;
  samples.Positions = result.Positions.data();
  samples.Normals = result.Normals.data();
  samples.Degenerate = result.Degenerate.data();
  evaluate(surface, result.Directions, samples, run.part(shareOfMesh, 1.0));
  run.report(1.0);
  return result;
}
}

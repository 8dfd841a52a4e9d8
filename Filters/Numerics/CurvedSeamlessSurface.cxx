#include "CurvedSeamlessSurface.h"

#include "GenusZeroCheck.h"
#include "MeshTopology.h"
#include "SphereCoverage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
constexpr Index BlockSize = 256;

Points unitVectors(const Points& vectors, const char* what)
{
  Points units(vectors.rows(), 3);
  for (Index i = 0; i < units.rows(); ++i)
  {
    units.row(i) = vectors.row(i).stableNormalized();
    if (!(std::abs(units.row(i).squaredNorm() - 1.0) < 0.5)) // zero and infinity stay as they are
    {
      throw std::invalid_argument(
        std::string(what) + " " + std::to_string(i) + " is zero or not finite: no direction");
    }
  }
  return units;
}

/// The faces turned to be counter-clockwise on the sphere, or an exception if it is not covered
/// just once.
Triangles facesOfMap(const Points& sphere, const Triangles& faces)
{
  Triangles turned = faces;
  SphereCoverage coverage = measureSphereCoverage(sphere, turned);
  if (coverage.Degree < 0)
  {
    turned.col(1).swap(turned.col(2));
    coverage = measureSphereCoverage(sphere, turned);
  }
  if (coverage.Degree != 1 || coverage.NumberOfFolds > 0)
  {
    throw std::invalid_argument("the map must cover the sphere just once, but it covers it " +
      std::to_string(coverage.Degree) + " times with " + std::to_string(coverage.NumberOfFolds) +
      " triangles folded over");
  }
  return turned;
}
}

//------------------------------------------------------------------------------
CurvedSeamlessSurface::CurvedSeamlessSurface(const Points& sphere, const Points& model,
  const Triangles& faces, const ParallelFor& parallelFor, const Progress& progress)
  : Sphere(unitVectors(sphere, "sphere position"))
  , Model(model)
  , Faces(facesOfMap(this->Sphere, faces))
{
  if (sphere.rows() != model.rows() || !model.allFinite())
  {
    throw std::invalid_argument("the model needs one finite position for each sphere position");
  }
  const Vector3 mean = model.colwise().mean();
  Points centered = model.rowwise() - mean.transpose();
  this->HeightUnit = centered.rowwise().stableNorm().maxCoeff();
  if (this->HeightUnit > 0.0)
  {
    centered /= this->HeightUnit;
  }
  const double rounding = 1e-12;
  const bool insideOut = signedVolume(centered, this->Faces) < -rounding;
  report(progress, 0.2);
  this->Neighbors = triangleNeighbors(this->Faces, model.rows());
  this->Locator = SphereLocator(this->Sphere, this->Faces);
  report(progress, 0.5);
  this->Network = NetworkShapes(this->Sphere, this->Faces, parallelFor);
  report(progress, 0.6);
  this->Shapes.resize(faces.rows());
  this->Centers.resize(faces.rows(), 3);
  this->Normals.resize(faces.rows(), 3);
  this->Degenerate.assign(faces.rows(), 0);
  forBlocks(parallelFor, faces.rows(), BlockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const auto ids = this->Faces.row(r);
        const Vector3 i = model.row(ids[0]), j = model.row(ids[1]), k = model.row(ids[2]);
        this->Shapes[r] = TriangleShape(i, j, k);
        this->Normals.row(r).setZero();
        if (!this->Shapes[r].degenerate())
        {
          const Vector3 normal =
            (j - i).stableNormalized().cross((k - i).stableNormalized()).normalized();
          this->Normals.row(r) = insideOut ? -normal : normal;
        }
        this->Centers.row(r) =
          this->Network.toModel(r, this->Shapes[r], Vector3::Constant(1.0 / 3.0));
      }
    });
  forBlocks(parallelFor, faces.rows(), BlockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        bool defined = !this->Shapes[r].degenerate() && !this->Network.degenerate(r);
        for (int k = 0; k < 3; ++k)
        {
          Vector3 unused;
          defined = this->edgeDirection(r, k, unused) && defined;
        }
        this->Degenerate[r] = defined ? 0 : 1;
      }
    });
}

//------------------------------------------------------------------------------
Vector3 CurvedSeamlessSurface::modelPoint(Index triangle, const Vector3& barycentric) const
{
  const auto ids = this->Faces.row(triangle);
  return barycentric[0] * this->Model.row(ids[0]) + barycentric[1] * this->Model.row(ids[1]) +
    barycentric[2] * this->Model.row(ids[2]);
}

//------------------------------------------------------------------------------
// Eq. 8, for the edge opposite to a corner. False, with the own normal, where it is 0/0.
bool CurvedSeamlessSurface::edgeDirection(Index triangle, int opposite, Vector3& direction) const
{
  const Vector3 own = this->Normals.row(triangle);
  const Vector3 sum =
    own + Vector3(this->Normals.row(this->Neighbors(triangle, (opposite + 1) % 3)));
  const double size = sum.norm();
  const double rounding = 1e-12;
  const bool defined = size > rounding;
  direction = defined ? Vector3(sum / size) : own;
  return defined;
}

//------------------------------------------------------------------------------
// Steps 8 and 9: n_q', Eq. 11.
Vector3 CurvedSeamlessSurface::direction(Index triangle, const Vector3& barycentric) const
{
  // q' = s c_w + ...: of the three subtriangles, that with the smallest s holds it.
  const Vector3 center = this->Centers.row(triangle);
  int k = 0;
  double s = 2.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double ofCenter = barycentric[corner] == 0.0 ? 0.0 : barycentric[corner] / center[corner];
    if (ofCenter < s)
    {
      s = ofCenter;
      k = corner;
    }
  }
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const double betaI = std::max(0.0, barycentric[i] - s * center[i]);
  const double betaJ = std::max(0.0, barycentric[j] - s * center[j]);

  // Along the edge from w_i to w_j, of length 1, the foot of c_w is at x, that of q' at
  // s x + betaJ. The subtriangle rises evenly from w_i to c_w and falls evenly from there to w_j,
  // so that |q' - a| / |b - a| is, on these two sides:
  const auto ids = this->Faces.row(triangle);
  const Vector3 wI = this->Model.row(ids[i]);
  const Vector3 edge = Vector3(this->Model.row(ids[j])) - wI;
  const double length2 = edge.squaredNorm();
  const double x =
    length2 > 0.0 ? (this->modelPoint(triangle, center) - wI).dot(edge) / length2 : 0.5;
  const auto quotient = [](double part, double rest)
  { return part + rest > 0.0 ? part / (part + rest) : 1.0; };
  double share = 1.0;
  if (x > 0.0)
  {
    share = quotient(betaJ, s * x);
  }
  if (x < 1.0)
  {
    share = std::min(share, quotient(betaI, s * (1.0 - x)));
  }

  Vector3 onEdge;
  this->edgeDirection(triangle, k, onEdge);
  const Vector3 own = this->Normals.row(triangle);
  return (share * (onEdge - own) + own).stableNormalized();
}

//------------------------------------------------------------------------------
CurvedSeamlessSurface::Image CurvedSeamlessSurface::evaluate(const Vector3& direction) const
{
  const SphereLocation location = this->Locator.locate(direction);
  const Index r = location.Triangle;
  if (r < 0)
  {
    throw std::invalid_argument("not a unit vector");
  }
  const Vector3& l = location.Barycentric;
  const auto ids = this->Faces.row(r);
  const Vector3 n0 = this->Sphere.row(ids[0]), n1 = this->Sphere.row(ids[1]),
                n2 = this->Sphere.row(ids[2]);

  // |p - p'| = 1 - |p'|, without the difference: 1 - |p'|^2 is a sum over the edges.
  const double deficit = l[0] * l[1] * (n1 - n0).squaredNorm() +
    l[1] * l[2] * (n2 - n1).squaredNorm() + l[2] * l[0] * (n0 - n2).squaredNorm();
  const double height = deficit / (1.0 + std::sqrt(std::max(0.0, 1.0 - deficit)));

  const Vector3 flat = this->Network.toModel(r, this->Shapes[r], l);
  Image image;
  image.Triangle = location.Triangle;
  image.Position = this->modelPoint(r, flat);
  if (height > 0.0)
  {
    image.Position += this->HeightUnit * height * this->direction(r, flat);
  }
  return image;
}

//------------------------------------------------------------------------------
CurvedSeamlessSurfaceResult buildCurvedSeamlessSurface(const Points& sphere, const Points& model,
  const Triangles& faces, const Points& directions, const ParallelFor& parallelFor,
  const Progress& progress)
{
  report(progress, 0.0);
  const double shareOfMesh = 0.5;
  CurvedSeamlessSurfaceResult result;
  result.Directions = unitVectors(directions, "direction");
  const Points& units = result.Directions;
  const CurvedSeamlessSurface surface(sphere, model, faces, parallelFor,
    [&](double fraction)
    {
      report(progress, shareOfMesh * fraction);
      return true;
    });
  result.NumberOfDegenerateTriangles =
    std::count(surface.degenerate().begin(), surface.degenerate().end(), 1);
  result.Positions.resize(units.rows(), 3);
  result.Normals.resize(units.rows(), 3);
  result.Degenerate.resize(units.rows());
  const Index chunk = 256 * BlockSize;
  for (Index first = 0; first < units.rows(); first += chunk)
  {
    const double fraction = static_cast<double>(first) / static_cast<double>(units.rows());
    report(progress, shareOfMesh + (1.0 - shareOfMesh) * fraction);
    forBlocks(parallelFor, std::min(chunk, units.rows() - first), BlockSize,
      [&](Index begin, Index end)
      {
        for (Index i = first + begin; i < first + end; ++i)
        {
          const CurvedSeamlessSurface::Image image = surface.evaluate(units.row(i));
          result.Positions.row(i) = image.Position;
          result.Normals.row(i) = surface.normal(image.Triangle);
          result.Degenerate[i] = surface.degenerate()[image.Triangle];
        }
      });
  }
  report(progress, 1.0);
  return result;
}
}

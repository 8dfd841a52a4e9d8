#include "Surface/SphereDomes.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
//------------------------------------------------------------------------------
SphereDomes::SphereDomes(const Points& sphere, const Points& model,
  const conformal::Triangles& triangles, const conformal::Triangles& neighbors, const FlatMap& map,
  bool insideOut, const Run& run)
  : Sphere(&sphere)
  , Model(&model)
  , Triangles(&triangles)
  , Neighbors(&neighbors)
  , Centers(triangles.rows(), 3)
  , Normals(Points::Zero(triangles.rows(), 3))
{
  const Index blockSize = 256;
  forBlocksReporting(run, triangles.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const Vector3 i = model.row(triangles(r, 0)), j = model.row(triangles(r, 1)),
                      k = model.row(triangles(r, 2));
        if (map.hasArea(r))
        {
          const Vector3 normal =
            (j - i).stableNormalized().cross((k - i).stableNormalized()).normalized();
          this->Normals.row(r) = insideOut ? -normal : normal;
        }
        this->Centers.row(r) = FlatMap::Triangle(map, r).toModel(Vector3::Constant(1.0 / 3.0));
      }
    });
}

//------------------------------------------------------------------------------
double SphereDomes::height(Index triangle, const Vector3& barycentric) const
{
  const Vector3& l = barycentric;
  const auto ids = this->Triangles->row(triangle);
  const Vector3 n0 = this->Sphere->row(ids[0]), n1 = this->Sphere->row(ids[1]),
                n2 = this->Sphere->row(ids[2]);
  // |p - p'| = 1 - |p'|, without cancellation: 1 - |p'|^2 is a sum over the edges.
  const double deficit = l[0] * l[1] * (n1 - n0).squaredNorm() +
    l[1] * l[2] * (n2 - n1).squaredNorm() + l[2] * l[0] * (n0 - n2).squaredNorm();
  return deficit / (1.0 + std::sqrt(std::max(0.0, 1.0 - deficit)));
}

//------------------------------------------------------------------------------
bool SphereDomes::defined(Index triangle) const
{
  bool defined = !this->Normals.row(triangle).isZero(0.0);
  for (int k = 0; k < 3; ++k)
  {
    Vector3 unused;
    defined = this->edgeDirection(triangle, k, unused) && defined;
  }
  return defined;
}

//------------------------------------------------------------------------------
// Compute the mean normal at the edge opposite to a corner, Eq. 8. If the equation is 0/0, return
// false and set the normal of the triangle.
bool SphereDomes::edgeDirection(Index triangle, int opposite, Vector3& direction) const
{
  const Vector3 own = this->Normals.row(triangle);
  const Vector3 sum =
    own + Vector3(this->Normals.row((*this->Neighbors)(triangle, next(opposite))));
  const double size = sum.norm();
  const double rounding = 1e-12;
  const bool defined = size > rounding;
  direction = defined ? Vector3(sum / size) : own;
  return defined;
}

//------------------------------------------------------------------------------
// Compute n_q', steps 8 and 9, Eq. 11.
Vector3 SphereDomes::direction(Index triangle, const Vector3& barycentric) const
{
  // q' = s c_w + ...: the subtriangle with the smallest s contains it.
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
  const int i = next(k), j = previous(k);
  const double betaI = std::max(0.0, barycentric[i] - s * center[i]);
  const double betaJ = std::max(0.0, barycentric[j] - s * center[j]);

  // Along the edge from w_i to w_j, of length 1, the foot of c_w is at x, that of q' at s x +
  // betaJ. The subtriangle rises linearly from w_i to c_w and falls linearly to w_j. On these two
  // parts, |q' - a| / |b - a| is:
  const auto ids = this->Triangles->row(triangle);
  const Vector3 wI = this->Model->row(ids[i]);
  const Vector3 edge = Vector3(this->Model->row(ids[j])) - wI;
  const double length2 = edge.squaredNorm();
  const Vector3 centerPoint = center[0] * this->Model->row(ids[0]) +
    center[1] * this->Model->row(ids[1]) + center[2] * this->Model->row(ids[2]);
  const double x = length2 > 0.0 ? (centerPoint - wI).dot(edge) / length2 : 0.5;
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
}

#include "Mesh/HingeBending.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace conformal
{
namespace
{
/// Factor of the energy that makes it as stiff as the uniform Laplacian.
constexpr double LikeLaplacian = 1.0 / 14.0;

/// Maximum of the numbers k of a hinge, since larger numbers of needles (very thin triangles) make
/// the equations ill-conditioned. Measured: with 8, triangles contract at creases; with 3, thin
/// triangles fold half as often again.
constexpr double MaximumNumber = 4.0;

double cotangent(const Vector3& a, const Vector3& b)
{
  constexpr double minimum = 1e-12; // lower bound of sines
  return a.dot(b) / std::max(a.cross(b).norm(), minimum * a.norm() * b.norm() + 1e-300);
}
}

HingeBending::HingeBending(const conformal::Triangles& triangles, const Adjacency& around,
  const Points& places, const Eigen::VectorXd& stiffness, const Run& run)
  : Triangles(triangles)
  , Around(around)
  , HingeOf(triangles.rows(), 3)
{
  const conformal::Triangles across = triangleNeighbors(triangles, around, run);
  // The triangle of smaller id numbers an edge. First count where each block of triangles starts.
  std::vector<Index> firstOfBlock((triangles.rows() + HeavyBlock - 1) / HeavyBlock + 1, 0);
  forBlocks(run, triangles.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      Index& count = firstOfBlock[begin / HeavyBlock + 1];
      for (Index r = begin; r < end; ++r)
      {
        count += (across.row(r).array() > static_cast<int>(r)).count();
      }
    });
  std::partial_sum(firstOfBlock.begin(), firstOfBlock.end(), firstOfBlock.begin());
  this->Hinges.resize(firstOfBlock.back());
  forBlocks(run, triangles.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      auto hinge = static_cast<int>(firstOfBlock[begin / HeavyBlock]);
      for (int r = static_cast<int>(begin); r < end; ++r)
      {
        for (int k = 0; k < 3; ++k)
        {
          const int other = across(r, k);
          if (other > r)
          {
            int j = 0;
            while (across(other, j) != r || triangles(other, j) != triangles(r, next(k)))
            {
              ++j;
            }
            this->HingeOf(r, k) = this->HingeOf(other, j) = hinge;
            this->Hinges[hinge++].Corners = { triangles(r, k), triangles(r, next(k)),
              triangles(r, previous(k)), triangles(other, previous(j)) };
          }
        }
      }
    });
  const Index size = static_cast<Index>(this->Hinges.size());
  this->Bent.resize(size, 3);
  forBlocks(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index h = begin; h < end; ++h)
      {
        Hinge& hinge = this->Hinges[h];
        const Vector3 a = places.row(hinge.Corners[0]), b = places.row(hinge.Corners[1]),
                      c = places.row(hinge.Corners[2]), d = places.row(hinge.Corners[3]);
        const double cotAc = cotangent(b - a, c - a), cotAd = cotangent(b - a, d - a),
                     cotBc = cotangent(a - b, c - b), cotBd = cotangent(a - b, d - b);
        Eigen::Array4d k(cotBc + cotBd, cotAc + cotAd, -cotAc - cotBc, -cotAd - cotBd);
        const double maximum = std::max(k.abs().maxCoeff(), MaximumNumber);
        const double s = 0.5 * (stiffness[hinge.Corners[0]] + stiffness[hinge.Corners[1]]);
        k *= std::sqrt(LikeLaplacian * s) * MaximumNumber / maximum;
        for (int i = 0; i < 4; ++i)
        {
          hinge.K[i] = static_cast<float>(k[i]);
        }
      }
    });
}

/// Visit each hinge with its local index of the vertex. The hinges of a triangle at the vertex
/// belong to the edge that starts there and to the opposite edge.
template <typename Visitor>
void HingeBending::forHingesOf(int vertex, const Visitor& visit) const
{
  for (const int* r = this->Around.begin(vertex); r != this->Around.end(vertex); ++r)
  {
    int k = 0;
    while (this->Triangles(*r, k) != vertex)
    {
      ++k;
    }
    const int starting = this->HingeOf(*r, k), opposite = this->HingeOf(*r, next(k));
    const Hinge &edge = this->Hinges[starting], &other = this->Hinges[opposite];
    visit(starting, edge.K[edge.Corners[0] == vertex ? 0 : 1]);
    visit(opposite, other.K[other.Corners[2] == vertex ? 2 : 3]);
  }
}

void HingeBending::bend(const Points& x, const Run& run)
{
  forBlocks(run, static_cast<Index>(this->Hinges.size()), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index h = begin; h < end; ++h)
      {
        const Hinge& hinge = this->Hinges[h];
        Vector3 sum = Vector3::Zero();
        for (int k = 0; k < 4; ++k)
        {
          sum += hinge.K[k] * Vector3(x.row(hinge.Corners[k]));
        }
        this->Bent.row(h) = sum.cast<float>();
      }
    });
}

Vector3 HingeBending::forceAt(int vertex) const
{
  Vector3 force = Vector3::Zero();
  this->forHingesOf(vertex,
    [&](int hinge, double k) { force += k * Vector3(this->Bent.row(hinge).cast<double>()); });
  return force;
}

double HingeBending::diagonalAt(int vertex) const
{
  double diagonal = 0.0;
  this->forHingesOf(vertex, [&](int, double k) { diagonal += k * k; });
  return diagonal;
}
}

#include "HingeBending.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr Index BlockSize = 512;

/// For equilateral triangles the form is then that of the uniform Laplacian.
constexpr double LikeLaplacian = 1.0 / 14.0;

/// The hinges of needles are not stiffer than this, which equations could not be solved with.
/// Measured: 8 draws triangles together at creases, 3 lets thin ones fold half as often again.
constexpr double LargestNumber = 4.0;

double cotangent(const Vector3& a, const Vector3& b)
{
  return a.dot(b) / std::max(a.cross(b).norm(), 1e-12 * a.norm() * b.norm() + 1e-300);
}
}

HingeBending::HingeBending(const Triangles& faces, Index numberOfVertices)
{
  const Triangles across = triangleNeighbors(faces, numberOfVertices);
  const auto opposite = [&](int triangle, int a, int b)
  {
    int k = 0;
    while (faces(triangle, k) == a || faces(triangle, k) == b)
    {
      ++k;
    }
    return faces(triangle, k);
  };
  this->Hinges.reserve(faces.rows() * 3 / 2);
  std::vector<int>& offsets = this->Around.Offsets;
  offsets.assign(numberOfVertices + 1, 0);
  for (Index r = 0; r < faces.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int other = across(r, k);
      if (other > r)
      {
        const int a = faces(r, k), b = faces(r, (k + 1) % 3);
        Hinge hinge;
        hinge.Corners = { a, b, faces(r, (k + 2) % 3), opposite(other, a, b) };
        this->Hinges.push_back(hinge);
        for (int corner : hinge.Corners)
        {
          ++offsets[corner + 1];
        }
      }
    }
  }
  for (Index i = 0; i < numberOfVertices; ++i)
  {
    offsets[i + 1] += offsets[i];
  }
  this->Around.Ids.resize(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t h = 0; h < this->Hinges.size(); ++h)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->Around.Ids[next[this->Hinges[h].Corners[k]]++] = static_cast<int>(4 * h) + k;
    }
  }
  this->Bent.resize(static_cast<Index>(this->Hinges.size()), 3);
}

void HingeBending::shape(
  const Points& places, const Eigen::VectorXd& stiffness, const ParallelFor& parallelFor)
{
  forBlocks(parallelFor, static_cast<Index>(this->Hinges.size()), BlockSize,
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
        const double largest = k.abs().maxCoeff();
        const double s = 0.5 * (stiffness[hinge.Corners[0]] + stiffness[hinge.Corners[1]]);
        k *= std::sqrt(LikeLaplacian * s) * std::min(1.0, LargestNumber / largest);
        for (int i = 0; i < 4; ++i)
        {
          hinge.K[i] = static_cast<float>(k[i]);
        }
      }
    });
}

void HingeBending::bend(const Points& x, const ParallelFor& parallelFor)
{
  forBlocks(parallelFor, static_cast<Index>(this->Hinges.size()), BlockSize,
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

Vector3 HingeBending::forceAt(Index vertex) const
{
  Vector3 force = Vector3::Zero();
  for (const int* i = this->Around.begin(vertex); i != this->Around.end(vertex); ++i)
  {
    const double k = this->Hinges[*i / 4].K[*i % 4];
    force += k * this->Bent.row(*i / 4).cast<double>();
  }
  return force;
}

double HingeBending::diagonalAt(Index vertex) const
{
  double diagonal = 0.0;
  for (const int* i = this->Around.begin(vertex); i != this->Around.end(vertex); ++i)
  {
    const double k = this->Hinges[*i / 4].K[*i % 4];
    diagonal += k * k;
  }
  return diagonal;
}
}

#include "Sphere/SphereOrientation.h"

#include <array>
#include <cmath>

namespace conformal
{
namespace
{
// Sum of non-overlapping doubles in ascending order; the last nonzero one has the sign of the sum.
class ExactSum
{
public:
  void add(double value)
  {
    double rest = value;
    for (int i = 0; i < this->Size; ++i)
    {
      const double a = this->Parts[i], sum = rest + a, part = sum - rest;
      this->Parts[i] = (rest - (sum - part)) + (a - part);
      rest = sum;
    }
    this->Parts[this->Size++] = rest;
  }

  void addProduct(double a, double b, double c)
  {
    const double high = a * b, low = std::fma(a, b, -high);
    for (double factor : { low, high })
    {
      const double product = factor * c;
      this->add(std::fma(factor, c, -product));
      this->add(product);
    }
  }

  int sign() const
  {
    for (int i = this->Size - 1; i >= 0; --i)
    {
      if (this->Parts[i] != 0.0)
      {
        return this->Parts[i] > 0.0 ? 1 : -1;
      }
    }
    return 0;
  }

private:
  std::array<double, 24> Parts{}; // parts of six products, four each
  int Size = 0;
};

int exactOrientation(const Vector3& a, const Vector3& b, const Vector3& c)
{
  ExactSum sum;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.addProduct(a[i], b[j], c[k]);
    sum.addProduct(-a[i], b[k], c[j]);
  }
  return sum.sign();
}
}

//------------------------------------------------------------------------------
int orientation(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 p = b - a, q = c - a;
  const double determinant = a.dot(p.cross(q));
  // Bound the rounding error: half a unit in the last place for the differences and for each later
  // step.
  const double error =
    16.0 * 0x1p-53 * a.cwiseAbs().sum() * p.cwiseAbs().maxCoeff() * q.cwiseAbs().maxCoeff();
  if (std::abs(determinant) > error)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return exactOrientation(a, b, c);
}

//------------------------------------------------------------------------------
Triangles turnedOutward(const Triangles& triangles, const Points& spherePositions)
{
  double volume = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = spherePositions.row(triangles(r, 0)),
                  b = spherePositions.row(triangles(r, 1)),
                  c = spherePositions.row(triangles(r, 2));
    volume += a.cross(b).dot(c);
  }
  Triangles result = triangles;
  if (volume < 0.0)
  {
    result.col(1).swap(result.col(2));
  }
  return result;
}

//------------------------------------------------------------------------------
Index countFlippedTriangles(const Points& spherePositions, const Triangles& triangles)
{
  Index count = 0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    count += orientation(spherePositions.row(triangles(r, 0)), spherePositions.row(triangles(r, 1)),
               spherePositions.row(triangles(r, 2))) <= 0;
  }
  return count;
}
}

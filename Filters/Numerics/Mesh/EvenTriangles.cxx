#include "Mesh/EvenTriangles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
constexpr double MinimumMeanAngle = 46.0, MinimumShare = 0.99;

double angle(const Vector3& u, const Vector3& v)
{
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

double minimumAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return std::min({ angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c) });
}
}

//------------------------------------------------------------------------------
bool hasEvenTriangles(const Mesh& mesh)
{
  double sum = 0.0;
  std::vector<int> valences(mesh.Positions.rows());
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const auto ids = mesh.Triangles.row(r);
    sum += minimumAngle(
      mesh.Positions.row(ids[0]), mesh.Positions.row(ids[1]), mesh.Positions.row(ids[2]));
    for (int k = 0; k < 3; ++k)
    {
      ++valences[ids[k]];
    }
  }
  const auto regular = std::count_if(
    valences.begin(), valences.end(), [](int valence) { return valence >= 5 && valence <= 7; });
  const double degrees = 180.0 / Pi;
  return sum * degrees >= MinimumMeanAngle * static_cast<double>(mesh.Triangles.rows()) &&
    static_cast<double>(regular) >= MinimumShare * static_cast<double>(mesh.Positions.rows());
}
}

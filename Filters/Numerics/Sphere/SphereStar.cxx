#include "Sphere/SphereStar.h"

#include "Base/IntegerPower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace conformal
{
namespace
{
using Vector2 = Eigen::Vector2d;

// Tangent plane of a position on the sphere. The third axis of its frame points outward.
struct Frame
{
  Vector3 X, Y, Z;

  explicit Frame(const Vector3& place)
    : X(place.unitOrthogonal())
    , Y(place.cross(X))
    , Z(place)
  {
  }
  Vector3 local(const Vector3& difference) const
  {
    return { this->X.dot(difference), this->Y.dot(difference), this->Z.dot(difference) };
  }
  Vector3 place(const Vector2& step) const // projection from the center of the sphere
  {
    return (this->Z + step[0] * this->X + step[1] * this->Y).normalized();
  }
};

// Determinant of (place, p, q) as a linear function of a step of the position in the tangent plane:
// Constant + Slope . step. The vectors p and q are differences from the position to its neighbors,
// in the frame of the tangent plane.
struct LinearDeterminant
{
  double Constant;
  Vector2 Slope;

  LinearDeterminant(const Vector3& p, const Vector3& q)
  {
    const Vector3 both = p.cross(q);
    this->Constant = both[2];
    this->Slope = { both[0] - (q[1] - p[1]), both[1] + (q[0] - p[0]) };
  }
  double at(const Vector2& step) const { return this->Constant + this->Slope.dot(step); }
};

// Clip a convex polygon to the half plane where a linear function is positive.
void clip(std::vector<Vector2>& polygon, const LinearDeterminant& side)
{
  std::vector<Vector2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double atA = side.at(a), atB = side.at(b);
    if (atA >= 0.0)
    {
      kept.push_back(a);
    }
    if ((atA >= 0.0) != (atB >= 0.0))
    {
      kept.push_back(a + atA / (atA - atB) * (b - a));
    }
  }
  polygon = std::move(kept);
}

// Compute the centroid of a polygon; no result without area.
std::optional<Vector2> centroid(const std::vector<Vector2>& polygon)
{
  double area = 0.0;
  Vector2 sum = Vector2::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const Vector2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
    const double part = a[0] * b[1] - a[1] * b[0];
    area += part;
    sum += part / 3.0 * (a + b);
  }
  if (!(area > 0.0))
  {
    return {};
  }
  return polygon[0] + sum / area;
}

// Terms of the energy that depend on areas: (S/A)^AreaExponent, and the term that penalizes much
// too small areas.
struct AreaTerms
{
  double Main, Guard;

  AreaTerms(double source, double inverseArea, const SphereEnergy& energy)
    : Main(energy.AreaExponent == 0.0 ? 1.0 : std::pow(source * inverseArea, energy.AreaExponent))
    , Guard((energy.AreaWeight * source * source + energy.SmallArea * energy.SmallArea) *
        inverseArea * inverseArea)
  {
  }
};

struct Derivatives
{
  double Value = 0.0;
  Vector2 Gradient = Vector2::Zero();
  Eigen::Matrix2d Hessian = Eigen::Matrix2d::Zero();
  double MaximumSquaredSide = 0.0;
  bool Valid = true;
};

// Derivatives of the energy for a step in the tangent plane followed by projection.
Derivatives derivatives(const std::vector<Vector3>& positions, const Frame& frame,
  const Corner* corners, int size, const SphereEnergy& energy)
{
  Derivatives sum;
  const double power1 = energy.AngleExponent;
  Vector3 q = frame.local(positions[corners[0].Neighbor] - frame.Z);
  double lengthQ = q.squaredNorm();
  for (int i = 0; i < size; ++i)
  {
    const Vector3 p = q;
    const double lengthP = lengthQ;
    q = frame.local(positions[corners[i + 1 < size ? i + 1 : 0].Neighbor] - frame.Z);
    lengthQ = q.squaredNorm();
    sum.MaximumSquaredSide = std::max(sum.MaximumSquaredSide, lengthQ);
    const LinearDeterminant side(p, q);
    if (!(side.Constant >= MinimumDeterminant))
    {
      sum.Valid = false;
      return sum;
    }
    const SourceTriangle& source = corners[i].Source;
    const auto& cotangents = source.Cotangents;
    const double area = 0.5 * side.Constant, inverseArea = 1.0 / area;
    const double dirichlet =
      cotangents[0] * (q - p).squaredNorm() + cotangents[1] * lengthQ + cotangents[2] * lengthP;
    const double inverseDirichlet = 1.0 / dirichlet;
    const AreaTerms terms(source.Area, inverseArea, energy);
    const double angle = source.Area * integerPower(dirichlet * inverseArea, energy.AngleExponent);
    const double main = angle * terms.Main, guard = angle * terms.Guard;

    // Relative derivatives of D and A; multiples of the identity represent the curvature of the
    // sphere.
    const Vector2 ofD =
      -2.0 * inverseDirichlet * (cotangents[1] * q.head<2>() + cotangents[2] * p.head<2>());
    const double curvatureOfD =
      2.0 * inverseDirichlet * (cotangents[1] * (1.0 + q[2]) + cotangents[2] * (1.0 + p[2]));
    const Vector2 ofA = 0.5 * inverseArea * side.Slope;
    // Up to a constant, one term is main A^-k D^l with k = AreaExponent + l; the other uses guard.
    const double k1 = energy.AreaExponent + power1, k2 = 2.0 + power1;
    const Vector2 slope1 = power1 * ofD - k1 * ofA, slope2 = power1 * ofD - k2 * ofA;
    const double both = main + guard, weighted = main * k1 + guard * k2;
    sum.Value += both;
    sum.Gradient += main * slope1 + guard * slope2;
    sum.Hessian += main * slope1 * slope1.transpose() + guard * slope2 * slope2.transpose() +
      weighted * ofA * ofA.transpose() - both * power1 * ofD * ofD.transpose();
    sum.Hessian.diagonal().array() += both * power1 * curvatureOfD + weighted;
  }
  return sum;
}

// Compute a Newton step if the energy is convex. Otherwise, compute a shorter step against the
// gradient.
Vector2 newtonStep(const Derivatives& at)
{
  const double a = at.Hessian(0, 0), b = at.Hessian(0, 1), c = at.Hessian(1, 1);
  const double mean = 0.5 * (a + c), radius = std::hypot(0.5 * (a - c), b);
  const double minimum = mean - radius, needed = 0.05 * (std::abs(mean) + radius);
  const double shift = std::max(0.0, needed - minimum);
  const double determinant = (a + shift) * (c + shift) - b * b;
  Vector2 step = { b * at.Gradient[1] - (c + shift) * at.Gradient[0],
    b * at.Gradient[0] - (a + shift) * at.Gradient[1] };
  step /= determinant;
  const double limit = std::sqrt(at.MaximumSquaredSide), length = step.norm();
  return length > limit ? Vector2(limit / length * step) : step;
}
}

//------------------------------------------------------------------------------
std::optional<Vector3> kernelCentroid(
  const std::vector<Vector3>& positions, const Ring& ring, double minimumHeight)
{
  const Vector3& origin = positions[ring.front()];
  const Frame frame(origin);
  std::vector<Vector3> local;
  double width = 0.0; // width of the ring in the chart projected from the center of the sphere
  constexpr double maximum = 5.0;
  for (int id : ring)
  {
    local.push_back(frame.local(positions[id] - origin));
    const double height = 1.0 + local.back()[2], reach = local.back().head<2>().norm();
    width = std::max(width, height * maximum > reach ? reach / height : maximum);
  }
  std::vector<Vector2> kernel = { { -width, -width }, { width, -width }, { width, width },
    { -width, width } };
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    clip(kernel, LinearDeterminant(local[i], local[(i + 1) % ring.size()]));
  }
  const std::optional<Vector2> middle = centroid(kernel);
  if (!middle)
  {
    return {};
  }
  const Vector3 place = frame.place(*middle);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Vector3 &a = positions[ring[i]], &b = positions[ring[(i + 1) % ring.size()]];
    const double longest = std::sqrt(
      std::max({ (a - place).squaredNorm(), (b - place).squaredNorm(), (b - a).squaredNorm() }));
    if (!(determinant(place, a, b) >= std::min(MinimumDeterminant, minimumHeight * longest)))
    {
      return {};
    }
  }
  return place;
}

//------------------------------------------------------------------------------
double starEnergy(const std::vector<Vector3>& positions, const Vector3& place,
  const Corner* corners, int size, const SphereEnergy& energy)
{
  double sum = 0.0;
  Vector3 q = positions[corners[0].Neighbor] - place;
  double lengthQ = q.squaredNorm();
  for (int i = 0; i < size; ++i)
  {
    const Vector3 p = q;
    const double lengthP = lengthQ;
    q = positions[corners[i + 1 < size ? i + 1 : 0].Neighbor] - place;
    lengthQ = q.squaredNorm();
    const double twiceArea = place.dot(p.cross(q));
    if (!(twiceArea >= MinimumDeterminant))
    {
      return std::numeric_limits<double>::infinity();
    }
    const SourceTriangle& source = corners[i].Source;
    const auto& cotangents = source.Cotangents;
    const double inverseArea = 2.0 / twiceArea;
    const double dirichlet =
      cotangents[0] * (q - p).squaredNorm() + cotangents[1] * lengthQ + cotangents[2] * lengthP;
    const AreaTerms terms(source.Area, inverseArea, energy);
    sum += source.Area * (terms.Main + terms.Guard) *
      integerPower(dirichlet * inverseArea, energy.AngleExponent);
  }
  return sum;
}

//------------------------------------------------------------------------------
void relaxVertex(std::vector<Vector3>& positions, int v, const Corner* corners, int size,
  const SphereEnergy& energy)
{
  const Frame frame(positions[v]);
  const Derivatives at = derivatives(positions, frame, corners, size, energy);
  if (!at.Valid)
  {
    return;
  }
  Vector2 step = newtonStep(at);
  constexpr double worthwhile = 1e-9; // relative decrease of the energy
  constexpr int attempts = 5;
  for (int i = 0; i < attempts && -at.Gradient.dot(step) > worthwhile * at.Value; ++i)
  {
    const Vector3 place = frame.place(step);
    if (starEnergy(positions, place, corners, size, energy) < at.Value)
    {
      positions[v] = place;
      return;
    }
    step *= 0.3;
  }
}
}

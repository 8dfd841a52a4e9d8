#include "Surface/CurvedSeamlessSurface.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Runs.h"
#include "Search/TriangleTree.h"
#include "Sheets.h"

#include <Eigen/LU>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

using conformal::buildCurvedSeamlessSurface;
using conformal::CurvedSeamlessInverse;
using conformal::CurvedSeamlessSurface;
using conformal::CurvedSeamlessSurfaceOptions;
using conformal::CurvedSeamlessSurfaceResult;
using conformal::DomeHeight;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::SeamMode;
using conformal::Triangles;
using conformal::Vector3;
using Complex = std::complex<double>;

namespace
{
CurvedSeamlessSurfaceOptions optionsOf(
  DomeHeight domeHeight, SeamMode seamMode = SeamMode::EdgeMatched)
{
  CurvedSeamlessSurfaceOptions options;
  options.DomeHeight = domeHeight;
  options.SeamMode = seamMode;
  return options;
}

/// The construction as the paper has it.
const CurvedSeamlessSurfaceOptions Published =
  optionsOf(DomeHeight::Published, SeamMode::PerTriangle);

const std::array<DomeHeight, 4> AllButFitted{ DomeHeight::None, DomeHeight::Published,
  DomeHeight::Scaled, DomeHeight::Curvature };

/// A lumpy model whose mean vertex is the origin and whose largest radius is 1, as in the paper.
Points lumpyModel(const Points& sphere)
{
  Points model(sphere.rows(), 3);
  for (Index i = 0; i < sphere.rows(); ++i)
  {
    const Vector3 n = sphere.row(i);
    const double radius =
      1.0 + 0.25 * std::sin(4.0 * n[0] + 1.0) * std::cos(3.0 * n[1]) + 0.1 * std::sin(9.0 * n[2]);
    model.row(i) << 1.4 * radius * n[0], radius * n[1], 0.8 * radius * n[2];
  }
  model.rowwise() -= model.colwise().mean().eval();
  return model / model.rowwise().norm().maxCoeff();
}

Points shaken(const Points& points, double by)
{
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> uniform(-by, by);
  Points result = points;
  for (Index i = 0; i < result.size(); ++i)
  {
    result.data()[i] += uniform(engine);
  }
  return result;
}

Points randomDirections(Index size)
{
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  Points directions(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    directions.row(i) << normal(engine), normal(engine), normal(engine);
    directions.row(i).normalize();
  }
  return directions;
}

/// The CSS algorithm as the paper writes it, at its own leisure.
class Transcription
{
public:
  Transcription(const Points& sphere, const Points& model, const Triangles& triangles)
    : Sphere(sphere)
    , Model(model)
    , Triangles(triangles)
    , Neighbors(conformal::triangleNeighbors(triangles, sphere.rows()))
  {
  }

  Vector3 image(const Vector3& p) const
  {
    // Step 6: t by the two determinants, in the triangle that then holds p' = t p.
    for (Index r = 0; r < this->Triangles.rows(); ++r)
    {
      Eigen::Matrix4d above, below;
      above.row(0).setOnes();
      below.row(0) << 1.0, 1.0, 1.0, 0.0;
      for (int k = 0; k < 3; ++k)
      {
        above.block<3, 1>(1, k) = below.block<3, 1>(1, k) = this->corner(this->Sphere, r, k);
      }
      above.block<3, 1>(1, 3) = below.block<3, 1>(1, 3) = p;
      // With these determinants the parameter runs from p, not c: p' = p - t (p - c).
      const double t = 1.0 - above.determinant() / below.determinant();
      const Vector3 flat = t * p;
      if (t > 0.0 &&
        inside(flat, this->corner(this->Sphere, r, 0), this->corner(this->Sphere, r, 1),
          this->corner(this->Sphere, r, 2)))
      {
        return this->dome(r, p, flat);
      }
    }
    throw std::logic_error("not found");
  }

private:
  static Vector3 corner(const Points& points, const Triangles& triangles, Index r, int k)
  {
    return points.row(triangles(r, k));
  }
  Vector3 corner(const Points& points, Index r, int k) const
  {
    return corner(points, this->Triangles, r, k);
  }

  static bool inside(const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const Vector3 normal = (b - a).cross(c - a);
    return (b - a).cross(x - a).dot(normal) >= 0.0 && (c - b).cross(x - b).dot(normal) >= 0.0 &&
      (a - c).cross(x - c).dot(normal) >= 0.0;
  }

  Vector3 normal(Index r) const // Eq. 7
  {
    const Vector3 i = this->corner(this->Model, r, 0);
    return (this->corner(this->Model, r, 1) - i)
      .cross(this->corner(this->Model, r, 2) - i)
      .normalized();
  }

  Vector3 dome(Index r, const Vector3& p, const Vector3& flat) const
  {
    const Vector3 centerOfNetwork =
      (this->corner(this->Sphere, r, 0) + this->corner(this->Sphere, r, 1) +
        this->corner(this->Sphere, r, 2)) /
      3.0; // Eq. 6
    const Vector3 center = this->conformal(r, centerOfNetwork);
    const Vector3 q = this->conformal(r, flat);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 i = this->corner(this->Model, r, k),
                    j = this->corner(this->Model, r, (k + 1) % 3);
      if (!inside(q, center, i, j))
      {
        continue;
      }
      const Vector3 along = (j - i).normalized();
      const Vector3 b = i + (q - i).dot(along) * along;
      const Vector3 up = (q - b).normalized();
      Vector3 a = q;
      for (const Vector3& end : { i, j }) // b + h up on the line from the end to the center
      {
        Eigen::Matrix<double, 3, 2> system;
        system << up, end - center;
        const Eigen::Vector2d solution =
          (system.transpose() * system).inverse() * system.transpose() * (end - b);
        if (solution[1] >= -1e-12 && solution[1] <= 1.0 + 1e-12)
        {
          a = b + solution[0] * up;
        }
      }
      const Vector3 own = this->normal(r);
      const Vector3 sum = own + this->normal(this->Neighbors(r, k)); // Eq. 8
      const double share = (q - a).norm() / (b - a).norm();
      const Vector3 direction = share * (sum.normalized() - own) + own; // Eq. 11
      return q + (p - t(r, p)).norm() * direction.normalized();         // Eq. 12
    }
    throw std::logic_error("no subtriangle");
  }

  Vector3 t(Index r, const Vector3& p) const
  {
    const Vector3 a = this->corner(this->Sphere, r, 0);
    const Vector3 across =
      (this->corner(this->Sphere, r, 1) - a).cross(this->corner(this->Sphere, r, 2) - a);
    return across.dot(a) / across.dot(p) * p;
  }

  /// Eqs. 4 and 5 by quadrature over the unit disk, prevertices at the cube roots of unity.
  Vector3 conformal(Index r, const Vector3& point) const
  {
    const Disk from(this->Sphere, this->Triangles, r), to(this->Model, this->Triangles, r);
    return to.point(to.map(from.inverse(from.flat(point))));
  }

  class Disk
  {
  public:
    Disk(const Points& points, const Triangles& triangles, Index r)
      : Origin(corner(points, triangles, r, 0))
    {
      const Vector3 j = corner(points, triangles, r, 1), k = corner(points, triangles, r, 2);
      this->X = (j - this->Origin).normalized();
      this->Y = (k - this->Origin - (k - this->Origin).dot(this->X) * this->X).normalized();
      const std::array<Complex, 3> z{ this->flat(this->Origin), this->flat(j), this->flat(k) };
      for (int c = 0; c < 3; ++c)
      {
        this->Angle[c] = std::arg((z[(c + 2) % 3] - z[c]) / (z[(c + 1) % 3] - z[c])) / Pi;
        this->Prevertex[c] = std::polar(1.0, 2.0 * Pi * c / 3.0);
      }
      const Complex first = this->toPrevertex(0), second = this->toPrevertex(1);
      this->B = (z[1] - z[0]) / (second - first);
      this->A = z[0] - this->B * first;
    }

    Complex flat(const Vector3& x) const
    {
      return { (x - this->Origin).dot(this->X), (x - this->Origin).dot(this->Y) };
    }
    Vector3 point(const Complex& z) const
    {
      return this->Origin + z.real() * this->X + z.imag() * this->Y;
    }
    Complex map(const Complex& v) const
    {
      const auto along = [&](double s) { return this->integrand(s * v) * v; };
      return this->A +
        this->B * boost::math::quadrature::gauss_kronrod<double, 61>::integrate(along, 0.0, 1.0, 8);
    }
    Complex inverse(const Complex& z) const
    {
      Complex v = 0.0;
      for (int i = 0; i < 100; ++i)
      {
        Complex step = (z - this->map(v)) / (this->B * this->integrand(v));
        const double room = 0.5 * (1.0 - std::abs(v));
        step *= std::min(1.0, room / std::abs(step));
        v += step;
        if (std::abs(step) < 1e-15)
        {
          break;
        }
      }
      return v;
    }

  private:
    // 1/zeta^2 prod (1 - v_i/zeta)^(angle - 1), finite at 0 since the exponents' sum is -2; each
    // factor is turned so that its branch cut lies outside the disk.
    Complex integrand(const Complex& zeta) const
    {
      Complex product = 1.0;
      for (int c = 0; c < 3; ++c)
      {
        product *= std::pow(1.0 - zeta / this->Prevertex[c], this->Angle[c] - 1.0);
      }
      return product;
    }
    Complex toPrevertex(int c) const
    {
      // From the singular end, 1 - s being given exactly there.
      boost::math::quadrature::tanh_sinh<double> rule;
      const auto part = [&](bool real)
      {
        return rule.integrate(
          [&](double s, double rest)
          {
            const double toEnd = s > 0.5 ? rest : 1.0 - s;
            Complex product = std::pow(toEnd, this->Angle[c] - 1.0);
            for (int other = 1; other < 3; ++other)
            {
              const int k = (c + other) % 3;
              product *=
                std::pow(1.0 - s * this->Prevertex[c] / this->Prevertex[k], this->Angle[k] - 1.0);
            }
            product *= this->Prevertex[c];
            return real ? product.real() : product.imag();
          },
          0.0, 1.0);
      };
      return { part(true), part(false) };
    }

    static constexpr double Pi = 3.14159265358979323846;
    Vector3 Origin, X, Y;
    std::array<double, 3> Angle{};
    std::array<Complex, 3> Prevertex;
    Complex A, B;
  };

  const Points& Sphere;
  const Points& Model;
  const conformal::Triangles& Triangles;
  conformal::Triangles Neighbors;
};
}

TEST(CurvedSeamlessSurface, FollowsThePaperToTheLetter)
{
  const Mesh network = makeGeodesicSphere(3);
  const Points model = lumpyModel(network.Positions);
  const Points directions = randomDirections(60);
  const Transcription paper(network.Positions, model, network.Triangles);
  const CurvedSeamlessSurfaceResult result = buildCurvedSeamlessSurface(
    { { model, network.Triangles }, network.Positions }, directions, Published);
  for (Index i = 0; i < directions.rows(); ++i)
  {
    const Vector3 expected = paper.image(directions.row(i));
    EXPECT_LT((Vector3(result.Positions.row(i)) - expected).norm(), 1e-10) << i;
  }
}

// Errors of the published domes on the sphere itself, as measured before this code was written.
TEST(CurvedSeamlessSurface, TheSpheresOwnDomesGiveTheSphere)
{
  const Points directions = makeGeodesicSphere(40).Positions;
  const auto maximumError = [&](int f)
  {
    const Mesh network = makeGeodesicSphere(f);
    const auto result = buildCurvedSeamlessSurface(
      { { network.Positions, network.Triangles }, network.Positions }, directions, Published);
    EXPECT_EQ(result.NumberOfDegeneratePatches, 0);
    return (result.Positions.rowwise().norm().array() - 1.0).abs().maxCoeff();
  };
  EXPECT_NEAR(maximumError(3), 2.0e-4, 1e-5);
  EXPECT_NEAR(maximumError(6), 1.5e-5, 1e-6);
  EXPECT_NEAR(maximumError(12), 1.0e-6, 1e-7);
}

TEST(CurvedSeamlessSurface, NetworkVerticesGoToTheirWeightsExactly)
{
  const Mesh network = makeGeodesicSphere(7);
  const Points model = shaken(lumpyModel(network.Positions), 0.05);
  const auto result = buildCurvedSeamlessSurface(
    { { model, network.Triangles }, network.Positions }, network.Positions);
  EXPECT_EQ(result.Positions, model);
}

TEST(CurvedSeamlessSurface, MovesWithTheModel)
{
  const Mesh network = makeGeodesicSphere(5);
  const Points model = shaken(lumpyModel(network.Positions), 0.03);
  const Points directions = randomDirections(500);
  const Points expected =
    buildCurvedSeamlessSurface({ { model, network.Triangles }, network.Positions }, directions)
      .Positions;

  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::RowVector3d shift(30.0, -20.0, 10.0);
  for (const double scale : { 1e-30, 1.0, 1e30 })
  {
    const Points moved = (scale * model * turn).rowwise() + scale * shift;
    const Points images =
      buildCurvedSeamlessSurface({ { moved, network.Triangles }, network.Positions }, directions)
        .Positions;
    const Points back = ((images / scale).rowwise() - shift) * turn.transpose();
    EXPECT_LT((back - expected).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(CurvedSeamlessSurface, TurningTheSphereMapTurnsTheDirections)
{
  const Mesh network = makeGeodesicSphere(5);
  const Points model = lumpyModel(network.Positions);
  const Points directions = randomDirections(500);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(3, -2, 1).normalized()).toRotationMatrix();
  const Points expected =
    buildCurvedSeamlessSurface({ { model, network.Triangles }, network.Positions }, directions)
      .Positions;
  const Points images = buildCurvedSeamlessSurface(
    { { model, network.Triangles }, network.Positions * turn }, directions * turn)
                          .Positions;
  EXPECT_LT((images - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CurvedSeamlessSurface, MirrorsAndTrianglesInsideOutChangeNothing)
{
  const Mesh network = makeGeodesicSphere(5);
  const Points model = lumpyModel(network.Positions);
  const Points directions = randomDirections(500);
  Triangles insideOut = network.Triangles;
  insideOut.col(0).swap(insideOut.col(1));
  for (const DomeHeight domeHeight : AllButFitted)
  {
    const auto expected = buildCurvedSeamlessSurface(
      { { model, network.Triangles }, network.Positions }, directions, optionsOf(domeHeight));
    for (const Triangles& triangles : { network.Triangles, insideOut })
    {
      for (const double sign : { 1.0, -1.0 })
      {
        const auto images =
          buildCurvedSeamlessSurface({ { model, triangles }, sign * network.Positions },
            sign * directions, optionsOf(domeHeight));
        EXPECT_LT((images.Positions - expected.Positions).cwiseAbs().maxCoeff(), 1e-13);
        EXPECT_LT((images.Normals - expected.Normals).cwiseAbs().maxCoeff(), 1e-12);
      }
    }
  }
}

TEST(CurvedSeamlessSurface, ThreadsAndCompanyChangeNothing)
{
  const Mesh network = makeGeodesicSphere(9);
  const Points model = shaken(lumpyModel(network.Positions), 0.03);
  const Points directions = randomDirections(3000);
  const auto alone =
    buildCurvedSeamlessSurface({ { model, network.Triangles }, network.Positions }, directions);
  const auto together =
    buildCurvedSeamlessSurface({ { model, network.Triangles }, network.Positions }, directions, {},
      nullptr, runs::backwards());
  EXPECT_EQ(alone.Positions, together.Positions);
  EXPECT_EQ(alone.Normals, together.Normals);
  const CurvedSeamlessSurface surface({ { model, network.Triangles }, network.Positions });
  for (Index i = 0; i < directions.rows(); i += 100)
  {
    CurvedSeamlessSurface::Evaluator fresh(surface); // remembers no triangle
    EXPECT_EQ(fresh.evaluate(alone.Directions.row(i)).Position, Vector3(alone.Positions.row(i)));
  }
}

// Errors on the sphere itself, where the published domes are at home.
TEST(CurvedSeamlessSurface, EveryDomeHeightComesToTheSphereAsCloseAsItCan)
{
  const Mesh network = makeGeodesicSphere(6);
  const Points directions = makeGeodesicSphere(40).Positions;
  const auto maximumError = [&](DomeHeight domeHeight)
  {
    const Points images =
      buildCurvedSeamlessSurface({ { network.Positions, network.Triangles }, network.Positions },
        directions, optionsOf(domeHeight))
        .Positions;
    return (images.rowwise().norm().array() - 1.0).abs().maxCoeff();
  };
  EXPECT_NEAR(maximumError(DomeHeight::None), 7.8e-3, 3e-4);
  EXPECT_NEAR(maximumError(DomeHeight::Published), 1.5e-5, 1e-6);
  EXPECT_LT(maximumError(DomeHeight::Scaled), 2e-5);
  EXPECT_LT(maximumError(DomeHeight::Curvature), 5e-4);
}

TEST(CurvedSeamlessSurface, ScaledDomesGrowWithTheModelAroundThem)
{
  // One half of a sphere of ten times the size: its domes are those of its own radius.
  const Mesh network = makeGeodesicSphere(8);
  Points model = network.Positions;
  for (Index i = 0; i < model.rows(); ++i)
  {
    model.row(i) *= model(i, 2) > 0.0 ? 10.0 : 1.0;
  }
  const Vector3 small = Vector3(0.21, -0.13, -1.0).normalized(), large = -small;
  for (const DomeHeight domeHeight : { DomeHeight::Scaled, DomeHeight::Published })
  {
    const CurvedSeamlessSurface surface(
      { { model, network.Triangles }, network.Positions }, optionsOf(domeHeight));
    CurvedSeamlessSurface::Evaluator evaluator(surface);
    const double ofLarge = evaluator.evaluate(large).Position.norm() / 10.0,
                 ofSmall = evaluator.evaluate(small).Position.norm();
    if (domeHeight == DomeHeight::Scaled)
    {
      EXPECT_NEAR(ofSmall, 1.0, 3e-5);
      EXPECT_NEAR(ofLarge, 1.0, 3e-5);
    }
    else
    {
      EXPECT_GT(ofSmall, 1.005);
    }
  }
}

TEST(CurvedSeamlessSurface, IsContinuousAcrossEdges)
{
  const Mesh network = makeGeodesicSphere(9);
  const Points model = shaken(lumpyModel(network.Positions), 0.04);
  for (const DomeHeight domeHeight : AllButFitted)
  {
    double jump[2] = {}, turn = 0.0;
    for (const SeamMode seamMode : { SeamMode::PerTriangle, SeamMode::EdgeMatched })
    {
      const CurvedSeamlessSurface surface(
        { { model, network.Triangles }, network.Positions }, optionsOf(domeHeight, seamMode));
      CurvedSeamlessSurface::Evaluator evaluator(surface);
      std::mt19937_64 engine(4);
      std::uniform_real_distribution<double> uniform(0.0, 1.0);
      for (int i = 0; i < 20000; ++i)
      {
        const Index r = static_cast<Index>(engine() % network.Triangles.rows());
        const int a = network.Triangles(r, 0), b = network.Triangles(r, 1);
        const Vector3 from = network.Positions.row(a), to = network.Positions.row(b);
        const double t = uniform(engine);
        const Vector3 onEdge = ((1.0 - t) * from + t * to).normalized();
        const Vector3 aside = 1e-12 * from.cross(to).normalized();
        const auto left = evaluator.evaluate((onEdge + aside).normalized()),
                   right = evaluator.evaluate((onEdge - aside).normalized());
        ASSERT_NE(left.Triangle, right.Triangle);
        const double length = (model.row(a) - model.row(b)).norm();
        double& largest = jump[seamMode == SeamMode::EdgeMatched];
        largest = std::max(largest, (left.Position - right.Position).norm() / length);
        if (seamMode == SeamMode::EdgeMatched)
        {
          turn = std::max(turn, (left.Normal - right.Normal).norm());
        }
      }
    }
    EXPECT_LT(jump[1], 1e-9);
    EXPECT_GT(jump[0], 0.2);
    if (domeHeight == DomeHeight::Curvature)
    {
      EXPECT_LT(turn, 1e-9);
    }
    else
    {
      EXPECT_GT(turn, 0.1);
    }
  }
}

TEST(CurvedSeamlessSurface, GoesToTheSurfaceAndBack)
{
  const Mesh network = makeGeodesicSphere(9);
  const Points model = lumpyModel(network.Positions);
  const Points directions = randomDirections(20000);
  for (const DomeHeight domeHeight : { DomeHeight::None, DomeHeight::Curvature })
  {
    const CurvedSeamlessSurface surface(
      { { model, network.Triangles }, network.Positions }, optionsOf(domeHeight));
    Points images(directions.rows(), 3), back = images, feet = images;
    conformal::SurfaceSamples samples;
    samples.Positions = images.data();
    conformal::evaluate(surface, directions, samples);
    conformal::invert(surface, images, back.data(), feet.data());
    EXPECT_LT((feet - images).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((back - directions).cwiseAbs().maxCoeff(), 1e-9);

    // Points near the surface have the direction of the closest point.
    const CurvedSeamlessInverse inverse(surface);
    CurvedSeamlessSurface::Evaluator evaluator(surface);
    for (Index i = 0; i < 300; ++i)
    {
      const auto at = evaluator.evaluate(directions.row(i));
      const auto foot =
        inverse.evaluate(at.Position + Vector3(1e-3, -2e-3, 1e-3), evaluator, at.Triangle);
      EXPECT_LE(foot.OnSurface.SquareDistance, 6e-6);
      EXPECT_LT(
        (evaluator.evaluate(foot.Direction).Position - foot.OnSurface.Position).norm(), 1e-9);
    }
  }
  EXPECT_THROW(
    CurvedSeamlessInverse(CurvedSeamlessSurface(
      { { model, network.Triangles }, network.Positions }, optionsOf(DomeHeight::Published))),
    std::invalid_argument);
}

TEST(CurvedSeamlessSurface, DerivativesAreDifferences)
{
  const Mesh network = makeGeodesicSphere(7);
  const Points model = shaken(lumpyModel(network.Positions), 0.02);
  const Points directions = randomDirections(500);
  for (const SeamMode seamMode : { SeamMode::PerTriangle, SeamMode::EdgeMatched })
  {
    const CurvedSeamlessSurface surface({ { model, network.Triangles }, network.Positions },
      optionsOf(DomeHeight::Curvature, seamMode));
    CurvedSeamlessSurface::Evaluator evaluator(surface);
    int compared = 0;
    for (Index i = 0; i < directions.rows(); ++i)
    {
      const Vector3 p = directions.row(i);
      Eigen::Matrix3d derivative;
      const auto here = evaluator.evaluate(p, &derivative);
      EXPECT_LT((derivative * p).norm(), 1e-12);
      const Vector3 u = p.unitOrthogonal();
      const double h = 3e-6;
      const auto ahead = evaluator.evaluate((p + h * u).normalized()),
                 behind = evaluator.evaluate((p - h * u).normalized());
      if (ahead.Triangle != here.Triangle || behind.Triangle != here.Triangle)
      {
        continue;
      }
      const Vector3 difference = (ahead.Position - behind.Position) / (2.0 * h);
      EXPECT_LT((difference - derivative * u).norm(), 1e-6 * (derivative * u).norm()) << i;
      ++compared;
    }
    EXPECT_GT(compared, 490);
  }
  const CurvedSeamlessSurface domes({ { model, network.Triangles }, network.Positions }, Published);
  double unused[9];
  conformal::SurfaceSamples samples;
  samples.Derivatives = unused;
  EXPECT_THROW(
    conformal::evaluate(domes, directions.topRows(1).eval(), samples), std::invalid_argument);
}

// What differentiation and integration are good for.
TEST(CurvedSeamlessSurface, IntegratesToItsAreaAndItsTotalCurvature)
{
  const Mesh network = makeGeodesicSphere(9);
  const Points model = lumpyModel(network.Positions);
  const CurvedSeamlessSurface surface({ { model, network.Triangles }, network.Positions });
  const Mesh dense = makeGeodesicSphere(180);
  Points positions(dense.Positions.rows(), 3), normals = positions,
                                               metrics(3 * positions.rows(), 3);
  std::vector<double> elements(positions.rows());
  conformal::SurfaceSamples samples;
  samples.Positions = positions.data();
  samples.Normals = normals.data();
  samples.Metrics = metrics.data();
  samples.AreaElements = elements.data();
  conformal::evaluate(surface, dense.Positions, samples);

  const auto solidAngle = [](const Vector3& a, const Vector3& b, const Vector3& c)
  { return 2.0 * std::atan2(a.cross(b).dot(c), 1.0 + a.dot(b) + b.dot(c) + c.dot(a)); };
  double ofMesh = 0.0, integral = 0.0, curvature = 0.0;
  for (Index r = 0; r < dense.Triangles.rows(); ++r)
  {
    const auto corners = [&](const Points& points)
    {
      return std::array<Vector3, 3>{ Vector3(points.row(dense.Triangles(r, 0))),
        Vector3(points.row(dense.Triangles(r, 1))), Vector3(points.row(dense.Triangles(r, 2))) };
    };
    const auto q = corners(positions), p = corners(dense.Positions), n = corners(normals);
    ofMesh += 0.5 * (q[1] - q[0]).cross(q[2] - q[0]).norm();
    // Inside the triangle, where no edge of the mesh is met.
    Vector3 middle = (p[0] + p[1] + p[2]).normalized();
    double element = 0.0;
    conformal::SurfaceSamples one;
    one.AreaElements = &element;
    conformal::evaluate(surface, conformal::PointView(middle.data(), 1), one);
    integral += element * solidAngle(p[0], p[1], p[2]);
    curvature += solidAngle(n[0], n[1], n[2]);
  }
  EXPECT_NEAR(integral / ofMesh, 1.0, 1e-4);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(curvature, 4.0 * pi, 0.04 * pi);

  // The metric's two principal minors make the area element.
  for (Index i = 0; i < positions.rows(); i += 97)
  {
    const Eigen::Matrix3d metric = metrics.middleRows<3>(3 * i);
    const double trace = metric.trace();
    const double minors = 0.5 * (trace * trace - (metric * metric).trace());
    EXPECT_NEAR(std::sqrt(minors), elements[i], 1e-9 * elements[i]);
  }
}

TEST(CurvedSeamlessSurface, AFitComesCloserThanItsStart)
{
  // Points of a fine lumpy model, learned on few vertices.
  const Points cloud = lumpyModel(makeGeodesicSphere(60).Positions);
  const Mesh network = makeGeodesicSphere(9);
  const Points model = shaken(lumpyModel(network.Positions), 0.004);
  const Mesh dense = makeGeodesicSphere(45);
  const conformal::TrainingSamples samples{ conformal::PointView(cloud) };
  const auto error = [&](DomeHeight domeHeight)
  {
    const Points surface =
      buildCurvedSeamlessSurface({ { model, network.Triangles }, network.Positions },
        dense.Positions, optionsOf(domeHeight), &samples)
        .Positions;
    const conformal::TriangleTree tree(surface, dense.Triangles);
    double sum = 0.0;
    for (Index i = 0; i < cloud.rows(); ++i)
    {
      sum += tree.closestPoint(cloud.row(i)).SquareDistance;
    }
    return sum / static_cast<double>(cloud.rows());
  };
  EXPECT_LT(error(DomeHeight::Fitted), 0.05 * error(DomeHeight::Curvature));
  EXPECT_THROW(buildCurvedSeamlessSurface({ { model, network.Triangles }, network.Positions },
                 dense.Positions, optionsOf(DomeHeight::Fitted)),
    std::invalid_argument);
}

TEST(CurvedSeamlessSurface, DegenerateTrianglesAreFlaggedAndFinite)
{
  const Mesh network = makeGeodesicSphere(4);
  Points model = lumpyModel(network.Positions);
  const int i = network.Triangles(10, 0), j = network.Triangles(10, 1);
  model.row(j) = model.row(i); // two triangles lose their area
  const Points directions = randomDirections(5000);
  const auto result =
    buildCurvedSeamlessSurface({ { model, network.Triangles }, network.Positions }, directions);
  EXPECT_EQ(result.NumberOfDegeneratePatches, 2);
  EXPECT_TRUE(result.Positions.allFinite());
  const CurvedSeamlessSurface surface({ { model, network.Triangles }, network.Positions });
  EXPECT_EQ(surface.degenerate()[10], 1);
  const auto flagged = std::count(result.Degenerate.begin(), result.Degenerate.end(), 1);
  EXPECT_GT(flagged, 0);
  EXPECT_LT(flagged, 200);
}

TEST(CurvedSeamlessSurface, AModelWithoutSizeIsOnePoint)
{
  const Mesh network = makeGeodesicSphere(2);
  const Points model = Points::Constant(network.Positions.rows(), 3, 5.0);
  const auto result = buildCurvedSeamlessSurface(
    { { model, network.Triangles }, network.Positions }, randomDirections(100));
  EXPECT_EQ(result.NumberOfDegeneratePatches, network.Triangles.rows());
  EXPECT_LT((result.Positions.array() - 5.0).abs().maxCoeff(), 1e-14);
}

TEST(CurvedSeamlessSurface, NeighborsFacingOppositeWaysAreFlagged)
{
  // A lattice pressed flat: all triangles at the rim have a neighbor on the other side.
  const Mesh network = makeGeodesicSphere(4);
  Points model = network.Positions;
  model.col(2).setZero();
  const auto result = buildCurvedSeamlessSurface(
    { { model, network.Triangles }, network.Positions }, randomDirections(2000), Published);
  EXPECT_GT(result.NumberOfDegeneratePatches, 0);
  EXPECT_LT(result.NumberOfDegeneratePatches, network.Triangles.rows());
  EXPECT_TRUE(result.Positions.allFinite());
}

TEST(CurvedSeamlessSurface, RefusesWhatIsNoMap)
{
  const Mesh network = makeGeodesicSphere(3);
  const Points& sphere = network.Positions;
  const Points directions = randomDirections(10);
  const auto build = [&](const Points& map, const Points& model, const Points& at) {
    buildCurvedSeamlessSurface({ { model, network.Triangles }, map }, at);
  };
  EXPECT_NO_THROW(build(3.0 * sphere, sphere, directions));

  Points bad = sphere;
  bad(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(build(bad, sphere, directions), std::invalid_argument);
  EXPECT_THROW(build(sphere, bad, directions), std::invalid_argument);
  bad.row(5).setZero();
  EXPECT_THROW(build(bad, sphere, directions), std::invalid_argument);
  bad = sphere.topRows(10);
  EXPECT_THROW(build(sphere, bad, directions), std::invalid_argument);
  bad = sphere; // one side of the sphere only
  bad.col(2) = bad.col(2).cwiseAbs();
  EXPECT_THROW(build(bad, sphere, directions), std::invalid_argument);
  bad = sphere;
  bad.row(0) = -bad.row(0); // folds
  EXPECT_THROW(build(bad, sphere, directions), std::invalid_argument);
  bad = directions;
  bad.row(3).setZero();
  EXPECT_THROW(build(sphere, sphere, bad), std::invalid_argument);
  bad(3, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(build(sphere, sphere, bad), std::invalid_argument);
  const CurvedSeamlessSurface surface({ { sphere, network.Triangles }, sphere });
  EXPECT_THROW(CurvedSeamlessSurface::Evaluator(surface).evaluate(
                 Vector3::Constant(std::numeric_limits<double>::quiet_NaN())),
    std::invalid_argument);
}

TEST(CurvedSeamlessSurface, ReportsProgressAndStopsWhenAsked)
{
  const Mesh network = makeGeodesicSphere(3);
  const auto build = [&](const conformal::Run& run)
  {
    buildCurvedSeamlessSurface({ { network.Positions, network.Triangles }, network.Positions },
      makeGeodesicSphere(120).Positions, {}, nullptr, run);
  };
  runs::Watch watch;
  build(watch.run());
  EXPECT_EQ(watch.fractions().front(), 0.0);
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_GT(watch.calls(), 6); // stages of the mesh, then chunks of points
  for (const double stopAt : watch.fractions())
  {
    EXPECT_THROW(build(runs::stoppingAt(stopAt)), conformal::Aborted);
  }
}

// A cap of the sphere, mapped by itself. Its curved surface is that of the sphere, up to the
// border.
TEST(CurvedSeamlessSurface, ASheetEndsAtItsBorder)
{
  conformal::MappedMesh sheet;
  static_cast<conformal::Mesh&>(sheet) = sheets::cap(16, 0.5 * conformal::Pi);
  sheet.SpherePositions = sheet.Positions;
  for (const conformal::DomeHeight domes :
    { conformal::DomeHeight::None, conformal::DomeHeight::Curvature,
      conformal::DomeHeight::Published, conformal::DomeHeight::Scaled })
  {
    const CurvedSeamlessSurface surface(conformal::withCaps(sheet), optionsOf(domes));
    EXPECT_TRUE(surface.isSheet());
    EXPECT_EQ(surface.numberOfVertices(), sheet.Positions.rows());
    EXPECT_EQ(surface.numberOfTriangles(), sheet.Triangles.rows());
    EXPECT_EQ(surface.numberOfDegeneratePatches(), 0);
    const conformal::Mesh fine = conformal::subdividedNetwork(surface, 3);
    EXPECT_EQ(fine.Triangles.rows(), 9 * sheet.Triangles.rows());
    std::vector<double> positions(3 * fine.Positions.rows()), normals(positions.size());
    conformal::SurfaceSamples samples;
    samples.Positions = positions.data();
    samples.Normals = normals.data();
    conformal::evaluate(surface, fine.Positions, samples);
    const bool isSmooth = domes == conformal::DomeHeight::Curvature;
    for (Index i = 0; i < fine.Positions.rows(); ++i)
    {
      const Vector3 x(positions.data() + 3 * i), n(normals.data() + 3 * i);
      EXPECT_NEAR(x.norm(), 1.0, isSmooth ? 5e-4 : 0.01);
      EXPECT_GE(x[2], -0.01);
      EXPECT_GT(n.dot(x), isSmooth ? 0.998 : 0.99);
      if (i < sheet.Positions.rows())
      {
        EXPECT_TRUE(x.isApprox(Vector3(sheet.Positions.row(i)), 1e-12));
      }
    }
  }
}

TEST(CurvedSeamlessSurface, DomesOfASheetAreFitted)
{
  conformal::MappedMesh sheet;
  static_cast<conformal::Mesh&>(sheet) = sheets::cap(6, 0.5 * conformal::Pi);
  sheet.SpherePositions = sheet.Positions;
  const Points cloud = sheets::cap(40, 0.5 * conformal::Pi).Positions;
  const conformal::TrainingSamples samplesOfCloud{ conformal::PointView(cloud) };
  const CurvedSeamlessSurface surface(
    conformal::withCaps(sheet), optionsOf(DomeHeight::Fitted), &samplesOfCloud);
  const conformal::Mesh fine = conformal::subdividedNetwork(surface, 3);
  std::vector<double> positions(3 * fine.Positions.rows());
  conformal::SurfaceSamples samples;
  samples.Positions = positions.data();
  conformal::evaluate(surface, fine.Positions, samples);
  for (Index i = 0; i < fine.Positions.rows(); ++i)
  {
    EXPECT_NEAR(Vector3(positions.data() + 3 * i).norm(), 1.0, 2e-3); // flat triangles: 0.006
  }
}

TEST(CurvedSeamlessSurface, BeyondTheBorderOfASheetThereIsNothing)
{
  conformal::MappedMesh sheet;
  static_cast<conformal::Mesh&>(sheet) = sheets::cap(6, 0.5 * conformal::Pi);
  sheet.SpherePositions = sheet.Positions;
  const CurvedSeamlessSurface surface(conformal::withCaps(sheet));
  CurvedSeamlessSurface::Evaluator evaluator(surface);
  EXPECT_NO_THROW(evaluator.evaluate(Vector3::UnitX()));
  EXPECT_THROW(evaluator.evaluate(-Vector3::UnitZ()), std::invalid_argument);
  EXPECT_THROW(evaluator.evaluate(Vector3(0.8, 0.0, -0.6)), std::invalid_argument);
  // The closest point of a point behind the sheet is on the sheet, not on its cap.
  const Points behind = Points(Eigen::RowVector3d(0.1, 0.0, -0.3));
  double direction[3], foot[3];
  conformal::invert(surface, behind, direction, foot);
  EXPECT_GE(direction[2], -1e-12);
  EXPECT_GT(Vector3(foot).norm(), 0.9);
}

#include "Texture/SphericalTexture.h"

#include "Mesh/GeodesicSphere.h"
#include "TextureFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

using conformal::Index;
using conformal::makeSphericalTexture;
using conformal::Points;
using conformal::SphereProjection;
using conformal::SphericalTexture;
using conformal::SphericalTextureOptions;
using conformal::TextureWrap;
using conformal::Triangles;
using conformal::Vector2;
using conformal::Vector3;
using fixtures::AllProjections;
using fixtures::egg;
using fixtures::seenFrom;

namespace
{
double signedArea(const SphericalTexture& texture, Index triangle)
{
  const auto at = [&](int k)
  { return Vector2(texture.Coordinates.row(texture.SplitTriangles(triangle, k))); };
  const Vector2 a = at(1) - at(0), b = at(2) - at(0);
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}

// Places of all points of a split surface, by the positions of the vertices.
Points placed(const SphericalTexture& texture, const Points& vertices)
{
  Points all(texture.Coordinates.rows(), 3);
  all.topRows(vertices.rows()) = vertices;
  for (std::size_t i = 0; i < texture.AddedPlaces.size(); ++i)
  {
    const conformal::SurfacePlace& place = texture.AddedPlaces[i];
    Vector3 sum = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += place.Weights[k] * Vector3(vertices.row(place.Ids[k]));
    }
    all.row(vertices.rows() + static_cast<Index>(i)) = sum;
  }
  return all;
}
}

// Neither turning the model with its viewer nor turning its sphere changes the picture; a mirrored
// sphere does not mirror it.
TEST(SphericalTexture, DoesNotDependOnCoordinates)
{
  const auto sphere = conformal::makeGeodesicSphere(10);
  const Points model = egg(sphere.Positions);
  const Vector3 direction(1, 0.4, 2), up(0.1, 1, 0);
  const SphericalTexture texture = makeSphericalTexture(
    model, sphere.Triangles, sphere.Positions, seenFrom<SphericalTextureOptions>(direction, up));
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.1, Vector3(3, 1, -1).normalized()).toRotationMatrix();

  Points turned = 1e150 * (model * turn.transpose());
  turned.rowwise() += Eigen::RowVector3d(3e150, 0, -1e150);
  const SphericalTexture ofTurned = makeSphericalTexture(turned, sphere.Triangles, sphere.Positions,
    seenFrom<SphericalTextureOptions>(turn * direction, turn * up));
  EXPECT_LT((ofTurned.Coordinates - texture.Coordinates).cwiseAbs().maxCoeff(), 1e-11);

  const Points turnedSphere = sphere.Positions * turn.transpose();
  const SphericalTexture onTurned = makeSphericalTexture(
    model, sphere.Triangles, turnedSphere, seenFrom<SphericalTextureOptions>(direction, up));
  EXPECT_LT((onTurned.Coordinates - texture.Coordinates).cwiseAbs().maxCoeff(), 1e-11);

  Points mirrored = sphere.Positions;
  mirrored.col(1) *= -1.0;
  const SphericalTexture onMirrored = makeSphericalTexture(
    model, sphere.Triangles, mirrored, seenFrom<SphericalTextureOptions>(direction, up));
  EXPECT_LT((onMirrored.Coordinates - texture.Coordinates).cwiseAbs().maxCoeff(), 1e-11);
}

// As the viewer sees the model, s grows to the right and t upwards.
TEST(SphericalTexture, IsNotMirroredOnAModel)
{
  const auto sphere = conformal::makeGeodesicSphere(10);
  const Points model = egg(sphere.Positions);
  for (const Vector3& direction : { Vector3(0, 0, 1), Vector3(1, 1, -1), Vector3(-2, 0.5, 0.2) })
  {
    const Vector3 up(0.2, 1, 0.1), right = up.cross(direction).normalized();
    const SphericalTexture texture = makeSphericalTexture(
      model, sphere.Triangles, sphere.Positions, seenFrom<SphericalTextureOptions>(direction, up));
    const Vector3 upright = direction.cross(right).normalized();
    double alongRight = 0.0, alongUp = 0.0, across = 0.0;
    for (Index i = 0; i < model.rows(); ++i)
    {
      const Vector2 st = texture.Coordinates.row(i).transpose() - Vector2(0.5, 0.5);
      if (st.norm() < 0.2)
      {
        alongRight += st[0] * right.dot(model.row(i));
        alongUp += st[1] * upright.dot(model.row(i));
        across += st[0] * upright.dot(model.row(i)) - st[1] * right.dot(model.row(i));
      }
    }
    EXPECT_GT(alongRight, 0.0);
    EXPECT_GT(alongUp, 0.0);
    EXPECT_LT(std::abs(across), 0.1 * (alongRight + alongUp));
  }
}

// A lattice point is the opposite pole here.
TEST(SphericalTexture, MasksWhatTheImageDoesNotReach)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  const SphericalTexture texture =
    makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions);
  for (Index i = 0; i < sphere.Positions.rows(); ++i)
  {
    const Vector2 st = texture.Coordinates.row(i);
    ASSERT_TRUE(st.allFinite());
    ASSERT_TRUE((st.array() >= 0.0).all() && (st.array() <= 1.0).all());
    const double z = sphere.Positions(i, 2);
    if (z > 1e-9)
    {
      EXPECT_EQ(texture.OutsideImage[i], 0);
    }
    if (z < -1.0 / 3.0 - 1e-9) // beyond the image's corners, |w|^2 = 2
    {
      EXPECT_EQ(texture.OutsideImage[i], 1);
    }
  }
}

TEST(SphericalTexture, StaysFiniteOnDegenerateModels)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  const Points point = Points::Ones(sphere.Positions.rows(), 3);
  const Points sheet = sphere.Positions * Vector3(1, 1, 0).asDiagonal();
  const Points line = sphere.Positions * Vector3(0, 0, 1).asDiagonal();
  Points collapsed = sphere.Positions;
  collapsed.rowwise() = Eigen::RowVector3d(0, 0, 1);
  for (const Points& model : { point, sheet, line })
  {
    for (const Points& positions : { sphere.Positions, collapsed })
    {
      const SphericalTexture texture = makeSphericalTexture(model, sphere.Triangles, positions);
      EXPECT_TRUE(texture.Coordinates.allFinite());
      EXPECT_NEAR(texture.Image.View.Pole.norm(), 1.0, 1e-12);
      EXPECT_NEAR(texture.Image.View.Up.norm(), 1.0, 1e-12);
    }
  }
}

// What a triangle shows at its middle and at its sides is what belongs there, and none shows it
// backwards: no triangle is laid across a seam, a fold or a border of the image.
TEST(SphericalTexture, SplitTrianglesShowWhatBelongsThere)
{
  const auto sphere = conformal::makeGeodesicSphere(24);
  SphericalTextureOptions options = seenFrom<SphericalTextureOptions>({ 1, 0.4, 2 }, { 0.1, 1, 0 });
  options.SplitSeam = true;
  for (double margin : { 0.0, 0.1 })
  {
    for (SphereProjection projection : AllProjections)
    {
      options.Projection = projection;
      options.Margin = margin;
      const SphericalTexture texture =
        makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
      const Points places = placed(texture, sphere.Positions);
      EXPECT_GE(texture.Coordinates.minCoeff(), 0.0);
      EXPECT_LE(texture.Coordinates.maxCoeff(), 1.0);
      Index shown = 0;
      for (Index r = 0; r < texture.SplitTriangles.rows(); ++r)
      {
        const auto ids = texture.SplitTriangles.row(r);
        const int outside = texture.OutsideImage[ids[0]];
        ASSERT_EQ(texture.OutsideImage[ids[1]], outside);
        ASSERT_EQ(texture.OutsideImage[ids[2]], outside);
        const double area = signedArea(texture, r);
        if (outside)
        {
          ASSERT_EQ(area, 0.0);
          continue;
        }
        ++shown;
        ASSERT_GT(area, 0.0);
        for (const Vector3& at : { Vector3(1, 1, 1), Vector3(9, 1, 9), Vector3(9, 1, 1) })
        {
          Vector2 st = Vector2::Zero();
          Vector3 n = Vector3::Zero();
          for (int k = 0; k < 3; ++k)
          {
            st += at[k] / at.sum() * texture.Coordinates.row(ids[k]).transpose();
            n += at[k] / at.sum() * places.row(ids[k]).transpose();
          }
          ASSERT_LT((conformal::textureToSphere(st, texture.Image) - n.normalized()).norm(), 0.01);
        }
      }
      EXPECT_GT(shown, sphere.Triangles.rows() / 2);
    }
  }
}

// The pieces of each triangle have its area and its sense, whatever was cut.
TEST(SphericalTexture, SplitKeepsTheSurface)
{
  const auto sphere = conformal::makeGeodesicSphere(16);
  for (TextureWrap wrap : { TextureWrap::Clamp, TextureWrap::Repeat, TextureWrap::Mirror })
  {
    for (SphereProjection projection : AllProjections)
    {
      SphericalTextureOptions options =
        seenFrom<SphericalTextureOptions>({ 1, 0.4, 2 }, { 0.1, 1, 0 });
      options.SplitSeam = true;
      options.Projection = projection;
      options.Wrap = wrap;
      options.Scale = { 0.7, 0.4 };
      const SphericalTexture texture =
        makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
      const Points places = placed(texture, sphere.Positions);
      Points areas = Points::Zero(sphere.Triangles.rows(), 3);
      const auto areaOf = [](const Points& points, const auto& ids)
      {
        const Vector3 a = points.row(ids[0]), b = points.row(ids[1]), c = points.row(ids[2]);
        return Vector3(0.5 * (b - a).cross(c - a));
      };
      for (Index r = 0; r < texture.SplitTriangles.rows(); ++r)
      {
        const Vector3 piece = areaOf(places, texture.SplitTriangles.row(r));
        const Index whole = texture.TriangleIds[r];
        ASSERT_GT(piece.dot(areaOf(sphere.Positions, sphere.Triangles.row(whole))), 0.0);
        areas.row(whole) += piece.transpose();
      }
      for (Index r = 0; r < sphere.Triangles.rows(); ++r)
      {
        const Vector3 expected = areaOf(sphere.Positions, sphere.Triangles.row(r));
        ASSERT_LT((Vector3(areas.row(r)) - expected).norm(), 1e-9 * expected.norm());
      }
      ASSERT_TRUE(texture.Coordinates.allFinite());
    }
  }
}

// Points that coincide count once: what was closed is closed but for the copies. (Clamp leaves a
// few ends of cuts on the rim of what the stereographic projection reaches.)
TEST(SphericalTexture, SplitLeavesNoCracks)
{
  const auto sphere = conformal::makeGeodesicSphere(10);
  for (SphereProjection projection : AllProjections)
  {
    SphericalTextureOptions options =
      seenFrom<SphericalTextureOptions>({ 1, 0.4, 2 }, { 0.1, 1, 0 });
    options.SplitSeam = true;
    options.Projection = projection;
    options.Wrap =
      projection == SphereProjection::Stereographic ? TextureWrap::Repeat : TextureWrap::Clamp;
    const SphericalTexture texture =
      makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
    const Points places = placed(texture, sphere.Positions);
    const auto place = [&](int id)
    {
      const Eigen::Vector3i rounded =
        (1e7 * places.row(id).transpose()).array().round().cast<int>();
      return std::array<int, 3>{ rounded[0], rounded[1], rounded[2] };
    };
    std::map<std::pair<std::array<int, 3>, std::array<int, 3>>, int> edges;
    for (Index r = 0; r < texture.SplitTriangles.rows(); ++r)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto a = place(texture.SplitTriangles(r, k));
        const auto b = place(texture.SplitTriangles(r, (k + 1) % 3));
        ++edges[{ a, b }];
        --edges[{ b, a }];
      }
    }
    Index open = 0;
    for (const auto& [edge, balance] : edges)
    {
      open += balance != 0;
    }
    EXPECT_EQ(open, 0) << static_cast<int>(projection);
  }
}

// Beside a pole of longitude and latitude: corners as far from it as the middle of the side between
// the others would make the straight triangle turn over.
TEST(SphericalTexture, SplitKeepsThinTrianglesBesideAPoleTheRightWayRound)
{
  const auto at = [](double longitude, double fromPole)
  {
    return Eigen::RowVector3d(std::sin(fromPole) * std::sin(longitude), std::cos(fromPole),
      std::sin(fromPole) * std::cos(longitude));
  };
  SphericalTextureOptions options;
  options.Projection = SphereProjection::LongitudeLatitude;
  options.SplitSeam = true;
  auto sphere = conformal::makeGeodesicSphere(4); // decides on the view
  const auto count = static_cast<int>(sphere.Positions.rows());
  Points positions(count + 3, 3);
  positions << sphere.Positions, at(0.02, 0.2), at(0.76, 0.2), at(0.39, 0.195);
  Triangles triangles(sphere.Triangles.rows() + 1, 3);
  triangles << sphere.Triangles, count, count + 1, count + 2;
  // 0.195 is farther from the pole than the side's middle, 0.2 cos(0.37) = 0.186, so from outside,
  // with the pole above, the third corner lies below.
  triangles.bottomRows(1) << count, count + 2, count + 1;
  options.ViewUp = { 0, 1, 0 };
  const SphericalTexture texture = makeSphericalTexture(positions, triangles, positions, options);
  double area = 0.0;
  int pieces = 0;
  for (Index r = 0; r < texture.SplitTriangles.rows(); ++r)
  {
    if (texture.TriangleIds[r] == sphere.Triangles.rows())
    {
      ASSERT_GT(signedArea(texture, r), 0.0);
      area += signedArea(texture, r);
      ++pieces;
    }
  }
  EXPECT_GT(pieces, 1);
  EXPECT_GT(area, 0.0);
}

TEST(SphericalTexture, WrapsAsAsked)
{
  const auto sphere = conformal::makeGeodesicSphere(20);
  SphericalTextureOptions options;
  options.FieldOfView = 90.0;
  const auto make = [&](TextureWrap wrap)
  {
    options.Wrap = wrap;
    return makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
  };
  const SphericalTexture clamp = make(TextureWrap::Clamp), repeat = make(TextureWrap::Repeat),
                         mirror = make(TextureWrap::Mirror);
  for (Index i = 0; i < sphere.Positions.rows(); ++i)
  {
    const Vector2 st = repeat.Coordinates.row(i);
    if (sphere.Positions(i, 2) < -0.9)
    {
      continue;
    }
    EXPECT_EQ(repeat.OutsideImage[i], 0);
    EXPECT_EQ(Vector2(clamp.Coordinates.row(i)), Vector2(st.cwiseMax(0.0).cwiseMin(1.0)));
    for (int axis = 0; axis < 2; ++axis) // a triangle wave of period two
    {
      EXPECT_NEAR(mirror.Coordinates(i, axis), std::abs(std::remainder(st[axis], 2.0)), 1e-12);
    }
  }
  EXPECT_GT(repeat.Coordinates.topRows(sphere.Positions.rows()).maxCoeff(), 2.0);
}

TEST(SphericalTexture, ScalesTheImageAboutItsMiddle)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  SphericalTextureOptions options;
  options.Wrap = TextureWrap::Repeat;
  const SphericalTexture whole =
    makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
  options.Scale = { 2.0, 0.5 };
  const SphericalTexture scaled =
    makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
  for (Index i = 0; i < sphere.Positions.rows(); ++i)
  {
    if (sphere.Positions(i, 2) > -0.9)
    {
      EXPECT_NEAR(scaled.Coordinates(i, 0) - 0.5, (whole.Coordinates(i, 0) - 0.5) / 2.0, 1e-12);
      EXPECT_NEAR(scaled.Coordinates(i, 1) - 0.5, (whole.Coordinates(i, 1) - 0.5) / 0.5, 1e-12);
    }
  }
}

TEST(SphericalTexture, RefusesScalesAndMarginsOutOfRange)
{
  const auto sphere = conformal::makeGeodesicSphere(2);
  const auto make = [&](const SphericalTextureOptions& options)
  { makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options); };
  for (double bad : { 0.0, -1.0, 1e4, std::nan("") })
  {
    SphericalTextureOptions options;
    options.Scale = { 1.0, bad };
    EXPECT_THROW(make(options), std::invalid_argument) << bad;
    options = {};
    options.Margin = bad == 0.0 ? 0.3 : bad;
    EXPECT_THROW(make(options), std::invalid_argument) << bad;
  }
}

TEST(SphericalTexture, DiskAndSquareDoNotUseTheView)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  for (const SphereProjection projection : { SphereProjection::Disk, SphereProjection::Square })
  {
    SphericalTextureOptions options;
    options.Projection = projection;
    options.ViewDirection = { 1.0, 0.0, 0.3 };
    options.ViewUp = options.ViewDirection; // no view
    const SphericalTexture texture =
      makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
    EXPECT_EQ(texture.Image.View.Pole, Vector3(0.0, 0.0, 1.0));
    EXPECT_THROW(makeSphericalTexture(sphere.Positions, Triangles(0, 3), sphere.Positions, options),
      std::invalid_argument);
  }
}

#include "Texture/SeamSplit.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::SphereProjection;
using conformal::SphericalTexture;
using conformal::splitAtSeams;
using conformal::TextureWrap;
using conformal::Vector2;
using conformal::Vector3;
using conformal::wrapped;

namespace
{
// The network with the coordinates of its vertices, as splitAtSeams is given them.
SphericalTexture unsplit(const Mesh& sphere, SphereProjection projection)
{
  SphericalTexture texture;
  texture.Image.Projection = projection;
  texture.Coordinates.resize(sphere.Positions.rows(), 2);
  texture.OutsideImage.assign(sphere.Positions.rows(), 0);
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    texture.Coordinates.row(v) = conformal::sphereToTexture(sphere.Positions.row(v), texture.Image);
  }
  return texture;
}

SphericalTexture split(const Mesh& sphere, SphereProjection projection)
{
  SphericalTexture texture = unsplit(sphere, projection);
  splitAtSeams(texture, sphere.Triangles, sphere.Positions, TextureWrap::Clamp, {});
  return texture;
}

Vector3 placeOf(const SphericalTexture& texture, const Points& vertices, int id)
{
  if (id < vertices.rows())
  {
    return vertices.row(id);
  }
  const conformal::SurfacePlace& place = texture.AddedPlaces[id - vertices.rows()];
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    sum += place.Weights[k] * Vector3(vertices.row(place.Ids[k]));
  }
  return sum;
}

Vector3 areaVector(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return 0.5 * (b - a).cross(c - a);
}

const SphereProjection Seamed[] = { SphereProjection::LongitudeLatitude,
  SphereProjection::Octahedral, SphereProjection::CubeMap };
}

TEST(SeamSplit, WrapsCoordinates)
{
  const Vector2 inside(0.3, 0.8);
  for (const TextureWrap wrap : { TextureWrap::Clamp, TextureWrap::Repeat, TextureWrap::Mirror })
  {
    EXPECT_EQ(wrapped(inside, wrap).Coordinates, inside);
    EXPECT_FALSE(wrapped(inside, wrap).IsOutside);
  }
  EXPECT_EQ(wrapped({ 1.25, -0.5 }, TextureWrap::Clamp).Coordinates, Vector2(1.0, 0.0));
  EXPECT_TRUE(wrapped({ 1.25, -0.5 }, TextureWrap::Clamp).IsOutside);
  EXPECT_EQ(wrapped({ 1.25, -0.5 }, TextureWrap::Repeat).Coordinates, Vector2(1.25, -0.5));
  EXPECT_EQ(wrapped({ 1.25, -0.5 }, TextureWrap::Mirror).Coordinates, Vector2(0.75, 0.5));
  EXPECT_EQ(wrapped({ 2.25, -1.5 }, TextureWrap::Mirror).Coordinates, Vector2(0.25, 0.5));
}

// Each triangle is cut into parts of its own plane and sense that fill it.
// The disk does not depend on the view. The view of a mirrored map is left-handed.
TEST(SeamSplit, DiskAndSquareDoNotDependOnTheView)
{
  const Mesh sphere = makeGeodesicSphere(6);
  for (const SphereProjection projection : { SphereProjection::Disk, SphereProjection::Square })
  {
    SphericalTexture mirrored = unsplit(sphere, projection);
    mirrored.Image.View.Right = { -1, 0, 0 };
    splitAtSeams(mirrored, sphere.Triangles, sphere.Positions, TextureWrap::Clamp, {});
    EXPECT_EQ(mirrored.SplitTriangles, split(sphere, projection).SplitTriangles);
  }
}

TEST(SeamSplit, ReportsProgressOften)
{
  const Mesh sphere = makeGeodesicSphere(20);
  SphericalTexture texture = unsplit(sphere, SphereProjection::Octahedral);
  runs::Watch watch;
  splitAtSeams(texture, sphere.Triangles, sphere.Positions, TextureWrap::Clamp, watch.run());
  EXPECT_GT(watch.calls(), 10);
}

TEST(SeamSplit, PartsFillTheirTriangles)
{
  const Mesh sphere = makeGeodesicSphere(7);
  for (const SphereProjection projection : Seamed)
  {
    const SphericalTexture texture = split(sphere, projection);
    ASSERT_EQ(static_cast<Index>(texture.TriangleIds.size()), texture.SplitTriangles.rows());
    ASSERT_EQ(texture.Coordinates.rows(),
      sphere.Positions.rows() + static_cast<Index>(texture.AddedPlaces.size()));
    EXPECT_GT(texture.SplitTriangles.rows(), sphere.Triangles.rows());
    Points sums = Points::Zero(sphere.Triangles.rows(), 3);
    for (Index r = 0; r < texture.SplitTriangles.rows(); ++r)
    {
      Vector3 corners[3];
      for (int k = 0; k < 3; ++k)
      {
        corners[k] = placeOf(texture, sphere.Positions, texture.SplitTriangles(r, k));
      }
      const auto ids = sphere.Triangles.row(texture.TriangleIds[r]);
      const Vector3 part = areaVector(corners[0], corners[1], corners[2]);
      const Vector3 whole = areaVector(
        sphere.Positions.row(ids[0]), sphere.Positions.row(ids[1]), sphere.Positions.row(ids[2]));
      ASSERT_GE(part.dot(whole), -1e-15);
      ASSERT_LT(part.cross(whole).norm(), 1e-12);
      sums.row(texture.TriangleIds[r]) += part;
    }
    for (Index r = 0; r < sphere.Triangles.rows(); ++r)
    {
      const auto ids = sphere.Triangles.row(r);
      const Vector3 whole = areaVector(
        sphere.Positions.row(ids[0]), sphere.Positions.row(ids[1]), sphere.Positions.row(ids[2]));
      ASSERT_LT((Vector3(sums.row(r)) - whole).norm(), 1e-12) << r;
    }
  }
}

// Without the split, triangles across a seam show all of the image.
TEST(SeamSplit, NoPartSpansASeam)
{
  const Mesh sphere = makeGeodesicSphere(7);
  const auto widest = [](const conformal::TextureCoordinates& st, const conformal::Triangles& ids)
  {
    double width = 0.0;
    for (Index r = 0; r < ids.rows(); ++r)
    {
      for (int k = 0; k < 3; ++k)
      {
        width = std::max(width, (st.row(ids(r, k)) - st.row(ids(r, (k + 1) % 3))).norm());
      }
    }
    return width;
  };
  for (const SphereProjection projection : Seamed)
  {
    const SphericalTexture before = unsplit(sphere, projection);
    const SphericalTexture texture = split(sphere, projection);
    EXPECT_GT(widest(before.Coordinates, sphere.Triangles), 0.3);
    EXPECT_TRUE((texture.Coordinates.array() >= 0.0).all());
    EXPECT_TRUE((texture.Coordinates.array() <= 1.0).all());
    if (projection == SphereProjection::LongitudeLatitude)
    {
      continue; // at its poles the edges of the image are wide
    }
    EXPECT_LT(widest(texture.Coordinates, texture.SplitTriangles), 0.3);
  }
}

// The middle of each part lies in the image where it does on the sphere, but for the bend of the
// projection.
TEST(SeamSplit, PartsLieWhereTheyDoOnTheSphere)
{
  const Mesh sphere = makeGeodesicSphere(12);
  for (const SphereProjection projection : Seamed)
  {
    const SphericalTexture texture = split(sphere, projection);
    for (Index r = 0; r < texture.SplitTriangles.rows(); ++r)
    {
      Vector3 place = Vector3::Zero();
      Vector2 shown = Vector2::Zero();
      for (int k = 0; k < 3; ++k)
      {
        const int id = texture.SplitTriangles(r, k);
        ASSERT_LT(id, texture.Coordinates.rows());
        place += placeOf(texture, sphere.Positions, id);
        shown += texture.Coordinates.row(id) / 3.0;
      }
      const Vector3 onSphere = conformal::textureToSphere(shown, texture.Image);
      ASSERT_LT((onSphere - place.normalized()).norm(), 0.1) << r;
    }
  }
}

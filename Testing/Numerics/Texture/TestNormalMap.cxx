#include "Texture/NormalMap.h"

#include "Mesh/GeodesicSphere.h"
#include "Texture/SphericalTexture.h"
#include "Texture/SurfaceTangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::Index;
using conformal::normalMap;
using conformal::PixelGrid;
using conformal::Points;
using conformal::SphereImage;
using conformal::SphereProjection;
using conformal::SurfaceWithNormals;
using conformal::TangentSurface;
using conformal::Vector2;
using conformal::Vector3;

namespace
{
const PixelGrid SquareGrid = { 80, 80 };
constexpr double Margin = 0.05;

// Sphere that is cut along the seams of an octahedral image.
struct CutSphere : TangentSurface
{
  SphereImage Image;
};

CutSphere cutSphere(int frequency, SphereProjection projection = SphereProjection::Octahedral)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency);
  conformal::SphericalTextureOptions options;
  options.Projection = projection;
  options.SplitSeam = true;
  options.Margin = Margin;
  const auto texture =
    conformal::makeSphericalTexture(sphere.Positions, sphere.Triangles, sphere.Positions, options);
  CutSphere cut;
  cut.Image = texture.Image;
  cut.Triangles = texture.SplitTriangles;
  cut.Positions.resize(texture.Coordinates.rows(), 3);
  cut.Positions.topRows(sphere.Positions.rows()) = sphere.Positions;
  for (std::size_t i = 0; i < texture.AddedPlaces.size(); ++i)
  {
    Vector3 sum = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += texture.AddedPlaces[i].Weights[k] *
        Vector3(sphere.Positions.row(texture.AddedPlaces[i].Ids[k]));
    }
    cut.Positions.row(sphere.Positions.rows() + static_cast<Index>(i)) = sum.normalized();
  }
  cut.SpherePositions = cut.Normals = cut.Positions;
  cut.Tangents = conformal::surfaceTangents(cut, cut.Normals, texture.Coordinates);
  return cut;
}

// Sphere whose normals lean towards a direction.
SurfaceWithNormals leaning(const Vector3& towards)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(30);
  SurfaceWithNormals detail;
  detail.Positions = sphere.Positions;
  detail.Triangles = sphere.Triangles;
  detail.Normals = (sphere.Positions.rowwise() + towards.transpose()).rowwise().normalized();
  return detail;
}

bool isInMargin(const Vector2& st)
{
  return (st - Vector2::Constant(0.5)).lpNorm<Eigen::Infinity>() > 0.5 - Margin;
}
}

TEST(NormalMap, IsFlatIfTheSurfacesAreEqual)
{
  const CutSphere cut = cutSphere(20);
  const Points values = normalMap(cut, cut.Image, SquareGrid, leaning(Vector3::Zero()));
  for (Index i = 0; i < SquareGrid.size(); ++i)
  {
    ASSERT_GT(values(i, 2), isInMargin(SquareGrid.middleOf(i)) ? 0.8 : 0.9999) << i;
  }
}

// The values, relative to the directions in which s and t increase, are the normals of the detail.
TEST(NormalMap, IsRelativeToTheDirectionsOfTheImage)
{
  const CutSphere cut = cutSphere(20);
  const Vector3 towards(0.2, -0.1, 0.25);
  const Points values = normalMap(cut, cut.Image, SquareGrid, leaning(towards));
  constexpr double step = 1e-5;
  Index compared = 0;
  for (Index i = 0; i < SquareGrid.size(); ++i)
  {
    const Vector2 st = SquareGrid.middleOf(i);
    const Vector2 q = (st - Vector2::Constant(0.5)).cwiseAbs();
    const double toFold = std::min(std::abs(q[0] + q[1] - (0.5 - Margin)), q.minCoeff());
    if (isInMargin(st) || toFold < 0.03)
    {
      continue;
    }
    const Vector3 p = conformal::textureToSphere(st, cut.Image);
    const Vector3 s =
      (conformal::textureToSphere(st + Vector2(step, 0), cut.Image) - p).normalized();
    const Vector3 normal = (p + towards).normalized();
    const Vector3 expected(s.dot(normal), p.cross(s).dot(normal), p.dot(normal));
    ASSERT_LT((values.row(i).transpose() - expected).norm(), 0.03) << st.transpose();
    ++compared;
  }
  EXPECT_GT(compared, SquareGrid.size() / 2);
}

// Faces of a cube have margins of their own.
TEST(NormalMap, IsContinuousInEachFaceOfACube)
{
  const CutSphere cut = cutSphere(20, SphereProjection::CubeMap);
  const PixelGrid grid = { 120, 80 };
  const Points values = normalMap(cut, cut.Image, grid, leaning(Vector3(0.2, -0.1, 0.25)));
  for (Index row = 0; row < grid.Height; ++row)
  {
    for (Index column = 0; column + 1 < grid.Width; ++column)
    {
      const Index i = row * grid.Width + column;
      const bool isCorner = std::min(row % 40, 39 - row % 40) < 4;
      if (column % 40 != 39 && !isCorner)
      {
        ASSERT_LT((values.row(i) - values.row(i + 1)).norm(), 0.1) << row << " " << column;
      }
    }
  }
}

// A pixel of the margin continues the values beside it: their frames are the same.
TEST(NormalMap, IsContinuousAtTheMargin)
{
  const CutSphere cut = cutSphere(20);
  const Points values = normalMap(cut, cut.Image, SquareGrid, leaning(Vector3(0.2, -0.1, 0.25)));
  for (Index row = 8; row < SquareGrid.Height - 8; ++row)
  {
    const Index border = row * SquareGrid.Width + static_cast<Index>(Margin * SquareGrid.Width);
    ASSERT_LT((values.row(border) - values.row(border - 1)).norm(), 0.1) << row;
  }
}

TEST(NormalMap, DoesNotDependOnThreads)
{
  const CutSphere cut = cutSphere(6);
  const SurfaceWithNormals detail = leaning(Vector3(0.2, -0.1, 0.25));
  const conformal::Run backwards(
    [](Index count, const std::function<void(Index)>& body)
    {
      for (Index i = count; i-- > 0;)
      {
        body(i);
      }
    },
    {});
  EXPECT_EQ(normalMap(cut, cut.Image, SquareGrid, detail),
    normalMap(cut, cut.Image, SquareGrid, detail, backwards));
}

TEST(NormalMap, RefusesImagesWithoutPixels)
{
  const CutSphere cut = cutSphere(6);
  const SurfaceWithNormals detail = leaning(Vector3::Zero());
  EXPECT_THROW(normalMap(cut, cut.Image, { 0, 5 }, detail), std::invalid_argument);
  EXPECT_THROW(normalMap(cut, cut.Image, SquareGrid, {}), std::invalid_argument);
}

#include "Register/SphericalTemplate.h"

#include "Heads.h"
#include "Runs.h"
#include "Sphere/SphereOrientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

using conformal::findSphericalTemplate;
using conformal::Index;
using conformal::Points;
using conformal::SpaceOfTransforms;
using conformal::SphericalTemplateOptions;
using conformal::SphericalTemplateResult;
using conformal::TemplateInput;
using conformal::Vector3;

namespace
{
// A head turned and moved, its map warped and turned.
TemplateInput copy(int number, int frequency, double nose = 0.7)
{
  TemplateInput input;
  input.Name = "head " + std::to_string(number);
  input.Surface = heads::withWarpedMap(heads::head(frequency, nose), 0.7 * number);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1 * number, Vector3(0.3, 0.5, -0.8).normalized()).toRotationMatrix();
  conformal::MappedMesh& mesh = input.Surface.Surface;
  mesh.Positions = (mesh.Positions * turn.transpose()).eval();
  mesh.Positions.rowwise() += Eigen::RowVector3d(number, 0.5, -0.3 * number);
  return input;
}

// The same with some of the icosahedron's vertices, which are the first ones at any frequency: the
// rotation need not be searched for.
TemplateInput held(int number, int frequency, double nose)
{
  TemplateInput input = copy(number, frequency, nose);
  input.Landmarks = { 0, 3, 7, 10 };
  return input;
}

SphericalTemplateOptions quick()
{
  SphericalTemplateOptions options;
  options.Registration.Frequency = 8;
  options.MeanFrequency = 16;
  options.MaximumNumberOfRounds = 1;
  return options;
}

void expectTemplateRefused(const std::vector<TemplateInput>& inputs, const std::string& why)
{
  try
  {
    findSphericalTemplate(inputs, {}, quick());
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()).rfind(why, 0), 0U) << error.what();
  }
}
}

// The mean of copies is the body that they were made of, and their points lie where they belong.
TEST(SphericalTemplate, CopiesGiveTheirBodyBack)
{
  constexpr int count = 3, frequency = 16;
  std::vector<TemplateInput> inputs;
  for (int s = 0; s < count; ++s)
  {
    inputs.push_back(copy(s, frequency));
  }
  SphericalTemplateOptions options;
  options.MaximumNumberOfRounds = 2;
  const SphericalTemplateResult result = findSphericalTemplate(inputs, {}, options);
  ASSERT_EQ(result.Registrations.size(), 3U);
  for (int s = 1; s < count; ++s)
  {
    EXPECT_LT(heads::meanAngle(
                result.Registrations[s].SpherePositions, result.Registrations[0].SpherePositions),
      1.0);
  }
  for (const auto& registration : result.Registrations)
  {
    EXPECT_EQ(registration.NumberOfFolds, 0);
    EXPECT_LT(registration.Stretch, 1.01);
    EXPECT_GT(registration.AgreementAfter, 0.99);
  }
  // It lies where the start does: back to where the head was made, each point is on its surface.
  const auto number = static_cast<double>(result.Start);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1 * number, Vector3(0.3, 0.5, -0.8).normalized()).toRotationMatrix();
  double square = 0.0;
  for (Index i = 0; i < result.Mean.Positions.rows(); ++i)
  {
    const Vector3 moved = result.Mean.Positions.row(i);
    const Vector3 p = (turn.transpose() * (moved - Vector3(number, 0.5, -0.3 * number)))
                        .cwiseQuotient(Vector3(1.2, 0.9, 1.0));
    square += std::pow(p.norm() - heads::radiusAt(p.normalized()), 2);
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(result.Mean.Positions.rows())), 0.01);
  EXPECT_EQ(
    conformal::countFlippedTriangles(result.Mean.SpherePositions, result.Mean.Triangles), 0);
}

// Bodies with equal ends. One feature distinguishes the ends of the first and the third, another
// feature those of the second and the third: only by way of the third, the second is not turned.
TEST(SphericalTemplate, AThirdSurfaceDecidesWhereTwoEndsAreEqual)
{
  std::vector<TemplateInput> inputs(3);
  for (TemplateInput& input : inputs)
  {
    input.Surface = heads::twoEnds();
    const Points& positions = input.Surface.Surface.Positions;
    input.Surface.Features = conformal::Rows::Zero(positions.rows(), 2);
    if (&input != &inputs[1])
    {
      input.Surface.Features.col(0) = positions.col(0);
    }
    if (&input != &inputs[0])
    {
      input.Surface.Features.col(1) = positions.col(0);
    }
  }
  const Points correct = inputs[0].Surface.Surface.SpherePositions;
  SphericalTemplateOptions options = quick();
  options.MaximumNumberOfRounds = 0;
  const auto undecided = findSphericalTemplate({ inputs[0], inputs[1] }, { 1.0, 1.0 }, options);
  EXPECT_TRUE(undecided.Registrations[1].IsAmbiguous);
  // The map of the second surface is turned by 180 degrees.
  inputs[1].Surface.Surface.SpherePositions.leftCols<2>() *= -1.0;
  const auto decided = findSphericalTemplate(inputs, { 1.0, 1.0 }, options);
  EXPECT_EQ(decided.Start, 0);
  EXPECT_FALSE(decided.Registrations[1].IsAmbiguous);
  EXPECT_TRUE(decided.Registrations[1].Second.empty());
  EXPECT_LT(heads::meanAngle(decided.Registrations[1].SpherePositions, correct), 5.0);
}

// The head whose nose is neither the longest nor the shortest is the start, wherever it stands.
TEST(SphericalTemplate, OrderDoesNotCount)
{
  const std::vector<TemplateInput> inputs = { held(0, 12, 0.3), held(1, 13, 0.7),
    held(2, 11, 1.2) };
  const auto forward = findSphericalTemplate(inputs, {}, quick());
  const auto backward = findSphericalTemplate({ inputs[2], inputs[1], inputs[0] }, {}, quick());
  EXPECT_EQ(forward.Start, 1);
  EXPECT_EQ(backward.Start, 1);
  for (int s = 0; s < 3; ++s)
  {
    EXPECT_LT(
      (forward.Registrations[s].SpherePositions - backward.Registrations[2 - s].SpherePositions)
        .cwiseAbs()
        .maxCoeff(),
      1e-6);
  }
  EXPECT_LT((forward.Mean.Positions - backward.Mean.Positions).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(SphericalTemplate, RoundsEndWhenTheMeanStays)
{
  const std::vector<TemplateInput> inputs = { held(0, 10, 0.4), held(1, 10, 0.9) };
  SphericalTemplateOptions options = quick();
  options.MaximumNumberOfRounds = 3;
  options.Tolerance = 0.0;
  const auto all = findSphericalTemplate(inputs, {}, options);
  ASSERT_EQ(all.Changes.size(), 3U);
  EXPECT_LT(all.Changes[2], all.Changes[0]);
  options.Tolerance = 1.001 * all.Changes[0];
  EXPECT_EQ(findSphericalTemplate(inputs, {}, options).Changes.size(), 1U);
  options.MaximumNumberOfRounds = 0;
  const auto none = findSphericalTemplate(inputs, {}, options);
  EXPECT_TRUE(none.Changes.empty());
  EXPECT_EQ(none.Registrations[none.Start].SpherePositions,
    inputs[none.Start].Surface.Surface.SpherePositions);
}

TEST(SphericalTemplate, LandmarksOfAllMeet)
{
  std::vector<TemplateInput> inputs = { copy(0, 10, 0.4), copy(1, 10, 0.7), copy(2, 10, 0.9) };
  for (TemplateInput& input : inputs)
  {
    input.Landmarks = { 3, 7, 200, 431, 431 - 60 };
  }
  const auto result = findSphericalTemplate(inputs, {}, quick());
  for (int s = 0; s < 3; ++s)
  {
    EXPECT_EQ(result.Registrations[s].NumberOfUnmetLandmarks, 0);
    for (const int id : inputs[s].Landmarks)
    {
      EXPECT_LT((result.Registrations[s].SpherePositions.row(id) -
                  result.Registrations[0].SpherePositions.row(id))
                  .norm(),
        1e-6);
    }
  }
}

// Round balls have no shape to go by; what is known of them are numbers.
TEST(SphericalTemplate, GivenFeaturesAreAveragedToo)
{
  std::vector<TemplateInput> inputs;
  const auto sphere = conformal::makeGeodesicSphere(12);
  for (int s = 0; s < 3; ++s)
  {
    TemplateInput input = copy(s, 12);
    conformal::RegisteredSurface& surface = input.Surface;
    surface.Surface.Positions = sphere.Positions;
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.9 * s, Vector3(0.1, 0.9, 0.4).normalized()).toRotationMatrix();
    surface.Surface.SpherePositions = sphere.Positions * turn.transpose();
    surface.Features.resize(sphere.Positions.rows(), 1);
    for (Index i = 0; i < sphere.Positions.rows(); ++i)
    {
      surface.Features(i, 0) = (5.0 + s) * heads::radiusAt(sphere.Positions.row(i)) - 3.0 * s;
    }
    inputs.push_back(input);
  }
  SphericalTemplateOptions options = quick();
  options.Registration.ShapeWeight = 0.0;
  options.Registration.Space = SpaceOfTransforms::Rotation;
  const auto result = findSphericalTemplate(inputs, { 1.0 }, options);
  for (int s = 0; s < 3; ++s)
  {
    EXPECT_LT(heads::meanAngle(
                result.Registrations[s].SpherePositions, result.Registrations[0].SpherePositions),
      1.0);
    EXPECT_GT(result.Registrations[s].AgreementAfter, 0.99);
  }
}

TEST(SphericalTemplate, OneSurfaceIsItsOwnTemplate)
{
  const std::vector<TemplateInput> inputs = { copy(1, 10) };
  SphericalTemplateOptions options = quick();
  const auto result = findSphericalTemplate(inputs, {}, options);
  EXPECT_EQ(result.Start, 0);
  EXPECT_TRUE(result.Changes.empty());
  EXPECT_EQ(result.Registrations[0].SpherePositions, inputs[0].Surface.Surface.SpherePositions);
  EXPECT_NEAR(result.Mean.Positions.rows(), 10 * 16 * 16 + 2, 0.02 * (10 * 16 * 16 + 2));
}

TEST(SphericalTemplate, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const std::vector<TemplateInput> inputs = { held(0, 9, 0.4), held(1, 8, 0.9) };
  const auto expected = findSphericalTemplate(inputs, {}, quick());
  const auto threaded = findSphericalTemplate(inputs, {}, quick(), runs::backwards());
  EXPECT_EQ(expected.Mean.Positions, threaded.Mean.Positions);
  for (int s = 0; s < 2; ++s)
  {
    EXPECT_EQ(expected.Registrations[s].SpherePositions, threaded.Registrations[s].SpherePositions);
  }
  runs::Watch watch;
  findSphericalTemplate(inputs, {}, quick(), watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_GT(watch.calls(), 50);
  EXPECT_THROW(
    findSphericalTemplate(inputs, {}, quick(), runs::stoppingAt(0.6)), conformal::Aborted);
}

TEST(SphericalTemplate, SurfacesThatCannotBeUsedAreNamed)
{
  expectTemplateRefused({}, "there is no surface");
  TemplateInput bad = copy(1, 8);
  bad.Surface.Surface.SpherePositions.row(30) *= -1.0;
  expectTemplateRefused({ copy(0, 8), bad }, "the map to the sphere of head 1 covers it");
  expectTemplateRefused({ bad, copy(0, 8) }, "the map to the sphere of head 1 covers it");
  bad = copy(1, 8);
  bad.Surface.Surface.Positions.setZero();
  expectTemplateRefused({ copy(0, 8), bad }, "head 1 has no area");
  bad = copy(1, 8);
  bad.Landmarks = { 4 };
  expectTemplateRefused({ copy(0, 8), bad }, "head 1 has 1 landmarks, but head 0 has 0");
}

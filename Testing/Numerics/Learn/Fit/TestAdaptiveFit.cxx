#include "Learn/Fit/AdaptiveFit.h"

#include "Base/Random.h"
#include "Clouds.h"
#include "Learn/ConformalSOM.h"
#include "Measure/Distortion.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Runs.h"
#include "Search/TriangleTree.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

using conformal::ConformalSOMOptions;
using conformal::ConformalSOMResult;
using conformal::Index;
using conformal::MappedMesh;
using conformal::MeshType;
using conformal::Pi;
using conformal::Points;
using conformal::trainConformalSOM;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
Vector3 direction(conformal::Random& random)
{
  const double z = 2.0 * random.uniform() - 1.0, angle = 2.0 * Pi * random.uniform();
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

Points ellipsoid(Index size, unsigned int seed)
{
  conformal::Random random(seed);
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    points.row(i) = direction(random).cwiseProduct(Vector3(1.0, 0.7, 0.8));
  }
  return points;
}

// A ball with five round arms, the half lines of three axes but one.
class Jack
{
public:
  static constexpr double Ball = 0.35, Arm = 0.12, Length = 0.88;

  static double distance(const Vector3& x)
  {
    double least = x.norm() - Ball;
    for (int arm = 0; arm < Arms; ++arm)
    {
      const double along = std::clamp(axis(arm).dot(x), 0.0, Length);
      least = std::min(least, (x - along * axis(arm)).norm() - Arm);
    }
    return least;
  }

  // Even in area: points of each part that lie in no other.
  static Points cloud(Index size, unsigned int seed)
  {
    conformal::Random random(seed);
    const double ball = 4.0 * Pi * Ball * Ball, arm = 2.0 * Pi * Arm * (Length + Arm);
    Points points(size, 3);
    for (Index i = 0; i < size;)
    {
      const double part = random.uniform() * (ball + Arms * arm);
      Vector3 x = Ball * direction(random);
      if (part >= ball)
      {
        // A cylinder and half a ball, whose area is that of as long a cylinder.
        const Vector3 along = axis(static_cast<int>((part - ball) / arm));
        const double place = random.uniform() * (Length + Arm);
        const double beyond = std::max(0.0, place - Length);
        const double radius = std::sqrt(Arm * Arm - beyond * beyond);
        const double angle = 2.0 * Pi * random.uniform();
        const Vector3 u(along[1], along[2], along[0]), v = along.cross(u);
        x = place * along + radius * (std::cos(angle) * u + std::sin(angle) * v);
      }
      if (distance(x) > -1e-9)
      {
        points.row(i++) = x;
      }
    }
    return points;
  }

private:
  static constexpr int Arms = 5;

  static Vector3 axis(int arm)
  {
    Vector3 result = Vector3::Zero();
    result[arm / 2] = arm % 2 == 0 ? 1.0 : -1.0;
    return result;
  }
};

// A ball with four horns that bend back to it: arcs in planes through its center, whose tips end a
// little above it.
class HornedBall
{
public:
  static constexpr double Ball = 0.7, Arc = 0.2, Horn = 0.06;
  static constexpr double First = -0.3, Last = 2.73; // angles along the arc

  static double distance(const Vector3& x)
  {
    double least = x.norm() - Ball;
    for (int horn = 0; horn < Horns; ++horn)
    {
      const Frame frame(horn);
      const Vector3 way = x - Ball * frame.Outward;
      const double opposite = 0.5 * (First + Last) + Pi; // from where both ends are as far away
      double angle = std::atan2(way.dot(frame.Outward), way.dot(frame.Along));
      angle += angle < opposite - 2.0 * Pi ? 2.0 * Pi : 0.0;
      least = std::min(least, (x - frame.place(std::clamp(angle, First, Last))).norm() - Horn);
    }
    return least;
  }

  static Points cloud(Index size, unsigned int seed)
  {
    conformal::Random random(seed);
    const double ball = 4.0 * Pi * Ball * Ball, horn = 2.0 * Pi * Horn * Arc * (Last - First);
    Points points(size, 3);
    for (Index i = 0; i < size;)
    {
      const double part = random.uniform() * (ball + Horns * horn);
      Vector3 x = Ball * direction(random);
      if (part >= ball)
      {
        const Frame frame(static_cast<int>((part - ball) / horn));
        const double along = First + random.uniform() * (Last - First);
        const Vector3 middle = frame.place(along), u = (middle - Ball * frame.Outward) / Arc;
        const double angle = 2.0 * Pi * random.uniform();
        x = middle +
          Horn * (std::cos(angle) * u + std::sin(angle) * frame.Along.cross(frame.Outward));
        const Vector3 beyond = direction(random); // the round tip
        if (random.uniform() * (Arc * (Last - First) + Horn) < Horn)
        {
          x = frame.place(Last) + Horn * beyond;
        }
      }
      if (distance(x) > -1e-9)
      {
        points.row(i++) = x;
      }
    }
    return points;
  }

private:
  static constexpr int Horns = 4;

  struct Frame
  {
    Vector3 Outward, Along;

    explicit Frame(int horn)
      : Outward(Vector3(
          horn < 2 ? 1.0 : -1.0, horn % 2 == 0 ? 1.0 : -1.0, horn == 0 || horn == 3 ? 1.0 : -1.0)
                  .normalized())
      , Along(Outward.unitOrthogonal())
    {
    }

    Vector3 place(double angle) const
    {
      return Ball * this->Outward +
        Arc * (std::cos(angle) * this->Along + std::sin(angle) * this->Outward);
    }
  };
};

ConformalSOMOptions adaptive(Index neurons)
{
  ConformalSOMOptions options;
  options.MeshType = MeshType::Adaptive;
  options.NumberOfNeurons = neurons;
  return options;
}

ConformalSOMResult learnedBy(
  const Points& points, ConformalSOMOptions options, conformal::HullMethod indicator)
{
  options.HullMethod = indicator;
  return trainConformalSOM(TrainingSamples{ conformal::PointView(points) }, options);
}

ConformalSOMOptions geodesic(int frequency)
{
  ConformalSOMOptions options;
  options.MeshType = conformal::MeshType::Geodesic;
  options.NumberOfNeurons = conformal::geodesicSphereSize(frequency);
  return options;
}

// Of points that were not learned.
double meanSquareDistance(const Points& points, const ConformalSOMResult& result)
{
  const conformal::TriangleTree tree(result.Positions, result.Triangles);
  double sum = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    sum += tree.closestPoint(points.row(i)).SquareDistance;
  }
  return sum / static_cast<double>(points.rows());
}

Vector3 center(const ConformalSOMResult& result, Index triangle)
{
  const auto ids = result.Triangles.row(triangle);
  return (result.Positions.row(ids[0]) + result.Positions.row(ids[1]) +
           result.Positions.row(ids[2])) /
    3.0;
}

double meanMinimumAngle(const ConformalSOMResult& result)
{
  double sum = 0.0;
  for (Index r = 0; r < result.Triangles.rows(); ++r)
  {
    double smallest = Pi;
    for (int k = 0; k < 3; ++k)
    {
      const auto corner = [&](int i)
      { return Vector3(result.Positions.row(result.Triangles(r, (k + i) % 3))); };
      const Vector3 u = corner(1) - corner(0), v = corner(2) - corner(0);
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
    sum += smallest * 180.0 / Pi;
  }
  return sum / static_cast<double>(result.Triangles.rows());
}

void expectWhole(const ConformalSOMResult& result, Index neurons)
{
  EXPECT_EQ(result.Positions.rows(), neurons);
  EXPECT_EQ(result.Triangles.rows(), 2 * neurons - 4);
  EXPECT_TRUE(result.Positions.allFinite());
  EXPECT_TRUE(conformal::checkGenusZero(result.Triangles, result.Positions.rows()).isGenusZero());
}

}

TEST(AdaptiveFit, HasAsManyNeuronsAsWanted)
{
  const Points points = ellipsoid(8000, 3);
  for (const Index neurons : { 12, 100, 777, 1501 })
  {
    const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), adaptive(neurons));
    expectWhole(result, neurons);
    EXPECT_GT(conformal::signedVolume(result.Positions, result.Triangles), 0.0);
    EXPECT_EQ(result.SpherePositions.rows(), neurons);
  }
}

TEST(AdaptiveFit, FitsAnEllipsoidNearlyAsTheGeodesicLattice)
{
  const Points points = ellipsoid(20000, 3), others = ellipsoid(10000, 4);
  const double even =
    meanSquareDistance(others, trainConformalSOM(TrainingSamples(points), geodesic(12)));
  const double own =
    meanSquareDistance(others, trainConformalSOM(TrainingSamples(points), adaptive(1442)));
  RecordProperty("Ratio", std::to_string(own / even));
  EXPECT_LT(own, 1.4 * even); // a smooth egg is what the regular lattice is best at
}

TEST(AdaptiveFit, FitsLimbsCloser)
{
  const Points points = Jack::cloud(20000, 3), others = Jack::cloud(10000, 4);
  const ConformalSOMResult lattice = trainConformalSOM(TrainingSamples(points), geodesic(14));
  const ConformalSOMResult own = trainConformalSOM(TrainingSamples(points), adaptive(1962));
  expectWhole(own, lattice.Positions.rows());
  const double ratio = meanSquareDistance(others, own) / meanSquareDistance(others, lattice);
  RecordProperty("Ratio", std::to_string(ratio));
  EXPECT_LT(ratio, 0.5);
  EXPECT_GT(meanMinimumAngle(own), 49.0);
  EXPECT_GT(meanMinimumAngle(own), meanMinimumAngle(lattice) + 5.0);
  // And no part of it leaves the object, as webs would.
  double farthest = 0.0;
  for (Index r = 0; r < own.Triangles.rows(); ++r)
  {
    farthest = std::max(farthest, std::abs(Jack::distance(center(own, r))));
  }
  EXPECT_LT(farthest, 0.02);
  EXPECT_EQ(own.UnsupportedFraction, 0.0);
}

// A cube, turned: neurons lie on its edges and in its corners, and no triangle cuts these off.
TEST(AdaptiveFit, MeetsSharpEdges)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, 4.0).normalized()).toRotationMatrix();
  conformal::Random random(3);
  const auto onCube = [&](int dimensions) // of a face, or an edge
  {
    Vector3 x;
    const int axis = std::min(2, static_cast<int>(3.0 * random.uniform()));
    for (int i = 0; i < 3; ++i)
    {
      const double free = random.uniform() - 0.5;
      x[(axis + i) % 3] = i < dimensions ? free : free < 0.0 ? -0.5 : 0.5;
    }
    return Vector3(turn * x);
  };
  Points points(20000, 3), edges(2000, 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = onCube(2);
  }
  for (Index i = 0; i < edges.rows(); ++i)
  {
    edges.row(i) = onCube(1);
  }
  const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), adaptive(3000));
  expectWhole(result, 3000);
  const double error = std::sqrt(meanSquareDistance(edges, result));
  RecordProperty("Error", std::to_string(error));
  EXPECT_LT(error, 1e-3);
}

TEST(AdaptiveFit, IsMappedConformally)
{
  const Points points = Jack::cloud(12000, 3);
  const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), adaptive(3000));
  const conformal::Distortion distortion =
    conformal::measureDistortion(result.Positions, result.Triangles, result.SpherePositions);
  EXPECT_LT(distortion.MeanQuasiConformalError, 1.15);
  EXPECT_EQ(distortion.NumberOfFlippedTriangles, 0);
}

TEST(AdaptiveFit, IsWhatBatchTakesWhereThePointsAreNotFlat)
{
  const Points points = ellipsoid(3000, 3);
  ConformalSOMOptions automatic;
  automatic.NumberOfNeurons = 500;
  EXPECT_EQ(trainConformalSOM(TrainingSamples(points), automatic).Positions,
    trainConformalSOM(TrainingSamples(points), adaptive(500)).Positions);
  Points flat = points;
  flat.col(2).setZero();
  EXPECT_EQ(trainConformalSOM(TrainingSamples(flat), automatic).Positions,
    trainConformalSOM(TrainingSamples(flat), geodesic(7)).Positions)
    << "of as many neurons, nearly";
  automatic.TrainingMode = conformal::TrainingMode::Online;
  automatic.Online.NumberOfEpochs = 0;
  automatic.NumberOfNeurons = conformal::geodesicSphereSize(3);
  EXPECT_EQ(trainConformalSOM(TrainingSamples(points), automatic).Positions.rows(), 92);
}

TEST(AdaptiveFit, SameBitsInAnyOrderOfBlocks)
{
  const Points points = Jack::cloud(8000, 3);
  const ConformalSOMResult a = trainConformalSOM(TrainingSamples(points), adaptive(1000));
  const ConformalSOMResult b =
    trainConformalSOM(TrainingSamples(points, {}, {}, {}, runs::backwards()), adaptive(1000),
      nullptr, runs::backwards());
  EXPECT_EQ(a.Positions, b.Positions);
  EXPECT_EQ(a.Triangles, b.Triangles);
  EXPECT_EQ(a.SpherePositions, b.SpherePositions);
}

TEST(AdaptiveFit, RanksShareTheSums)
{
  const Points points = Jack::cloud(8000, 3);
  std::vector<double> priority(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    priority[i] = points(i, 2) > 0.5 ? 3.0 : 1.0;
  }
  const ConformalSOMResult whole =
    trainConformalSOM(TrainingSamples(points, priority), adaptive(1000));
  const std::vector<Index> cuts = { 0, 3000, 3000, 8000 };
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const Index first = cuts[reduce.Rank], size = cuts[reduce.Rank + 1] - first;
      const Points own = points.middleRows(first, size);
      const std::vector<double> weights(priority.begin() + first, priority.begin() + first + size);
      const ConformalSOMResult result =
        trainConformalSOM(TrainingSamples(own, weights, {}, reduce), adaptive(1000));
      EXPECT_EQ(result.Positions, whole.Positions) << reduce.Rank;
      EXPECT_EQ(result.Triangles, whole.Triangles) << reduce.Rank;
      EXPECT_EQ(result.UnsupportedFraction, whole.UnsupportedFraction);
    });
}

// An object without limbs does not need the hull.
TEST(AdaptiveFit, StartsFromTheSphereOrAHull)
{
  using conformal::StartingShape;
  const Points egg = ellipsoid(8000, 3), jack = Jack::cloud(12000, 3);
  const auto hulled = [](const Points& points, StartingShape shape)
  {
    ConformalSOMOptions options = adaptive(1000);
    options.StartingShape = shape;
    const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), options);
    expectWhole(result, 1000);
    return result.FromHull;
  };
  EXPECT_FALSE(hulled(egg, StartingShape::Automatic));
  EXPECT_TRUE(hulled(egg, StartingShape::Hull));
  EXPECT_TRUE(hulled(jack, StartingShape::Automatic));
  EXPECT_FALSE(hulled(jack, StartingShape::Sphere));
}

// Webs within the horns are too small for the coarse lattice that is learned from the sphere; they
// show in the polished surface, which is then learned anew from a hull.
TEST(AdaptiveFit, StartsAnewFromAHullWhereWebsShowLate)
{
  using conformal::StartingShape;
  const Points points = HornedBall::cloud(40000, 3);
  ConformalSOMOptions options = adaptive(4000);
  const auto farthest = [](const ConformalSOMResult& result)
  {
    double far = 0.0;
    for (Index r = 0; r < result.Triangles.rows(); ++r)
    {
      far = std::max(far, std::abs(HornedBall::distance(center(result, r))));
    }
    return far;
  };
  const ConformalSOMResult anew = trainConformalSOM(TrainingSamples(points), options);
  options.StartingShape = StartingShape::Sphere;
  const ConformalSOMResult fromSphere = trainConformalSOM(TrainingSamples(points), options);
  expectWhole(anew, 4000);
  EXPECT_TRUE(anew.FromHull);
  EXPECT_EQ(anew.UnsupportedFraction, 0.0);
  EXPECT_LT(farthest(anew), 0.02);
  // It has something to mend, and the coarse lattice would not have told.
  EXPECT_GT(fromSphere.UnsupportedFraction, 0.001);
  EXPECT_GT(farthest(fromSphere), 0.04);
}

// A start takes the place of the hull, whichever way its triangles run and however few they are.
TEST(AdaptiveFit, StartsFromAMesh)
{
  const Points points = ellipsoid(8000, 3), others = ellipsoid(5000, 4);
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(4);
  MappedMesh start{ sphere, sphere.Positions };
  for (const bool insideOut : { false, true })
  {
    if (insideOut)
    {
      start.Triangles.col(0).swap(start.Triangles.col(1));
    }
    const ConformalSOMResult result =
      trainConformalSOM(TrainingSamples(points), adaptive(642), &start);
    expectWhole(result, 642);
    EXPECT_FALSE(result.FromHull);
    EXPECT_LT(meanSquareDistance(others, result), 2e-5);
    EXPECT_GT(conformal::signedVolume(result.Positions, result.Triangles), 0.0);
  }
  MappedMesh open = start;
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  EXPECT_THROW(
    trainConformalSOM(TrainingSamples(points), adaptive(642), &open), std::invalid_argument);
  MappedMesh far = start;
  far.Positions *= 100.0;
  EXPECT_THROW(
    trainConformalSOM(TrainingSamples(points), adaptive(642), &far), std::invalid_argument);
}

TEST(AdaptiveFit, LeavesOutliersAndNoiseBehind)
{
  const Points clean = ellipsoid(20000, 3), others = ellipsoid(10000, 4);
  conformal::Random random(5);
  Points noisy = clean;
  constexpr double Noise = 0.02;
  for (Index i = 0; i < noisy.rows(); ++i)
  {
    noisy.row(i) *= 1.0 + std::sqrt(3.0) * Noise * (2.0 * random.uniform() - 1.0);
  }
  Points strays = clean;
  for (Index i = 0; i < strays.rows(); i += 50)
  {
    strays.row(i) = 1.2 * random.uniform() * direction(random);
  }
  const ConformalSOMResult plain = trainConformalSOM(TrainingSamples(clean), adaptive(1442));
  EXPECT_LT(plain.NoiseToDetail, 0.5);
  EXPECT_LT(
    meanSquareDistance(others, trainConformalSOM(TrainingSamples(strays), adaptive(1442))), 2e-6);
  const ConformalSOMResult smoothed = trainConformalSOM(TrainingSamples(noisy), adaptive(1442));
  EXPECT_GT(smoothed.NoiseToDetail, 2.0);
  EXPECT_LT(meanSquareDistance(others, smoothed), 0.16 * Noise * Noise);
}

// Noise as large as an edge: a surface that follows it has half as much area again, and webs.
TEST(AdaptiveFit, DoesNotCrumpleInNoise)
{
  constexpr double noise = 0.025;
  Points points = Jack::cloud(12000, 3);
  conformal::Random random(5);
  for (Index i = 0; i < points.size(); ++i)
  {
    points.data()[i] += std::sqrt(12.0) * noise * (random.uniform() - 0.5);
  }
  const auto area = [](const ConformalSOMResult& result)
  { return conformal::surfaceArea(result.Positions, result.Triangles); };
  const ConformalSOMResult clean =
    trainConformalSOM(TrainingSamples(Jack::cloud(12000, 3)), adaptive(3000));
  const ConformalSOMResult noisy = trainConformalSOM(TrainingSamples(points), adaptive(3000));
  expectWhole(noisy, 3000);
  double squares = 0.0;
  for (Index r = 0; r < noisy.Triangles.rows(); ++r)
  {
    const double distance = Jack::distance(center(noisy, r));
    squares += distance * distance;
  }
  const double error = std::sqrt(squares / static_cast<double>(noisy.Triangles.rows()));
  RecordProperty("Error", std::to_string(error / noise));
  RecordProperty("Area", std::to_string(area(noisy) / area(clean)));
  EXPECT_LT(error, 0.35 * noise);
  EXPECT_NEAR(area(noisy), area(clean), 0.08 * area(clean));
}

TEST(AdaptiveFit, DegenerateCloudsGiveFiniteMeshes)
{
  std::vector<Points> clouds = { ellipsoid(4, 3), ellipsoid(5, 3), ellipsoid(40, 3) };
  for (const Index size : { 1, 2, 3, 50 })
  {
    clouds.emplace_back(Points::Constant(size, 3, 7.0));
    Points line = Points::Zero(size, 3);
    line.col(0).setLinSpaced(0.0, 1.0);
    clouds.push_back(line);
    line.col(1) = line.col(0).array().square();
    clouds.push_back(line);
  }
  Points plane = ellipsoid(5000, 3);
  plane.col(1).setZero();
  clouds.push_back(plane);
  for (const Points& points : clouds)
  {
    const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), adaptive(300));
    expectWhole(result, 300);
    EXPECT_TRUE(result.SpherePositions.allFinite());
    EXPECT_LT((result.SpherePositions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-9);
  }
}

TEST(AdaptiveFit, StopsWhenToldTo)
{
  const Points points = Jack::cloud(8000, 3);
  runs::Watch watch;
  trainConformalSOM(TrainingSamples(points), adaptive(1000), nullptr, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_GE(watch.calls(), 50);
  for (const double when : { 0.0, 0.1, 0.3, 0.5, 0.9, 0.98 })
  {
    EXPECT_THROW(
      trainConformalSOM(TrainingSamples(points), adaptive(1000), nullptr, runs::stoppingAt(when)),
      conformal::Aborted)
      << when;
  }
}

TEST(AdaptiveFit, RefusesWhatItCannotUse)
{
  const Points points = ellipsoid(100, 3);
  const auto refused = [&](auto change)
  {
    ConformalSOMOptions options = adaptive(100);
    change(options);
    EXPECT_THROW(trainConformalSOM(TrainingSamples(points), options), std::invalid_argument);
  };
  refused([](auto& o) { o.NumberOfNeurons = 11; });
  refused([](auto& o) { o.TrainingMode = conformal::TrainingMode::Online; });
}

// A clean cloud keeps its hull, to the bit; one that leaks gets the other.
TEST(AdaptiveFit, TakesTheHullThatTheCloudSupports)
{
  using conformal::HullMethod;
  const Points jack = Jack::cloud(12000, 3);
  const Points cut = clouds::where(ellipsoid(9000, 3), [](const Vector3& x) { return x[0] < 0.1; });
  ConformalSOMOptions options = adaptive(1500);
  options.StartingShape = conformal::StartingShape::Hull;
  const ConformalSOMResult automatic = learnedBy(jack, options, HullMethod::Automatic);
  EXPECT_EQ(automatic.Hull, HullMethod::Distance);
  EXPECT_EQ(automatic.NumberOfStarts, 1);
  EXPECT_LT(defectScore(automatic.Quality), 0.5);
  EXPECT_LT(automatic.Noise, 0.002);
  EXPECT_NEAR(automatic.AreaRatio, 0.85, 0.1);
  EXPECT_EQ(automatic.Positions, learnedBy(jack, options, HullMethod::Distance).Positions);

  const ConformalSOMResult leaking = learnedBy(cut, options, HullMethod::Automatic);
  EXPECT_EQ(leaking.Hull, HullMethod::WindingNumbers);
  EXPECT_EQ(leaking.Positions, learnedBy(cut, options, HullMethod::WindingNumbers).Positions);
}

// So few points that the hull by the distance has holes and folds: the result is judged, learned
// anew, and better.
TEST(AdaptiveFit, StartsAnewWhereTheResultIsBad)
{
  using conformal::HullMethod;
  const Points points = Jack::cloud(500, 3);
  const ConformalSOMOptions options = adaptive(3000);
  const ConformalSOMResult bad = learnedBy(points, options, HullMethod::Distance),
                           best = learnedBy(points, options, HullMethod::Automatic);
  RecordProperty("Distance", std::to_string(defectScore(bad.Quality)));
  RecordProperty("Automatic", std::to_string(defectScore(best.Quality)));
  EXPECT_GT(defectScore(bad.Quality), 1.0);
  EXPECT_EQ(best.NumberOfStarts, 2);
  EXPECT_LT(defectScore(best.Quality), defectScore(bad.Quality));
}

// An ellipsoid of which an end is missing: the surface continues round over the hole, farther if
// it is learned from a hull by winding numbers.
TEST(AdaptiveFit, GoesOnOverAHoleByWindingNumbers)
{
  const Points points =
    clouds::where(ellipsoid(9000, 3), [](const Vector3& x) { return x[0] < 0.45; });
  const TrainingSamples samples{ conformal::PointView(points) };
  ConformalSOMOptions options;
  options.MeshType = conformal::MeshType::Adaptive;
  options.NumberOfNeurons = 1500;
  options.StartingShape = conformal::StartingShape::Hull;
  const auto volumeBy = [&](conformal::HullMethod indicator)
  {
    options.HullMethod = indicator;
    const ConformalSOMResult result = trainConformalSOM(samples, options);
    EXPECT_TRUE(conformal::checkGenusZero(result.Triangles, result.Positions.rows()).isGenusZero());
    return conformal::signedVolume(result.Positions, result.Triangles);
  };
  const double whole = 4.0 / 3.0 * Pi * 0.7 * 0.8;
  // Cut off flat: (2 + 3 c - c^3) / 4 of it.
  const double flat = whole * (2.0 + 3.0 * 0.45 - std::pow(0.45, 3)) / 4.0;
  const double byDistance = volumeBy(conformal::HullMethod::Distance);
  const double byWindingNumbers = volumeBy(conformal::HullMethod::WindingNumbers);
  EXPECT_GT(byDistance, flat + 0.05 * whole);
  EXPECT_GT(byWindingNumbers, byDistance);
  EXPECT_LT(byWindingNumbers, 1.03 * whole);
}

#include "Learn/Online/NeuronBlocks.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::NeuronBlocks;
using conformal::Points;
using conformal::Vector3;

namespace
{
// Neurons whose weights lie about as they would half-way through learning: on a bent, folded
// surface with two coincident neurons.
struct Fixture
{
  explicit Fixture(int frequency)
    : Network(conformal::makeGeodesicSphere(frequency).Positions)
    , Weights(Network)
  {
    for (Index i = 0; i < this->Weights.rows(); ++i)
    {
      this->Weights.row(i) *= 0.6 + 0.4 * std::sin(5.0 * this->Network(i, 0));
    }
    this->Weights.row(this->Weights.rows() - 1) = this->Weights.row(3);
  }
  Points Network, Weights;
};

Vector3 anyPoint(conformal::Random& random)
{
  const double x = 2.4 * random.uniform() - 1.2, y = 2.4 * random.uniform() - 1.2;
  return Vector3(x, y, 2.4 * random.uniform() - 1.2);
}
}

TEST(NeuronBlocks, WinnerIsTheClosestNeuron)
{
  for (int frequency : { 1, 2, 7, 20 })
  {
    const Fixture fixture(frequency);
    const NeuronBlocks neurons(fixture.Network, fixture.Weights);
    conformal::Random random(1);
    for (int trial = 0; trial < 500; ++trial)
    {
      const Vector3 x = trial == 0 ? Vector3(fixture.Weights.row(3)) : anyPoint(random);
      Index closest = 0;
      (fixture.Weights.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff(&closest);
      EXPECT_EQ(neurons.findWinner(x), closest);
    }
  }
}

// Eq. 3, written out neuron by neuron; winners stay right after many updates.
TEST(NeuronBlocks, UpdateIsEquationThree)
{
  for (int frequency : { 1, 3, 20 })
  {
    Fixture fixture(frequency);
    NeuronBlocks neurons(fixture.Network, fixture.Weights);
    conformal::Random random(2);
    for (double sigma : { 0.4, 0.1, 0.02 })
    {
      for (int trial = 0; trial < 100; ++trial)
      {
        const Vector3 x = anyPoint(random), r = anyPoint(random).normalized();
        const double alpha = 0.3 * random.uniform();
        Points moved = neurons.weights();
        neurons.update(x, r, alpha, sigma);
        for (Index i = 0; i < moved.rows(); ++i)
        {
          const double d = (r - Vector3(fixture.Network.row(i))).norm();
          const double h = std::exp(-d * d / (2.0 * sigma * sigma));
          const Vector3 step = alpha * h * (x - Vector3(moved.row(i)));
          const Vector3 taken = neurons.weight(static_cast<int>(i)) - Vector3(moved.row(i));
          if (d > 4.001 * sigma)
          {
            EXPECT_EQ(taken, Vector3::Zero());
          }
          else if (d < 3.999 * sigma)
          {
            EXPECT_LE((taken - step).norm(), 1e-4 * step.norm() + 1e-15);
          }
        }
        const Points weights = neurons.weights();
        Index closest = 0;
        (weights.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff(&closest);
        EXPECT_EQ(neurons.findWinner(x), closest);
      }
    }
  }
}

// Winners and updates are those of all dimensions, written out neuron by neuron.
TEST(NeuronBlocks, LearnsFurtherValues)
{
  constexpr Index numberOfValues = 3;
  const Fixture fixture(12);
  NeuronBlocks neurons(fixture.Network, fixture.Weights, numberOfValues);
  conformal::Random random(5);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Vector3 x = anyPoint(random), values = 0.5 * anyPoint(random);
    const Vector3 r = anyPoint(random).normalized();
    Eigen::MatrixXd before(fixture.Network.rows(), 6);
    for (Index i = 0; i < before.rows(); ++i)
    {
      before.row(i) = neurons.fullWeight(static_cast<int>(i)).transpose();
    }
    Eigen::Matrix<double, 6, 1> pattern;
    pattern << x, values;
    Index closest = 0;
    (before.rowwise() - pattern.transpose()).rowwise().squaredNorm().minCoeff(&closest);
    ASSERT_EQ(neurons.findWinner(x, values.data()), closest);
    neurons.update(x, r, 0.2, 0.3, values.data());
    for (Index i = 0; i < before.rows(); ++i)
    {
      const double d = (r - Vector3(fixture.Network.row(i))).norm();
      const double share = d < 4.0 * 0.3 ? 0.2 * std::exp(-d * d / (2.0 * 0.3 * 0.3)) : 0.0;
      const Eigen::Matrix<double, 6, 1> way = pattern - before.row(i).transpose();
      const Eigen::Matrix<double, 6, 1> taken =
        neurons.fullWeight(static_cast<int>(i)) - before.row(i).transpose();
      ASSERT_LE((taken - share * way).norm(), 1e-4 * way.norm());
    }
  }
}

TEST(NeuronBlocks, GivesBackItsWeights)
{
  const Fixture fixture(5);
  EXPECT_EQ(NeuronBlocks(fixture.Network, fixture.Weights).weights(), fixture.Weights);
}

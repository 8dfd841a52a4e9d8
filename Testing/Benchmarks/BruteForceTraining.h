// Train a conformal self-organizing map exactly by the published algorithm, to measure the speed of
// trainConformalSOM(). Each step computes the distances of all neurons, and moves all neurons.
#ifndef BruteForceTraining_h
#define BruteForceTraining_h

#include "Base/Random.h"
#include "Learn/Online/OnlineTraining.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"
#include "TriangleMap/NetworkShapes.h"

#include <cmath>

namespace reference
{
/// Train a network online: one sample in each step, without priorities. The samples are drawn as by
/// trainConformalSOM(). Loops over neurons use the vector instructions of the processor.
/// @return weights of the #N neurons in units of the training: #N by 3
inline conformal::Points trainByBruteForce(
  const conformal::TrainingSamples& samples, const conformal::OnlineTrainingOptions& options)
{
  using namespace conformal;
  const Mesh network = makeGeodesicSphere(options.Frequency);
  const Adjacency around = vertexTriangles(network.Triangles, network.Positions.rows());
  const NetworkShapes shapes(network.Positions, network.Triangles);
  const Eigen::Array<double, Eigen::Dynamic, 3> n = network.Positions.array();
  Eigen::Array<double, Eigen::Dynamic, 3> w = n;
  Eigen::ArrayXd distances, shares;
  const auto weight = [&](int i) { return Vector3(w(i, 0), w(i, 1), w(i, 2)); };
  Random random(options.RandomSeed);
  for (int t = 0; t < options.NumberOfEpochs; ++t)
  {
    const double sigma =
      options.InitialNeighborhoodRadius * std::exp(-t / options.NeighborhoodTimeConstant);
    const double alpha =
      options.InitialLearningRate * std::exp(-t / options.LearningRateTimeConstant);
    for (int step = 0; step < options.SamplesPerEpoch; ++step)
    {
      const Vector3 x = samples[random.index(samples.size())];
      distances =
        (w.col(0) - x[0]).square() + (w.col(1) - x[1]).square() + (w.col(2) - x[2]).square();
      const double least = distances.minCoeff();
      int winner = 0;
      while (distances[winner] != least)
      {
        ++winner;
      }
      FootPoint foot;
      for (const int* r = around.begin(winner); r != around.end(winner); ++r)
      {
        const auto ids = network.Triangles.row(*r);
        FootPoint candidate =
          closestPointOfTriangle(x, weight(ids[0]), weight(ids[1]), weight(ids[2]));
        candidate.Triangle = *r;
        foot = candidate.SquareDistance < foot.SquareDistance ? candidate : foot;
      }
      const auto ids = network.Triangles.row(foot.Triangle);
      const TriangleShape simplex(weight(ids[0]), weight(ids[1]), weight(ids[2]));
      const Vector3 image = shapes.toNetwork(foot.Triangle, simplex, foot.Barycentric);
      const Vector3 r = (network.Positions.row(ids[0]) * image[0] +
        network.Positions.row(ids[1]) * image[1] + network.Positions.row(ids[2]) * image[2])
                          .normalized();
      shares = alpha *
        (((n.col(0) - r[0]).square() + (n.col(1) - r[1]).square() + (n.col(2) - r[2]).square()) *
          (-0.5 / (sigma * sigma)))
          .exp();
      for (int c = 0; c < 3; ++c)
      {
        w.col(c) += shares * (x[c] - w.col(c));
      }
    }
  }
  return w.matrix();
}
}

#endif

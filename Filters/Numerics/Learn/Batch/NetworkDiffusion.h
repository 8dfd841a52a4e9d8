/// Spread sums over the neighbors of neurons, the neighborhood of batch training (BatchTraining.h,
/// SphericalSOM.h). Own construction: a few steps of diffusion over the network take the place of
/// the neighborhood function h of \cite Liou2008 Eq. 3, and need fewer operations.

#ifndef ConformalNetworkDiffusion_h
#define ConformalNetworkDiffusion_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
/// Weight of the mean of its neighbors in the mean of a neuron, relative to the mean weight of the
/// patterns of a neuron. With this weight, a neuron without patterns gets the mean of its
/// neighbors.
constexpr double NegligibleShare = 1e-6;

/// Return the frequencies of the networks of batch training: from coarse to fine, each about twice
/// the previous one.
/// @param[in] finest    frequency of the last network
/// @param[in] coarsest  smallest frequency of a network before the last one
inline std::vector<int> levelsOf(int finest, int coarsest)
{
  std::vector<int> levels = { finest };
  while (levels.back() / 2 >= coarsest)
  {
    levels.push_back(levels.back() / 2);
  }
  std::reverse(levels.begin(), levels.end());
  return levels;
}

/// Return the number of diffusion steps in a pass of a network. It decreases from 5 to 1.
inline int diffusionsOf(int pass, int numberOfPasses)
{
  constexpr int widest = 5; // in the first pass of each network
  return std::max(1, widest - pass * widest / numberOfPasses);
}

/// Diffuse by one step. Every neuron keeps half of its sums, and distributes the other half equally
/// to its neighbors.
/// @param[in] neighbors   result of vertexNeighbors() for the network
/// @param[in,out] shares  matrix with one row of sums for each neuron
template <typename Shares>
void diffuse(const Adjacency& neighbors, Shares& shares, const Run& run)
{
  constexpr Index blockSize = 1024;
  Shares spread(shares.rows(), shares.cols());
  forBlocks(run, shares.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        spread.row(i) = 0.5 * shares.row(i);
        for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
        {
          spread.row(i) += 0.5 / neighbors.size(*j) * shares.row(*j);
        }
      }
    });
  shares.swap(spread);
}
}

#endif

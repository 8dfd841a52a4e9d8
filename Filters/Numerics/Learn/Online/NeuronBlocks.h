/// Store neurons in spatial blocks, for fast search of the winner and fast update of its
/// neighborhood. Own construction: blocks have bounds, because these make the search fast and keep
/// it exact.

#ifndef ConformalNeuronBlocks_h
#define ConformalNeuronBlocks_h

#include "Base/Types.h"
#include "Search/BoxTree.h" // for Box

#include <vector>

namespace conformal
{
/// Neurons in blocks that are compact on the sphere. Several blocks form a group. Every block and
/// group has a fixed ball that contains its network positions n_i, and a box that contains its
/// current weights w_i.
class NeuronBlocks
{
public:
  /// @param[in] network  #N by 3 unit vectors n_i
  /// @param[in] weights  #N by 3, initial weights w_i
  NeuronBlocks(const Points& network, const Points& weights);

  /// Find the winner: the neuron whose weight vector is closest to x (step 3 of \cite Liou2008). If
  /// several are equally close, the lowest id is returned.
  int findWinner(const Vector3& x) const;

  /// Apply Eq. 3, \cite Liou2008, to all neurons: w_i += learningRate exp(-|r - n_i|^2 / (2
  /// radius^2)) (x - w_i). Neurons farther from r than Reach times the radius are not moved. For
  /// other neurons, the factor of x - w_i has a relative error of at most 1e-4.
  void update(const Vector3& x, const Vector3& r, double learningRate, double radius);

  Vector3 weight(int neuron) const;
  Points weights() const; ///< #N by 3

  static constexpr float Reach = 4.0F;
  static constexpr int BlockSize = 48; ///< chosen by measurement: 32 and 64 are slightly slower
  static constexpr int GroupSize = 8;

private:
  struct Block
  {
    // Positions are stored coordinate by coordinate, for vectorization. Single precision is
    // sufficient for distances on the sphere, which are used in a Gaussian only. Weights accumulate
    // small steps and need doubles.
    alignas(64) float Network[3][BlockSize];
    alignas(64) double Weights[3][BlockSize];
    int Ids[BlockSize];
  };
  struct Surroundings
  {
    Vector3 Center = Vector3::Zero(); ///< center of the ball around the network positions
    double Radius = 0.0;
    Box Weights;
  };

  static void moveBlock(
    Block& block, const double* x, const float* r, float learningRate, float factor, Box& box);
  void encloseGroup(std::size_t group);

  std::vector<Block> Blocks;
  std::vector<Surroundings> BlockBounds, GroupBounds;
  std::vector<int> PlaceOf; ///< position of each neuron: block * BlockSize + lane
};
}

#endif

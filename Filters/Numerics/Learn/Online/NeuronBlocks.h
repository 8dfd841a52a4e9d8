/// Neurons in spatial blocks, so that the winner of a sample is found and its neighborhood
/// moved without visiting the rest.
/// Own construction: exact, unlike approximate searches for the winner.

#ifndef ConformalNeuronBlocks_h
#define ConformalNeuronBlocks_h

#include "Base/Types.h"
#include "Search/BoxTree.h" // for Box

#include <vector>

namespace conformal
{
/// Neurons in blocks that are compact on the sphere, blocks in groups. Every block and group keeps
/// a ball around its network positions n_i, which never changes, and a box around its weights w_i,
/// which follows them.
class NeuronBlocks
{
public:
  /// @param[in] network  #N by 3 unit vectors n_i
  /// @param[in] weights  #N by 3, w_i at the start
  NeuronBlocks(const Points& network, const Points& weights);

  /// The neuron whose weight vector is closest to x; of equals, the lowest id (step 3).
  int findWinner(const Vector3& x) const;

  /// Eq. 3:
  /// w_i += learningRate exp(-|r - n_i|^2 / (2 radius^2)) (x - w_i).
  /// Neurons farther than Reach radii from r have no share; the others' is right to 1e-4 relative.
  void update(const Vector3& x, const Vector3& r, double learningRate, double radius);

  Vector3 weight(int neuron) const;
  Points weights() const; ///< #N by 3

  static constexpr float Reach = 4.0F;
  static constexpr int BlockSize = 48; ///< measured: 32 and 64 are a little slower
  static constexpr int GroupSize = 8;

private:
  struct Block
  {
    // Coordinate by coordinate, as vector units like them. Single precision is enough for a
    // distance on the sphere that only a Gaussian looks at; weights add up small steps.
    alignas(64) float Network[3][BlockSize];
    alignas(64) double Weights[3][BlockSize];
    int Ids[BlockSize];
  };
  struct Surroundings
  {
    Vector3 Center = Vector3::Zero(); ///< of the ball around the network positions
    double Radius = 0.0;
    Box Weights;
  };

  static void moveBlock(
    Block& block, const double* x, const float* r, float learningRate, float factor, Box& box);
  void encloseGroup(std::size_t group);

  std::vector<Block> Blocks;
  std::vector<Surroundings> BlockBounds, GroupBounds;
  std::vector<int> PlaceOf; ///< of each neuron: block * BlockSize + lane
};
}

#endif

/// Store the neurons of a self-organizing map in blocks, for fast search and update. Each neuron
/// has a network position on the unit sphere, and a weight vector in space.
///
/// Own construction, not from a publication: each block of neurons has bounds in space and on the
/// sphere. A search for the neuron closest to a sample skips blocks whose bounds are farther away
/// than the closest neuron so far. The search is therefore fast, and still exact.

#ifndef ConformalNeuronBlocks_h
#define ConformalNeuronBlocks_h

#include "Base/Types.h"
#include "Search/BoxTree.h" // for Box

#include <vector>

namespace conformal
{
/// Neurons in blocks. The neurons of a block are close together on the sphere, and several blocks
/// form a group. For each block and each group, two bounds are stored:
/// - a ball that contains the network positions n_i, which do not change
/// - a box that contains the current weight vectors w_i
class NeuronBlocks
{
public:
  /// @param[in] network  #N by 3 unit vectors: network positions n_i
  /// @param[in] weights  #N by 3, initial weight vectors w_i
  /// @param[in] numberOfValues  number D of further dimensions of patterns and weight vectors. The
  ///   weight vectors begin with 0 in these dimensions.
  NeuronBlocks(const Points& network, const Points& weights, Index numberOfValues = 0);

  /// Find the winner (step 3 of \cite Liou2008): the neuron whose weight vector is closest to x, in
  /// all dimensions. If several weight vectors are equally close, the lowest id is returned.
  /// @param[in] values  D further values of the pattern; may be null if D is 0
  int findWinner(const Vector3& x, const double* values = nullptr) const;

  /// Move all neurons i by Eq. 3 of \cite Liou2008. Let alpha be the learning rate, and sigma the
  /// neighborhood radius. Then: w_i += alpha exp(-|r - n_i|^2 / (2 sigma^2)) (x - w_i).
  ///
  /// Neurons with |r - n_i| above Reach times sigma are not moved. The computed factors of x - w_i
  /// have relative errors of at most 1e-4.
  /// @param[in] x             pattern: a sample point
  /// @param[in] r             reference point of the pattern, a unit vector
  /// @param[in] learningRate  alpha
  /// @param[in] radius        sigma
  /// @param[in] values        D further values of the pattern; may be null if D is 0
  void update(const Vector3& x, const Vector3& r, double learningRate, double radius,
    const double* values = nullptr);

  /// Return the weight vector of a neuron in the first three dimensions.
  Vector3 weight(int neuron) const;
  /// Return all weight vectors in the first three dimensions, #N by 3.
  Points weights() const;
  /// Return the weight vector of a neuron in all 3 + D dimensions.
  Eigen::VectorXd fullWeight(int neuron) const;

  /// Distance on the sphere beyond which neurons are not moved, in units of the neighborhood
  /// radius.
  static constexpr float Reach = 4.0F;
  /// Number of neurons in a block. By measurement, 32 and 64 are slightly slower.
  static constexpr int BlockSize = 48;
  static constexpr int GroupSize = 8; ///< number of blocks in a group

private:
  struct Block
  {
    // Coordinates are stored one after the other, for vectorization. Network positions have single
    // precision, since they are only used for distances in a Gaussian. Weight vectors accumulate
    // small steps, so they have double precision.
    alignas(64) float Network[3][BlockSize];
    alignas(64) double Weights[3][BlockSize];
    int Ids[BlockSize];
  };
  struct Surroundings
  {
    Vector3 Center = Vector3::Zero(); ///< center of the ball around the network positions
    double Radius = 0.0;              ///< radius of this ball
    Box Weights;                      ///< box that contains the weight vectors
  };

  static void moveBlock(Block& block, const double* x, const float* r, float learningRate,
    float factor, Box& box, double* values, const double* targets, Index numberOfValues);
  /// Return the weights of a block in the further dimensions: BlockSize values of each dimension.
  const double* valuesOf(std::size_t block) const
  {
    return this->Values.data() + block * BlockSize * this->NumberOfValues;
  }
  void encloseGroup(std::size_t group);

  std::vector<Block> Blocks;
  std::vector<Surroundings> BlockBounds, GroupBounds;
  /// Weights in the further dimensions, for each block, dimension and neuron of the block. The
  /// boxes of Surroundings do not bound them: a distance in three dimensions is a lower bound of
  /// the distance in all dimensions, so that the search stays exact.
  std::vector<double> Values;
  Index NumberOfValues = 0;
  /// Position of each neuron: block * BlockSize + index within the block.
  std::vector<int> PlaceOf;
};
}

#endif

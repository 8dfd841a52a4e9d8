#include "Learn/Online/NeuronBlocks.h"

#include "Base/Lanes.h"
#include "Search/BoxTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace conformal
{
namespace
{
using Halves =
  float __attribute__((vector_size(16), aligned(4))); // one float for each element of Doubles
}

NeuronBlocks::NeuronBlocks(const Points& network, const Points& weights, Index numberOfValues)
  : NumberOfValues(numberOfValues)
{
  // The tree splits the neurons at medians, so that adjacent leaves contain neighbors on the
  // sphere.
  std::vector<Box> boxes(network.rows());
  for (Index i = 0; i < network.rows(); ++i)
  {
    boxes[i].extend(Vector3(network.row(i)));
  }
  const std::vector<int> order = buildBoxTree(boxes).Items;

  const std::size_t count = (order.size() + BlockSize - 1) / BlockSize;
  this->Blocks.resize(count);
  this->Values.assign(count * BlockSize * numberOfValues, 0.0);
  this->BlockBounds.resize(count);
  this->GroupBounds.resize((count + GroupSize - 1) / GroupSize);
  this->PlaceOf.resize(order.size());
  for (std::size_t b = 0; b < count; ++b)
  {
    Block& block = this->Blocks[b];
    Surroundings& bounds = this->BlockBounds[b];
    for (int lane = 0; lane < BlockSize; ++lane)
    {
      // The last block is padded with copies of its last neuron. The copies move like this neuron.
      const std::size_t place = std::min(b * BlockSize + lane, order.size() - 1);
      const int id = order[place];
      block.Ids[lane] = id;
      for (int c = 0; c < 3; ++c)
      {
        block.Network[c][lane] = static_cast<float>(network(id, c));
        block.Weights[c][lane] = weights(id, c);
      }
      bounds.Center += Vector3(network.row(id)) / BlockSize;
      bounds.Weights.extend(Vector3(weights.row(id)));
      this->PlaceOf[id] = static_cast<int>(place);
    }
    for (int id : block.Ids)
    {
      bounds.Radius = std::max(bounds.Radius, (Vector3(network.row(id)) - bounds.Center).norm());
    }
  }
  for (std::size_t g = 0; g < this->GroupBounds.size(); ++g)
  {
    Surroundings& bounds = this->GroupBounds[g];
    const std::size_t first = g * GroupSize, last = std::min(first + GroupSize, count);
    for (std::size_t b = first; b < last; ++b)
    {
      bounds.Center += this->BlockBounds[b].Center / static_cast<double>(last - first);
    }
    for (std::size_t b = first; b < last; ++b)
    {
      bounds.Radius = std::max(bounds.Radius,
        (this->BlockBounds[b].Center - bounds.Center).norm() + this->BlockBounds[b].Radius);
    }
    this->encloseGroup(g);
  }
}

void NeuronBlocks::encloseGroup(std::size_t g)
{
  Box box;
  const std::size_t first = g * GroupSize;
  for (std::size_t b = first; b < std::min(first + GroupSize, this->Blocks.size()); ++b)
  {
    box.extend(this->BlockBounds[b].Weights);
  }
  this->GroupBounds[g].Weights = box;
}

int NeuronBlocks::findWinner(const Vector3& x, const double* values) const
{
  // The closest group is searched first, so that most others are excluded by their distance.
  std::size_t start = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < this->GroupBounds.size(); ++g)
  {
    const double distance = this->GroupBounds[g].Weights.squareDistance(x);
    if (distance < minimum)
    {
      minimum = distance;
      start = g;
    }
  }
  int winner = std::numeric_limits<int>::max();
  double best = std::numeric_limits<double>::infinity();
  const auto scanBlock = [&](std::size_t b)
  {
    const Block& block = this->Blocks[b];
    double distances[BlockSize];
    for (int lane = 0; lane < BlockSize; ++lane)
    {
      const double dx = block.Weights[0][lane] - x[0], dy = block.Weights[1][lane] - x[1],
                   dz = block.Weights[2][lane] - x[2];
      distances[lane] = dx * dx + dy * dy + dz * dz;
    }
    const double* own = this->valuesOf(b);
    for (Index c = 0; c < this->NumberOfValues; ++c, own += BlockSize)
    {
      for (int lane = 0; lane < BlockSize; ++lane)
      {
        const double difference = own[lane] - values[c];
        distances[lane] += difference * difference;
      }
    }
    for (int lane = 0; lane < BlockSize; ++lane)
    {
      if (distances[lane] < best || (distances[lane] == best && block.Ids[lane] < winner))
      {
        best = distances[lane];
        winner = block.Ids[lane];
      }
    }
  };
  const auto scanGroup = [&](std::size_t g)
  {
    const std::size_t first = g * GroupSize,
                      last = std::min(first + GroupSize, this->Blocks.size());
    std::array<double, GroupSize> distances;
    std::size_t closest = first;
    for (std::size_t b = first; b < last; ++b)
    {
      distances[b - first] = this->BlockBounds[b].Weights.squareDistance(x);
      closest = distances[b - first] < distances[closest - first] ? b : closest;
    }
    for (std::size_t k = 0; k < last - first; ++k)
    {
      // Search the closest block first, then the other blocks in order.
      const std::size_t b = k == 0 ? closest : first + k - (first + k <= closest);
      if (distances[b - first] <= best)
      {
        scanBlock(b);
      }
    }
  };
  scanGroup(start);
  for (std::size_t g = 0; g < this->GroupBounds.size(); ++g)
  {
    if (g != start && this->GroupBounds[g].Weights.squareDistance(x) <= best)
    {
      scanGroup(g);
    }
  }
  return winner;
}

// The result has equal bits for vectors of any width: fused multiply-add is not enabled, and lanes
// do not interact.
// Compile clones only with GCC and the GNU C library. Clang 14 compiles them, but other files
// cannot link to them.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
__attribute__((target_clones("avx2", "default")))
#endif
void NeuronBlocks::moveBlock(Block& block,
  const double* x, const float* r, float learningRate, float factor, Box& box, double* values,
  const double* targets, Index numberOfValues)
{
  static_assert(BlockSize % FloatLanes == 0, "blocks are filled with whole vectors");
  constexpr float Cut = 0.5F * Reach * Reach;
  alignas(64) float shares[BlockSize];
  for (int lane = 0; lane < BlockSize; lane += FloatLanes)
  {
    const Floats dx = *reinterpret_cast<const Floats*>(block.Network[0] + lane) - r[0];
    const Floats dy = *reinterpret_cast<const Floats*>(block.Network[1] + lane) - r[1];
    const Floats dz = *reinterpret_cast<const Floats*>(block.Network[2] + lane) - r[2];
    const Floats u = (dx * dx + dy * dy + dz * dz) * factor;

    // Compute exp(-u) with a relative error of 1e-5: evaluate a Taylor series of exp(-u / 32), and
    // square the result five times. Values of u beyond the cut are clamped, and their results are
    // set to 0. This avoids branches.
    const Floats cut = Floats{} + Cut;
    const Floats v = (u < cut ? u : cut) * (-1.0F / 32);
    Floats e = 1.0F / 6 + v * (1.0F / 24 + v * (1.0F / 120 + v * (1.0F / 720)));
    e = 1.0F + v * (1.0F + v * (0.5F + v * e));
    e *= e;
    e *= e;
    e *= e;
    e *= e;
    e *= e;
    *reinterpret_cast<Floats*>(shares + lane) = (u <= cut ? e : Floats{}) * learningRate;
  }
  for (int c = 0; c < 3; ++c)
  {
    Doubles low = Doubles{} + std::numeric_limits<double>::infinity(), high = -low;
    for (int lane = 0; lane < BlockSize; lane += DoubleLanes)
    {
      const Doubles share =
        __builtin_convertvector(*reinterpret_cast<const Halves*>(shares + lane), Doubles);
      Doubles& weights = *reinterpret_cast<Doubles*>(block.Weights[c] + lane);
      weights += share * (x[c] - weights);
      low = weights < low ? weights : low;
      high = weights > high ? weights : high;
    }
    box.Lower[c] = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
    box.Upper[c] = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
  }
  for (Index c = 0; c < numberOfValues; ++c, values += BlockSize)
  {
    for (int lane = 0; lane < BlockSize; ++lane)
    {
      values[lane] += static_cast<double>(shares[lane]) * (targets[c] - values[lane]);
    }
  }
}

void NeuronBlocks::update(
  const Vector3& x, const Vector3& r, double learningRate, double radius, const double* values)
{
  const Eigen::Vector3f target = r.cast<float>();
  const float factor = static_cast<float>(0.5 / (radius * radius));
  const auto reaches = [&](const Surroundings& bounds)
  {
    const double reach = Reach * radius + bounds.Radius;
    return (bounds.Center - r).squaredNorm() <= reach * reach;
  };
  for (std::size_t g = 0; g < this->GroupBounds.size(); ++g)
  {
    if (!reaches(this->GroupBounds[g]))
    {
      continue;
    }
    const std::size_t first = g * GroupSize;
    for (std::size_t b = first; b < std::min(first + GroupSize, this->Blocks.size()); ++b)
    {
      if (reaches(this->BlockBounds[b]))
      {
        moveBlock(this->Blocks[b], x.data(), target.data(), static_cast<float>(learningRate),
          factor, this->BlockBounds[b].Weights,
          this->Values.data() + b * BlockSize * this->NumberOfValues, values, this->NumberOfValues);
      }
    }
    this->encloseGroup(g);
  }
}

Vector3 NeuronBlocks::weight(int neuron) const
{
  const int place = this->PlaceOf[neuron];
  const Block& block = this->Blocks[place / BlockSize];
  const int lane = place % BlockSize;
  return Vector3(block.Weights[0][lane], block.Weights[1][lane], block.Weights[2][lane]);
}

Eigen::VectorXd NeuronBlocks::fullWeight(int neuron) const
{
  const int place = this->PlaceOf[neuron];
  const double* values = this->valuesOf(place / BlockSize) + place % BlockSize;
  Eigen::VectorXd weight(3 + this->NumberOfValues);
  weight.head<3>() = this->weight(neuron);
  for (Index c = 0; c < this->NumberOfValues; ++c)
  {
    weight[3 + c] = values[c * BlockSize];
  }
  return weight;
}

Points NeuronBlocks::weights() const
{
  Points all(static_cast<Index>(this->PlaceOf.size()), 3);
  for (Index i = 0; i < all.rows(); ++i)
  {
    all.row(i) = this->weight(static_cast<int>(i));
  }
  return all;
}
}

/// Combine data of all ranks (MPI processes): concatenation, minimum, maximum and sums in rank
/// order. All communication consists of sums of integers over all ranks, see Reduce.

#ifndef ConformalAcrossProcesses_h
#define ConformalAcrossProcesses_h

#include "Base/Reduce.h"
#include "Base/Types.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace conformal
{
/// Concatenate the rows of all ranks in rank order, on every rank.
/// @param[in] own  rows of this rank. The number of rows can differ between ranks. Rows are sent as
///   doubles. Doubles represent integers exactly up to a magnitude of 2^53.
template <typename Matrix>
Matrix gatherRows(const Reduce& reduce, const Matrix& own)
{
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Matrix::ColsAtCompileTime, Eigen::RowMajor>;
  if (reduce.NumberOfRanks == 1)
  {
    return own;
  }
  std::vector<double> numbers(static_cast<std::size_t>(own.size()));
  Eigen::Map<Rows>(numbers.data(), own.rows(), own.cols()) = own.template cast<double>();
  const std::vector<double> all = gather(reduce, numbers);
  return Eigen::Map<const Rows>(
    all.data(), static_cast<Index>(all.size()) / Matrix::ColsAtCompileTime, own.cols())
    .template cast<typename Matrix::Scalar>();
}

/// Concatenate the triangles of all ranks in rank order, on every rank. Vertex ids of the result
/// refer to the concatenated points of all ranks.
/// @param[in] own     triangles of this rank, with ids in [0, points)
/// @param[in] points  number of points of this rank
/// @throws std::invalid_argument if an int cannot hold the number of all points
inline Triangles gatherTriangles(const Reduce& reduce, Triangles own, Index points)
{
  const Index before = shareOf(reduce, points).Before;
  if (before + points > std::numeric_limits<int>::max())
  {
    throw std::invalid_argument("the processes together have more points than an int can count");
  }
  own.array() += static_cast<int>(before);
  return gatherRows(reduce, own);
}

/// Minimum of a number over all ranks, and the lowest rank on which the number has this value.
struct Minimum
{
  double Value = std::numeric_limits<double>::infinity();
  int Rank = 0;
};

/// Compute the element-wise minimum over all ranks.
/// @param[in] own  numbers of this rank; their count must be equal on all ranks
inline std::vector<Minimum> minimum(const Reduce& reduce, const std::vector<double>& own)
{
  const Index size = static_cast<Index>(own.size());
  std::vector<Minimum> result(size);
  // maximum number of values gathered from each rank at once, to limit memory
  constexpr Index ChunkSize = 1 << 16;
  for (Index first = 0; first < size; first += ChunkSize)
  {
    const Index count = std::min(ChunkSize, size - first);
    const std::vector<double> all =
      gather(reduce, { own.data() + first, own.data() + first + count });
    for (Index i = 0; i < static_cast<Index>(all.size()); ++i)
    {
      Minimum& best = result[first + i % count];
      if (all[i] < best.Value)
      {
        best = { all[i], static_cast<int>(i / count) };
      }
    }
  }
  return result;
}

/// Compute the element-wise maximum over all ranks.
/// @param[in] own  numbers of this rank; their count must be equal on all ranks
inline std::vector<double> maximum(const Reduce& reduce, const std::vector<double>& own)
{
  const std::vector<double> all = gather(reduce, own);
  std::vector<double> most = own;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    most[i % own.size()] = std::max(most[i % own.size()], all[i]);
  }
  return most;
}

/// Update an array on one rank after another, in rank order. Each rank continues from the values
/// that the previous rank computed. All ranks receive the values of the last rank. If `goOn` adds
/// numbers, the sums therefore have the same bits as in a single process. This function is slow,
/// since the array is sent once per rank.
/// @param[in,out] numbers  array of `count` values; equal on all ranks before the call, and again
///   after the call
/// @param[in] goOn         function that updates `numbers` with the data of this rank
inline void inTurn(
  const Reduce& reduce, double* numbers, Index count, const std::function<void()>& goOn)
{
  if (reduce.NumberOfRanks == 1 || count == 0) // nothing to send, and `numbers` may be null
  {
    goOn();
    return;
  }
  std::vector<std::int64_t> bits(count);
  for (int rank = 0; rank < reduce.NumberOfRanks; ++rank)
  {
    std::fill(bits.begin(), bits.end(), 0);
    if (rank == reduce.Rank)
    {
      goOn();
      std::memcpy(bits.data(), numbers, count * sizeof(double));
    }
    reduce.sum(bits.data(), count);
    std::memcpy(numbers, bits.data(), count * sizeof(double));
  }
}
}

#endif

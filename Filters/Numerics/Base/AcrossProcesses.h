/// Exchange of data between processes, as sums over all of them.

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
/// The rows of all processes one after the other, in the order of their ranks, on each of them.
/// Whole numbers must be exact as doubles.
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

/// The triangles of all processes, over the points of all, likewise.
/// @param[in] own     ids in [0, points)
/// @param[in] points  of this process
/// @throws std::invalid_argument if ids do not fit into an int
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

/// The least of a number that each process has, and the first process that has it.
struct Minimum
{
  double Value = std::numeric_limits<double>::infinity();
  int Rank = 0;
};

/// Of each of the numbers, as many on all processes.
inline std::vector<Minimum> minimum(const Reduce& reduce, const std::vector<double>& own)
{
  const Index size = static_cast<Index>(own.size());
  std::vector<Minimum> result(size);
  constexpr Index ChunkSize = 1 << 16; // all of it from all processes would be much
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

/// Of each number the largest over all processes.
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

/// Processes go on with numbers one after the other, in the order of their ranks, each from where
/// the one before it has left them; all end with those of the last. So sums of floating-point
/// numbers come out as if one process had added all of them, to the bit. Takes its time: the
/// numbers are sent once for each process.
/// @param[in,out] numbers  the same on all processes
inline void inTurn(
  const Reduce& reduce, double* numbers, Index count, const std::function<void()>& goOn)
{
  if (reduce.NumberOfRanks == 1)
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

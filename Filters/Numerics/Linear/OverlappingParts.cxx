#include "Linear/OverlappingParts.h"

#include "Base/AllColumns.h"

#include <algorithm>
#include <numeric>

namespace conformal
{
namespace
{
/// Divide the ids in [begin, end) into cores, and append them to the parts.
void addCores(const Points& places, int* begin, int* end, Index maximumSize,
  std::vector<OverlappingPart>& parts)
{
  if (end - begin <= maximumSize)
  {
    OverlappingPart part;
    part.Ids.assign(begin, end);
    std::sort(part.Ids.begin(), part.Ids.end());
    part.CoreSize = end - begin;
    parts.push_back(std::move(part));
    return;
  }
  Eigen::RowVector3d low = places.row(*begin), high = low;
  for (const int* id = begin; id != end; ++id)
  {
    low = low.cwiseMin(places.row(*id));
    high = high.cwiseMax(places.row(*id));
  }
  Index axis = 0;
  (high - low).maxCoeff(&axis);
  int* const middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end,
    [&](int a, int b)
    {
      const double x = places(a, axis), y = places(b, axis);
      return x != y ? x < y : a < b;
    });
  addCores(places, begin, middle, maximumSize, parts);
  addCores(places, middle, end, maximumSize, parts);
}
}

//------------------------------------------------------------------------------
Columns OverlappingPart::rowsOf(const Columns& whole) const
{
  return whole(this->Ids, AllColumns);
}

//------------------------------------------------------------------------------
SparseMatrix OverlappingPart::principalPart(const SparseMatrix& whole) const
{
  const auto size = static_cast<Index>(this->Ids.size());
  if (size == 0)
  {
    return SparseMatrix(0, 0);
  }
  // Ids of a part are often in a small range of all ids.
  const auto [first, last] = std::minmax_element(this->Ids.begin(), this->Ids.end());
  const int lowest = *first, end = *last - lowest + 1;
  std::vector<int> own(end, -1);
  for (int i = 0; i < size; ++i)
  {
    own[this->Ids[i] - lowest] = i;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < size; ++column)
  {
    for (SparseMatrix::InnerIterator entry(whole, this->Ids[column]); entry; ++entry)
    {
      const auto place = static_cast<int>(entry.row()) - lowest;
      if (place >= 0 && place < end && own[place] >= 0)
      {
        entries.emplace_back(own[place], column, entry.value());
      }
    }
  }
  SparseMatrix part(size, size);
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

//------------------------------------------------------------------------------
std::vector<OverlappingPart> overlappingParts(
  const Points& places, const Adjacency& neighbors, Index maximumSize, int rings)
{
  std::vector<int> ids(places.rows());
  std::iota(ids.begin(), ids.end(), 0);
  std::vector<OverlappingPart> parts;
  addCores(places, ids.data(), ids.data() + ids.size(), maximumSize, parts);
  std::vector<int> seenBy(ids.size(), -1);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    std::vector<int>& own = parts[p].Ids;
    const int stamp = static_cast<int>(p);
    for (const int id : own)
    {
      seenBy[id] = stamp;
    }
    std::size_t begin = 0;
    for (int ring = 0; ring < rings; ++ring)
    {
      const std::size_t end = own.size();
      for (; begin < end; ++begin)
      {
        const int id = own[begin];
        for (const int* other = neighbors.begin(id); other != neighbors.end(id); ++other)
        {
          if (seenBy[*other] != stamp)
          {
            seenBy[*other] = stamp;
            own.push_back(*other);
          }
        }
      }
    }
    std::sort(own.begin() + parts[p].CoreSize, own.end());
  }
  return parts;
}
}

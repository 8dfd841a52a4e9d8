#include "Linear/OverlappingParts.h"

#include "Base/AllColumns.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using conformal::Columns;
using conformal::Index;
using conformal::OverlappingPart;
using conformal::SparseMatrix;

namespace
{
// Identity plus a multiple of the graph Laplacian.
SparseMatrix smoothing(const conformal::Adjacency& neighbors, Index size, double weight)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i)
  {
    entries.emplace_back(i, i, 1.0 + weight * static_cast<double>(neighbors.size(i)));
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      entries.emplace_back(i, *j, -weight);
    }
  }
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
}

class OverlappingParts : public ::testing::Test
{
protected:
  const conformal::Mesh Sphere = conformal::makeGeodesicSphere(16);
  const Index Size = Sphere.Positions.rows();
  const conformal::Adjacency Neighbors = conformal::vertexNeighbors(Sphere.Triangles, Size);

  Columns solved(const SparseMatrix& matrix, const Columns& right, Index maximum, int rings) const
  {
    Columns result = Columns::Zero(this->Size, right.cols());
    for (const OverlappingPart& part :
      conformal::overlappingParts(this->Sphere.Positions, this->Neighbors, maximum, rings))
    {
      Columns some = part.rowsOf(right);
      conformal::factorize(
        part.principalPart(matrix), this->Sphere.Positions(part.Ids, conformal::AllColumns), 1)
        .solve(some);
      part.copyCore(some, result);
    }
    return result;
  }
};

// The cores are small and have each unknown once. The overlap consists of the wanted rings.
TEST_F(OverlappingParts, HaveEachUnknownInOneCore)
{
  std::vector<int> visits(this->Size, 0);
  for (const OverlappingPart& part :
    conformal::overlappingParts(this->Sphere.Positions, this->Neighbors, 300, 1))
  {
    EXPECT_LE(part.CoreSize, 300);
    EXPECT_FALSE(part.isWhole());
    std::vector<int> within(this->Size, 0);
    for (std::size_t i = 0; i < part.Ids.size(); ++i)
    {
      within[part.Ids[i]] += 1;
      visits[part.Ids[i]] += static_cast<Index>(i) < part.CoreSize ? 1 : 0;
    }
    for (Index i = 0; i < part.CoreSize; ++i)
    {
      const int id = part.Ids[i];
      for (const int* j = this->Neighbors.begin(id); j != this->Neighbors.end(id); ++j)
      {
        EXPECT_EQ(within[*j], 1);
      }
    }
  }
  EXPECT_EQ(visits, std::vector<int>(this->Size, 1));
}

TEST_F(OverlappingParts, OfFewUnknownsAreTheWhole)
{
  const auto parts =
    conformal::overlappingParts(this->Sphere.Positions, this->Neighbors, this->Size, 3);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].isWhole());
  const SparseMatrix matrix = smoothing(this->Neighbors, this->Size, 1.0);
  EXPECT_EQ((parts[0].principalPart(matrix) - matrix).norm(), 0.0);
}

// The error decreases by a constant factor from ring to ring, and without an overlap it is large.
TEST_F(OverlappingParts, SolveLocalEquationsLikeTheWhole)
{
  const SparseMatrix matrix = smoothing(this->Neighbors, this->Size, 0.5);
  Columns right(this->Size, 2);
  for (Index i = 0; i < this->Size; ++i)
  {
    right.row(i) << std::sin(0.7 * static_cast<double>(i)), this->Sphere.Positions(i, 0);
  }
  const Columns exact = this->solved(matrix, right, this->Size, 0);
  EXPECT_LT((matrix * exact - right).norm(), 1e-10 * right.norm());
  const auto error = [&](int rings)
  { return (this->solved(matrix, right, 700, rings) - exact).cwiseAbs().maxCoeff(); };
  EXPECT_GT(error(0), 0.05);
  EXPECT_LT(error(4), 0.05 * error(0));
  EXPECT_LT(error(12), 1e-4 * error(0));
}

#include "Linear/MultifrontalCholesky.h"

#include "Base/NumericalFailure.h"
#include "Base/Random.h"
#include "Linear/NestedDissection.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <vector>

using conformal::Columns;
using conformal::EdgeWeights;
using conformal::Index;
using conformal::MultifrontalCholesky;

namespace
{
struct Membrane
{
  EdgeWeights Weights;
  std::vector<double> Diagonal;
  conformal::Points Places;
};

// Strings of many strengths, each vertex also held a little.
Membrane membrane(int frequency)
{
  const auto sphere = conformal::makeGeodesicSphere(frequency);
  Membrane result = { conformal::equalWeights(sphere.Triangles, sphere.Positions.rows()), {},
    sphere.Positions };
  conformal::Random random(1);
  EdgeWeights& weights = result.Weights;
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    for (const int* other = weights.Neighbors.begin(v); other != weights.Neighbors.end(v); ++other)
    {
      if (*other > v)
      {
        const double weight = 0.1 + random.uniform();
        weights.Weights[other - weights.Neighbors.Ids.data()] = weight;
        const int* back = std::lower_bound(
          weights.Neighbors.begin(*other), weights.Neighbors.end(*other), static_cast<int>(v));
        weights.Weights[back - weights.Neighbors.Ids.data()] = weight;
      }
    }
  }
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    result.Diagonal.push_back(weights.sumAt(v) + 0.01);
  }
  return result;
}

Columns solved(const Membrane& of, const conformal::Run& run = {})
{
  Columns columns = of.Places.leftCols<2>();
  MultifrontalCholesky(of.Weights, of.Diagonal, of.Places, run).solve(columns);
  return columns;
}

}

TEST(MultifrontalCholesky, AgreesWithAnotherFactorization)
{
  for (int frequency : { 1, 2, 7, 40 })
  {
    const Membrane of = membrane(frequency);
    std::vector<Eigen::Triplet<double>> entries;
    for (Index v = 0; v < of.Places.rows(); ++v)
    {
      entries.emplace_back(v, v, of.Diagonal[v]);
      for (int i = of.Weights.Neighbors.Offsets[v]; i < of.Weights.Neighbors.Offsets[v + 1]; ++i)
      {
        entries.emplace_back(v, of.Weights.Neighbors.Ids[i], -of.Weights.Weights[i]);
      }
    }
    Eigen::SparseMatrix<double> matrix(of.Places.rows(), of.Places.rows());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Columns expected = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(
      Columns(of.Places.leftCols<2>()));
    EXPECT_LT((solved(of) - expected).norm(), 1e-11 * expected.norm()) << frequency;
  }
}

TEST(MultifrontalCholesky, SameBitsOnTwoThreads)
{
  const Membrane of = membrane(90); // large fronts, too
  EXPECT_EQ(solved(of), solved(of, runs::backwards()));
}

TEST(MultifrontalCholesky, RefusesWhatIsNotPositiveDefinite)
{
  Membrane of = membrane(5);
  of.Diagonal[7] = -1.0;
  EXPECT_THROW(solved(of), conformal::NumericalFailure);
}

// A graph that no cut makes smaller.
TEST(MultifrontalCholesky, RefusesWhatWouldFillUp)
{
  Membrane of;
  const int size = 3000;
  conformal::Random random(1);
  std::vector<std::vector<int>> neighbors(size);
  for (int i = 0; i < 10 * size; ++i)
  {
    const auto a = static_cast<int>(random.index(size)), b = static_cast<int>(random.index(size));
    if (a != b && std::count(neighbors[a].begin(), neighbors[a].end(), b) == 0)
    {
      neighbors[a].push_back(b);
      neighbors[b].push_back(a);
    }
  }
  of.Weights.Neighbors.Offsets = { 0 };
  for (const auto& ids : neighbors)
  {
    of.Weights.Neighbors.Ids.insert(of.Weights.Neighbors.Ids.end(), ids.begin(), ids.end());
    of.Weights.Neighbors.Offsets.push_back(static_cast<int>(of.Weights.Neighbors.Ids.size()));
  }
  of.Weights.Weights.assign(of.Weights.Neighbors.Ids.size(), 1.0);
  of.Diagonal.assign(size, 100.0);
  of.Places = conformal::Points::Random(size, 3);
  EXPECT_THROW(solved(of), conformal::NumericalFailure);
}

TEST(MultifrontalCholesky, DissectsPiecesThatAreNotConnected)
{
  const auto sphere = conformal::makeGeodesicSphere(10);
  const Index size = sphere.Positions.rows(), count = sphere.Triangles.rows();
  conformal::Points places(2 * size, 3);
  conformal::Triangles triangles(2 * count, 3);
  places << sphere.Positions, sphere.Positions;
  places.bottomRows(size).col(0).array() += 5.0;
  triangles << sphere.Triangles, (sphere.Triangles.array() + static_cast<int>(size)).matrix();
  const auto neighbors = conformal::equalWeights(triangles, 2 * size).Neighbors;
  for (const auto& part : conformal::dissect(neighbors, places).Parts)
  {
    EXPECT_LT(part.End - part.Begin, size / 10);
  }
}

// A grid of 12 columns that are far apart, and 200 rows. The fewest unknowns are across the rows.
TEST(MultifrontalCholesky, CutsWhereTheFewestUnknownsAre)
{
  const int columns = 12, rows = 200;
  conformal::Points places(columns * rows, 3);
  conformal::Adjacency neighbors;
  neighbors.Offsets = { 0 };
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      places.row(j * columns + i) << 100.0 * i, j, 0.0;
      for (const auto& [x, y] :
        { std::pair(i - 1, j), std::pair(i + 1, j), std::pair(i, j - 1), std::pair(i, j + 1) })
      {
        if (x >= 0 && x < columns && y >= 0 && y < rows)
        {
          neighbors.Ids.push_back(y * columns + x);
        }
      }
      neighbors.Offsets.push_back(static_cast<int>(neighbors.Ids.size()));
    }
  }
  const auto largest = [&](conformal::CutAxes axes)
  {
    int size = 0;
    for (const auto& part : conformal::dissect(neighbors, places, axes).Parts)
    {
      size = std::max(size, part.Children.empty() ? 0 : part.End - part.Begin);
    }
    return size;
  };
  EXPECT_EQ(largest(conformal::CutAxes::LongestSide), rows);
  EXPECT_EQ(largest(conformal::CutAxes::FewestUnknowns), columns);
}

TEST(MultifrontalCholesky, PartsAreKeptApart)
{
  const auto sphere = conformal::makeGeodesicSphere(30);
  const auto neighbors = conformal::vertexNeighbors(sphere.Triangles, sphere.Positions.rows());
  const auto order = conformal::dissect(neighbors, sphere.Positions);
  ASSERT_GT(order.Parts.size(), 100u);
  // The part that each unknown lies in, and the parts above that.
  std::vector<int> parents(order.Parts.size(), -1), partOf(order.Order.size(), -1);
  for (std::size_t part = 0; part < order.Parts.size(); ++part)
  {
    for (int child : order.Parts[part].Children)
    {
      parents[child] = static_cast<int>(part);
    }
    for (int place = order.Parts[part].Begin; place < order.Parts[part].End; ++place)
    {
      EXPECT_EQ(order.Positions[order.Order[place]], place);
      partOf[order.Order[place]] = static_cast<int>(part);
    }
  }
  EXPECT_EQ(std::count(partOf.begin(), partOf.end(), -1), 0);
  const auto isAbove = [&](int upper, int lower)
  {
    while (lower >= 0 && lower != upper)
    {
      lower = parents[lower];
    }
    return lower == upper;
  };
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    for (const int* other = neighbors.begin(v); other != neighbors.end(v); ++other)
    {
      EXPECT_TRUE(isAbove(partOf[v], partOf[*other]) || isAbove(partOf[*other], partOf[v]));
    }
  }
}

TEST(MultifrontalCholesky, ReportsProgressAndStops)
{
  const Membrane of = membrane(40);
  runs::Watch watch;
  const MultifrontalCholesky factor(of.Weights, of.Diagonal, of.Places, watch.run());
  EXPECT_GT(watch.calls(), 10);
  EXPECT_THROW(MultifrontalCholesky(of.Weights, of.Diagonal, of.Places, runs::stoppingAt(0.5)),
    conformal::Aborted);
}

#include "Linear/MultifrontalCholesky.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr Index PanelSize = 96;
// Number of rows above which fronts are factored one after another, each on all threads
constexpr Index LargeFront = 500;
// Number of multiplications below which any elimination order is used
constexpr double LargeWork = 1e8;
}

//------------------------------------------------------------------------------
MultifrontalCholesky::MultifrontalCholesky(const EdgeWeights& weights,
  const std::vector<double>& diagonal, const Points& places, const Run& run, int rings)
{
  const double size = static_cast<double>(places.rows());
  Steps steps(run, { 0.06, 0.03, 0.91 }); // dissection, boundaries, elimination
  steps.next();
  // The dissection of a surface needs about 15 n^1.5 multiplications. The width of its separators
  // is the number of rings.
  const double scale = rings * rings * rings * size * std::sqrt(size);
  double total = this->dissect(weights.Neighbors, places, CutAxes::LongestSide);
  if (total > LargeWork + 60.0 * scale)
  {
    const double before = total;
    total = this->dissect(weights.Neighbors, places, CutAxes::FewestUnknowns);
    if (total > before)
    {
      total = this->dissect(weights.Neighbors, places, CutAxes::LongestSide);
    }
  }
  steps.next();
  if (total > LargeWork + 300.0 * scale)
  {
    throw NumericalFailure("the surface cannot be cut into small parts");
  }
  std::vector<std::vector<std::size_t>> levels;
  for (std::size_t part = 0; part < this->Fronts.size(); ++part)
  {
    const std::size_t level = this->Dissection.Parts[part].Level;
    levels.resize(std::max(levels.size(), level + 1));
    levels[level].push_back(part);
  }
  const Run eliminating = steps.next();
  double done = 0.0;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
  {
    std::vector<std::size_t> small;
    for (std::size_t part : *level)
    {
      const bool large = this->Fronts[part].Factor.rows() >= LargeFront;
      if (!large)
      {
        small.push_back(part);
        continue;
      }
      this->assemble(part, weights, diagonal);
      const double share = this->work(part);
      this->eliminate(part, eliminating.part(done / total, (done + share) / total));
      done += share;
    }
    double share = 0.0;
    for (std::size_t part : small)
    {
      share += this->work(part);
    }
    forBlocksReporting(eliminating.part(done / total, (done + share) / total),
      static_cast<Index>(small.size()), 1,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          this->assemble(small[i], weights, diagonal);
          this->eliminate(small[i], {});
        }
      });
    done += share;
  }
}

//------------------------------------------------------------------------------
// Compute the elimination order and the boundaries of its parts. Return the number of
// multiplications.
double MultifrontalCholesky::dissect(const Adjacency& graph, const Points& places, CutAxes axes)
{
  this->Dissection = conformal::dissect(graph, places, axes);
  this->Fronts.assign(this->Dissection.Parts.size(), {});
  this->findBoundaries(graph);
  double total = 0.0;
  for (std::size_t part = 0; part < this->Fronts.size(); ++part)
  {
    total += this->work(part);
  }
  return total;
}

//------------------------------------------------------------------------------
void MultifrontalCholesky::findBoundaries(const Adjacency& graph)
{
  std::vector<std::size_t> seenBy(this->Dissection.Order.size(), this->Fronts.size());
  for (std::size_t part = 0; part < this->Fronts.size(); ++part)
  {
    const NestedDissection::Part& own = this->Dissection.Parts[part];
    std::vector<int>& boundary = this->Fronts[part].Boundary;
    const auto see = [&](int place)
    {
      if (place >= own.End && seenBy[place] != part)
      {
        seenBy[place] = part;
        boundary.push_back(place);
      }
    };
    for (int place = own.Begin; place < own.End; ++place)
    {
      const int id = this->Dissection.Order[place];
      for (const int* other = graph.begin(id); other != graph.end(id); ++other)
      {
        see(this->Dissection.Positions[*other]);
      }
    }
    for (int child : own.Children)
    {
      for (int place : this->Fronts[child].Boundary)
      {
        see(place);
      }
    }
    std::sort(boundary.begin(), boundary.end());
  }
}

//------------------------------------------------------------------------------
// Estimate the number of multiplications.
double MultifrontalCholesky::work(std::size_t part) const
{
  const NestedDissection::Part& own = this->Dissection.Parts[part];
  const double size = own.End - own.Begin;
  const double rows = size + static_cast<double>(this->Fronts[part].Boundary.size());
  return 0.5 * size * rows * rows + 1000.0;
}

//------------------------------------------------------------------------------
void MultifrontalCholesky::assemble(
  std::size_t part, const EdgeWeights& weights, const std::vector<double>& diagonal)
{
  const NestedDissection::Part& own = this->Dissection.Parts[part];
  Front& front = this->Fronts[part];
  const int size = own.End - own.Begin;
  const int rest = static_cast<int>(front.Boundary.size());
  front.Factor.setZero(size + rest, size);
  front.Update.setZero(rest, rest);
  const auto rowOf = [&](int place)
  {
    return place < own.End ? place - own.Begin
                           : size +
        static_cast<int>(std::lower_bound(front.Boundary.begin(), front.Boundary.end(), place) -
          front.Boundary.begin());
  };
  for (int place = own.Begin; place < own.End; ++place)
  {
    const int id = this->Dissection.Order[place], column = place - own.Begin;
    front.Factor(column, column) = diagonal[id];
    for (int i = weights.Neighbors.Offsets[id]; i < weights.Neighbors.Offsets[id + 1]; ++i)
    {
      const int other = this->Dissection.Positions[weights.Neighbors.Ids[i]];
      if (other > place)
      {
        front.Factor(rowOf(other), column) -= weights.Weights[i];
      }
    }
  }
  std::vector<int> rows;
  for (int child : own.Children)
  {
    Front& from = this->Fronts[child];
    rows.clear();
    for (int place : from.Boundary)
    {
      rows.push_back(rowOf(place));
    }
    for (std::size_t j = 0; j < rows.size(); ++j)
    {
      const auto column = from.Update.col(static_cast<Index>(j));
      const bool inUpdate = rows[j] >= size;
      const int first = inUpdate ? size : 0;
      double* target = (inUpdate ? front.Update : front.Factor).col(rows[j] - first).data();
      for (std::size_t i = j; i < rows.size(); ++i)
      {
        target[rows[i] - first] += column[static_cast<Index>(i)];
      }
    }
    from.Update.resize(0, 0);
  }
}

//------------------------------------------------------------------------------
void MultifrontalCholesky::eliminate(std::size_t part, const Run& run)
{
  Columns& factor = this->Fronts[part].Factor;
  Columns& update = this->Fronts[part].Update;
  const Index rows = factor.rows(), size = factor.cols();
  for (Index begin = 0; begin < size; begin += PanelSize)
  {
    const Index width = std::min(PanelSize, size - begin), end = begin + width;
    auto corner = factor.block(begin, begin, width, width);
    Eigen::LLT<Eigen::Ref<Columns>> llt(corner);
    if (llt.info() != Eigen::Success)
    {
      throw NumericalFailure("the matrix is not positive definite");
    }
    const auto lower = corner.triangularView<Eigen::Lower>();
    // Process a block of rows, then a block of columns, each on one thread.
    forBlocks(run, rows - end, 2 * PanelSize,
      [&](Index from, Index to)
      {
        auto block = factor.block(end + from, begin, to - from, width);
        lower.transpose().solveInPlace<Eigen::OnTheRight>(block);
      });
    const auto panel = factor.middleCols(begin, width);
    forBlocks(run, rows - end, PanelSize,
      [&](Index from, Index to)
      {
        for (const bool inUpdate : { false, true }) // columns of the part, then of its boundary
        {
          const Index first = inUpdate ? std::max(end + from, size) : end + from;
          const Index last = inUpdate ? end + to : std::min(end + to, size);
          if (first >= last)
          {
            continue;
          }
          const Index count = last - first;
          const auto some = panel.middleRows(first, count).transpose();
          Columns& target = inUpdate ? update : factor;
          const Index row = inUpdate ? first - size : first, column = row;
          target.block(row, column, rows - first, count).noalias() -=
            panel.bottomRows(rows - first) * some;
        }
      });
    run.report(static_cast<double>(end) / static_cast<double>(size));
  }
}

//------------------------------------------------------------------------------
void MultifrontalCholesky::solve(Columns& columns) const
{
  Columns x(columns.rows(), columns.cols());
  for (Index i = 0; i < x.rows(); ++i)
  {
    x.row(i) = columns.row(this->Dissection.Order[i]);
  }
  Columns rest;
  for (std::size_t part = 0; part < this->Fronts.size(); ++part)
  {
    const Front& front = this->Fronts[part];
    const Index size = front.Factor.cols(), boundary = front.Factor.rows() - size;
    auto own = x.middleRows(this->Dissection.Parts[part].Begin, size);
    front.Factor.topRows(size).triangularView<Eigen::Lower>().solveInPlace(own);
    rest.noalias() = front.Factor.bottomRows(boundary) * own;
    for (Index i = 0; i < boundary; ++i)
    {
      x.row(front.Boundary[i]) -= rest.row(i);
    }
  }
  for (std::size_t part = this->Fronts.size(); part-- > 0;)
  {
    const Front& front = this->Fronts[part];
    const Index size = front.Factor.cols(), boundary = front.Factor.rows() - size;
    rest.resize(boundary, x.cols());
    for (Index i = 0; i < boundary; ++i)
    {
      rest.row(i) = x.row(front.Boundary[i]);
    }
    auto own = x.middleRows(this->Dissection.Parts[part].Begin, size);
    own.noalias() -= front.Factor.bottomRows(boundary).transpose() * rest;
    front.Factor.topRows(size).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
  for (Index i = 0; i < x.rows(); ++i)
  {
    columns.row(this->Dissection.Order[i]) = x.row(i);
  }
}
}

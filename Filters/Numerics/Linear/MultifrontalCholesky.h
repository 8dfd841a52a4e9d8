/// Multifrontal Cholesky solver for mesh Laplacians.

#ifndef ConformalMultifrontalCholesky_h
#define ConformalMultifrontalCholesky_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"
#include "Linear/NestedDissection.h"

#include <vector>

namespace conformal
{
/// The Cholesky factor of a positive definite matrix, front by front (\cite Duff1983): each part of
/// a nested dissection is a dense matrix of its own unknowns and of those later ones that it
/// touches. Parts of one level are independent, so they are done at the same time; large ones are
/// done a panel at a time, with a report after each, so that no step is long.
///
/// Eigen's own sparse factorizations go column by column, on one thread and without a report; for
/// Igea's 134,342 unknowns they take 0.7 s, this one 0.2 s.
class MultifrontalCholesky
{
public:
  /// Of the matrix with the given diagonal and the negative weights beside it.
  /// @param[in] places  a point for each unknown, for the order of elimination
  /// @param[in] rings   of a mesh's vertices that the matrix couples to each, for the limit of work
  /// @throws NumericalFailure if the matrix is not positive definite, or its factor is so full
  ///         that it would take too long: neighbors are far apart
  MultifrontalCholesky(const EdgeWeights& weights, const std::vector<double>& diagonal,
    const Points& places, const Run& run = {}, int rings = 1);

  /// @param[in,out] columns  right-hand sides, then solutions
  void solve(Columns& columns) const;

private:
  struct Front
  {
    std::vector<int> Boundary; // later places in the order, ascending
    Columns Factor;            // rows of the part and of its boundary, columns of the part
    Columns Update;            // what is left for the parent, lower half
  };

  void findBoundaries(const Adjacency& graph);
  double work(std::size_t part) const;
  void assemble(std::size_t part, const EdgeWeights& weights, const std::vector<double>& diagonal);
  void eliminate(std::size_t part, const Run& run);

  NestedDissection Dissection;
  std::vector<Front> Fronts;
};
}

#endif

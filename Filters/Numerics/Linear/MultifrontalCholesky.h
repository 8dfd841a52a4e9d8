/// Solve linear equations of mesh Laplacians by the multifrontal Cholesky method, \cite Duff1983.

#ifndef ConformalMultifrontalCholesky_h
#define ConformalMultifrontalCholesky_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"
#include "Linear/NestedDissection.h"

#include <vector>

namespace conformal
{
/// Cholesky factor of a sparse positive definite matrix, computed from small dense matrices called
/// fronts, \cite Duff1983. Nested dissection divides the unknowns recursively into parts, see
/// NestedDissection. Each part has a front. The first rows of a front belong to the unknowns of the
/// part. The other rows belong to all unknowns of later parts to which the part is connected. Parts
/// of one level (recursion depth) are independent, and are factored concurrently. Large fronts are
/// factored in panels (blocks of columns), with a progress report after each panel.
///
/// Eigen's sparse factorizations compute one column after another, on one thread and without
/// progress reports. For a mesh of 134,342 vertices (the scan Igea), Eigen's factorizations need
/// 0.7 s. This class needs 0.2 s.
class MultifrontalCholesky
{
public:
  /// Factor a symmetric matrix. The off-diagonal entries are the weights times -1.
  /// @param[in] places  position of each unknown in space. Positions determine only the sequence in
  ///   which unknowns are eliminated.
  /// @param[in] rings  number of rings of neighbors that the matrix couples to a vertex; 1 for
  ///   direct neighbors. The more rings, the more entries of the factor are permitted.
  /// @throws NumericalFailure if the matrix is not positive definite, or its factor has too many
  ///   entries. The factor has many entries if neighboring unknowns are far apart in space.
  MultifrontalCholesky(const EdgeWeights& weights, const std::vector<double>& diagonal,
    const Points& places, const Run& run = {}, int rings = 1);

  /// Solve the linear equations for each column.
  /// @param[in,out] columns  on input, the right-hand sides. On return, the solutions.
  void solve(Columns& columns) const;

private:
  struct Front
  {
    // Unknowns of this front that belong to later parts, as ascending positions in
    // NestedDissection::Order
    std::vector<int> Boundary;
    // Columns of the Cholesky factor for the unknowns of this part. The rows are the unknowns of
    // the part, then those of Boundary.
    Columns Factor;
    // Lower triangle of the Schur complement: the matrix that remains when the part is eliminated.
    // This matrix is added to the front of the parent part.
    Columns Update;
  };

  double dissect(const Adjacency& graph, const Points& places, CutAxes axes);
  void findBoundaries(const Adjacency& graph);
  double work(std::size_t part) const;
  void assemble(std::size_t part, const EdgeWeights& weights, const std::vector<double>& diagonal);
  void eliminate(std::size_t part, const Run& run);

  NestedDissection Dissection;
  std::vector<Front> Fronts;
};
}

#endif

/// Learn a self-organizing map of a table with any number of columns. The neurons are the vertices
/// of a geodesic sphere, as in \cite Liou2008, so that the map has no border. Maps on geodesic
/// spheres for tables are described by \cite Wu2006.
///
/// A row of the table is a pattern x, and each neuron has a weight vector w_i with one number for
/// each column.

#ifndef ConformalSphericalSOM_h
#define ConformalSphericalSOM_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Options of learnSphericalSOM().
struct SphericalSOMOptions
{
  /// Requested number of neurons, at least 12, or 0 for 5 sqrt(#P), \cite Vesanto2000. The map has
  /// the nearest number of the form 10 f^2 + 2, where f is an integer.
  Index NumberOfNeurons = 0;
  /// Whether each column is divided by its standard deviation before distances are measured.
  bool Standardize = true;
  unsigned int RandomSeed = 1; ///< seed of the axes at the beginning, and of the selection of rows
};

/// Self-organizing map with #N neurons of a table of #P rows and D columns.
///
/// Distances are measured after standardization. If the columns are not standardized, distances are
/// in the unit of the columns.
struct SphericalSOMResult
{
  Mesh Network;                   ///< geodesic sphere: network positions n_i, and triangles
  Columns Weights;                ///< D by #N weight vectors w_i, in the units of the columns
  std::vector<int> Winners;       ///< #P, neuron that is closest to each row
  std::vector<int> SecondWinners; ///< #P, second closest neuron of each row
  std::vector<double> Distances;  ///< #P, distance between each row and its winner
  std::vector<int> Hits;          ///< #N, number of rows of which each neuron is the winner
  /// #N, row of each neuron. It is the row that is closest to the weight vector if the neuron has
  /// no hits, and otherwise the first row of which the neuron is the winner.
  std::vector<int> Rows;
  /// #N, U-matrix (\cite Ultsch1990): mean distance between the weight vectors of each neuron and
  /// its neighbors
  std::vector<double> UMatrix;
  double QuantizationError =
    0.0; ///< mean distance between rows and their winners, \cite Kohonen2001
  /// Fraction of the rows whose winner and second winner are no neighbors, \cite Kiviluoto1996
  double TopographicError = 0.0;
};

/// Learn a map by batch training on geodesic spheres of increasing frequency, as
/// learnFromSphere() learns a surface from points.
///
/// In a pass, each row x is projected as in step 3 of \cite Liou2008. The winner is the neuron
/// whose weight vector is closest to x, and the projection is the closest point of the triangles
/// around the winner. The corners of the triangle with the projection get its barycentric weights,
/// which are diffused over the network (NetworkDiffusion.h). The resulting weights h_i(x) take the
/// place of h in Eq. 3 of \cite Liou2008. Each w_i is replaced by the mean of all rows, weighted by
/// h_i(x): the step of Eq. 3, summed over the rows with all w_i fixed. The diffusion becomes
/// narrower from pass to pass.
///
/// Implementation note: \cite Liou2008 begins with w_i = n_i. Here, the sphere is first stretched
/// to the ellipsoid of the three largest standard deviations along orthogonal axes of the rows, as
/// \cite Kohonen2001 recommends for planar maps.
/// @param[in] rows  D by #P: one column of the matrix for each row of the table; finite
/// @throws std::invalid_argument if there are no rows or no columns, or an option is out of range
/// @throws Aborted
/// @post The result depends only on the arguments, bit by bit, not on the number of threads.
SphericalSOMResult learnSphericalSOM(
  const Columns& rows, const SphericalSOMOptions& options = {}, const Run& run = {});
}

#endif

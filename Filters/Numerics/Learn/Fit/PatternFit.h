/// Fit values at the vertices of a mesh to the pattern values of samples by least squares. Pattern
/// values are dimensions of the samples beyond the three coordinates, such as colors.

#ifndef ConformalPatternFit_h
#define ConformalPatternFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Compute the pattern values of the vertices that minimize
///
///     sum p |b v - a|^2 + s m sum |v_i - v_j|^2.
///
/// The first sum is over all samples: p is the weight of the sample, a are its pattern values, and
/// b v are the values v of the mesh at its foot point (the closest point of the mesh), interpolated
/// by the barycentric weights b. The second sum is over all edges (i, j), and m is the mean over
/// the vertices of the sum of p b^2. The smoothness s is chosen from 0.001, 0.01, 0.1 and 1 by
/// cross-validation (\cite Stone1974): every fifth sample is left out, and the chosen
/// smoothness has the smallest errors at these samples.
///
/// Own construction: for fixed triangles and foot points, the minimum is the limit of Eq. 3 of
/// \cite Liou2008 without neighborhood, if the pattern values of a sample move the corners of its
/// triangle by the barycentric weights. The edges take the place of the neighborhood: they give
/// values to vertices without samples.
/// @param[in] mesh  vertices in the samples' unit, and triangles. All vertices are connected.
/// @return #V by D values. Each value is within the range of the samples' values.
/// @throws Aborted
/// @post The result does not depend on the number of threads or ranks, bit by bit.
Columns fitPatternValues(const TrainingSamples& samples, const Mesh& mesh, const Run& run = {});
}

#endif

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

/// Move the vertices of a mesh along its surface, so that edges of triangles follow steps of the
/// samples' pattern values.
///
/// In each of 8 rounds, each sample is projected to the mesh in all dimensions, as in step 3 of
/// \cite Liou2008. Near a step of the values, samples are thus projected to the side of the step
/// with equal values. Vertices then move toward their samples, by the least-squares fit of
/// fitPatternValues() for moves, which squeezes the triangles on the step. Own construction: only
/// moves along the surface are made, so that the shape of the mesh remains that of the coordinates.
/// Triangles do not turn over. If the samples lie in a plane, nothing moves.
///
/// Implementation note: \cite Liou2008 moves neurons in all dimensions at once. In the fit of Batch
/// mode, distances of the coordinates are measured along normals of the surface, which exist in
/// three dimensions only.
/// @param[in,out] mesh  vertices in the samples' unit, and triangles. All vertices are connected.
/// @throws Aborted
/// @post The result does not depend on the number of threads or ranks, bit by bit.
void alignWithPatternValues(const TrainingSamples& samples, Mesh& mesh, const Run& run = {});
}

#endif

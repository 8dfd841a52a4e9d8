/// CSM: a closed mesh learned from scattered points, with its map to the sphere.

#ifndef ConformalConformalSOM_h
#define ConformalConformalSOM_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Training.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Learn a closed surface through the samples, \cite Liou2008 section 2.
///
/// Implementation note: the weights start as the unit sphere around the samples' centroid, scaled
/// so that their largest radius is 1, the frame in which the paper's constants are meant.
///
/// Implementation note: in Online mode a neuron farther than 4 sigma from r is not moved (its
/// share in Eq. 3 is below 3.4e-4), which is what makes it fast; Documentation/Filters.md has the
/// difference it makes.
///
/// @param[in] samples   at least one pattern
/// @param[in] start     may be null: the surface learning starts from, resampled at the neurons'
///                      positions. Batch training then goes straight to the polish. Without sphere
///                      positions it is a closed mesh of genus zero, counter-clockwise seen from
///                      outside, with the samples as its vertices, for Batch only. It is mapped to
///                      the sphere here where that is needed. Where that fails, and where the
///                      result is bad (SurfaceVerdict.h), StartingShape Automatic tries the other
///                      starts and keeps the best result.
/// @throws std::invalid_argument if there are no samples, an option is out of range, or the mesh to
///         start from has fewer than four triangles
/// @throws Aborted
/// @post the result depends only on the arguments: same input, same bits, any number of threads;
///       points scaled by a power of two give weights scaled by it, bit by bit
ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& options = {}, const MappedMesh* start = nullptr, const Run& run = {});

/// As many as the network of these options has.
Index numberOfNeurons(const ConformalSOMOptions& options);

/// What trainConformalSOM() takes, in nanoseconds as in Steps: the middle of what the shapes of
/// objects make of it.
double workOfConformalSOM(const ConformalSOMOptions& options);

/// Root mean square distance between each neuron and the patterns it stands for: those in whose
/// simplex it has the largest barycentric weight. In the points' own unit; 0 without patterns.
/// @return #N values
std::vector<double> quantizationErrors(
  const TrainingSamples& samples, const ConformalSOMResult& result, const Run& run = {});
}

#endif

/// CSM: a closed mesh learned from scattered points, with its map to the sphere.

#ifndef ConformalConformalSOM_h
#define ConformalConformalSOM_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Learn a closed surface through the samples, \cite Liou2008 section 2, and map it to the sphere:
/// a geodesic mesh by the positions of its neurons in the network, an adaptive mesh conformally
/// (GlobalConformalMap.h).
///
/// Implementation note: the weights start as the unit sphere around the samples' centroid, scaled
/// so that their largest radius is 1, the frame in which the paper's constants are meant. An
/// adaptive mesh may start from other surfaces (StartSearch.h).
///
/// Implementation note: in Online mode a neuron farther than 4 sigma from r is not moved (its
/// share in Eq. 3 is below 3.4e-4), which is what makes it fast; Documentation/Filters.md has the
/// difference it makes.
///
/// @param[in] samples  at least one
/// @param[in] mesh     may be null: a closed mesh of genus zero to start from, for an adaptive
/// mesh,
///                     or with SpherePositions in Online mode, where it gives the first weights.
///                     With SpherePositions it is any mesh near the samples, of which only the
///                     surface counts. Without SpherePositions it is the samples' own mesh, with
///                     the samples as its vertices and triangles counter-clockwise seen from
///                     outside. Not used for samples in a plane if MeshType is Automatic.
/// @throws std::invalid_argument if there are no samples, an option is out of range, a geodesic
/// mesh
///         is to start from anything but the sphere, or the mesh to start from is not closed and of
///         genus zero
/// @throws Aborted
/// @post the result depends only on the arguments: same input, same bits, any number of threads;
///       points scaled by a power of two give weights scaled by it, bit by bit
ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& options = {}, const MappedMesh* mesh = nullptr, const Run& run = {});

/// Root mean square distance between each neuron and the patterns it stands for: those in whose
/// simplex it has the largest barycentric weight. In the points' own unit; 0 without patterns.
/// @return #N values
std::vector<double> quantizationErrors(
  const TrainingSamples& samples, const ConformalSOMResult& result, const Run& run = {});
}

#endif

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
/// Learn a closed surface through the samples, \cite Liou2008 section 2, and map it to the sphere.
/// The map of a geodesic mesh is given by the network positions of its neurons. An adaptive mesh is
/// mapped conformally (GlobalConformalMap.h).
///
/// Implementation note: the initial weights are the unit sphere around the centroid of the samples,
/// which are scaled to a maximum radius of 1. The constants of the paper refer to this frame. An
/// adaptive mesh may start from other surfaces (StartSearch.h).
///
/// Implementation note: in Online mode, neurons farther than 4 sigma from r are not moved, which
/// reduces the cost. Their factor in Eq. 3 is below 3.4e-4. Documentation/Filters.md lists the
/// effect.
///
/// @param[in] samples  at least one
/// @param[in] mesh     closed mesh of genus zero to start from, or null. It requires an adaptive
///   mesh, or SpherePositions in Online mode as the initial weights. With SpherePositions, it is
///   any mesh near the samples, of which only the surface is used. Without, it is the samples' own
///   mesh: its vertices are the samples, and triangles are counter-clockwise seen from outside. It
///   is ignored for samples in a plane if MeshType is Automatic.
/// @throws std::invalid_argument if there are no samples, or an option is out of range
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or a geodesic mesh is
///   to start from anything but the sphere
/// @throws Aborted
/// @post the result depends only on the arguments: same input, same bits, any number of threads;
///   points scaled by a power of two give weights scaled by it, bit by bit
ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& options = {}, const MappedMesh* mesh = nullptr, const Run& run = {});

/// Compute the root mean square distance between each neuron and its patterns, in the points' own
/// unit. A pattern belongs to the neuron of maximum barycentric weight in the triangle of its
/// projection. Neurons without patterns get 0. Of a large cloud, options.Batch.SamplesPerNeuron
/// patterns for each neuron are used, so the time does not grow with the cloud.
/// @return #N values
std::vector<double> quantizationErrors(const TrainingSamples& samples,
  const ConformalSOMResult& result, const ConformalSOMOptions& options = {}, const Run& run = {});
}

#endif

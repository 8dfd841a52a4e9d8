/// Conformal self-organizing map (CSM): learn a closed mesh from scattered points, and map it to
/// the sphere.

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
/// Implementation note: samples are shifted to their centroid and scaled to a maximum radius of 1.
/// The constants of \cite Liou2008 refer to these coordinates. The initial weights are the unit
/// sphere. An adaptive mesh may start from other surfaces (StartSearch.h).
///
/// Implementation note: in Online mode, neurons farther than 4 sigma from the reference point r are
/// not moved, which reduces the cost. Their factor in Eq. 3 is below 3.4e-4.
/// Documentation/Filters.md describes the effect on results.
///
/// @param[in] samples  at least one sample
/// @param[in] mesh     closed mesh of genus zero to start from, or null. In Batch mode, a start
///   mesh requires that the learned mesh is adaptive. In Online mode, the start mesh must have
///   SpherePositions, and gives the initial weights. A start mesh with SpherePositions may be any
///   mesh near the samples; only its surface is used. A start mesh without SpherePositions is the
///   samples' own mesh: its vertices are the samples, and its triangles are counter-clockwise seen
///   from outside. The start mesh is ignored for samples in a plane if MeshType is Automatic.
/// @throws std::invalid_argument if there are no samples, or an option is out of range
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or if a geodesic mesh
///   is requested with a start other than the sphere
/// @throws Aborted
/// @post the result depends only on the arguments: equal input gives equal bits for any number of
///   threads. If points are scaled by a power of two, the resulting weights are scaled by the same
///   factor, bit by bit.
ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& options = {}, const MappedMesh* mesh = nullptr, const Run& run = {});

/// Compute the root mean square distance between each neuron and its patterns, in the unit of the
/// input points. Each pattern is assigned to one corner of the triangle that contains its
/// projection: the corner of maximum barycentric weight. Neurons without patterns get 0. At most
/// options.Batch.SamplesPerNeuron patterns per neuron are used, so that large clouds take no
/// longer.
/// @return #N values
std::vector<double> quantizationErrors(const TrainingSamples& samples,
  const ConformalSOMResult& result, const ConformalSOMOptions& options = {}, const Run& run = {});
}

#endif

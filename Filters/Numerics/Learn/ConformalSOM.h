/// Learn a closed triangle mesh from scattered points, and map the mesh to the unit sphere. The
/// method is the conformal self-organizing map (CSM) of \cite Liou2008.

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
/// Learn a closed triangle mesh through the samples, \cite Liou2008 section 2, and map the mesh to
/// the sphere.
///
/// The mesh is geodesic or adaptive (options.MeshType). A geodesic mesh has the triangles of a
/// geodesic sphere (a subdivided icosahedron). Each vertex (neuron) is mapped to its position on
/// the geodesic sphere, called network position. An adaptive mesh has triangles of about equal size
/// all over the surface. After learning, a conformal map of this mesh is computed
/// (GlobalConformalMap.h).
///
/// Implementation note: samples are shifted to their centroid and scaled to a maximum radius of 1.
/// The constants of \cite Liou2008 refer to these coordinates. Learning of a geodesic mesh begins
/// with the unit sphere, unless a start mesh is given. Learning of an adaptive mesh can begin with
/// other surfaces (StartSearch.h).
///
/// If options.Genus is AsFound, an adaptive mesh keeps the handles of the object. A mesh with
/// handles has no map to the sphere, and no border: SpherePositions are empty, and options.Opening
/// is ignored.
///
/// Implementation note: in Online mode (options.TrainingMode), each step moves neurons (vertices)
/// near a reference point r. The distance between neuron and r is measured on the sphere. Let sigma
/// be the neighborhood radius of Eq. 3 in \cite Liou2008. To reduce the cost, neurons farther than
/// 4 sigma from r are not moved. Eq. 3 would move these neurons by less than 3.4e-4 of their
/// distance from the sample. Documentation/Filters.md describes the effect on results.
/// Implementation note: if the samples have pattern values (TrainingSamples::setPatternValues()),
/// samples and weight vectors have more than three dimensions. In Online mode, distances, winners,
/// projections and updates are those of all dimensions. In Batch mode, the shape is learned from
/// the coordinates alone, since its fit measures distances along normals in space. The vertices
/// then move along the surface toward steps of the pattern values, in all dimensions, and the
/// pattern values of the mesh are fitted (PatternFit.h).
/// @param[in] samples  at least one sample
/// @param[in] mesh     start mesh, or null. A start mesh is closed, of genus zero, and in the
///   coordinates of the input points.
///
///   - If the start mesh has SpherePositions, its vertices need not be samples, but must be near
///     the samples. Batch mode uses only the surface of the start mesh, not the map. In Online
///     mode, each neuron starts at the point of the start mesh that is mapped to its network
///     position.
///   - If the start mesh has no SpherePositions, its vertices must be the samples. Its triangles
///     must be counter-clockwise seen from outside. Online mode requires SpherePositions.
///   - In Batch mode, a start mesh is not allowed if options.MeshType is Geodesic. If MeshType is
///     Automatic and the samples lie in a plane, the start mesh is ignored.
/// @throws std::invalid_argument if there are no samples, or an option is out of range
/// @throws std::invalid_argument if the start mesh is not closed and of genus zero
/// @throws std::invalid_argument if options.Genus is AsFound, and the mesh is learned from the
/// sphere
/// @throws std::invalid_argument if a geodesic mesh is requested (MeshType Geodesic or Online
///   mode), but options.StartingShape is Hull or Mesh
/// @throws Aborted
/// @post The result depends only on the arguments, bit by bit, not on the number of threads. If the
///   points are scaled by a power of two, the resulting positions are scaled by this factor, bit by
///   bit.
ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& options = {}, const MappedMesh* mesh = nullptr, const Run& run = {});

/// Compute the root mean square distance between each vertex (neuron) and its samples, in the unit
/// of the input points.
///
/// Each sample is projected to the closest point of the mesh, in some triangle. The sample belongs
/// to the corner of this triangle with the largest barycentric weight at the projection. A vertex
/// without samples gets 0. At most options.Batch.SamplesPerNeuron samples per vertex are used, so
/// that the cost is independent of the number of samples.
/// @param[in] result  learned mesh with #N vertices
/// @return #N distances
std::vector<double> quantizationErrors(const TrainingSamples& samples,
  const ConformalSOMResult& result, const ConformalSOMOptions& options = {}, const Run& run = {});
}

#endif

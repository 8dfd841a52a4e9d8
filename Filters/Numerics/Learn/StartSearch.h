/// Learn a mesh from several start surfaces, and select the best result.
///
/// Own construction, not from a publication: a start surface is a closed surface from which
/// learning begins. Several start surfaces are tried, because no single one suits all shapes.

#ifndef ConformalStartSearch_h
#define ConformalStartSearch_h

#include "Base/Run.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Return the type of the mesh to learn. If options.MeshType is Automatic, return Adaptive in Batch
/// mode. In Online mode, or if all samples lie in a plane, return Geodesic.
MeshType meshTypeFor(const ConformalSOMOptions& options, const TrainingSamples& samples);

/// Learn in Batch mode (options.TrainingMode) from one or more start surfaces, and return the best
/// result.
///
/// Each learned mesh is evaluated (SurfaceQuality.h). A mesh is bad if one of its defects exceeds
/// the tolerance for this defect. Webs are spurious membranes that span gaps between limbs (thin
/// parts). Only meshes learned from the sphere are tested for webs. A result is good if its mesh is
/// not bad and has no webs.
///
/// For StartingShape Automatic, the following start surfaces are tried in this order until a result
/// is good. For other values of StartingShape, only some of the start surfaces are tried, as stated
/// in the list:
/// - Given mesh: if a start mesh with SpherePositions (a map to the sphere) is given, this mesh is
///   the only start surface.
/// - Own mesh: if a start mesh without SpherePositions is given, its vertices are the samples. This
///   mesh is the first start surface.
/// - Sphere: only for StartingShape Automatic or Sphere, and options.Genus Zero. For a geodesic
/// mesh, the sphere is the
///   only start surface.
/// - Hull (closed surface around the samples): only for StartingShape Automatic or Hull. If an
///   adaptive mesh is learned from samples of affine rank below 3, the hull replaces the sphere.
///   The affine rank is 2 for samples in a plane, and 1 for samples on a line.
/// - Other hull: only if a hull was tried, HullMethod is Automatic, and the best result is bad. If
///   there are fewer than two samples for each neuron, also if its map to the sphere is not
///   conformal. This hull is made by the method that was not used for the first hull.
///
/// Of two results, the better one has the lower defectScore(). For each half percent of unsupported
/// area (see FittedMesh), or of area on cuts, that it has beyond the other one, 1 is added to its
/// score. If there are fewer than two samples for each neuron, errors of maps to the sphere
/// (ToleratedMap) are compared in the same way. However, a result with webs is replaced by the next
/// result, whatever the scores. If the affine rank is below 3, results cannot be evaluated, and the
/// first one is returned.
///
/// If HullMethod is Automatic, the method is selected by chooseHull() of GenusZeroHull.h.
///
/// @param[in] mesh  start mesh or null, see trainConformalSOM()
/// @return the best result, with positions in the samples' unit (maximum radius 1). Only a geodesic
///   mesh has SpherePositions.
/// @throws std::invalid_argument if the start mesh is open, not of genus zero, or far from the
///   samples
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
///   (processes)
ConformalSOMResult learnFromBestStart(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run = {});
}

#endif

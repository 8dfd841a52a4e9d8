/// Choose the initial surface of learning. Own construction: several surfaces are tried and the
/// best result is kept, because no initial surface suits all shapes.

#ifndef ConformalStartSearch_h
#define ConformalStartSearch_h

#include "Base/Run.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Return the type of the learned mesh: options.MeshType, or the type that is selected if the
/// option is Automatic.
MeshType meshTypeFor(const ConformalSOMOptions& options, const TrainingSamples& samples);

/// Learn in Batch mode from several starts and return the best result.
///
/// Starts are tried in this order, each only if its condition holds:
/// - If a mesh with SpherePositions is given, it is the only start.
/// - If a mesh without SpherePositions (the samples' own mesh) is given, it is the first start.
/// - The sphere is tried for StartingShape Sphere, or for Automatic if no result is good yet. For a
///   geodesic mesh, the sphere is the only start.
/// - A hull is tried for StartingShape Hull, or for Automatic if no result is good yet. For points
///   of affine rank below 3 with an adaptive mesh, it replaces the sphere.
/// - The hull of the other method is tried for HullMethod Automatic, if a hull was tried and the
///   best result is bad.
///
/// A result is bad if a defect exceeds its tolerance (SurfaceQuality.h). A result of the sphere is
/// also not good if it has webs (spurious membranes). Of two results, the one with the lower
/// defectScore() is better, but a result without webs is better than any with webs. For points of
/// affine rank below 3, results cannot be evaluated and the first one is returned.
///
/// For HullMethod Automatic, the hull is made by chooseHull() of GenusZeroHull.h.
///
/// @param[in] mesh  start mesh or null; see trainConformalSOM()
/// @return the best result, with positions in the samples' unit. It has SpherePositions only if it
///   is a geodesic mesh.
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or far from the
///   samples
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
ConformalSOMResult learnFromBestStart(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run = {});
}

#endif

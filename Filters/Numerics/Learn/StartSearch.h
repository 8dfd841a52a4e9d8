/// Choice of the initial surface of learning by trial; own construction.

#ifndef ConformalStartSearch_h
#define ConformalStartSearch_h

#include "Base/Run.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Return the type of the learned mesh: options.MeshType, or the selected type if it is Automatic.
MeshType meshTypeFor(const ConformalSOMOptions& options, const TrainingSamples& samples);

/// Learn in Batch mode from several starts and return the best result.
///
/// Starts are tried in this order, as long as their conditions hold:
/// - A mesh with SpherePositions, if given, is the only start.
/// - A mesh without SpherePositions, the samples' own mesh, is the first start if given.
/// - The sphere is used for StartingShape Sphere, or for Automatic until a result is good. For a
///   geodesic mesh, it is the only start.
/// - A hull is used for StartingShape Hull, or for Automatic until a result is good.
/// - The hull of the other method is used for HullMethod Automatic, if a hull was tried and the
///   best result is bad.
///
/// A result is bad if a defect of its quality exceeds the tolerance (SurfaceQuality.h). From the
/// sphere, it is also not good if it has webs. Of two results, the one with the lower defectScore()
/// is better. Any result is better than one with webs. Points of affine rank below 3 cannot be
/// evaluated, and the first result is returned.
///
/// A hull with HullMethod Automatic is chooseHull() of GenusZeroHull.h.
///
/// @param[in] mesh  may be null; see trainConformalSOM()
/// @return positions in the samples' unit; SpherePositions of a geodesic mesh only
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or far from the
///   samples
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
ConformalSOMResult learnFromBestStart(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run = {});
}

#endif

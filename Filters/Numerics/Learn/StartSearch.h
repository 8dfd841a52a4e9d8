/// Choice of the surface that learning starts from, by trying; own construction.

#ifndef ConformalStartSearch_h
#define ConformalStartSearch_h

#include "Base/Run.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Type of the mesh that is learned: options.MeshType, or what it stands for if it is Automatic.
MeshType meshTypeFor(const ConformalSOMOptions& options, const TrainingSamples& samples);

/// Learn in Batch mode from one start after the other, as far as each is wanted, and return the
/// best result.
///
/// - A mesh with SpherePositions is the only start where it is given.
/// - A mesh without SpherePositions, the samples' own mesh, comes first where it is given.
/// - The sphere follows with StartingShape Sphere, or with Automatic while there is no good result.
///   For a geodesic mesh it is the only start.
/// - A hull follows with StartingShape Hull, or with Automatic while there is no good result.
/// - The hull of the other method comes last, with HullMethod Automatic, where the best result is
///   bad and a hull was tried.
///
/// A result is bad where a defect of its quality (SurfaceQuality.h) is more than tolerated, and not
/// good from the sphere where it has webs. Of two results the one with the lower defectScore() is
/// better, and any result is better than one with webs. In points of rank below 3, nothing can be
/// evaluated, and the first result is returned.
///
/// A hull with HullMethod Automatic is chooseHull() of GenusZeroHull.h.
///
/// @param[in] mesh  may be null; see trainConformalSOM()
/// @return positions in the samples' unit; SpherePositions of a geodesic mesh only
/// @throws std::invalid_argument if the mesh is not closed and of genus zero, or far from the
/// samples
/// @throws Aborted
/// @post the result depends only on the arguments, not on threads or ranks
ConformalSOMResult learnFromBestStart(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run = {});
}

#endif

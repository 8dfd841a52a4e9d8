/// Carries values from one surface to another by their maps to the sphere.
/// Methods of \cite Glasser2013.

#ifndef ConformalSphericalResample_h
#define ConformalSphericalResample_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Register/ResampleWeights.h"

namespace conformal
{
enum class ResampleMethod
{
  Barycentric, ///< between the three points of the source around each point
  AreaAdaptive ///< so that each point of the source counts by its area
};

struct SphericalResampleOptions
{
  ResampleMethod Method = ResampleMethod::AreaAdaptive;
};

struct SphericalResampling
{
  ResampleWeights Weights; ///< of the source's points, for each point of the target
  Index NumberOfFolds = 0; ///< of the source's map: there it covers the sphere more than once
};

/// What the points of a target are made of, as Connectome Workbench defines it.
///
/// Barycentric: the point of the source's sphere, of flat triangles, that is closest to the
/// target's point on the unit sphere; its barycentric coordinates are the weights.
///
/// AreaAdaptive, its ADAP_BARY_AREA: points of the target are made of the same points as above,
/// or, if there are more that name it from the other side (a point of the source lies in a
/// triangle of which it is a corner), of those, by their barycentric coordinates. Then weights are
/// multiplied by the area around the target's point, those of each point of the source are scaled
/// so that they add up to the area around that, and those of each target point divided by their
/// sum. So all of the source counts where the target is coarser, and it is an interpolation where
/// the target is finer.
///
/// @param[in] source  its positions say what area is around each point; points of no triangle do
///                    not count
/// @param[in] target  Barycentric needs no triangles and no positions of it
/// @throws std::invalid_argument if a surface is open, or a map does not cover the sphere once,
///   mirrored or not; those of the target need not with Barycentric
/// @throws Aborted
SphericalResampling resampleSurface(const MappedMesh& source, const MappedMesh& target,
  const SphericalResampleOptions& options = {}, const Run& run = {});
}

#endif

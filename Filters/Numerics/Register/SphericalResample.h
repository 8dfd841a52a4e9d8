/// Resample values of one surface at the points of another by their maps to the sphere.
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
  Barycentric, ///< interpolate in the source triangle that contains each target point
  AreaAdaptive ///< every source point contributes by its area
};

struct SphericalResampleOptions
{
  ResampleMethod Method = ResampleMethod::AreaAdaptive;
};

struct SphericalResampling
{
  ResampleWeights Weights; ///< for each target point, weights of source points
  Index NumberOfFolds = 0; ///< of the source's map, which then covers the sphere more than once
};

/// Compute the weights of source points for each target point, as Connectome Workbench defines
/// them.
///
/// Barycentric: the weights are the barycentric coordinates of the closest point on the flat
/// triangles of the source's sphere.
///
/// AreaAdaptive (ADAP_BARY_AREA of Connectome Workbench):
/// 1. Compute Barycentric weights forward, from source to target, and in reverse, from target to
///    source.
/// 2. For each target point, use the reverse weights if they name more source points, else the
///    forward ones.
/// 3. Multiply the weights of each target point by its area.
/// 4. Scale the weights of each source point so that their sum is its area.
/// 5. Normalize the weights of each target point to sum 1.
///
/// All of the source thus contributes to a coarser target, and a finer target is interpolated.
///
/// @param[in] source  its positions define the areas of points; points without triangles are
///   ignored
/// @param[in] target  Barycentric needs neither its triangles nor its positions
/// @throws std::invalid_argument if a surface is open, or a map does not cover the sphere once,
///   mirrored or not; the target is not checked for Barycentric
/// @throws Aborted
SphericalResampling resampleSurface(const MappedMesh& source, const MappedMesh& target,
  const SphericalResampleOptions& options = {}, const Run& run = {});
}

#endif

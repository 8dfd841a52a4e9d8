/// Resample values of one surface at the points of another surface by their maps to the sphere,
/// with the methods of \cite Glasser2013.

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
  AreaAdaptive ///< every source point contributes with a weight by its area
};

struct SphericalResampleOptions
{
  ResampleMethod Method = ResampleMethod::AreaAdaptive;
};

struct SphericalResampling
{
  ResampleWeights Weights; ///< for each target point, weights of source points
  /// Number of folded triangles of the source's map, which covers parts of the sphere more than
  /// once.
  Index NumberOfFolds = 0;
};

/// Compute the weights of source points for each target point, as Connectome Workbench defines
/// them.
///
/// Barycentric: the weights are the barycentric coordinates of the target point's closest point on
/// the flat triangles of the source's sphere.
///
/// AreaAdaptive (ADAP_BARY_AREA of Connectome Workbench):
/// 1. Compute Barycentric weights forward, from source to target, and in reverse, from target to
///    source.
/// 2. For each target point, use the reverse weights if they involve more source points, else the
///    forward weights.
/// 3. Multiply the weights of each target point by its area.
/// 4. Scale the weights of each source point so that their sum is its area.
/// 5. Normalize the weights of each target point to sum 1.
///
/// Thus all source points contribute to a coarser target, and values are interpolated for a finer
/// target.
///
/// @param[in] source  surface with a map. Its positions define the areas of points; points without
///   triangles are ignored.
/// @param[in] target  surface with a map; for Barycentric, only SpherePositions are used
/// @throws std::invalid_argument if a surface is open, or a map does not cover the sphere once,
///   mirrored or not; the target is not checked for Barycentric
/// @throws Aborted
SphericalResampling resampleSurface(const MappedMesh& source, const MappedMesh& target,
  const SphericalResampleOptions& options = {}, const Run& run = {});
}

#endif

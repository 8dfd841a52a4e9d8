/// Measure distances between a model surface and a reference, in both directions, \cite Liou2008
/// and \cite Cignoni1998.

#ifndef ConformalSurfaceMismatch_h
#define ConformalSurfaceMismatch_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Length that is the unit of the measures.
enum class MismatchUnit
{
  MaxRadius,    ///< maximum distance of a reference point from the centroid of the reference points
  HalfDiagonal, ///< half the diagonal of the bounding box of the reference
  None          ///< unit of the user (CoordinateUnit)
};

struct SurfaceMismatchOptions
{
  MismatchUnit LengthUnit = MismatchUnit::MaxRadius;
  double CoordinateUnit = 1.0; ///< length of a coordinate difference of 1, in the unit of the user
  /// Number of samples of the surface of the model, spread evenly over the area.
  int NumberOfSamples = 60000;
  int RandomSeed = 1; ///< seed of the positions of the samples
};

/// Minimum distance between a web and the reference, in units of LengthUnit. A web is a part of the
/// model that spans a gap of the object.
constexpr double WebDistance = 0.02;

/// Measures of the mismatch between a model surface and a reference. Distances are in units of
/// LengthUnit, and mean squares in units of its square. ModelDistances and ReferenceDistances are
/// in the unit of the user.
struct SurfaceMismatch
{
  double LengthUnit = 1.0; ///< length of LengthUnit in the unit of the user
  /// Mean square distance from reference points to the surface of the model, E_mis in
  /// \cite Liou2008.
  double MeanSquarePointToSurface = 0.0;
  /// Mean square distance from reference points to the nearest vertex of the model.
  double MeanSquarePointToVertex = 0.0;
  /// Mean square distance from samples of the model to the reference.
  double MeanSquareSurfaceToPoint = 0.0;
  double HausdorffDistance = 0.0; ///< maximum distance in either direction
  /// Fraction of the area of the model that is farther than WebDistance from the reference, in [0,
  /// 1].
  double WebFraction = 0.0;
  std::vector<double> ModelDistances; ///< distance from each model vertex to the reference, #V
  /// Distance from each reference point to the surface of the model, #P.
  std::vector<double> ReferenceDistances;
};

/// Measure the mismatch error E_mis, \cite Liou2008 section 4.1, and the distances in the opposite
/// direction. For a model M and #P reference points x, E_mis = 1 / #P sum_x dist(x, M)^2. This
/// measure does not detect webs, since a model may pass through all reference points and also span
/// gaps.
///
/// The nearest vertex is searched among the vertices of triangles. If the reference has no
/// triangles, the distance to the reference is the distance to its nearest point. All reference
/// points are data, even those without triangles. The maximum distance from the model is computed
/// over its samples and vertices. HausdorffDistance is therefore a lower bound of the exact
/// distance.
///
/// Implementation note: samples are placed at equal steps of the accumulated area. Within
/// triangles, they are placed by a sequence of low discrepancy. The noise is much less than that of
/// independent random samples.
///
/// Implementation note: the reference may be distributed over several processes. Each process has a
/// part of the reference, and all processes have the whole model. The reference consists of all
/// parts in the order of the processes. The measures are equal on all processes, and have the same
/// bits as with a single process. If the reference has no triangles, the points stay on their
/// processes. Otherwise, the reference is copied to all processes.
///
/// @param[in] modelPoints  #V by 3
/// @param[in] modelTriangles  #F by 3, at least one
/// @param[in] referencePoints  #P by 3; all processes together have at least one point
/// @param[in] referenceTriangles  ids of reference points; may be empty
/// @param[in] reduce  sum over all processes that hold parts of the reference
/// @throws std::invalid_argument if the model has no triangles, or if the reference has no points
/// @throws std::invalid_argument if a coordinate is not finite
/// @throws std::invalid_argument if all reference points coincide, so that the unit is zero
/// @throws std::invalid_argument if a measure leaves the range of doubles
/// @post the result depends only on the arguments of all processes, not on threads
SurfaceMismatch measureSurfaceMismatch(const PointView& modelPoints,
  const Triangles& modelTriangles, const PointView& referencePoints,
  const Triangles& referenceTriangles, const SurfaceMismatchOptions& options = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif

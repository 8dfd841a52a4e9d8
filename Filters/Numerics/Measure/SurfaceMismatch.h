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
  None          ///< unit of the user
};

struct SurfaceMismatchOptions
{
  MismatchUnit LengthUnit = MismatchUnit::MaxRadius;
  double CoordinateUnit = 1.0; ///< length of a coordinate difference of 1, in the unit of the user
  /// Number of samples of the model's surface, spread evenly over its area.
  int NumberOfSamples = 60000;
  int RandomSeed = 1; ///< seed of the positions of the samples
};

/// Minimum distance of a web from the reference, in units of LengthUnit. A web is a part of the
/// model that spans a gap of the object.
constexpr double WebDistance = 0.02;

/// Measures of the mismatch, in units of LengthUnit and its square. ModelDistances and
/// ReferenceDistances are in the unit of the user.
struct SurfaceMismatch
{
  double LengthUnit = 1.0; ///< unit of the measures, in the unit of the user
  /// E_mis: mean square distance from reference points to the model's surface.
  double MeanSquarePointToSurface = 0.0;
  /// Mean square distance from reference points to the nearest vertex of the model.
  double MeanSquarePointToVertex = 0.0;
  /// Mean square distance from samples of the model to the reference.
  double MeanSquareSurfaceToPoint = 0.0;
  double HausdorffDistance = 0.0; ///< maximum distance in either direction
  /// Fraction of the model's area that is farther than WebDistance from the reference.
  double WebFraction = 0.0;
  std::vector<double> ModelDistances; ///< #V: distance from each model vertex to the reference
  /// #P: distance from each reference point to the model's surface.
  std::vector<double> ReferenceDistances;
};

/// Measure the mismatch error E_mis = 1 / #P sum_x dist(x, M)^2 of a model M, \cite Liou2008
/// section 4.1, and the distances in the opposite direction. E_mis does not detect webs, since a
/// model may pass through all data and also span gaps.
///
/// The nearest vertex is searched among the vertices of triangles. If the reference has no
/// triangles, the distance to it is the distance to its nearest point. All reference points are
/// data, even those without triangles. The maximum distance from the model is computed over its
/// samples and vertices. HausdorffDistance is therefore a lower bound of the exact distance.
///
/// Implementation note: samples are placed at equal steps of the accumulated area, and within
/// triangles by a sequence of low discrepancy. This gives much less noise than independent random
/// samples.
///
/// With several processes, each has a part of the reference, and all have the whole model. The
/// reference consists of all parts in the order of the processes. The measures are equal on all
/// processes, and equal to the bit to those of a single process. The points of a reference without
/// triangles stay on their processes. A reference with triangles is copied to all processes.
///
/// @param[in] modelPoints         #V by 3
/// @param[in] modelTriangles      #F by 3, at least one
/// @param[in] referencePoints     #P by 3; all processes together have at least one point
/// @param[in] referenceTriangles  may be empty
/// @param[in] reduce              sum over all processes that hold parts of the reference
/// @throws std::invalid_argument if the model has no triangles, the reference has no points, or a
///   coordinate is not finite
/// @throws std::invalid_argument if all reference points coincide, so that the unit is zero, or a
///   measure leaves the range of doubles
/// @post the result depends only on the arguments of all processes, not on threads
SurfaceMismatch measureSurfaceMismatch(const PointView& modelPoints,
  const Triangles& modelTriangles, const PointView& referencePoints,
  const Triangles& referenceTriangles, const SurfaceMismatchOptions& options = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif

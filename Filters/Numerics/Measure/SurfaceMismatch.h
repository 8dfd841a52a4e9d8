/// Measure distances between a model surface and a reference, in both directions (from model to
/// reference, and from reference to model), \cite Liou2008 and \cite Cignoni1998.

#ifndef ConformalSurfaceMismatch_h
#define ConformalSurfaceMismatch_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Length that is used as unit of the measures.
enum class MismatchUnit
{
  MaxRadius,    ///< maximum distance of a reference point from the centroid of the reference points
  HalfDiagonal, ///< half the diagonal of the bounding box of the reference
  None          ///< unit of the user (CoordinateUnit)
};

struct SurfaceMismatchOptions
{
  MismatchUnit LengthUnit = MismatchUnit::MaxRadius;
  double CoordinateUnit = 1.0; ///< length of a coordinate difference of 1, in the unit of the user,
                               ///< such as 0.001 for coordinates in mm and the unit m
  /// Number of samples of the surface of the model, spread evenly over the area.
  int NumberOfSamples = 60000;
  int RandomSeed = 1; ///< seed of the positions of the samples
  /// Radius of the disks over which curvatures are averaged, as a fraction of half the diagonal of
  /// the bounding box of the reference.
  double CurvatureRadius = 0.03;
};

/// Maximum number of samples at which curvatures are compared.
constexpr int MaximumCurvatureSamples = 6000;

/// A web is a part of the model that spans a gap of the object. Parts of the model count as webs if
/// they are farther than this distance from the reference [LengthUnit].
constexpr double WebDistance = 0.02;

/// Measures of the mismatch between a model surface and a reference. Distances are divided by
/// LengthUnit, and mean squares by the square of LengthUnit. ModelDistances and ReferenceDistances
/// are not divided. They are in the unit of the user.
struct SurfaceMismatch
{
  /// Length of SurfaceMismatchOptions::LengthUnit, in the unit of the user.
  double LengthUnit = 1.0;
  /// Mean square distance from reference points to the surface of the model, E_mis in
  /// \cite Liou2008.
  double MeanSquarePointToSurface = 0.0;
  /// Mean square distance from reference points to the nearest vertex of the model.
  double MeanSquarePointToVertex = 0.0;
  /// Mean square distance from samples of the model to the reference.
  double MeanSquareSurfaceToPoint = 0.0;
  double HausdorffDistance = 0.0; ///< maximum distance in either direction
  /// For each sample of the model, the angle between its triangle and the closest triangle of the
  /// reference is measured. This is the root mean square of all angles, in [0, 90] degrees. Valid
  /// if HasNormalAngle is true.
  double RootMeanSquareNormalAngle = 0.0;
  /// Root mean square difference of the mean curvatures of model and reference, see MeanCurvature,
  /// over at most MaximumCurvatureSamples of the samples [1 / LengthUnit]. Before, border points
  /// with equal coordinates are merged, and triangles are oriented consistently. Valid if
  /// HasNormalAngle is true.
  double RootMeanSquareCurvatureError = 0.0;
  bool HasNormalAngle = false; ///< whether the reference has triangles
  /// Fraction of the area of the model that is farther than WebDistance from the reference, in [0,
  /// 1].
  double WebFraction = 0.0;
  std::vector<double> ModelDistances; ///< distance from each model vertex to the reference, #V
  /// Distance from each reference point to the surface of the model, #P.
  std::vector<double> ReferenceDistances;
};

/// Measure the mismatch error E_mis, \cite Liou2008 section 4.1, and the distances in the opposite
/// direction. For a model M and #P reference points x, E_mis = 1 / #P sum_x dist(x, M)^2. E_mis
/// does not detect webs, since a model with webs can also pass through all reference points.
///
/// For MeanSquarePointToVertex, vertices of the model without triangles are ignored. If the
/// reference has no triangles, the distance to the reference is the distance to its nearest point.
/// Distances to the model are measured from all reference points, even from those without
/// triangles. From the model to the reference, distances are measured at samples and vertices of
/// the model, but not at all other points. HausdorffDistance is therefore a lower bound of the
/// exact Hausdorff distance.
///
/// Implementation note: samples are placed at equal steps of the accumulated area, the sum of the
/// areas of all previous triangles. Within triangles, samples are placed by a sequence of low
/// discrepancy, whose points are evenly distributed. The measures have much less noise than with
/// independent random samples.
///
/// Implementation note: the reference can be distributed over several processes. Each process then
/// has a part of the reference, and the whole model. The reference consists of all parts in the
/// order of the processes. The measures are equal on all processes, and have the same bits as with
/// a single process. If the reference has no triangles, the points stay on their processes.
/// Otherwise, the reference is copied to all processes.
///
/// @param[in] modelPoints  #V by 3
/// @param[in] modelTriangles  #F by 3, at least one
/// @param[in] referencePoints  #P by 3; all processes together have at least one point
/// @param[in] referenceTriangles  ids of reference points; may be empty
/// @param[in] reduce  function that combines values of all processes that hold parts of the
///   reference
/// @throws std::invalid_argument if the model has no triangles, or if the reference has no points
/// @throws std::invalid_argument if a coordinate is not finite
/// @throws std::invalid_argument if all reference points coincide, so that the unit is zero
/// @throws std::invalid_argument if a measure exceeds the range of doubles
/// @post the result depends only on the arguments of all processes, not on the number of threads
SurfaceMismatch measureSurfaceMismatch(const PointView& modelPoints,
  const Triangles& modelTriangles, const PointView& referencePoints,
  const Triangles& referenceTriangles, const SurfaceMismatchOptions& options = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif

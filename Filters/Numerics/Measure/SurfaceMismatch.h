/// Distances between a model surface and its reference in both directions, \cite Liou2008 and \cite
/// Cignoni1998.

#ifndef ConformalSurfaceMismatch_h
#define ConformalSurfaceMismatch_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Length used as the unit of the figures.
enum class MismatchUnit
{
  MaxRadius,    ///< maximum distance of a reference point from the centroid of all
  HalfDiagonal, ///< half the diagonal of the bounding box of the reference
  None          ///< the unit of the user
};

struct SurfaceMismatchOptions
{
  MismatchUnit LengthUnit = MismatchUnit::MaxRadius;
  double CoordinateUnit = 1.0; ///< length of 1 in the coordinates, in the unit of the user
  int NumberOfSamples = 60000; ///< samples of the surface of the model, spread evenly over its area
  int RandomSeed = 1;          ///< seed of the samples
};

/// Distance from the reference, in units of length, beyond which area of the model is web: a
/// spurious membrane across a gap of the object.
constexpr double WebDistance = 0.02;

/// Mismatch figures in units of LengthUnit; distances of points in the unit of the user.
struct SurfaceMismatch
{
  double LengthUnit = 1.0;               ///< unit of the figures, in the unit of the user
  double MeanSquarePointToSurface = 0.0; ///< E_mis, \cite Liou2008 section 4.1
  double MeanSquarePointToVertex = 0.0;  ///< to the nearest vertex of the model
  double MeanSquareSurfaceToPoint = 0.0; ///< samples of the model to the reference
  double HausdorffDistance = 0.0;        ///< maximum of both one-sided distances
  /// Share of the area of the model farther than WebDistance
  double WebFraction = 0.0;
  std::vector<double> ModelDistances;     ///< #V: model vertex to reference
  std::vector<double> ReferenceDistances; ///< #P: reference point to model surface
};

/// Measure the mismatch error E_mis = 1 / #P sum_x dist(x, M)^2 of a model M, \cite Liou2008
/// section 4.1. Also measure the reverse distances, since a model may pass through all data and yet
/// span gaps.
///
/// The nearest vertex is one used by triangles. If the reference has no triangles, distances to it
/// are distances to its nearest point. Every reference point counts as data, even without a
/// triangle. Maxima from the model are taken over its samples and vertices, so HausdorffDistance is
/// a lower bound of the exact distance.
///
/// Implementation note: samples step evenly through the area. A low-discrepancy sequence places
/// them in each triangle, with much less noise than independent samples.
///
/// Each rank has a part of the reference and the whole model. The figures describe the
/// concatenation of the parts and are equal on all ranks. They equal those of one process with all
/// parts bit by bit. Points of a reference without triangles stay distributed; a reference with
/// triangles is gathered on all ranks.
///
/// @param[in] modelPoints         #V by 3
/// @param[in] modelTriangles      #F by 3, at least one
/// @param[in] referencePoints     #P by 3, at least one on all ranks together
/// @param[in] referenceTriangles  may be empty
/// @param[in] reduce              sums over the ranks that hold the other parts
/// @throws std::invalid_argument if there is nothing to measure, a coordinate is not finite, or the
///   reference has no extent to define the unit
/// @throws std::overflow_error if a figure exceeds the range of doubles
/// @post the result depends only on the arguments of all ranks, not on threads
SurfaceMismatch measureSurfaceMismatch(const PointView& modelPoints,
  const Triangles& modelTriangles, const PointView& referencePoints,
  const Triangles& referenceTriangles, const SurfaceMismatchOptions& options = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif

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
/// section 4.1, and what it cannot see: a model may pass through all data and yet span gaps.
///
/// The nearest vertex is sought among those used by triangles. Where the reference has no
/// triangles, the distance to it is that to its nearest point. Every reference point counts as
/// data, also those of no triangle. From the model's side maxima are taken over its samples and
/// vertices, so that HausdorffDistance is a lower bound of the exact distance.
///
/// Implementation note: samples step evenly through the area and fill each triangle by a sequence
/// of low discrepancy, which leaves much less noise than independent ones.
///
/// Of several processes each has a part of the reference and all have all of the model. What the
/// parts are, one after the other, is measured: the figures are the same on all processes, to the
/// bit those of one process that has all. Points of a reference without triangles stay where they
/// are; one with triangles is gathered on all processes.
///
/// @param[in] modelPoints         #V by 3
/// @param[in] modelTriangles      #F by 3, at least one
/// @param[in] referencePoints     #P by 3, at least one on all processes together
/// @param[in] referenceTriangles  may be empty
/// @param[in] reduce              adds up over the processes that hold the other parts
/// @throws std::invalid_argument if there is nothing to measure, a coordinate is not finite, the
///   reference has no extent to take a unit from, or a figure leaves the range of doubles
/// @post the result depends only on the arguments of all processes, not on threads
SurfaceMismatch measureSurfaceMismatch(const PointView& modelPoints,
  const Triangles& modelTriangles, const PointView& referencePoints,
  const Triangles& referenceTriangles, const SurfaceMismatchOptions& options = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif

/// Conformal map of one triangle, prepared for many points, \cite Liou2008 Eqs. 4 and 5.

#ifndef ConformalTriangleMap_h
#define ConformalTriangleMap_h

#include "Base/Types.h"
#include "TriangleMap/HalfDiskSeries.h"
#include "TriangleMap/SchwarzChristoffel.h"

#include <array>

namespace conformal
{
/// Precomputed series of a corner, for shapes that many triangles have.
struct CornerTable
{
  static constexpr int InverseTerms = 24;
  std::array<double, halfdisk::MaximumTerms> Map{}; ///< as in CornerSeries
  std::array<double, InverseTerms> Inverse{}; ///< coefficients of log(s/W) in powers W^1, W^2, ...
  double Limit = 0.0; ///< maximum log |W| at which Inverse has full precision
};
using ShapeTable = std::array<CornerTable, 3>;

/// Position on an edge: the shares of its two ends, of sum 1, each to full precision.
struct EdgeShares
{
  double First = 0.0, Second = 0.0;
};

/// Point on the border of the half disk, relative to the nearer end of the edge of the triangle.
struct EdgePoint
{
  bool AtSecond = false; ///< whether the second end is at s = 0
  double S = 0.0;        ///< positive towards the second end, negative towards the first
  double LogS = 0.0;     ///< log |s|
};

/// TriangleShape that keeps its series from point to point. An edge is identified by its opposite
/// corner k: its first end is corner k + 1, its second end corner k + 2. Use it for triangles that
/// are not degenerate, and from one thread at a time.
class TriangleMap
{
public:
  TriangleMap() = default;
  explicit TriangleMap(const TriangleShape& shape);

  /// @param[in] shape     with the corners in the order of the triangle
  /// @param[in] table     of the shape, must outlive this object; may be null
  /// @param[in] rotation  corner k of the table is corner k + rotation of the triangle
  TriangleMap(const TriangleShape& shape, const ShapeTable* table, int rotation);

  /// Precompute the series of a shape. The cost equals that of mapping a few points without a
  /// table.
  static ShapeTable makeTable(const TriangleShape& shape);

  const TriangleShape& shape() const { return this->Shape; }

  /// Map a point as the functions of TriangleShape do.
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;
  Vector3 fromHalfDisk(const HalfDiskPoint& point);

  /// Map a point along an edge, in real arithmetic.
  EdgePoint toHalfDisk(int edge, const EdgeShares& shares);
  EdgeShares fromHalfDisk(int edge, const EdgePoint& point);

  /// Compute d log z / d log |s|, with z the distance from the nearer end.
  double logSlope(int edge, const EdgePoint& point);

  /// Compute the logarithm of the factor c in z = c (4 |s|)^a + ... Here z is the distance from an
  /// end, in units of the length of the edge.
  double logFactor(int edge, bool atSecond);

  static int corner(int edge, bool atSecond) { return atSecond ? previous(edge) : next(edge); }

private:
  static CornerTable makeTable(const TriangleShape& shape, int corner);
  struct Sums
  {
    double Map, Slope;
  };
  const double* mapSeries(int corner, int terms);
  Sums sums(int corner, double s, double logS);
  double logUniform(int edge, bool atSecond, double share);

  TriangleShape Shape;
  const ShapeTable* Table = nullptr;
  int Rotation = 0;
  bool HasLogarithms = false;         // computed at the first use of an edge
  std::array<double, 3> LogLeading{}; // of each corner
  std::array<double, 3> LogLengths{}; // of each edge
  std::array<halfdisk::CornerSeries, 3> Series;
};
}

#endif

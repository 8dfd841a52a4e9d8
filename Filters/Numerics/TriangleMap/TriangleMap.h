/// Conformal map of one triangle, prepared for many points, \cite Liou2008 Eqs. 4 and 5.

#ifndef ConformalTriangleMap_h
#define ConformalTriangleMap_h

#include "Base/Types.h"
#include "TriangleMap/HalfDiskSeries.h"
#include "TriangleMap/SchwarzChristoffel.h"

#include <array>

namespace conformal
{
/// Precomputed power series of a corner, for a shape that many triangles have.
struct CornerTable
{
  static constexpr int InverseTerms = 24;
  std::array<double, halfdisk::MaximumTerms> Map{}; ///< coefficients as in CornerSeries::Map
  std::array<double, InverseTerms> Inverse{};       ///< coefficients of W^1, W^2, ... in log(s/W)
  double Limit = 0.0; ///< maximum log |W| for which Inverse has full precision
};
using ShapeTable = std::array<CornerTable, 3>;

/// Position on an edge: the barycentric coordinates of its two ends, each to full precision. Their
/// sum is 1.
struct EdgeShares
{
  double First = 0.0, Second = 0.0;
};

/// Point on the border of the half disk, on an edge of the triangle. The nearer end of the edge is
/// at s = 0.
struct EdgePoint
{
  bool AtSecond = false; ///< whether the second end is at s = 0
  double S = 0.0; ///< coordinate s; positive towards the second end, negative towards the first end
  double LogS = 0.0; ///< log |s|
};

/// Conformal map of one TriangleShape that stores coefficients of its series for further points. An
/// edge is identified by its opposite corner k: its first end is corner k + 1, its second end
/// corner k + 2. The triangle must not be degenerate. Only one thread at a time may use this
/// object.
class TriangleMap
{
public:
  TriangleMap() = default;
  explicit TriangleMap(const TriangleShape& shape);

  /// @param[in] shape     shape of the triangle, with its corners in the triangle's order
  /// @param[in] table     table of the shape, must outlive this object; may be null
  /// @param[in] rotation  corner k of the table is corner k + rotation of the triangle
  TriangleMap(const TriangleShape& shape, const ShapeTable* table, int rotation);

  /// Precompute the series of a shape. The computation costs as much as mapping a few points
  /// without a table.
  static ShapeTable makeTable(const TriangleShape& shape);

  const TriangleShape& shape() const { return this->Shape; }

  /// Map a point to or from the half disk, as TriangleShape does.
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;
  Vector3 fromHalfDisk(const HalfDiskPoint& point);

  /// Map a point of an edge to or from the half disk, in real arithmetic.
  EdgePoint toHalfDisk(int edge, const EdgeShares& shares);
  EdgeShares fromHalfDisk(int edge, const EdgePoint& point);

  /// Compute the derivative d log z / d log |s|, where z is the distance from the nearer end of the
  /// edge.
  double logSlope(int edge, const EdgePoint& point);

  /// Compute log c, where z = c (4 |s|)^a + ... is the expansion of the map near an end of the
  /// edge. Here z is the distance from this end, in units of the length of the edge.
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
  // Whether LogLeading and LogLengths are set; they are computed when an edge is first used
  bool HasLogarithms = false;
  std::array<double, 3> LogLeading{}; // for each corner
  std::array<double, 3> LogLengths{}; // for each edge
  std::array<halfdisk::CornerSeries, 3> Series;
};
}

#endif

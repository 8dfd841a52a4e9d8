/// Map many points of one triangle conformally, \cite Liou2008 Eqs. 4 and 5. The half disk to which
/// triangles are mapped is defined at the beginning of SchwarzChristoffel.h.

#ifndef ConformalTriangleMap_h
#define ConformalTriangleMap_h

#include "Base/Types.h"
#include "TriangleMap/HalfDiskSeries.h"
#include "TriangleMap/SchwarzChristoffel.h"

#include <array>

namespace conformal
{
/// Precomputed power series at one corner of a shape that many triangles have.
struct CornerTable
{
  static constexpr int InverseTerms = 24;
  std::array<double, halfdisk::MaximumTerms> Map{}; ///< coefficients as in CornerSeries::Map
  /// Coefficients of W^1, W^2, ... in log(s/W), with W as in CornerSeries::guess()
  std::array<double, InverseTerms> Inverse{};
  double Limit = 0.0; ///< maximum log |W| for which Inverse has full precision
};
using ShapeTable = std::array<CornerTable, 3>;

/// Position on an edge: the two barycentric coordinates of the ends of the edge, each to full
/// precision. The sum of both coordinates is 1.
struct EdgeShares
{
  double First = 0.0, Second = 0.0;
};

/// Point of the half disk that is the image of a point on an edge of the triangle. The nearer end
/// of the edge is at s = 0.
struct EdgePoint
{
  bool AtSecond = false; ///< whether the second end is at s = 0
  /// Coordinate s; positive if the first end is at s = 0, negative if the second end is
  double S = 0.0;
  double LogS = 0.0; ///< log |s|
};

/// Conformal map of one TriangleShape that stores the coefficients of its series for further
/// points. An edge is identified by its opposite corner k. The first end of the edge is corner k +
/// 1 (mod 3). The second end is corner k + 2 (mod 3). The triangle must not be degenerate. Only one
/// thread at a time may use this object.
class TriangleMap
{
public:
  TriangleMap() = default;
  explicit TriangleMap(const TriangleShape& shape);

  /// @param[in] shape     shape of the triangle, with corners in the sequence of the triangle's
  ///   vertices
  /// @param[in] table     table of the shape; must outlive this object. May be null.
  /// @param[in] rotation  corner k of the table is corner k + rotation (mod 3) of the triangle
  TriangleMap(const TriangleShape& shape, const ShapeTable* table, int rotation);

  /// Compute the table of a shape. The cost is that of mapping a few points without a table.
  static ShapeTable makeTable(const TriangleShape& shape);

  const TriangleShape& shape() const { return this->Shape; }

  /// Map a point to or from the half disk, with the same result as TriangleShape::toHalfDisk() and
  /// TriangleShape::fromHalfDisk().
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;
  Vector3 fromHalfDisk(const HalfDiskPoint& point);

  /// Map a point of an edge to or from the half disk. These functions need only real arithmetic.
  EdgePoint toHalfDisk(int edge, const EdgeShares& shares);
  EdgeShares fromHalfDisk(int edge, const EdgePoint& point);

  /// Compute the derivative d log z / d log |s| at a point of an edge. Here z is the distance of
  /// the point from the nearer end of the edge.
  double logSlope(int edge, const EdgePoint& point);

  /// Compute log c, where c is the leading coefficient of the map near an end of an edge. The map
  /// is z = c (4 |s|)^a + ... Here z is the distance from this end, in units of the length of the
  /// edge. The exponent a is the angle at this end, in units of pi.
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
  // whether LogLeading and LogLengths are computed, at the first call for an edge
  bool HasLogarithms = false;
  std::array<double, 3> LogLeading{}; // logarithm of the factor k/a of the series at each corner
  std::array<double, 3> LogLengths{}; // logarithm of the length of each edge
  std::array<halfdisk::CornerSeries, 3> Series;
};
}

#endif

/// Map many points of one triangle conformally, \cite Liou2008 Eqs. 4 and 5. Triangles are mapped
/// to the upper half of the unit disk. The complex coordinate s of this half disk is defined at the
/// beginning of SchwarzChristoffel.h.

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
  /// Coefficients of the power series of log(s/W) in W, from W^1 on; for W, see
  /// CornerSeries::guess()
  std::array<double, InverseTerms> Inverse{};
  double Limit = 0.0; ///< maximum log |W| for which Inverse has full precision
};
using ShapeTable = std::array<CornerTable, 3>;

/// Position on an edge: the barycentric coordinates that belong to the two ends of the edge, each
/// to full precision. The two coordinates have the sum 1.
struct EdgeShares
{
  double First = 0.0, Second = 0.0;
};

/// Point of the half disk that is the image of a point on an edge of the triangle. The edge is
/// mapped to the diameter, where s is real. The end of the edge nearer to the point is mapped to
/// s = 0.
struct EdgePoint
{
  bool AtSecond = false; ///< whether the second end of the edge (see TriangleMap) is at s = 0
  /// Coordinate s; positive if the first end is at s = 0, negative if the second end is
  double S = 0.0;
  double LogS = 0.0; ///< log |s|
};

/// Conformal map of one TriangleShape. The coefficients of its power series are computed once, and
/// reused for all further points. An edge is identified by its opposite corner k. The first end of
/// the edge is corner k + 1 (mod 3). The second end is corner k + 2 (mod 3). The triangle must not
/// be degenerate. Only one thread at a time may use this object.
class TriangleMap
{
public:
  TriangleMap() = default;
  explicit TriangleMap(const TriangleShape& shape);

  /// @param[in] shape     shape of the triangle, with corners in the sequence of the triangle's
  ///   vertices
  /// @param[in] table     table of the shape, or null; must outlive this object
  /// @param[in] rotation  corner k of the table is corner k + rotation (mod 3) of the triangle
  TriangleMap(const TriangleShape& shape, const ShapeTable* table, int rotation);

  /// Compute the table of a shape. Computing a table costs about as much as mapping a few points
  /// without a table.
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
  // whether LogLeading and LogLengths are already computed; the first call for an edge computes
  // them
  bool HasLogarithms = false;
  // Logarithm of the factor k/a of CornerSeries at each corner (constant k, angle a of the corner)
  std::array<double, 3> LogLeading{};
  std::array<double, 3> LogLengths{}; // logarithm of the length of each edge
  std::array<halfdisk::CornerSeries, 3> Series;
};
}

#endif

/// Conformal map of one triangle, prepared for many points.

#ifndef ConformalTriangleMap_h
#define ConformalTriangleMap_h

#include "Base/Types.h"
#include "TriangleMap/HalfDiskSeries.h"
#include "TriangleMap/SchwarzChristoffel.h"

#include <array>

namespace conformal
{
/// The series of a corner worked out beforehand, for shapes that many triangles have.
struct CornerTable
{
  static constexpr int InverseTerms = 24;
  std::array<double, halfdisk::MaximumTerms> Map{}; ///< as in CornerSeries
  std::array<double, InverseTerms> Inverse{};       ///< of log(s/W) in powers W^1, W^2, ...
  double Limit = 0.0;                               ///< log |W| up to which Inverse has all digits
};
using ShapeTable = std::array<CornerTable, 3>;

/// A place on an edge: the shares of its two ends, of sum 1, each to its last digit.
struct EdgeShares
{
  double First = 0.0, Second = 0.0;
};

/// A place on the border of the half disk, as the nearer end of the triangle's edge sees it.
struct EdgePoint
{
  bool AtSecond = false; ///< which end is at s = 0
  double S = 0.0;        ///< positive towards the second end, negative towards the first
  double LogS = 0.0;     ///< log |s|
};

/// A TriangleShape that keeps its series from point to point. An edge is named by the corner k
/// opposite, its first end is corner k + 1 and its second corner k + 2. Only for triangles that are
/// not degenerate, and for one thread at a time.
class TriangleMap
{
public:
  TriangleMap() = default;
  explicit TriangleMap(const TriangleShape& shape);

  /// @param[in] shape     in the triangle's own order of the corners
  /// @param[in] table     of its shape, must outlive this; may be null
  /// @param[in] rotation  corner k of the table is corner k + rotation of the triangle
  TriangleMap(const TriangleShape& shape, const ShapeTable* table, int rotation);

  /// Worth it for more than a few triangles: it takes as long as mapping a few points without.
  static ShapeTable makeTable(const TriangleShape& shape);

  const TriangleShape& shape() const { return this->Shape; }

  /// As TriangleShape's functions.
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;
  Vector3 fromHalfDisk(const HalfDiskPoint& point);

  /// The same along an edge, in real numbers.
  EdgePoint toHalfDisk(int edge, const EdgeShares& shares);
  EdgeShares fromHalfDisk(int edge, const EdgePoint& point);

  /// d log z / d log |s| of the distance z from the nearer end.
  double logSlope(int edge, const EdgePoint& point);

  /// Logarithm of the factor c in z = c (4 |s|)^a + ..., z being the distance from an end as a
  /// share of the edge.
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
  bool HasLogarithms = false;         // worked out when an edge asks first
  std::array<double, 3> LogLeading{}; // of a corner
  std::array<double, 3> LogLengths{}; // of an edge
  std::array<halfdisk::CornerSeries, 3> Series;
};
}

#endif

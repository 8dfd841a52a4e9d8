/// Conformal maps between triangles, vertices to vertices, \cite Liou2008 Eqs. 4 and 5.
///
/// A point passes through a half disk common to all triangles: any triangle -> half disk -> any
/// other. Barycentric coordinates go in and come out, so that no planes are needed.
///
/// Implementation note: the paper integrates over the whole unit disk. Three prevertices may lie
/// anywhere on its border, so the disk is replaced by its image that has most to give: the upper
/// half of the unit disk |s| <= 1, Im s >= 0, one corner of the triangle at s = 0, the next at 1,
/// the previous at -1, the edge opposite on the half circle. With the angles a, b, c of these
/// corners in units of pi, Eqs. 4 and 5 become
///     dz/ds = k 4^a s^(a-1) (1-s)^(2b-1) (1+s)^(2c-1),   k = pi D / (Gamma(a) Gamma(b) Gamma(c)),
/// D being the diameter of the circumcircle; the factor 1 + s^2 cancels since a + b + c = 1.
/// Nothing is left to be solved for, all coefficients are real, and of the three corners there is
/// always one that sees a point at |s| <= 2 - sqrt(3): 30 terms of a power series give all digits
/// of a double, whatever the shape of the triangle.

#ifndef ConformalSchwarzChristoffel_h
#define ConformalSchwarzChristoffel_h

#include "Parallel.h"
#include "Types.h"

#include <array>
#include <complex>
#include <vector>

namespace conformal
{
/// A point of the half disk, as one corner of the triangle sees it.
struct HalfDiskPoint
{
  int Corner = 0;            ///< at s = 0; the next corner is at 1, the previous at -1
  std::complex<double> S;    ///< s, near enough to 0 for the series: |s| < 1/3
  std::complex<double> LogS; ///< log s, imaginary part in [0, pi], exactly 0 or pi on edges
};

/// A triangle up to similarity, and its conformal map to and from the half disk.
class TriangleShape
{
public:
  /// No shape: degenerate.
  TriangleShape() = default;

  /// Vertices in any plane, any unit.
  TriangleShape(const Vector3& p0, const Vector3& p1, const Vector3& p2);

  /// The angles are too small for a map (under 1e-9), or a coordinate is not finite.
  bool degenerate() const { return this->Degenerate; }

  /// Interior angles in units of pi.
  const std::array<double, 3>& angles() const { return this->Angles; }

  /// Triangle to half disk, by Newton's method on a univalent function. About 0.4 us.
  /// @param[in] barycentric  of sum 1; what is negative counts as 0
  /// @pre not degenerate
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;

  /// Half disk to triangle, by the series of the point's corner. About 0.1 us.
  /// @return barycentric coordinates, none negative; exactly 0 where an edge says so
  /// @pre not degenerate
  Vector3 fromHalfDisk(const HalfDiskPoint& point) const;

  /// dz/ds in the plane that has the point's corner at 0, the next corner on the positive real
  /// axis and the circumcircle's diameter as unit. The derivative of a map between two triangles
  /// is the quotient of theirs. Infinite at s = 0.
  /// @pre not degenerate
  std::complex<double> derivative(const HalfDiskPoint& point) const;

private:
  friend class NetworkShapes;

  double leading(int corner) const { return this->Scale / this->Angles[corner]; }
  std::complex<double> logUniform(int corner, const Vector3& barycentric) const;
  int corner(const Vector3& barycentric, std::complex<double>& logUniform) const;
  HalfDiskPoint solve(
    int corner, std::complex<double> logUniform, const Vector3& barycentric) const;
  Vector3 place(const HalfDiskPoint& point, std::complex<double> series) const;

  std::array<double, 3> Angles{}; // units of pi
  std::array<double, 3> Sines{}; // also the length of the edge opposite, diameter of circumcircle 1
  std::array<double, 3> Cosines{};
  double Scale = 0.0; // k of the comment at the top
  bool Degenerate = true;
};

/// The triangles of a fixed network, those of one shape sharing tables of their map.
///
/// A geodesic sphere of frequency 36 has 25,920 triangles but 156 shapes (312 with their mirror
/// images). A shape that few triangles have is mapped without tables, so that a mesh without any
/// symmetry costs no memory.
class NetworkShapes
{
public:
  NetworkShapes() = default;

  /// @param[in] positions  #N by 3
  /// @param[in] faces      #R by 3 ids of positions
  NetworkShapes(
    const Points& positions, const Triangles& faces, const ParallelFor& parallelFor = {});

  /// How many shapes have tables.
  Index numberOfTables() const { return static_cast<Index>(this->Tables.size()); }

  /// Network triangle to model triangle, \cite Liou2008 Eq. 10: barycentric coordinates of p' to
  /// those of q'. Affine (returned as they are) if one of the triangles is degenerate.
  Vector3 toModel(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  /// Model triangle to network triangle, z' = f_2(f_1^-1(z)) below \cite Liou2008 Eq. 5.
  Vector3 toNetwork(Index triangle, const TriangleShape& model, const Vector3& barycentric) const;

  bool degenerate(Index triangle) const
  {
    return this->Shapes[this->Uses[triangle].Shape].degenerate();
  }

private:
  // The series of a corner: of the map from the half disk, and of its inverse.
  static constexpr int Terms = 36;
  static constexpr int InverseTerms = 24;
  struct CornerTable
  {
    std::array<double, Terms> Series{};         // coefficients of s^1, s^2, ...
    std::array<double, InverseTerms> Inverse{}; // of log(s/W) in powers W^1, W^2, ...
    double Limit = 0.0;                         // log |W| up to which Inverse has all digits
  };
  struct Use
  {
    int Shape = 0;
    int Rotation = 0; // vertex k of the shape is vertex k + Rotation of the triangle
  };

  static CornerTable makeCornerTable(const TriangleShape& shape, int corner);
  HalfDiskPoint toHalfDisk(Index triangle, const Vector3& barycentric) const;
  Vector3 fromHalfDisk(Index triangle, const HalfDiskPoint& point) const;

  std::vector<Use> Uses;
  std::vector<TriangleShape> Shapes;
  std::vector<int> TableOfShape; // or -1
  std::vector<std::array<CornerTable, 3>> Tables;
};
}

#endif

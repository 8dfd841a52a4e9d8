/// Encode the numbers of a web page (SurfacePage.h) as integer codes of few bytes, which compress
/// well. The script of the page decodes the codes.

#ifndef ConformalPageNumbers_h
#define ConformalPageNumbers_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace conformal
{
/// Minimum and maximum of numbers, both of them finite.
struct PageRange
{
  double Low = 0.0;
  double High = 0.0;
};

/// Compute the minimum and maximum of the finite numbers. If no number is finite, the result is (0,
/// 0).
PageRange rangeOf(const std::vector<double>& values);

/// Encode a number as an integer from 0 (for range.Low) to `steps` (for range.High), rounded to the
/// nearest code.
/// @param[in] value  number in the range
std::uint32_t codeOf(double value, const PageRange& range, std::uint32_t steps);

/// Decode a code to a number. The number is exactly range.Low for code 0, and exactly range.High
/// for code `steps`.
double valueOfCode(std::uint32_t code, const PageRange& range, std::uint32_t steps);

constexpr std::uint32_t PositionSteps = 65535; ///< `steps` of each coordinate of a position

/// Encode the direction of a nonzero vector as two codes from 0 to PositionSteps. The vector is
/// projected to the octahedron |x| + |y| + |z| = 1. The lower half (z < 0) of the octahedron is
/// folded outward, so that the octahedron becomes a square. The codes are the two coordinates in
/// this square, from 0 to PositionSteps.
std::array<std::uint32_t, 2> octahedralCode(double x, double y, double z);

/// Decode two codes of octahedralCode() to a unit vector. The vector differs from the encoded
/// direction by less than 1e-4 (0.006 degrees).
std::array<double, 3> octahedralDirection(const std::array<std::uint32_t, 2>& code);

/// Append codes as bytes. Each code is replaced by its difference from the previous code, modulo
/// 256^width. The sign of the difference becomes the lowest bit. The lowest bytes of all
/// differences are written first, then the next bytes.
/// @param[in] width  number of bytes of a code: 1, 2 or 4
void appendCodes(std::string& bytes, const std::vector<std::uint32_t>& codes, std::size_t width);

/// Return the Morton code of a position in the square of octahedralCode(). The bits of both codes
/// alternate in the result. If positions are sorted by their Morton codes, most consecutive
/// positions are close to each other.
std::uint32_t mortonCode(const std::array<std::uint32_t, 2>& code);
}

#endif

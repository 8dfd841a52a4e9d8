/// Numbers in the encoding of a page: integer codes of few bytes, in an order that compresses well.
/// The script decodes them.

#ifndef ConformalPageNumbers_h
#define ConformalPageNumbers_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace conformal
{
/// Minimum and maximum of numbers, both finite.
struct PageRange
{
  double Low = 0.0;
  double High = 0.0;
};

/// Compute the range of the finite numbers; (0, 0) if there are none.
PageRange rangeOf(const std::vector<double>& values);

/// Return the nearest of the codes 0 to steps, which divide the range evenly.
/// @param[in] value  in the range
std::uint32_t codeOf(double value, const PageRange& range, std::uint32_t steps);

/// Return the number of a code: exactly Low for 0 and High for steps.
double valueOfCode(std::uint32_t code, const PageRange& range, std::uint32_t steps);

constexpr std::uint32_t PositionSteps = 65535; ///< for each coordinate of a position

/// Encode a direction of any nonzero length as two codes of 0 to PositionSteps. The code is a
/// position on the octahedron |x| + |y| + |z| = 1 with its lower half folded outward.
std::array<std::uint32_t, 2> octahedralCode(double x, double y, double z);

/// Decode two codes to a unit vector, within 1e-4 of the direction.
std::array<double, 3> octahedralDirection(const std::array<std::uint32_t, 2>& code);

/// Append codes as differences from the previous code, modulo the range of the width, with the sign
/// as the lowest bit. The lowest bytes of all codes come first, then the next ones.
/// @param[in] width  bytes of a code: 1, 2 or 4
void appendCodes(std::string& bytes, const std::vector<std::uint32_t>& codes, std::size_t width);

/// Return the position in an order of the square with close neighbors (Morton order): the
/// alternating bits of both codes.
std::uint32_t mortonCode(const std::array<std::uint32_t, 2>& code);
}

#endif

/// Numbers as a page has them: whole codes of few bytes, in an order that compresses well. The
/// script reads them.

#ifndef ConformalPageNumbers_h
#define ConformalPageNumbers_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace conformal
{
/// Smallest and largest of some numbers, both finite.
struct PageRange
{
  double Low = 0.0;
  double High = 0.0;
};

/// The range of those numbers that are finite; (0, 0) if there are none.
PageRange rangeOf(const std::vector<double>& values);

/// The nearest of the codes 0 to steps, which divide the range evenly.
/// @param[in] value  in the range
std::uint32_t codeOf(double value, const PageRange& range, std::uint32_t steps);

/// The number that a code stands for: exactly Low for 0 and High for steps.
double valueOfCode(std::uint32_t code, const PageRange& range, std::uint32_t steps);

constexpr std::uint32_t PositionSteps = 65535; ///< of each coordinate of a position

/// A direction of any length but 0 as two codes of 0 to PositionSteps, on the octahedron
/// |x| + |y| + |z| = 1 whose lower half is folded outwards.
std::array<std::uint32_t, 2> octahedralCode(double x, double y, double z);

/// The unit vector of such codes; within 1e-4 of the direction.
std::array<double, 3> octahedralDirection(const std::array<std::uint32_t, 2>& code);

/// Append codes, each as its difference from the one before, modulo what the width holds, with the
/// sign as the lowest bit; first the lowest bytes of all of them, then the next ones.
/// @param[in] width  bytes of a code: 1, 2 or 4
void appendCodes(std::string& bytes, const std::vector<std::uint32_t>& codes, std::size_t width);

/// A place in an order of the square in which neighbors are near: the bits of both codes in turn.
std::uint32_t mortonCode(const std::array<std::uint32_t, 2>& code);
}

#endif

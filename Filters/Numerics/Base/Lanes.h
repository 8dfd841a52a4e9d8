/// Define vectors of 8 floats and of 4 doubles for SIMD instructions. A lane is one element of a
/// vector.

#ifndef ConformalLanes_h
#define ConformalLanes_h

namespace conformal
{
/// Vector types of GCC and Clang. Operators + - * < ?: act on each element separately. Results have
/// the same bits with every SIMD instruction set. Vectors need only the alignment of their
/// elements. Use these types only in loops that compilers do not vectorize automatically.
using Floats = float __attribute__((vector_size(32), aligned(4)));
using Doubles = double __attribute__((vector_size(32), aligned(8)));
constexpr int FloatLanes = 8;
constexpr int DoubleLanes = 4;
}

#endif

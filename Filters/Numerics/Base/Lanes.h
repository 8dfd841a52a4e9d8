/// Small fixed-size vectors for SIMD units.

#ifndef ConformalLanes_h
#define ConformalLanes_h

namespace conformal
{
/// GCC's and Clang's vectors: + - * < ?: work lane by lane, on whatever units there are, and give
/// the same bits on all of them. They may lie anywhere in memory. Used in the few loops that a
/// compiler does not see through.
using Floats = float __attribute__((vector_size(32), aligned(4)));
using Doubles = double __attribute__((vector_size(32), aligned(8)));
constexpr int FloatLanes = 8;
constexpr int DoubleLanes = 4;
}

#endif

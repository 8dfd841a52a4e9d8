/// Small fixed-size vectors for SIMD units.

#ifndef ConformalLanes_h
#define ConformalLanes_h

namespace conformal
{
/// Vector types of GCC and Clang. Operators + - * < ?: act on each element separately, with the
/// same bits on every SIMD unit. Vectors need only the alignment of their elements. They serve in
/// the few loops that compilers do not vectorize automatically.
using Floats = float __attribute__((vector_size(32), aligned(4)));
using Doubles = double __attribute__((vector_size(32), aligned(8)));
constexpr int FloatLanes = 8;
constexpr int DoubleLanes = 4;
}

#endif

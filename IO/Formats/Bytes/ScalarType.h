/// Define the types of numbers in files.

#ifndef ConformalScalarType_h
#define ConformalScalarType_h

#include <cstddef>
#include <cstdint>
#include <utility>

namespace conformal
{
enum class ScalarType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64,
  Int64,
  UInt64
};

/// Call f with a zero of the C++ type that corresponds to a ScalarType. If f is a generic lambda,
/// the compiler deduces the C++ type from this zero.
template <typename Function>
decltype(auto) withType(ScalarType type, Function&& f)
{
  switch (type)
  {
    case ScalarType::Int8:
      return f(std::int8_t());
    case ScalarType::UInt8:
      return f(std::uint8_t());
    case ScalarType::Int16:
      return f(std::int16_t());
    case ScalarType::UInt16:
      return f(std::uint16_t());
    case ScalarType::Int32:
      return f(std::int32_t());
    case ScalarType::UInt32:
      return f(std::uint32_t());
    case ScalarType::Float32:
      return f(float());
    case ScalarType::Int64:
      return f(std::int64_t());
    case ScalarType::UInt64:
      return f(std::uint64_t());
    case ScalarType::Float64:
      break;
  }
  return f(double());
}

inline std::size_t sizeOf(ScalarType type)
{
  return withType(type, [](auto zero) { return sizeof(zero); });
}

inline bool isFloating(ScalarType type)
{
  return type == ScalarType::Float32 || type == ScalarType::Float64;
}

inline bool isByte(ScalarType type)
{
  return type == ScalarType::UInt8;
}
}

#endif

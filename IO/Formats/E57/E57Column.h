/// Decode the values of one field of the points of an E57 scan.

#ifndef ConformalE57Column_h
#define ConformalE57Column_h

#include "Bytes/NamedArray.h"
#include "E57/E57Description.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace conformal
{
enum class E57Store
{
  Value, ///< convert the value to the type of the array
  Flag,  ///< store 1 unless the value is 0; the array is UInt8
  Color  ///< map the values between two limits to 0 to 255; the array is UInt8
};

/// Destination of the values of a field: a component of the tuples of an array.
struct E57Target
{
  NamedArray* Array = nullptr; ///< large enough for all points; null if the values are not used
  std::size_t Component = 0;
  std::size_t FirstTuple = 0;
  E57Store Store = E57Store::Value;
  double Low = 0.0;    ///< value of a color that becomes 0
  double High = 255.0; ///< value of a color that becomes 255
};

/// Decoder of the byte stream of a field, which is divided among the data packets of a section at
/// any byte. Integers need bits() bits each, beginning with the least significant bit of the first
/// byte. The numbers of the file are these bits plus Minimum. Source: ASTM E2807-11, section 9.
class E57Column
{
public:
  E57Column(const E57Field& field, const E57Target& target, std::size_t numberOfPoints);

  /// Test whether the values of all points were decoded.
  bool isDone() const { return this->Done == this->Count; }

  /// Decode the next bytes of the stream.
  /// @throws std::invalid_argument if an integer is above the maximum of the field, or if bytes
  ///   follow the last value, apart from the padding of at most 8 bytes
  void add(std::string_view bytes);

private:
  void addIntegers(std::size_t count);
  template <typename Value>
  void store(std::size_t count, Value value);

  const E57Field Field;
  const E57Target Target;
  const std::size_t Count;
  const std::size_t Bits;
  std::size_t Done = 0;     ///< number of decoded values
  std::vector<char> Bytes;  ///< bytes that are not yet decoded, and padding
  std::size_t FirstBit = 0; ///< bit of the first byte at which the next value begins
  std::size_t Excess = 0;   ///< number of bytes after the last value
};
}

#endif

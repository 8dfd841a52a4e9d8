#include "E57/E57Column.h"

#include "Bytes/ByteOrder.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr std::size_t WordBytes = 8;

// Return the bits of a stream from the given bit on, as many as the mask has. The stream must
// contain 9 bytes from there on.
std::uint64_t bitsAt(const char* bytes, std::uint64_t bit, std::uint64_t mask)
{
  const char* first = bytes + bit / 8;
  const unsigned shift = bit % 8;
  std::uint64_t word = littleEndianAt<std::uint64_t>(first) >> shift;
  if (shift > 0)
  {
    word |= std::uint64_t(static_cast<unsigned char>(first[WordBytes])) << (64 - shift);
  }
  return word & mask;
}

std::uint8_t colorByte(double value, double low, double high)
{
  const double scaled = (value - low) / (high - low) * 255.0 + 0.5;
  return scaled >= 255.0 ? 255 : scaled > 0.0 ? static_cast<std::uint8_t>(scaled) : 0;
}
}

//------------------------------------------------------------------------------
E57Column::E57Column(const E57Field& field, const E57Target& target, std::size_t numberOfPoints)
  : Field(field)
  , Target(target)
  , Count(numberOfPoints)
  , Bits(field.bits())
{
  if (!this->Target.Array)
  {
    this->Done = this->Count;
  }
  else if (this->Bits == 0) // values that the file does not contain, since all are equal
  {
    this->addIntegers(this->Count);
  }
}

//------------------------------------------------------------------------------
void E57Column::add(std::string_view bytes)
{
  if (!this->Target.Array)
  {
    return;
  }
  if (this->isDone())
  {
    this->Excess += bytes.size();
  }
  else
  {
    this->Bytes.insert(this->Bytes.end(), bytes.begin(), bytes.end());
    const std::size_t size = this->Bytes.size();
    const std::size_t count =
      std::min(this->Count - this->Done, (8 * size - this->FirstBit) / this->Bits);
    this->Bytes.resize(size + WordBytes + 1); // so that words can be read at the end
    const char* const data = this->Bytes.data();
    if (this->Field.isInteger())
    {
      this->addIntegers(count);
    }
    else if (this->Field.Kind == E57Kind::Float32)
    {
      this->store(count, [data](std::size_t i) { return littleEndianAt<float>(data + 4 * i); });
    }
    else
    {
      this->store(count, [data](std::size_t i) { return littleEndianAt<double>(data + 8 * i); });
    }
    const std::size_t decoded = this->FirstBit + count * this->Bits;
    this->FirstBit = decoded % 8;
    this->Bytes.resize(size);
    this->Bytes.erase(
      this->Bytes.begin(), this->Bytes.begin() + static_cast<std::ptrdiff_t>(decoded / 8));
    this->Excess = this->isDone() ? this->Bytes.size() : 0;
  }
  if (this->Excess > WordBytes)
  {
    throw std::invalid_argument("found more values of " + this->Field.Name + " than the " +
      std::to_string(this->Count) + " of recordCount");
  }
}

//------------------------------------------------------------------------------
void E57Column::addIntegers(std::size_t count)
{
  const std::uint64_t range = this->Field.range();
  const auto minimum = static_cast<std::uint64_t>(this->Field.Minimum);
  const std::uint64_t mask =
    this->Bits == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << this->Bits) - 1;
  const char* const data = this->Bytes.data();
  const std::uint64_t bits = this->Bits;
  const std::uint64_t firstBit = this->FirstBit;
  std::uint64_t largest = 0;
  const auto next = [=, &largest](std::size_t i)
  {
    const std::uint64_t stored = bits > 0 ? bitsAt(data, firstBit + i * bits, mask) : 0;
    largest = std::max(largest, stored);
    return static_cast<std::int64_t>(minimum + std::min(stored, range));
  };
  if (this->Field.Kind == E57Kind::Integer)
  {
    this->store(count, next);
  }
  else
  {
    const double scale = this->Field.Scale;
    const double offset = this->Field.Offset;
    this->store(
      count, [=](std::size_t i) { return static_cast<double>(next(i)) * scale + offset; });
  }
  if (largest > range)
  {
    throw std::invalid_argument(
      "found a value of " + this->Field.Name + " that is above its maximum");
  }
}

//------------------------------------------------------------------------------
template <typename Value>
void E57Column::store(std::size_t count, Value value)
{
  NamedArray& array = *this->Target.Array;
  const std::size_t stride = array.tupleBytes();
  unsigned char* to = array.Values.data() + (this->Target.FirstTuple + this->Done) * stride +
    this->Target.Component * sizeOf(array.Type);
  this->Done += count;
  if (this->Target.Store == E57Store::Flag)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i * stride] = value(i) != 0 ? 1 : 0;
    }
    return;
  }
  if (this->Target.Store == E57Store::Color)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i * stride] =
        colorByte(static_cast<double>(value(i)), this->Target.Low, this->Target.High);
    }
    return;
  }
  withType(array.Type,
    [&](auto zero)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto converted = static_cast<decltype(zero)>(value(i));
        std::memcpy(to + i * stride, &converted, sizeof(converted));
      }
    });
}
}

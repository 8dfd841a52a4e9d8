// Make the bytes of files for tests of parsers.
#ifndef MadeBytes_h
#define MadeBytes_h

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace samples
{
inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
  return text;
}

// Builder of bytes. Numbers are big-endian or little-endian.
class Bytes
{
public:
  explicit Bytes(bool isBig, std::string start = {})
    : IsBig(isBig)
    , Made(std::move(start))
  {
  }
  template <typename T>
  Bytes& add(T value)
  {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    const std::uint16_t one = 1;
    char first = 0;
    std::memcpy(&first, &one, 1);
    if (this->IsBig == (first == 1))
    {
      std::reverse(bytes, bytes + sizeof(T));
    }
    this->Made.append(bytes, sizeof(T));
    return *this;
  }
  template <typename T>
  Bytes& add(const std::vector<T>& values)
  {
    for (const T value : values)
    {
      this->add(value);
    }
    return *this;
  }
  Bytes& text(const std::string& text)
  {
    this->Made += text;
    return *this;
  }
  const std::string& bytes() const { return this->Made; }

private:
  bool IsBig;
  std::string Made;
};
}

#endif

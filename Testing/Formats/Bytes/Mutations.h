// Change the bytes of a file at random.
#ifndef Mutations_h
#define Mutations_h

#include <algorithm>
#include <iterator>
#include <random>
#include <string>

namespace samples
{
/// Return the bytes after one to three random changes. Equal seeds cause equal changes.
inline std::string Mutated(std::string bytes, std::uint32_t seed)
{
  // Numbers and words that often cause errors of parsers.
  static const char* const words[] = { "-1", "0", "4294967295", "18446744073709551615", "nan",
    "1e999", "x", "3", "255", "list", "double", "face", "tristrips", "BINARY", "\n", "\r", "\t",
    "\xFF\xFF\xFF\xFF", "\x7F\xFF\xFF\xFF", "1e-400", ",", ";", "#", "{", ")" };
  std::mt19937 random(seed);
  const auto below = [&](std::size_t count) { return random() % std::max<std::size_t>(1, count); };
  const std::size_t changes = 1 + below(3);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i)
  {
    // A small file may consist mostly of its header. Every second change is therefore in the second
    // half of the file.
    const std::size_t begin = below(2) == 0 ? 0 : bytes.size() / 2;
    const std::size_t at = begin + below(bytes.size() - begin);
    switch (below(10))
    {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(random());
        break;
      case 2:
        bytes.erase(at, 1 + below(9));
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(30)));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        bytes.insert(at, words[below(std::size(words))]);
        break;
      case 6:
        bytes.insert(at, below(50) == 0 ? (1 << 20) : 1 + below(3000), bytes[at]);
        break;
      case 7: // replace a number of four bytes
        bytes.replace(at, 4, { '\0', static_cast<char>(random()), '\0', '\1' });
        break;
      default: // replace a word by another word
      {
        const std::size_t word = std::min(bytes.find_first_of(" \n", at), bytes.size() - 1) + 1;
        const std::size_t end = std::min(bytes.find_first_of(" \n", word), bytes.size());
        bytes.replace(word, end - word, words[below(std::size(words))]);
      }
    }
  }
  return bytes;
}
}

#endif

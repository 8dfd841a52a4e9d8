/// Read the numbers after the header of a file, which are stored as bytes or as text.

#ifndef ConformalFileValues_h
#define ConformalFileValues_h

#include "Bytes/ByteReader.h"
#include "Bytes/NumberText.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/ScalarType.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace conformal
{
/// Read numbers that are stored as bytes, in the byte order of this machine or in the opposite
/// order.
class BinaryValues
{
public:
  BinaryValues(ByteReader& input, bool swap)
    : Input(input)
    , Swap(swap)
  {
  }

  template <typename T>
  T next()
  {
    const std::string_view bytes = this->Input.peek(sizeof(T));
    if (bytes.size() < sizeof(T))
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends inside a record");
    }
    char copy[sizeof(T)];
    std::memcpy(copy, bytes.data(), sizeof(T));
    if (this->Swap)
    {
      std::reverse(copy, copy + sizeof(T));
    }
    this->Input.advance(sizeof(T));
    T value;
    std::memcpy(&value, copy, sizeof(T));
    return value;
  }

  void skip(ScalarType type, std::size_t count)
  {
    if (!this->Input.skip(count * sizeOf(type)))
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends inside a record");
    }
  }

  void endRecord() {}

  /// Return the minimum size of a number and its separator in the file [bytes]. Binary numbers have
  /// no separator.
  static std::size_t minimumBytes(ScalarType type) { return sizeOf(type); }

private:
  ByteReader& Input;
  bool Swap;
};

/// Read numbers that are stored as text, separated by blanks or line ends. A record is all numbers
/// of one point or polygon. Each record must end at the end of a line. If `hasRemarks` is true, the
/// text may have comments, from "#" to the end of the line.
class TextValues
{
public:
  explicit TextValues(ByteReader& input, bool hasRemarks = false)
    : Input(input)
    , HasRemarks(hasRemarks)
  {
  }

  template <typename T>
  T next()
  {
    constexpr std::size_t longestNumber = 4096;
    this->skipBlanks();
    const std::string_view text = this->Input.peek(longestNumber + 1);
    T value = T();
    const std::size_t length = readNumber(text, value);
    if (length == 0 || length > longestNumber) // a longer word may be truncated
    {
      this->failAtWord(
        text, std::is_floating_point<T>::value ? "a number" : "an integer of the property's type");
    }
    this->Input.advance(length);
    ++this->NumbersOfRecord;
    return value;
  }

  void skip(ScalarType type, std::size_t count)
  {
    withType(type,
      [&](auto zero)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          this->next<decltype(zero)>();
        }
      });
  }

  void endRecord()
  {
    if (!this->isLineEnd())
    {
      this->Input.fail(ParseCode::Malformed,
        "found " + quoted(wordOf(this->Input.peek(1))) + " after the " +
          std::to_string(this->NumbersOfRecord) +
          (this->NumbersOfRecord == 1 ? " number" : " numbers") +
          " of a record, expected the end of the line; this line or the one before has a wrong "
          "number of columns");
    }
    this->NumbersOfRecord = 0;
  }

  /// Test whether the rest of the current line is empty, apart from blanks and a comment.
  bool isLineEnd()
  {
    this->skipWhile([](char c) { return c == ' ' || c == '\t'; });
    const std::string_view text = this->Input.peek(1);
    return text.empty() || isBlank(text[0]) || (this->HasRemarks && isRemark(text));
  }

  /// Check that the text has been read completely.
  /// @throws ParseError unless only blanks and comments remain
  void endFile()
  {
    this->skipBlanks();
    const std::string_view text = this->Input.peek(1);
    if (!text.empty())
    {
      this->failAtWord(text, "the end of the file");
    }
  }

  /// Advance to the next word, or to the end of the text.
  void skipBlanks()
  {
    this->skipWhile(isBlank);
    while (this->HasRemarks && isRemark(this->Input.peek(1)))
    {
      this->skipWhile([](char c) { return c != '\n' && c != '\r'; });
      this->skipWhile(isBlank);
    }
  }

  static std::size_t minimumBytes(ScalarType) { return 2; }

private:
  template <typename Predicate>
  void skipWhile(Predicate isSkipped)
  {
    for (std::size_t skipped = 0;;)
    {
      const std::string_view window = this->Input.peek(1);
      const std::size_t length =
        std::find_if_not(window.begin(), window.end(), isSkipped) - window.begin();
      skipped += length;
      if (skipped > LongestLine)
      {
        this->Input.fail(ParseCode::Malformed, tooLongMessage("blanks or a comment"));
      }
      this->Input.advance(length);
      if (length < window.size() || window.empty())
      {
        return;
      }
    }
  }

  static std::string_view wordOf(std::string_view text)
  {
    return text.substr(
      0, static_cast<std::size_t>(std::find_if(text.begin(), text.end(), isBlank) - text.begin()));
  }

  [[noreturn]] void failAtWord(std::string_view text, const std::string& expected)
  {
    if (text.empty())
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends, expected " + expected);
    }
    this->Input.fail(
      ParseCode::Malformed, "found " + quoted(wordOf(text)) + ", expected " + expected);
  }

  ByteReader& Input;
  const bool HasRemarks;
  std::size_t NumbersOfRecord = 0; ///< count of numbers read since the end of the last record
};
}

#endif

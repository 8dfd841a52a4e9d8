/// Reads a text line by line, and a line word by word.

#ifndef ConformalLineReader_h
#define ConformalLineReader_h

#include "Bytes/ByteReader.h"
#include "Bytes/NumberText.h"
#include "Bytes/ParseLimits.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace conformal
{
/// Lines of up to LongestLine that end with LF, CR or CRLF, the last one also with the input. The
/// line at hand is not passed yet: a failure is one of this line.
class LineReader
{
public:
  /// A byte order mark at the start is skipped.
  explicit LineReader(ByteReader& input)
    : Input(input)
  {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    const bool isMarked = input.offset() == 0 && input.peek(3).substr(0, 3) == mark;
    input.advance(isMarked ? mark.size() : 0);
  }

  /// Go to the next line; false if there is none.
  /// @throws ParseError if it is too long
  bool next()
  {
    this->Input.advance(this->Passed);
    this->Passed = 0;
    const std::uint64_t begin = this->Input.offset();
    for (std::string_view window = this->Input.peek(1); !window.empty();)
    {
      const std::size_t length =
        std::min(this->LineFeed.find(window, begin), this->Return.find(window, begin));
      if (length > LongestLine)
      {
        this->Input.fail(ParseCode::Malformed, tooLongMessage("a line"));
      }
      if (length + 1 < window.size() || window.size() == this->Input.left())
      {
        this->Text = window.substr(0, length);
        const bool isPair = window.substr(length, 2) == "\r\n";
        this->Passed = std::min(length + (isPair ? 2 : 1), window.size());
        return true;
      }
      window = this->Input.peek(std::min(2 * window.size(), LongestLine + 2));
    }
    return false;
  }

  /// The line at hand without its end, valid until the next one.
  std::string_view text() const { return this->Text; }

  /// Whether the line at hand has nothing but blanks.
  bool isBlankLine() const { return this->Text.find_first_not_of(" \t\v\f") == Text.npos; }

  /// Leave the line at hand: the input is behind its end then.
  void finish()
  {
    this->Input.advance(this->Passed);
    this->Passed = 0;
  }

  /// @throws ParseError that quotes the line
  [[noreturn]] void failExpecting(const std::string& expected) const
  {
    this->Input.fail(
      ParseCode::Malformed, "found " + quoted(this->Text) + ", expected " + expected);
  }

private:
  // The next place of a letter, kept until it is passed: a text has but one sort of line end, and
  // the other must not be looked for in all that is left at every line.
  struct NextPlace
  {
    const char Letter;
    std::uint64_t Offset = 0; ///< in the input
    bool IsFound = false;     ///< otherwise it is not before Offset

    // Place in a window that begins at that offset; the window's size if it is not there.
    std::size_t find(std::string_view window, std::uint64_t begin)
    {
      if (!this->IsFound || this->Offset < begin)
      {
        const std::size_t from = this->Offset > begin ? this->Offset - begin : 0;
        const std::size_t place = std::min(window.find(this->Letter, from), window.size());
        this->IsFound = place < window.size();
        this->Offset = begin + place;
      }
      return static_cast<std::size_t>(this->Offset - begin);
    }
  };

  ByteReader& Input;
  NextPlace LineFeed = { '\n' };
  NextPlace Return = { '\r' };
  std::string_view Text;
  std::size_t Passed = 0; ///< bytes of the line at hand with its end
};

/// The words of a line, between blanks.
class LineWords
{
public:
  explicit LineWords(std::string_view line)
    : Rest(line)
  {
  }

  /// The next word, empty at the end.
  std::string_view next()
  {
    constexpr std::string_view blanks = " \t\v\f";
    this->Rest.remove_prefix(std::min(this->Rest.find_first_not_of(blanks), this->Rest.size()));
    const std::string_view word =
      this->Rest.substr(0, std::min(this->Rest.find_first_of(blanks), this->Rest.size()));
    this->Rest.remove_prefix(word.size());
    return word;
  }

  /// The next word as a number; false if it is none that T can hold.
  template <typename T>
  bool next(T& value)
  {
    const std::string_view word = this->next();
    return !word.empty() && readNumber(word, value) == word.size();
  }

  /// What follows the words taken so far.
  std::string_view rest() const { return this->Rest; }

private:
  std::string_view Rest;
};

/// Whether a line of this first word is blank or a remark.
inline bool isIgnored(std::string_view firstWord)
{
  return firstWord.empty() || isRemark(firstWord);
}
}

#endif

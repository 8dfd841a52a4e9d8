/// Read a text line by line, and a line word by word.

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
/// Reader of lines that end with LF, CR or CRLF. The last line may have no line end. The maximum
/// length of a line is LongestLine (ParseLimits.h). The input stays at the start of the current
/// line until the next line is read. An error message therefore states the number of the current
/// line.
class LineReader
{
public:
  /// Construct a reader. A byte order mark at the start of the input is skipped.
  explicit LineReader(ByteReader& input)
    : Input(input)
  {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    const bool isMarked = input.offset() == 0 && input.peek(3).substr(0, 3) == mark;
    input.advance(isMarked ? mark.size() : 0);
  }

  /// Advance to the next line. Return false if there is no further line.
  /// @throws ParseError if the line is too long
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

  /// Return the current line without its line end. The result is valid until the next line is read.
  std::string_view text() const { return this->Text; }

  /// Test whether the current line has only blanks.
  bool isBlankLine() const { return this->Text.find_first_not_of(" \t\v\f") == Text.npos; }

  /// Advance the input past the current line. Afterwards, the next byte of the input is the first
  /// byte after the line end.
  void finish()
  {
    this->Input.advance(this->Passed);
    this->Passed = 0;
  }

  /// Throw an error for the current line, whose text is not the expected text.
  /// @throws ParseError with a message that quotes the line
  [[noreturn]] void failExpecting(const std::string& expected) const
  {
    this->Input.fail(
      ParseCode::Malformed, "found " + quoted(this->Text) + ", expected " + expected);
  }

private:
  // Position of the next LF or of the next CR in the input. The position is kept until the reader
  // has passed it. Most texts have only one kind of line end. Without the kept position, the reader
  // would search the rest of the text for the other kind at every line.
  struct NextPlace
  {
    const char Letter;
    std::uint64_t Offset = 0; ///< offset in the input
    /// If true, the character is at Offset. If false, the input before Offset has been searched and
    /// does not contain the character.
    bool IsFound = false;

    // Return the position of the character in a window of the input that begins at the offset
    // `begin`. If the window does not contain the character, return the size of the window.
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
  std::size_t Passed = 0; ///< number of bytes of the current line, with its line end
};

/// Reader of the words of a line, which are separated by blanks.
class LineWords
{
public:
  explicit LineWords(std::string_view line)
    : Rest(line)
  {
  }

  /// Return the next word, or an empty word at the end of the line.
  std::string_view next()
  {
    constexpr std::string_view blanks = " \t\v\f";
    this->Rest.remove_prefix(std::min(this->Rest.find_first_not_of(blanks), this->Rest.size()));
    const std::string_view word =
      this->Rest.substr(0, std::min(this->Rest.find_first_of(blanks), this->Rest.size()));
    this->Rest.remove_prefix(word.size());
    return word;
  }

  /// Read the next word as a number. Return false if the word is not a number in the range of T.
  template <typename T>
  bool next(T& value)
  {
    const std::string_view word = this->next();
    return !word.empty() && readNumber(word, value) == word.size();
  }

  /// Return the rest of the line after the words read so far.
  std::string_view rest() const { return this->Rest; }

private:
  std::string_view Rest;
};

/// Test by the first word of a line whether the line is blank or a comment, which begins with "#".
inline bool isIgnored(std::string_view firstWord)
{
  return firstWord.empty() || isRemark(firstWord);
}
}

#endif

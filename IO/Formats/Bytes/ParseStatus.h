/// Describe the outcome of reading a file: the error and its position in the file.

#ifndef ConformalParseStatus_h
#define ConformalParseStatus_h

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace conformal
{
enum class ParseCode
{
  Ok,
  FileNotFound,
  CannotOpen,       ///< no permission to read, or a directory, pipe or device
  UnrecognizedType, ///< the file does not have the format of this parser
  PrematureEnd,     ///< the file ends before all expected data
  Malformed,        ///< the file violates the rules of its format
  OutOfMemory,
  Aborted ///< the caller's progress callback returned false
};

/// Outcome of parsing a file. Line is the number of the line with the error, counted from 1. For
/// binary data, Line is 0, and Offset is the position of the error.
struct ParseStatus
{
  ParseCode Code = ParseCode::Ok;
  std::uint64_t Line = 0;
  std::uint64_t Offset = 0; ///< number of bytes before the error
  std::string Message;      ///< description of the data that were found and expected

  bool ok() const { return this->Code == ParseCode::Ok; }

  /// Return the position and the message: "line 12: ..." or "byte 340: ...".
  std::string text() const;
};

/// Exception that parsers throw internally. The public functions of parsers catch this exception
/// and return its status.
class ParseError : public std::exception
{
public:
  explicit ParseError(ParseStatus status)
    : Status(std::move(status))
  {
  }
  const char* what() const noexcept override { return this->Status.Message.c_str(); }
  const ParseStatus& status() const { return this->Status; }

private:
  ParseStatus Status;
};

/// Quote text of a file for a message. Long text is truncated, and each character that is not
/// printable becomes "?".
std::string quoted(std::string_view text);

/// Run a parser and return its status: Ok, the status of a ParseError, OutOfMemory, or Aborted.
ParseStatus statusOf(const std::function<void()>& parse);
}

#endif

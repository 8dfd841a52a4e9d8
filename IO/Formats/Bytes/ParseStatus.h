/// Outcome of reading a file: the error and its position in the file.

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
  CannotOpen,       ///< the file may not be read, or it is a directory, pipe or device
  UnrecognizedType, ///< the file does not have the format of this parser
  PrematureEnd,     ///< the file ends before all data that its header states
  Malformed,        ///< the file violates the rules of its format
  OutOfMemory,
  Aborted ///< the progress callback of the run returned false
};

/// Outcome of parsing. Line is counted from 1; it is 0 in binary data.
struct ParseStatus
{
  ParseCode Code = ParseCode::Ok;
  std::uint64_t Line = 0;
  std::uint64_t Offset = 0; ///< number of bytes before the error
  std::string Message;      ///< description of the found and the expected data

  bool ok() const { return this->Code == ParseCode::Ok; }

  /// Return the position and the message: "line 12: ..." or "byte 340: ...".
  std::string text() const;
};

/// Exception inside parsers. The public functions of parsers return its status instead.
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

/// Quote text of a file for a message, shortened and with printable characters only.
std::string quoted(std::string_view text);

/// Run a parser and return its status: Ok, the status of a ParseError, OutOfMemory, or Aborted.
ParseStatus statusOf(const std::function<void()>& parse);
}

#endif

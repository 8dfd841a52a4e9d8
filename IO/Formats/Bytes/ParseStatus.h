/// Outcome of reading a file: the error and its place in the file.

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
  CannotOpen,       ///< no permission, or a directory, pipe or device
  UnrecognizedType, ///< not the format of this parser
  PrematureEnd,     ///< the file ends before its promised data
  Malformed,        ///< the file violates the rules of its format
  OutOfMemory,
  Aborted ///< the progress callback of the run returned false
};

/// Outcome of a parse. Line counts from 1; it is 0 in binary data.
struct ParseStatus
{
  ParseCode Code = ParseCode::Ok;
  std::uint64_t Line = 0;
  std::uint64_t Offset = 0; ///< bytes before the position of the error
  std::string Message;      ///< found and expected data

  bool ok() const { return this->Code == ParseCode::Ok; }

  /// Return the message after its position: "line 12: ..." or "byte 340: ...".
  std::string text() const;
};

/// Exception inside parsers; their public functions return the status instead.
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

/// Quote text of a file for a message: short and printable.
std::string quoted(std::string_view text);

/// Run a parser and return its status: a ParseError's, OutOfMemory, or Aborted.
ParseStatus statusOf(const std::function<void()>& parse);
}

#endif

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
  UnrecognizedType, ///< not the format this parser reads
  PrematureEnd,     ///< the file ends before all it promised
  Malformed,        ///< the file breaks the rules of its format
  OutOfMemory,
  Aborted ///< the progress callback of the run returned false
};

/// The end of a parse. Line counts from 1 and is 0 where lines make no sense (binary data).
struct ParseStatus
{
  ParseCode Code = ParseCode::Ok;
  std::uint64_t Line = 0;
  std::uint64_t Offset = 0; ///< bytes before the place
  std::string Message;      ///< what was found, and what was expected

  bool ok() const { return this->Code == ParseCode::Ok; }

  /// The message with its place before it, "line 12: ..." or "byte 340: ...".
  std::string text() const;
};

/// How parsers stop inside; the functions a caller sees return the status instead.
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

/// A file's text as a message may show it: in quotes, short, printable.
std::string quoted(std::string_view text);

/// Run a parser and return its status: a ParseError's, OutOfMemory, or Aborted.
ParseStatus statusOf(const std::function<void()>& parse);
}

#endif

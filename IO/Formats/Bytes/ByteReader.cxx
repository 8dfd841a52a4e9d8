#include "Bytes/ByteReader.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

namespace conformal
{
namespace
{
constexpr std::size_t WindowBytes = std::size_t(1) << 20; // fits the second-level cache

// Count line ends in [begin, end). The byte before `begin` is `last`. CRLF counts as one line end.
std::uint64_t countLineEnds(const char* begin, const char* end, char last)
{
  if (begin == end)
  {
    return 0;
  }
  if (last != '\r' && !std::memchr(begin, '\r', end - begin))
  {
    return std::count(begin, end, '\n');
  }
  std::uint64_t lines = 0;
  for (const char* c = begin; c != end; ++c)
  {
    lines += *c == '\r' || (*c == '\n' && last != '\r') ? 1 : 0;
    last = *c;
  }
  return lines;
}
}

//------------------------------------------------------------------------------
ByteReader::ByteReader(std::string_view bytes)
  : Window(bytes.data())
  , Begin(bytes.data())
  , End(bytes.data() + bytes.size())
  , Size(bytes.size())
{
}

//------------------------------------------------------------------------------
ByteReader::ByteReader(Read read, std::uint64_t size, Seek seek)
  : Source(std::move(read))
  , Jump(std::move(seek))
  , Size(size)
{
}

//------------------------------------------------------------------------------
void ByteReader::refill(std::size_t count)
{
  if (!this->Source || this->fetched() == this->Size)
  {
    return;
  }
  const std::uint64_t passed = this->Begin - this->Window;
  if (!this->Binary && passed > 0)
  {
    this->LinesBefore += countLineEnds(this->Window, this->Begin, this->LastBefore);
    this->LastBefore = this->Begin[-1];
  }
  this->WindowOffset += passed;
  const std::size_t kept = this->End - this->Begin;
  const std::uint64_t wanted =
    std::min<std::uint64_t>(std::max(count, WindowBytes), this->Size - this->WindowOffset);
  if (this->Begin != this->Window)
  {
    std::memmove(this->Buffer.data(), this->Begin, kept);
  }
  if (wanted > this->Buffer.size())
  {
    this->Buffer.resize(wanted);
  }
  const std::size_t got =
    wanted > kept ? this->Source(this->Buffer.data() + kept, wanted - kept) : 0;
  this->Window = this->Begin = this->Buffer.data();
  this->End = this->Begin + kept + got;
  if (kept + got < wanted)
  {
    this->Size = this->fetched(); // the input is shorter than its stated size
  }
}

//------------------------------------------------------------------------------
bool ByteReader::skip(std::uint64_t count)
{
  const std::uint64_t target = this->offset() + std::min(count, this->left());
  if (this->Binary && this->Jump && target > this->fetched())
  {
    count -= target - this->offset();
    this->seek(target);
  }
  while (count > 0)
  {
    const std::size_t there = this->peek(1).size();
    if (there == 0)
    {
      return false;
    }
    const std::size_t step = std::min<std::uint64_t>(there, count);
    this->advance(step);
    count -= step;
  }
  return true;
}

//------------------------------------------------------------------------------
bool ByteReader::seek(std::uint64_t offset)
{
  if (offset >= this->WindowOffset && offset <= this->fetched())
  {
    this->Begin = this->Window + (offset - this->WindowOffset);
    return true;
  }
  if (offset > this->Size || !this->Jump)
  {
    return false;
  }
  this->Jump(offset);
  this->WindowOffset = offset;
  this->Window = this->Begin = this->End = this->Buffer.data();
  return true;
}

//------------------------------------------------------------------------------
std::uint64_t ByteReader::line() const
{
  return this->Binary
    ? 0
    : 1 + this->LinesBefore + countLineEnds(this->Window, this->Begin, this->LastBefore);
}

//------------------------------------------------------------------------------
void ByteReader::fail(ParseCode code, const std::string& message) const
{
  throw ParseError({ code, this->line(), this->offset(), message });
}

//------------------------------------------------------------------------------
void ByteReader::requireBytes()
{
  if (this->peek(1).empty())
  {
    this->fail(ParseCode::PrematureEnd, "the file is empty");
  }
}

//------------------------------------------------------------------------------
bool startsLike(const std::string& path, std::size_t size,
  const std::function<bool(std::string_view, std::uint64_t)>& looksRight)
{
  ByteReader input;
  bool isRight = false;
  return openFile(path, input).ok() &&
    statusOf([&]() { isRight = looksRight(input.peek(size), input.size()); }).ok() && isRight;
}

//------------------------------------------------------------------------------
ParseStatus openFile(const std::string& path, ByteReader& input)
{
  const std::filesystem::path name = std::filesystem::u8path(path);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(name, error);
  if (status.type() == std::filesystem::file_type::not_found)
  {
    return { ParseCode::FileNotFound, 0, 0, "there is no such file" };
  }
  if (error)
  {
    return { ParseCode::CannotOpen, 0, 0, "cannot be opened: " + error.message() };
  }
  if (!std::filesystem::is_regular_file(status))
  {
    return { ParseCode::CannotOpen, 0, 0, "is not a regular file" };
  }
  const std::uint64_t size = std::filesystem::file_size(name, error);
  auto file = std::make_shared<std::filebuf>();
  if (error || !file->open(name, std::ios::in | std::ios::binary))
  {
    return { ParseCode::CannotOpen, 0, 0, "cannot be opened for reading" };
  }
  input = ByteReader([file](char* buffer, std::size_t count)
    { return static_cast<std::size_t>(file->sgetn(buffer, count)); },
    size,
    [file](std::uint64_t offset)
    { file->pubseekpos(static_cast<std::streamoff>(offset), std::ios::in); });
  return {};
}
}

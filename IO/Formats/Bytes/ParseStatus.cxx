#include "Bytes/ParseStatus.h"

#include "Base/Run.h"

#include <ios>
#include <new>

namespace conformal
{
//------------------------------------------------------------------------------
std::string ParseStatus::text() const
{
  if (this->Line > 0)
  {
    return "line " + std::to_string(this->Line) + ": " + this->Message;
  }
  return "byte " + std::to_string(this->Offset) + ": " + this->Message;
}

//------------------------------------------------------------------------------
std::string quoted(std::string_view text)
{
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest))
  {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + (text.size() > longest ? "...\"" : "\"");
}

//------------------------------------------------------------------------------
ParseStatus statusOf(const std::function<void()>& parse)
{
  try
  {
    parse();
    return {};
  }
  catch (const ParseError& e)
  {
    return e.status();
  }
  catch (const Aborted& e)
  {
    return { ParseCode::Aborted, 0, 0, e.what() };
  }
  catch (const std::ios_base::failure& e) // the system cannot read, such as from a disk with faults
  {
    return { ParseCode::CannotOpen, 0, 0, std::string("cannot be read: ") + e.what() };
  }
  catch (const std::bad_alloc&)
  {
    return { ParseCode::OutOfMemory, 0, 0, "out of memory" };
  }
}
}

#include "Text/XMLParser.h"

#include <expat.h>

#include <algorithm>
#include <new>

namespace conformal
{
namespace
{
// Return the position of the parser. Expat 2.9 replaces these functions and deprecates them.
#if XML_MAJOR_VERSION > 2 || (XML_MAJOR_VERSION == 2 && XML_MINOR_VERSION >= 9)
std::int64_t byteIndex(XML_Parser parser)
{
  return XML_GetCurrentByteIndex64(parser);
}
std::uint64_t lineNumber(XML_Parser parser)
{
  return XML_GetCurrentLineNumber64(parser);
}
#else
std::int64_t byteIndex(XML_Parser parser)
{
  return XML_GetCurrentByteIndex(parser);
}
std::uint64_t lineNumber(XML_Parser parser)
{
  return XML_GetCurrentLineNumber(parser);
}
#endif
}

//------------------------------------------------------------------------------
template <typename Call>
void XMLParser::guard(Call call) noexcept
{
  if (this->Error)
  {
    return;
  }
  try
  {
    call(this->Handler);
  }
  catch (...)
  {
    this->Error = std::current_exception();
    XML_StopParser(this->Parser.get(), XML_FALSE);
  }
}

//------------------------------------------------------------------------------
XMLParser::XMLParser(XMLHandler& handler)
  : Handler(handler)
  , Parser(XML_ParserCreate(nullptr), XML_ParserFree)
{
  if (!this->Parser)
  {
    throw std::bad_alloc();
  }
  XML_Parser parser = this->Parser.get();
  XML_SetUserData(parser, this);
  XML_SetElementHandler(
    parser,
    [](void* self, const char* name, const char** attributes)
    {
      static_cast<XMLParser*>(self)->guard(
        [&](XMLHandler& called) { called.start(name, attributes); });
    },
    [](void* self, const char* name)
    { static_cast<XMLParser*>(self)->guard([&](XMLHandler& called) { called.end(name); }); });
  XML_SetCharacterDataHandler(parser,
    [](void* self, const char* text, int size)
    {
      static_cast<XMLParser*>(self)->guard(
        [&](XMLHandler& called) {
          called.text({ text, static_cast<std::size_t>(size) });
        });
    });
  XML_SetEntityDeclHandler(parser,
    [](void* self, const char*, int, const char*, int, const char*, const char*, const char*,
      const char*)
    { static_cast<XMLParser*>(self)->guard([](XMLHandler& called) { called.entity(); }); });
}

//------------------------------------------------------------------------------
bool XMLParser::parse(std::string_view piece, bool isLast)
{
  const XML_Status status =
    XML_Parse(this->Parser.get(), piece.data(), static_cast<int>(piece.size()), isLast ? 1 : 0);
  if (this->Error)
  {
    std::rethrow_exception(this->Error);
  }
  return status == XML_STATUS_OK;
}

//------------------------------------------------------------------------------
std::string XMLParser::message() const
{
  return std::string("the XML is not valid: ") +
    XML_ErrorString(XML_GetErrorCode(this->Parser.get()));
}

//------------------------------------------------------------------------------
bool XMLParser::endsEarly() const
{
  const XML_Error code = XML_GetErrorCode(this->Parser.get());
  return code == XML_ERROR_NO_ELEMENTS || code == XML_ERROR_UNCLOSED_TOKEN ||
    code == XML_ERROR_PARTIAL_CHAR;
}

//------------------------------------------------------------------------------
std::uint64_t XMLParser::offset() const
{
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, byteIndex(this->Parser.get())));
}

//------------------------------------------------------------------------------
std::uint64_t XMLParser::line() const
{
  return lineNumber(this->Parser.get());
}

}

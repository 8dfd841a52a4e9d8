/// Parse XML in pieces, by the library expat.

#ifndef ConformalXMLParser_h
#define ConformalXMLParser_h

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace conformal
{
/// Receiver of the parts of an XML document. Its functions can throw exceptions.
class XMLHandler
{
public:
  virtual ~XMLHandler() = default;

  /// Begin an element.
  /// @param[in] attributes  names and values by turns; the last pointer is null
  virtual void start(const char* name, const char** attributes) = 0;
  /// End an element.
  virtual void end(const char* name) = 0;
  /// Receive a part of the text of an element.
  virtual void text(std::string_view part) = 0;
  /// Receive the definition of an entity, which formats should refuse.
  virtual void entity() = 0;
};

/// Parser that calls a handler. Expat is C code. If the handler throws an exception, the exception
/// is therefore stored until expat returns, and is then thrown again.
class XMLParser
{
public:
  /// @param[in] handler  must exist as long as this object
  explicit XMLParser(XMLHandler& handler);
  XMLParser(const XMLParser&) = delete;
  XMLParser& operator=(const XMLParser&) = delete;

  /// Parse the next piece.
  /// @return whether the XML is valid so far
  /// @throws any exception of the handler
  bool parse(std::string_view piece, bool isLast);

  /// State what is wrong, after parse() returned false.
  std::string message() const;
  /// Return whether the XML ends inside of an element, after parse() returned false.
  bool endsEarly() const;

  /// Return the position of the current part in the XML [bytes].
  std::uint64_t offset() const;
  /// Return the number of the current line; the first is 1.
  std::uint64_t line() const;

private:
  template <typename Call>
  void guard(Call call) noexcept;

  XMLHandler& Handler;
  std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> Parser;
  std::exception_ptr Error;
};
}

#endif

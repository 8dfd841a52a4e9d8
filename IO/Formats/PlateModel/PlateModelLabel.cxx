#include "PlateModel/PlateModelLabel.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace conformal
{
namespace
{
constexpr std::string_view Blanks = " \t\r\n\v\f";

std::string_view trimmed(std::string_view text)
{
  const std::size_t begin = std::min(text.find_first_not_of(Blanks), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(Blanks) + 1);
}

// Replace each comment by a blank.
std::string withoutComments(std::string_view text, std::string_view open, std::string_view close)
{
  std::string result;
  while (true)
  {
    const std::size_t begin = text.find(open);
    result += text.substr(0, begin);
    if (begin == text.npos)
    {
      return result;
    }
    result += ' ';
    const std::size_t end = text.find(close, begin + open.size());
    text.remove_prefix(end == text.npos ? text.size() : end + close.size());
  }
}

// Return the length of a unit [m], or 0 if it is no unit of length in which bodies are described.
double metersOf(std::string_view unit)
{
  std::string word(trimmed(unit));
  if (word.size() > 2 &&
    ((word.front() == '"' && word.back() == '"') || (word.front() == '<' && word.back() == '>')))
  {
    word = trimmed(std::string_view(word).substr(1, word.size() - 2));
  }
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const auto isOneOf = [&](std::initializer_list<std::string_view> words)
  { return std::find(words.begin(), words.end(), std::string_view(word)) != words.end(); };
  if (isOneOf({ "km", "kilometer", "kilometers", "kilometre", "kilometres" }))
  {
    return 1000.0;
  }
  return isOneOf({ "m", "meter", "meters", "metre", "metres" }) ? 1.0 : 0.0;
}

void addUnit(PlateModelLabel& label, std::string_view unit)
{
  const double meters = metersOf(unit);
  if (meters == 0.0 || label.HasSeveralUnits)
  {
    return;
  }
  label.HasSeveralUnits = label.MetersPerUnit != 0.0 && label.MetersPerUnit != meters;
  label.MetersPerUnit = label.HasSeveralUnits ? 0.0 : meters;
}

// Return the text of the next element of XML with a name, and remove the text up to its end. The
// name may have a prefix of a namespace, and the element may have attributes. Without a further
// element, return an empty text and remove all.
std::string_view takeElement(std::string_view& text, std::string_view name)
{
  while (true)
  {
    const std::size_t begin = text.find('<');
    const std::size_t end = begin == text.npos ? begin : text.find('>', begin);
    if (end == text.npos)
    {
      text = {};
      return {};
    }
    std::string_view tag = text.substr(begin + 1, end - begin - 1);
    text.remove_prefix(end + 1);
    tag = tag.substr(0, tag.find_first_of(Blanks));
    if (!tag.empty() && tag.front() != '/')
    {
      tag.remove_prefix(tag.find(':') == tag.npos ? 0 : tag.find(':') + 1);
    }
    if (tag == name)
    {
      const std::string_view content = text.substr(0, text.find('<'));
      text.remove_prefix(content.size());
      return trimmed(content);
    }
  }
}

PlateModelLabel parseXML(std::string_view text)
{
  PlateModelLabel label;
  std::string_view rest = text;
  takeElement(rest, "Target_Identification");
  label.TargetName = takeElement(rest, "name");
  for (rest = text; !rest.empty();)
  {
    addUnit(label, takeElement(rest, "unit"));
  }
  return label;
}

PlateModelLabel parseStatements(std::string_view text)
{
  PlateModelLabel label;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t equals = line.find('=');
    if (equals == line.npos)
    {
      continue;
    }
    const std::string_view key = trimmed(line.substr(0, equals));
    std::string_view value = trimmed(line.substr(equals + 1));
    if (key == "UNIT")
    {
      addUnit(label, value);
    }
    else if (key == "TARGET_NAME" && label.TargetName.empty())
    {
      if (value.size() > 1 && value.front() == '"' && value.back() == '"')
      {
        value = trimmed(value.substr(1, value.size() - 2));
      }
      label.TargetName = value;
    }
  }
  return label;
}
}

//------------------------------------------------------------------------------
PlateModelLabel parsePlateModelLabel(std::string_view text)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.substr(0, mark.size()) == mark)
  {
    text.remove_prefix(mark.size());
  }
  return trimmed(text).substr(0, 1) == "<" ? parseXML(withoutComments(text, "<!--", "-->"))
                                           : parseStatements(withoutComments(text, "/*", "*/"));
}
}

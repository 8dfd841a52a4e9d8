#include "TextCloud/TextCloudLayout.h"

#include "Bytes/LineReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace conformal
{
namespace
{
constexpr std::size_t MaximumSampleLines = 100;
constexpr std::size_t MaximumColumns = 1000; // more than in any real table
constexpr std::string_view Blanks = " \t\v\f";

using Words = std::vector<std::string_view>;
using Rows = std::vector<std::vector<double>>;

std::string_view trimmed(std::string_view text, std::string_view ends)
{
  const std::size_t begin = std::min(text.find_first_not_of(ends), text.size());
  return text.substr(begin, text.find_last_not_of(ends) + 1 - begin);
}

// Call use(word) for each column.
template <typename Use>
void forEachWord(std::string_view line, char delimiter, Use use)
{
  if (delimiter == ' ')
  {
    LineWords rest(line);
    for (std::string_view word = rest.next(); !word.empty(); word = rest.next())
    {
      use(word);
    }
    return;
  }
  line = trimmed(line, delimiter == '\t' ? " \v\f" : Blanks);
  while (!line.empty()) // a delimiter at the end of the line starts no word
  {
    const std::size_t end = std::min(line.find(delimiter), line.size());
    use(trimmed(line.substr(0, end), Blanks));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
}

Words split(std::string_view line, char delimiter)
{
  Words words;
  forEachWord(line, delimiter, [&](std::string_view word) { words.push_back(word); });
  return words;
}

std::string lowerCase(std::string_view text)
{
  std::string result(text);
  for (char& c : result)
  {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

bool readWord(std::string_view word, bool decimalComma, double& value)
{
  std::string text(word);
  if (decimalComma)
  {
    std::replace(text.begin(), text.end(), ',', '.');
  }
  return !text.empty() && readNumber(text, value) == text.size();
}

bool isWholeNumber(std::string_view line)
{
  return trimmed(line, Blanks).find_first_not_of("0123456789") == std::string_view::npos;
}

// First lines of a text: comments, names of columns, and lines of numbers.
struct Sample
{
  std::vector<std::string> Remarks; // comments before the numbers
  std::string Names;
  std::size_t NamesLine = 0;
  std::vector<std::string_view> Lines; // lines of numbers
  std::vector<std::size_t> Numbers;    // of these lines, counted from 1
  std::size_t FirstOffset = 0;
};

bool isPlainText(std::string_view line)
{
  return std::all_of(line.begin(), line.end(),
    [](char c) { return static_cast<unsigned char>(c) >= ' ' || isBlank(c); });
}

Sample takeSample(std::string_view start, bool isWhole)
{
  Sample sample;
  ByteReader input(start);
  LineReader lines(input);
  for (std::size_t number = 1; sample.Lines.size() < MaximumSampleLines && lines.next(); ++number)
  {
    const std::string_view line = lines.text();
    const bool isCut =
      !isWhole && line.data() + line.size() == start.data() + start.size() && number > 1;
    if (isCut)
    {
      break;
    }
    if (!isPlainText(line))
    {
      throw NoTextCloud(number, "found " + quoted(line) + ", expected text");
    }
    if (isIgnoredLine(line))
    {
      if (sample.Lines.empty() && sample.Remarks.size() < MaximumSampleLines)
      {
        sample.Remarks.emplace_back(trimmed(line, "#/; \t\v\f"));
      }
    }
    else if (sample.Lines.empty() && sample.Names.empty() && !startsWithNumber(line, ','))
    {
      sample.Names = trimmed(line, Blanks);
      sample.NamesLine = number;
    }
    else
    {
      if (sample.Lines.empty())
      {
        sample.FirstOffset = line.data() - start.data();
      }
      sample.Lines.push_back(line);
      sample.Numbers.push_back(number);
    }
  }
  return sample;
}

// Meaning of the name of a column: a component of a known array. Name is empty if the meaning is
// unknown.
struct Role
{
  std::string_view Name;
  std::size_t Component = 0;
};

Role roleOf(std::string name)
{
  const std::size_t unit = name.find_first_of("[(");
  if (unit != std::string::npos && unit > 0)
  {
    name = trimmed(name.substr(0, unit), Blanks);
  }
  static const std::pair<std::string_view, Role> roles[] = { { "x", { "Points", 0 } },
    { "y", { "Points", 1 } }, { "z", { "Points", 2 } }, { "points:0", { "Points", 0 } },
    { "points:1", { "Points", 1 } }, { "points:2", { "Points", 2 } },
    { "points_0", { "Points", 0 } }, { "points_1", { "Points", 1 } },
    { "points_2", { "Points", 2 } }, { "nx", { "Normals", 0 } }, { "ny", { "Normals", 1 } },
    { "nz", { "Normals", 2 } }, { "normal_x", { "Normals", 0 } }, { "normal_y", { "Normals", 1 } },
    { "normal_z", { "Normals", 2 } }, { "normals:0", { "Normals", 0 } },
    { "normals:1", { "Normals", 1 } }, { "normals:2", { "Normals", 2 } }, { "r", { "RGB", 0 } },
    { "g", { "RGB", 1 } }, { "b", { "RGB", 2 } }, { "red", { "RGB", 0 } },
    { "green", { "RGB", 1 } }, { "blue", { "RGB", 2 } }, { "rgb:0", { "RGB", 0 } },
    { "rgb:1", { "RGB", 1 } }, { "rgb:2", { "RGB", 2 } }, { "i", { "Intensity", 0 } },
    { "intensity", { "Intensity", 0 } } };
  for (const auto& [known, role] : roles)
  {
    if (name == known)
    {
      return role;
    }
  }
  return {};
}

std::string columnName(std::size_t number)
{
  return "Column" + std::to_string(number);
}

// Find the first repeated name. If no name is repeated, return an empty text.
std::string repeatedName(const std::vector<std::string>& names)
{
  std::set<std::string> seen;
  const auto repeated = std::find_if(
    names.begin(), names.end(), [&](const std::string& name) { return !seen.insert(name).second; });
  return repeated == names.end() ? "" : *repeated;
}

// Read the names of columns from a line. If there are not as many names as columns, or x, y or z is
// missing, return no names. A column without a name is named by its number.
std::vector<std::string> namesFrom(std::string_view line, char delimiter, std::size_t columns)
{
  for (const char separator : { delimiter == ' ' ? '\t' : delimiter, delimiter })
  {
    std::vector<std::string> names;
    std::array<bool, 3> has = {};
    for (const std::string_view word : split(line, separator))
    {
      names.emplace_back(trimmed(word, "\"' \t"));
      if (names.back().empty())
      {
        names.back() = columnName(names.size());
      }
      const Role role = roleOf(lowerCase(names.back()));
      if (role.Name == "Points")
      {
        has[role.Component] = true;
      }
    }
    if (names.size() == columns && has[0] && has[1] && has[2])
    {
      return names;
    }
  }
  return {};
}

// Return the number for full brightness of colors in three columns: 255 if all numbers are bytes, 1
// if they are fractions, and 65535 if they have 16 bits. Other numbers are no colors; return 0.
double fullColorOf(const Rows& rows, const std::array<std::size_t, 3>& columns)
{
  for (const double full : { 255.0, 1.0, 65535.0 })
  {
    const bool allFit = std::all_of(rows.begin(), rows.end(),
      [&](const std::vector<double>& row)
      {
        return std::all_of(
          columns.begin(), columns.end(), [&](std::size_t i) { return isColor(row[i], full); });
      });
    if (allFit)
    {
      return full;
    }
  }
  return 0.0;
}

// Columns without names are colors only if they are bytes: fractions may be anything.
bool areColors(const Rows& rows, std::size_t first)
{
  return fullColorOf(rows, { first, first + 1, first + 2 }) == 255.0;
}

// Rows of zeros are black, unless another row is a normal.
bool areNormals(const Rows& rows, std::size_t first)
{
  constexpr double tolerance = 0.01; // tolerance for normals with three digits
  const auto lengthOf = [first](const std::vector<double>& row)
  { return std::hypot(row[first], row[first + 1], row[first + 2]); };
  return std::all_of(rows.begin(), rows.end(),
           [&](const std::vector<double>& row)
           { return lengthOf(row) == 0.0 || std::abs(lengthOf(row) - 1.0) < tolerance; }) &&
    std::any_of(rows.begin(), rows.end(),
      [&](const std::vector<double>& row) { return lengthOf(row) > 0.0; });
}

std::vector<std::string> namesByValues(const Rows& rows, std::size_t columns)
{
  std::vector<std::string> names = { "x", "y", "z" };
  const auto add = [&](std::initializer_list<const char*> more)
  { names.insert(names.end(), more.begin(), more.end()); };
  if (columns == 4)
  {
    add({ "Intensity" });
  }
  else if (columns == 6 && areNormals(rows, 3))
  {
    add({ "nx", "ny", "nz" });
  }
  else if (columns == 6 && areColors(rows, 3))
  {
    add({ "r", "g", "b" });
  }
  else if (columns == 7 && areColors(rows, 4))
  {
    add({ "Intensity", "r", "g", "b" });
  }
  else if (columns == 7 && areColors(rows, 3))
  {
    add({ "r", "g", "b", "Intensity" });
  }
  else if (columns == 9 && areColors(rows, 6) && areNormals(rows, 3))
  {
    add({ "nx", "ny", "nz", "r", "g", "b" });
  }
  else if (columns == 9 && areColors(rows, 3) && areNormals(rows, 6))
  {
    add({ "r", "g", "b", "nx", "ny", "nz" });
  }
  while (names.size() < columns)
  {
    names.push_back(columnName(names.size() + 1));
  }
  return names;
}

// Assign each column to an array. Columns of a known array form this array. Every other column
// becomes an array of its own name.
void placeColumns(const std::vector<std::string>& names, const Rows& rows, TextCloudLayout& layout)
{
  constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  layout.Columns.assign(names.size(), { nowhere, 0 });
  const auto group = [&](const char* array, ScalarType type, std::size_t components)
  {
    std::array<std::size_t, 3> members = { nowhere, nowhere, nowhere };
    for (std::size_t i = names.size(); i-- > 0;) // if "x" and "X" exist, the first is used
    {
      const Role role = roleOf(lowerCase(names[i]));
      if (role.Name == array)
      {
        members[role.Component] = i;
      }
    }
    const auto end = members.begin() + components;
    if (std::find(members.begin(), end, nowhere) != end)
    {
      return;
    }
    if (type == ScalarType::UInt8)
    {
      const double full = fullColorOf(rows, members);
      if (full == 0.0)
      {
        return;
      }
      layout.FullColor = full;
    }
    for (std::size_t c = 0; c < components; ++c)
    {
      layout.Columns[members[c]] = { layout.Arrays.size(), c };
    }
    layout.Arrays.push_back(makeArray(array, type, components));
  };
  group("Points", ScalarType::Float64, 3);
  group("Normals", ScalarType::Float64, 3);
  group("RGB", ScalarType::UInt8, 3);
  group("Intensity", ScalarType::Float64, 1);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (layout.Columns[i].Array == nowhere)
    {
      layout.Columns[i] = { layout.Arrays.size(), 0 };
      layout.Arrays.push_back(makeArray(names[i], ScalarType::Float64, 1));
    }
  }
}

[[noreturn]] void refuse(std::size_t line, std::string_view text, const std::string& expected)
{
  throw NoTextCloud(line, "found " + quoted(text) + ", expected " + expected);
}

// Return the numbers of all lines that have one number in each column.
Rows rowsOf(const std::vector<std::string_view>& lines, char delimiter, std::size_t columns,
  bool decimalComma)
{
  Rows rows;
  for (const std::string_view text : lines)
  {
    std::vector<double> row;
    for (const std::string_view word : split(text, delimiter))
    {
      double value = 0.0;
      if (!readWord(word, decimalComma, value))
      {
        break;
      }
      row.push_back(value);
    }
    if (row.size() == columns)
    {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

// Test whether commas can only be decimal marks, as in "0,5;1;2,5": semicolons separate the
// columns, no number has a point, and all words are numbers.
bool haveDecimalCommas(const std::vector<std::string_view>& lines)
{
  const auto isDecimal = [](std::string_view line)
  {
    const Words words = split(line, ';');
    double value = 0.0;
    return line.find(';') != std::string_view::npos && line.find('.') == std::string_view::npos &&
      std::all_of(words.begin(), words.end(),
        [&](std::string_view word) { return readWord(word, true, value); });
  };
  const auto hasComma = [](std::string_view line)
  { return line.find(',') != std::string_view::npos; };
  return std::any_of(lines.begin(), lines.end(), hasComma) &&
    std::all_of(lines.begin(), lines.end(), isDecimal);
}

double meanBytesOf(const std::vector<std::string_view>& lines)
{
  constexpr double minimum = 6.0; // "0 0 0" and a line end
  double bytes = 0.0;
  for (const std::string_view text : lines)
  {
    bytes += static_cast<double>(text.size() + 1) / static_cast<double>(lines.size());
  }
  return std::max(minimum, bytes);
}

// Return the names of the columns from the line of names, or from a comment before the points. If
// both are missing, return no names.
std::vector<std::string> statedNames(const Sample& sample, char delimiter, std::size_t columns)
{
  std::vector<std::string> names;
  if (sample.NamesLine == 0)
  {
    for (const std::string& remark : sample.Remarks)
    {
      names = names.empty() ? namesFrom(remark, delimiter, columns) : names;
      names = repeatedName(names).empty() ? names : std::vector<std::string>();
    }
    return names;
  }
  names = namesFrom(sample.Names, delimiter, columns);
  if (names.empty())
  {
    refuse(sample.NamesLine, sample.Names,
      "numbers, or names of the " + std::to_string(columns) + " columns with x, y and z");
  }
  const std::string repeated = repeatedName(names);
  if (!repeated.empty())
  {
    throw NoTextCloud(
      sample.NamesLine, "found two columns " + quoted(repeated) + ", expected each name once");
  }
  return names;
}
}

//------------------------------------------------------------------------------
bool isColor(double value, double fullColor)
{
  return value >= 0.0 && value <= fullColor && (fullColor == 1.0 || value == std::floor(value));
}

//------------------------------------------------------------------------------
bool isIgnoredLine(std::string_view line)
{
  line = trimmed(line, Blanks);
  return isIgnored(line) || line[0] == ';' || line.substr(0, 2) == "//";
}

//------------------------------------------------------------------------------
bool startsWithNumber(std::string_view line, char delimiter)
{
  line = trimmed(line, Blanks);
  double value = 0.0;
  if (readNumber(line, value, delimiter) > 0)
  {
    return true;
  }
  const std::size_t sign = !line.empty() && (line[0] == '-' || line[0] == '+') ? 1 : 0;
  return line.size() > sign && ((line[sign] >= '0' && line[sign] <= '9') || line[sign] == '.');
}

//------------------------------------------------------------------------------
std::string describeNoPoint(std::string_view line, const TextCloudLayout& layout)
{
  std::size_t count = 0;
  std::string wrongWord;
  forEachWord(line, layout.Delimiter,
    [&](std::string_view word)
    {
      ++count;
      double value = 0.0;
      if (wrongWord.empty() && !readWord(word, layout.DecimalComma, value))
      {
        wrongWord = quoted(word) + " in column " + std::to_string(count);
      }
    });
  const std::size_t columns = layout.Columns.size();
  if (count == columns)
  {
    return "found " + quoted(line) + " with " + (wrongWord.empty() ? "a wrong number" : wrongWord) +
      ", expected " + std::to_string(columns) + " numbers" +
      (line.find('"') == std::string_view::npos ? "" : " without quotation marks");
  }
  const std::string delimiter =
    layout.Delimiter == ' ' ? "" : " between \"" + std::string(1, layout.Delimiter) + "\"";
  return "found " + quoted(line) + " with " + std::to_string(count) +
    (count == 1 ? " column" : " columns") + ", expected " + std::to_string(columns) + " columns" +
    delimiter + " as in the first line of numbers";
}

//------------------------------------------------------------------------------
TextCloudLayout findTextCloudLayout(std::string_view start, bool isWhole, bool decimalComma)
{
  Sample sample = takeSample(start, isWhole);
  TextCloudLayout layout;
  if (sample.Lines.empty() && sample.NamesLine > 0)
  {
    refuse(sample.NamesLine, sample.Names, "points after the names of columns, or x, y and z");
  }
  if (sample.Lines.empty())
  {
    throw NoTextCloud(1, "the text has no points");
  }
  layout.FirstOffset = sample.FirstOffset;
  layout.HasCount = isWholeNumber(sample.Lines[0]);
  const auto firstPoint = std::find_if_not(sample.Lines.begin(), sample.Lines.end(), isWholeNumber);
  const std::size_t firstNumber =
    firstPoint == sample.Lines.end() ? 1 : sample.Numbers[firstPoint - sample.Lines.begin()];
  if (layout.HasCount) // the counts of further blocks are also removed
  {
    sample.Lines.erase(
      std::remove_if(sample.Lines.begin(), sample.Lines.end(), isWholeNumber), sample.Lines.end());
  }
  layout.DecimalComma = decimalComma || haveDecimalCommas(sample.Lines);
  // If the first lines contain no point, points are assumed to have three numbers.
  const std::string_view line = sample.Lines.empty() ? "0 0 0" : sample.Lines[0];
  const auto has = [&](char c) { return line.find(c) != std::string_view::npos; };
  layout.Delimiter = has(';') ? ';' : has(',') && !layout.DecimalComma ? ',' : ' ';
  const std::size_t columns = split(line, layout.Delimiter).size();
  if (columns < 3 || columns > MaximumColumns)
  {
    refuse(firstNumber, line, "3 to " + std::to_string(MaximumColumns) + " numbers of a point");
  }

  const Rows rows = rowsOf(sample.Lines, layout.Delimiter, columns, layout.DecimalComma);
  layout.AllLinesFit = !rows.empty() && rows.size() == sample.Lines.size();
  layout.MeanLineBytes = meanBytesOf(sample.Lines);
  layout.HasNames = sample.NamesLine > 0;
  const std::vector<std::string> names = statedNames(sample, layout.Delimiter, columns);
  placeColumns(names.empty() ? namesByValues(rows, columns) : names, rows, layout);
  return layout;
}
}

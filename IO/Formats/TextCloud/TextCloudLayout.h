/// Find the meaning of the columns of a text file of points, from its first lines.

#ifndef ConformalTextCloudLayout_h
#define ConformalTextCloudLayout_h

#include "Bytes/NamedArray.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
struct TextCloudLayout
{
  char Delimiter = ' ';      ///< separator of columns; a blank stands for blanks and tabs
  bool HasCount = false;     ///< whether the number of points precedes the points
  bool DecimalComma = false; ///< whether commas are decimal marks
  bool HasNames = false;     ///< whether a line, not a comment, contains the names of the columns
  double FullColor = 255.0;  ///< number for full brightness in columns of colors: 1, 255 or 65535

  /// Array and component in which the values of a column are stored.
  struct Column
  {
    std::size_t Array = 0;
    std::size_t Component = 0;
  };
  std::vector<Column> Columns;
  std::vector<NamedArray> Arrays; ///< arrays to fill; the first array is for the points
  std::size_t FirstOffset = 0;    ///< offset of the first line with numbers [bytes]
  double MeanLineBytes = 0.0;     ///< mean length of the examined lines [bytes]
  bool AllLinesFit = false;       ///< whether each examined line is a point; false without lines
};

/// Test whether a number is a component of a color: a fraction if fullColor is 1, otherwise an
/// integer.
/// @param[in] fullColor  number for full brightness, see TextCloudLayout::FullColor
bool isColor(double value, double fullColor);

/// Test whether a line is blank or a comment after #, // or ;.
bool isIgnoredLine(std::string_view line);

/// Test whether a line begins with a number.
bool startsWithNumber(std::string_view line, char delimiter);

/// Return an error message for a line that is not a point. The line has a wrong number of columns,
/// or contains a word that is not a number.
std::string describeNoPoint(std::string_view line, const TextCloudLayout& layout);

/// Exception for a text whose first lines are not points. Line is the number of the wrong line,
/// counted from 1.
class NoTextCloud : public std::invalid_argument
{
public:
  NoTextCloud(std::size_t line, const std::string& message)
    : std::invalid_argument(message)
    , Line(line)
  {
  }
  const std::size_t Line;
};

/// Find the layout of a text from its first lines.
///
/// The delimiter is found in the first line of numbers. If this line contains a semicolon, the
/// delimiter is a semicolon. Otherwise, if the line contains a comma that is not a decimal mark,
/// the delimiter is a comma. Otherwise, blanks and tabs separate the columns.
///
/// Names of columns are read from a line before the first numbers. This line may be a comment. The
/// line of names must contain x, y and z, and no name twice. A unit in brackets after a name, such
/// as "x [mm]", does not matter. Columns with names of colors are colors if all values in the first
/// hundred lines are integers in [0, 255], fractions in [0, 1], or integers in [0, 65535]; the
/// first case that applies is used. Without names, the first three columns are x, y and z. The
/// meaning of the columns after z is then found from the number of columns and the values in the
/// first hundred lines:
/// - 4 columns: the fourth column is the intensity;
/// - 6 columns: normals if all of them have length 1 (within 0.01) or 0, and at least one has
///   length 1; otherwise colors if all values are integers in [0, 255];
/// - 7 columns: intensity and colors, or colors and intensity;
/// - 9 columns: normals and colors, or colors and normals.
///
/// If no case applies, columns after z are named by their number, such as "Column4".
///
/// @param[in] start         bytes from the start of a text
/// @param[in] isWhole       whether `start` is the whole text; otherwise the last line may be
///   incomplete
/// @param[in] decimalComma  whether commas are decimal marks. Otherwise, they are if semicolons
///   separate the columns, and the numbers contain commas and no points.
/// @throws NoTextCloud if the first lines are not points
TextCloudLayout findTextCloudLayout(std::string_view start, bool isWhole, bool decimalComma);
}

#endif

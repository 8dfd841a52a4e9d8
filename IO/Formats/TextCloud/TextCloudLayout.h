/// Meaning of the columns of a text file of points, derived from its first lines.

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
  char Delimiter = ' '; ///< separator of columns; a blank includes tabs
  bool HasCount = false;
  bool HasNames = false;

  /// Array and component in which the values of a column are stored.
  struct Column
  {
    std::size_t Array = 0;
    std::size_t Component = 0;
  };
  std::vector<Column> Columns;
  std::vector<NamedArray> Arrays; ///< arrays without values; the first array contains the points
  std::size_t FirstOffset = 0;    ///< offset of the first line with numbers
  double MeanLineBytes = 0.0;     ///< mean length of the examined lines with points
  bool AllLinesFit = false;       ///< whether there are such lines, and each has all columns
};

/// Test whether a line is blank or a comment after #, // or ;.
bool isIgnoredLine(std::string_view line);

/// Test whether a line begins with a number.
bool startsWithNumber(std::string_view line, char delimiter);

/// Describe why a line is not a point: a wrong number of columns, or a word that is not a number.
std::string describeNoPoint(
  std::string_view line, const TextCloudLayout& layout, bool decimalComma);

/// Exception for a text whose first lines are not points. Line is counted from 1.
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
/// The delimiter is a semicolon if the first line of numbers contains a semicolon. Otherwise it is
/// a comma, if the line contains a comma and commas are not decimal marks. Otherwise it is a blank.
///
/// Names of columns are read from a line before the numbers, which may be a comment. This line must
/// contain the names x, y and z, and no name twice. Without names, the first three columns are x, y
/// and z. The other columns are classified by the number of columns and by the values of the first
/// hundred lines:
/// - 4 columns: intensity;
/// - 6 columns: normals if all are of unit length, else colors if all are integers in 0..255;
/// - 7 columns: intensity and colors in either order;
/// - 9 columns: normals and colors in either order.
///
/// All other columns are named "Column4" and so on.
///
/// @param[in] start    bytes from the start of a text
/// @param[in] isWhole  whether `start` is the whole text; otherwise the last line may be incomplete
/// @throws NoTextCloud
TextCloudLayout findTextCloudLayout(std::string_view start, bool isWhole, bool decimalComma);
}

#endif

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
  char Delimiter = ' '; ///< blank includes tabs
  bool HasCount = false;
  bool HasNames = false;

  /// Destination of the value of each column.
  struct Column
  {
    std::size_t Array = 0;
    std::size_t Component = 0;
  };
  std::vector<Column> Columns;
  std::vector<NamedArray> Arrays; ///< without values; the first array is the points
  std::size_t FirstOffset = 0;    ///< offset of the lines with numbers
  double MeanLineBytes = 0.0;     ///< mean of the examined lines with points
  bool AllLinesFit = false;       ///< whether such lines exist and all have a number in each column
};

/// Test whether a line is blank or a comment after #, // or ;.
bool isIgnoredLine(std::string_view line);

/// Test whether a line begins with a number.
bool startsWithNumber(std::string_view line, char delimiter);

/// Describe the error of a line that is not a point: its number of columns, or a word that is not a
/// number.
std::string describeNoPoint(
  std::string_view line, const TextCloudLayout& layout, bool decimalComma);

/// Reason why the first lines of a text are not points; the line counts from 1.
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

/// Find the layout.
///
/// The delimiter is a semicolon if the first line of numbers has one. Else it is a comma if the
/// line has one and commas are not decimal marks, else a blank.
///
/// Names of columns come from a line before the numbers, a comment or not, with names x, y and z,
/// and no name twice. Without names, the columns after the first three are classified by their
/// number and by the values of the first hundred lines:
/// - 4 columns: intensity;
/// - 6 columns: normals if all are of unit length, else colors if all are integers in 0..255;
/// - 7 columns: intensity and colors in either order;
/// - 9 columns: normals and colors in either order.
///
/// All others are "Column4" and so on.
///
/// @param[in] start    bytes from the start of a text
/// @param[in] isWhole  whether they are the whole text; otherwise the last line may be incomplete
/// @throws NoTextCloud
TextCloudLayout findTextCloudLayout(std::string_view start, bool isWhole, bool decimalComma);
}

#endif

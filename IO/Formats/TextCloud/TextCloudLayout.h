/// Meaning of the columns of a text file with points, found from its first lines.

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
  char Delimiter = ' '; ///< also for tabs
  bool HasCount = false;
  bool HasNames = false;

  /// Where the value of each column goes.
  struct Column
  {
    std::size_t Array = 0;
    std::size_t Component = 0;
  };
  std::vector<Column> Columns;
  std::vector<NamedArray> Arrays; ///< without values; the first are the points
  std::size_t FirstOffset = 0;    ///< where the lines with numbers begin
  double MeanLineBytes = 0.0;     ///< of the lines with points that were seen
  bool AllLinesFit = false;       ///< whether there were some and all have a number in each column
};

/// Whether a line is blank or a remark behind #, // or ;.
bool isIgnoredLine(std::string_view line);

/// Whether a line begins with a number.
bool startsWithNumber(std::string_view line, char delimiter);

/// What is wrong with a line that is no point, for a message: its number of columns, or a word that
/// is no number.
std::string describeNoPoint(
  std::string_view line, const TextCloudLayout& layout, bool decimalComma);

/// Why the first lines of a text are no points; the line counts from 1.
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
/// The delimiter is a semicolon if the first line of numbers has one, else a comma if it has one
/// and commas are no decimal marks, else blanks. Names of columns come from a line before the
/// numbers, a remark or not, that names x, y and z, and nothing twice. Without names, columns after
/// the first three are told by their number and by the values of the first hundred lines: 4:
/// intensity; 6: normals if all are of unit length, else colors if all are whole and in 0..255; 7:
/// intensity and colors in either order; 9: normals and colors in either order; all others are
/// "Column4" and so on.
///
/// @param[in] start    bytes from the start of a text
/// @param[in] isWhole  whether that is all of it, otherwise its last line may be half of one
/// @throws NoTextCloud
TextCloudLayout findTextCloudLayout(std::string_view start, bool isWhole, bool decimalComma);
}

#endif

/// Read the points of an E57 scan, which are divided into packets.

#ifndef ConformalE57Section_h
#define ConformalE57Section_h

#include "Bytes/ProgressReport.h"
#include "E57/E57Column.h"
#include "E57/E57Description.h"
#include "E57/E57Pages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace conformal
{
/// Reader of the sections of a file that contain points. Source: ASTM E2807-11, section 9.
class E57Sections
{
public:
  /// @param[in] fileBytes  size of the file, which limits the total length of all sections
  E57Sections(E57Pages& pages, std::uint64_t fileBytes, ProgressReport& progress)
    : Pages(pages)
    , FileBytes(fileBytes)
    , Progress(progress)
  {
  }

  /// Read packets until all columns have the values of all points.
  /// @param[in,out] columns  decoders of the fields of the scan, in the order of its fields
  /// @throws ParseError if the section is malformed, or ends before all values
  void read(const E57Scan& scan, std::vector<E57Column>& columns);

private:
  void open(const E57Scan& scan);
  void checkLeft(std::size_t bytes) const;
  void readPacket(std::vector<E57Column>& columns);
  void readData(std::vector<E57Column>& columns, std::size_t bytes);

  E57Pages& Pages;
  const std::uint64_t FileBytes;
  ProgressReport& Progress;
  std::uint64_t TotalBytes = 0;          ///< length of all sections so far
  std::uint64_t Left = 0;                ///< length of the rest of the current section
  std::array<char, 1 << 16> Packet = {}; ///< longest packet
};
}

#endif

#include "E57/E57Section.h"

#include "Bytes/ByteOrder.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
constexpr std::size_t PacketHeaderBytes = 4;
constexpr std::size_t DataHeaderBytes = 6;
}

//------------------------------------------------------------------------------
void E57Sections::read(const E57Scan& scan, std::vector<E57Column>& columns)
{
  this->open(scan);
  const auto isDone = [](const E57Column& column) { return column.isDone(); };
  while (!std::all_of(columns.begin(), columns.end(), isDone))
  {
    try
    {
      this->readPacket(columns);
    }
    catch (const std::invalid_argument& e)
    {
      this->Pages.fail(ParseCode::Malformed, e.what());
    }
    this->Progress.tick();
  }
}

//------------------------------------------------------------------------------
// Move to the first packet of a section.
void E57Sections::open(const E57Scan& scan)
{
  constexpr char pointSection = 1;
  this->Pages.seek(scan.Section);
  char header[32]; // id, padding to 8 bytes, length, offsets of the first data and index packets
  this->Pages.read(header, sizeof(header));
  if (header[0] != pointSection)
  {
    this->Pages.fail(ParseCode::Malformed, "expected a section of points");
  }
  this->Left = littleEndianAt<std::uint64_t>(header + 8);
  // Scans that share a section would let a small file take much time.
  this->TotalBytes += std::min(this->Left, this->FileBytes + 1);
  if (this->TotalBytes > this->FileBytes)
  {
    this->Pages.fail(
      ParseCode::Malformed, "found sections of points that overlap or are longer than the file");
  }
  this->Left -= std::min<std::uint64_t>(this->Left, sizeof(header));
  this->Pages.seek(littleEndianAt<std::uint64_t>(header + 16));
}

//------------------------------------------------------------------------------
void E57Sections::readPacket(std::vector<E57Column>& columns)
{
  constexpr char dataPacket = 1;
  constexpr char ignoredPacket = 2; // 0 is a packet of the index, which is not needed
  this->checkLeft(PacketHeaderBytes);
  this->Pages.read(this->Packet.data(), PacketHeaderBytes);
  const std::size_t bytes = std::size_t(littleEndianAt<std::uint16_t>(this->Packet.data() + 2)) + 1;
  const char type = this->Packet[0];
  if (bytes % 4 != 0 || type < 0 || type > ignoredPacket)
  {
    this->Pages.fail(ParseCode::Malformed, "expected a packet of points");
  }
  this->checkLeft(bytes);
  this->Left -= bytes;
  if (type != dataPacket)
  {
    this->Pages.skip(bytes - PacketHeaderBytes);
    return;
  }
  this->Pages.read(this->Packet.data() + PacketHeaderBytes, bytes - PacketHeaderBytes);
  this->readData(columns, bytes);
}

//------------------------------------------------------------------------------
void E57Sections::checkLeft(std::size_t bytes) const
{
  if (bytes > this->Left)
  {
    this->Pages.fail(ParseCode::PrematureEnd,
      "the section of points ends before the values that recordCount states");
  }
}

//------------------------------------------------------------------------------
void E57Sections::readData(std::vector<E57Column>& columns, std::size_t bytes)
{
  const char* const packet = this->Packet.data();
  const std::size_t fields =
    bytes >= DataHeaderBytes ? littleEndianAt<std::uint16_t>(packet + PacketHeaderBytes) : 0;
  std::size_t at = DataHeaderBytes + 2 * fields;
  if (fields != columns.size() || at > bytes)
  {
    this->Pages.fail(ParseCode::Malformed,
      "found a packet of " + std::to_string(fields) + " fields, expected the " +
        std::to_string(columns.size()) + " of the prototype");
  }
  for (std::size_t i = 0; i < fields; ++i)
  {
    const std::size_t length = littleEndianAt<std::uint16_t>(packet + DataHeaderBytes + 2 * i);
    if (length > bytes - at)
    {
      this->Pages.fail(ParseCode::Malformed, "found a field that is longer than its packet");
    }
    columns[i].add({ packet + at, length });
    at += length;
  }
}
}

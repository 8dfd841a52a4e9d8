/// Read the directories of a TIFF file, which describe its pages, \cite TIFF6 section 2.

#ifndef ConformalTIFFDirectory_h
#define ConformalTIFFDirectory_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/ParseStatus.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
/// Function that opens an input at its beginning. The parser calls it again to move backward in an
/// input that has no function Seek.
using OpenInput = std::function<ParseStatus(ByteReader&)>;

/// Test whether the first bytes of a file are those of a TIFF file.
bool looksLikeTIFF(std::string_view start);

/// Numbers of the tags that are read.
enum class TIFFTag : std::uint16_t
{
  Width = 256,
  Height = 257,
  BitsPerSample = 258,
  Compression = 259,
  Description = 270,
  StripOffsets = 273,
  Orientation = 274,
  SamplesPerPixel = 277,
  RowsPerStrip = 278,
  StripByteCounts = 279,
  XResolution = 282,
  YResolution = 283,
  PlanarConfiguration = 284,
  ResolutionUnit = 296,
  Predictor = 317,
  TileWidth = 322,
  SampleFormat = 339
};

/// Directory of one page: numbers of each tag, none of which is negative. Rational numbers are
/// quotients. Of tags other than strips, only the first number is read. Only the first page has
/// a description and resolutions.
struct TIFFDirectory
{
  std::map<TIFFTag, std::vector<double>> Numbers;
  std::string Description;
  std::uint64_t Offset = 0; ///< of the directory in the file

  /// Return the first number of a tag, or a default if the page has no such tag.
  double number(TIFFTag tag, double otherwise) const;

  /// Return the first number of a tag, at most the largest int, or a default.
  int whole(TIFFTag tag, int otherwise) const;
};

/// File that can be read at any offset.
class TIFFFile
{
public:
  /// @throws ParseError if the input cannot be opened, or is no TIFF file
  TIFFFile(OpenInput open, const ParseLimits& limits);

  bool isBigEndian() const { return this->IsBig; }
  ByteReader& input() { return this->Input; }

  /// Move to an offset. @throws ParseError if the file ends before it
  void seek(std::uint64_t offset);

  /// Read the directories of all pages. Their time and memory are limited by the size of the file,
  /// also if directories or their arrays overlap.
  /// @throws ParseError if a page has a tag twice, or pages share so many tags that they exceed the
  ///   size of the file
  /// @throws Aborted if the progress callback of `run` returns false
  std::vector<TIFFDirectory> directories(const Run& run);

private:
  std::uint64_t number(int bytes);
  TIFFDirectory directory(std::uint64_t& next);
  void count(std::uint64_t records, std::uint64_t bytes); ///< adds to BytesOfTags
  void readEntry(TIFFDirectory& result, TIFFTag tag, std::uint16_t type, std::uint64_t count,
    std::uint64_t offset);

  OpenInput Open;
  const ParseLimits& Limits;
  ByteReader Input;
  bool IsBig = false;            ///< byte order
  bool HasLongOffsets = false;   ///< BigTIFF: offsets have 8 bytes instead of 4
  std::uint64_t First = 0;       ///< offset of the first directory
  std::uint64_t BytesOfTags = 0; ///< of all directories and arrays that were read
};
}

#endif

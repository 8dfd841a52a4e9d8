/// Define a stack of pictures as TIFF files of the programs ImageJ and Fiji hold it, \cite TIFF6.

#ifndef ConformalTIFFStack_h
#define ConformalTIFFStack_h

#include "Bytes/OwnedArray.h"
#include "Bytes/ScalarType.h"

#include <array>
#include <cstddef>
#include <string>

namespace conformal
{
/// Size, type and units of a stack.
struct TIFFStackInfo
{
  std::size_t Width = 0;
  std::size_t Height = 0;
  std::size_t Slices = 1;
  std::size_t Channels = 1;
  std::size_t Frames = 1; ///< time steps
  ScalarType Type = ScalarType::UInt8;
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 }; ///< positive, in Unit
  std::string Unit;                                  ///< such as "micron"; empty if unknown
  double FrameInterval = 1.0;                        ///< positive, in seconds or unknown units

  std::size_t pixelsPerPage() const { return this->Width * this->Height; }
  std::size_t pages() const { return this->Slices * this->Channels * this->Frames; }
};

/// A stack. The numbers of the channels of a voxel are consecutive. Voxels are in rows, rows in
/// slices, and slices in frames. The parser reads one frame, and the writer writes all.
struct TIFFStack
{
  TIFFStackInfo Info;
  OwnedArray<unsigned char> Values; ///< bytes, in the byte order of this machine
};
}

#endif

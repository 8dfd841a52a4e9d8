/// Parser of PCD files of the Point Cloud Library.

#ifndef ConformalPCDParser_h
#define ConformalPCDParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/FilePiece.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

namespace conformal
{
/// Read a file of version 0.5 to 0.7: ascii, binary or binary_compressed.
///
/// x, y, z become Points (Float32 if all three are, else Float64), normal_x, normal_y, normal_z
/// "Normals". Fields rgb and rgba of four bytes, whatever type they claim, are colors, "RGB" and
/// "RGBA" (UInt8). Every other field keeps its name, type and count; padding is left out. A point
/// that is not finite is one that the scanner did not see: it is dropped without a word.
///
/// @param[in] piece  of a binary file that is not compressed; others cannot be cut
SurfaceResult parsePCD(ByteReader& input, const FilePiece& piece = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif

/// Parse PCD files of the Point Cloud Library.

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
/// Fields x, y, z become Points (Float32 if all three fields are, else Float64). Fields normal_x,
/// normal_y, normal_z become "Normals". Fields rgb and rgba of four bytes and any type become the
/// colors "RGB" and "RGBA" (UInt8). Every other field keeps its name, type and count; padding is
/// omitted. A point that is not finite marks a pixel without a measurement: it is dropped without a
/// message.
///
/// @param[in] piece  part to read of a file in format "binary"; other files cannot be divided
SurfaceResult parsePCD(ByteReader& input, const FilePiece& piece = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif

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
/// Read a PCD file of version 0.5 to 0.7, in format ascii, binary or binary_compressed.
///
/// Fields x, y, z become the coordinates. Coordinates are Float32 if all three fields are 4-byte
/// floats, otherwise Float64. Fields normal_x, normal_y, normal_z become "Normals". A field rgb or
/// rgba of four bytes, whatever its type, becomes the colors "RGB" or "RGBA" (UInt8). Every other
/// field becomes an array with the field's name, type and number of components. Padding fields,
/// which contain no data, are omitted.
///
/// The position in the line VIEWPOINT becomes SurfaceData::ScannerPosition, see
/// PCDHeader::ScannerPosition. The orientation of the scanner is ignored.
///
/// A point with a coordinate that is not finite marks a pixel of the scanner without a measurement.
/// The parser drops this point, and does not count it in SurfaceData::DroppedPoints.
///
/// @param[in] piece  part of the points to read. Only files in format "binary" can be divided. In
///   all other files, all points belong to the first part
SurfaceResult parsePCD(ByteReader& input, const FilePiece& piece = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif

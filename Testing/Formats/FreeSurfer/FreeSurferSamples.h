// Make valid and broken files of FreeSurfer for tests.
#ifndef FreeSurferSamples_h
#define FreeSurferSamples_h

#include "../Bytes/MadeBytes.h"

namespace samples
{
inline const std::vector<float>& TetrahedronPoints()
{
  static const std::vector<float> points = { 0, 0, -100, 94.28F, 0, 33.33F, -47.14F, 81.65F, 33.33F,
    -47.14F, -81.65F, 33.33F };
  return points;
}

inline const std::vector<std::int32_t>& TetrahedronIds()
{
  static const std::vector<std::int32_t> ids = { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 };
  return ids;
}

// Return a surface file of triangles. The polygons do not depend on the scale. The surface of scale
// 1 can therefore be the sphere of the surface of another scale.
inline std::string FreeSurferTriangles(float scale = 1.0F)
{
  Bytes file(true,
    "\xFF\xFF\xFE"
    "created by me on a day\n\n");
  file.add<std::int32_t>(4).add<std::int32_t>(4);
  for (const float coordinate : TetrahedronPoints())
  {
    file.add(scale * coordinate);
  }
  return file.add(TetrahedronIds())
    .add(std::vector<std::int32_t>{ 2, 0, 20 })
    .text("valid = 1  # volume info valid\ncras   = 1 2 3\n")
    .bytes();
}

inline Bytes& Add24(Bytes& file, std::uint32_t value)
{
  return file.add(static_cast<std::uint8_t>(value >> 16))
    .add(static_cast<std::uint8_t>(value >> 8))
    .add(static_cast<std::uint8_t>(value));
}

inline std::string FreeSurferQuads(bool isOld)
{
  Bytes file(true, isOld ? "\xFF\xFF\xFF" : "\xFF\xFF\xFD");
  Add24(Add24(file, 5), 2);
  for (int i = 0; i < 15; ++i)
  {
    isOld ? file.add(static_cast<std::int16_t>(50 * i - 300))
          : file.add(0.5F * static_cast<float>(i) - 3.0F);
  }
  for (const std::uint32_t id : { 0U, 1U, 2U, 3U, 1U, 2U, 4U, 3U })
  {
    Add24(file, id);
  }
  return file.bytes();
}

inline std::string FreeSurferCurv(bool isOld, int points = 4)
{
  Bytes file(true, isOld ? "" : "\xFF\xFF\xFF");
  if (isOld)
  {
    Add24(Add24(file, static_cast<std::uint32_t>(points)), 4);
  }
  else
  {
    file.add<std::int32_t>(points).add<std::int32_t>(4).add<std::int32_t>(1);
  }
  for (int i = 0; i < points; ++i)
  {
    isOld ? file.add(static_cast<std::int16_t>(25 * i - 50))
          : file.add(0.25F * static_cast<float>(i) - 0.5F);
  }
  return file.bytes();
}

inline std::vector<std::string> FreeSurferFiles()
{
  return { FreeSurferTriangles(), FreeSurferQuads(false), FreeSurferQuads(true) };
}

// Return a file with the four bytes from `at` on replaced by a number.
inline std::string With32(std::string file, std::size_t at, std::uint32_t value)
{
  return file.replace(at, 4, Bytes(true).add(value).bytes());
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadFreeSurferFiles()
{
  const std::string triangles = FreeSurferTriangles();
  const std::string quads = FreeSurferQuads(false);
  const std::string old = FreeSurferQuads(true);
  const std::size_t head = 3 + 24; // size of the magic number and the lines of text
  const std::size_t ids = head + 8 + 48;
  std::vector<std::string> files = { FreeSurferCurv(true), FreeSurferCurv(false),
    With32(triangles, head, 0xFFFFFFFFU), With32(triangles, head, 0x7FFFFFFFU),
    With32(triangles, head, 1000), With32(triangles, head, 0),
    With32(triangles, head + 4, 0x80000000U), With32(triangles, head + 4, 0x7FFFFFFFU),
    With32(triangles, head + 4, 100), With32(triangles, head + 8, 0x7FC00000U),
    With32(triangles, head + 12, 0x7F800000U), With32(triangles, head + 16, 0xFF800000U),
    With32(triangles, ids, 4), With32(triangles, ids + 44, 0xFFFFFFFFU),
    With32(triangles, ids + 8, 0x7FFFFFFFU), With32(triangles, 0, 0xFFFFFC00U),
    replaced(triangles, "\n", " "), "\xFF\xFF\xFE" + std::string(10000, 'x') };
  for (const std::string& file : { triangles.substr(0, ids + 48), quads, old })
  {
    for (const std::size_t size : { std::size_t(2), std::size_t(3), std::size_t(5), file.size() / 3,
           file.size() / 2, file.size() - 3, file.size() - 1 })
    {
      files.push_back(file.substr(0, size));
    }
  }
  return files;
}
}

#endif

// Make scans of a sphere from three sides, in the format of the Stanford 3D Scanning Repository.
#ifndef AlignedScansSamples_h
#define AlignedScansSamples_h

#include "../PLY/PLYSamples.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace samples
{
struct SphereScan
{
  std::string Name;
  std::array<double, 3> Translation;
  std::array<double, 4> Quaternion; // unit quaternion with the scalar part last
};

inline const std::vector<SphereScan>& SphereScanMotions()
{
  static const std::vector<SphereScan> scans = { { "front.ply", { 0, 0, 0 }, { 0, 0, 0, 1 } },
    { "side.ply", { 0.5, -1, 2 }, { 0, 0.6, 0, 0.8 } },
    { "top.ply", { -3, 0.25, 0 }, { 0.5, 0.5, -0.5, 0.5 } } };
  return scans;
}

// Return the vector v, rotated by the usual rotation of a unit quaternion q.
inline std::array<double, 3> Turned(const std::array<double, 4>& q, const std::array<double, 3>& v)
{
  const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b)
  {
    return std::array<double, 3>{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0] };
  };
  const std::array<double, 3> axis = { q[0], q[1], q[2] };
  std::array<double, 3> inner = cross(axis, v);
  for (int c = 0; c < 3; ++c)
  {
    inner[c] += q[3] * v[c];
  }
  const std::array<double, 3> outer = cross(axis, inner);
  return { v[0] + 2 * outer[0], v[1] + 2 * outer[1], v[2] + 2 * outer[2] };
}

// Return scans of the unit sphere as big-endian PLY files, with a range grid and a confidence. The
// list of scans moves each point p of a scan to R^-1 p + t. For each scanned point s of the sphere,
// the scan therefore contains p = R (s - t).
inline std::vector<std::pair<std::string, std::string>> SphereScans()
{
  std::vector<std::pair<std::string, std::string>> files;
  for (const SphereScan& scan : SphereScanMotions())
  {
    constexpr int size = 7;
    Bytes vertices(true);
    Bytes grid(true);
    int count = 0;
    for (int cell = 0; cell < size * size; ++cell)
    {
      const double x = 0.35 * (cell % size - size / 2);
      const double y = 0.35 * (cell / size - size / 2);
      const double zz = 1.0 - x * x - y * y;
      grid.add<std::uint8_t>(zz >= 0.0 ? 1 : 0);
      if (zz < 0.0)
      {
        continue;
      }
      // The scanned side of the sphere is rotated with the scanner.
      const std::array<double, 3> seen = { x, y, std::sqrt(zz) };
      const std::array<double, 3> shift = Turned(scan.Quaternion, scan.Translation);
      for (int c = 0; c < 3; ++c)
      {
        vertices.add(static_cast<float>(seen[c] - shift[c]));
      }
      vertices.add(0.5F);
      grid.add<std::int32_t>(count++);
    }
    files.emplace_back(scan.Name,
      "ply\nformat binary_big_endian 1.0\nobj_info num_cols 7\nobj_info num_rows 7\n"
      "element vertex " +
        std::to_string(count) +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty float confidence\n"
        "element range_grid 49\nproperty list uchar int vertex_indices\nend_header\n" +
        vertices.bytes() + grid.bytes());
  }
  files.emplace_back("broken.ply", "ply\nformat ascii 1.0\nend_header\n");
  return files;
}

inline const std::string& SphereConf()
{
  static const std::string text = "camera 0 0 0 0 0 0 1\n"
                                  "bmesh front.ply 0 0 0 0 0 0 1\n"
                                  "bmesh side.ply 0.5 -1 2 0 0.6 0 0.8\n"
                                  "mesh top.ply -3 0.25 0 0.5 0.5 -0.5 0.5\n";
  return text;
}

inline std::vector<std::string> AlignedScansFiles()
{
  return { SphereConf(), "mesh side.ply 0 0 0 0 0 0 2\n" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadAlignedScansFiles()
{
  const std::string& conf = SphereConf();
  std::vector<std::string> files = { "camera 0 0 0 0 0 0 1\n", "# nothing\n",
    "mesh missing.ply 0 0 0 0 0 0 1\n", "mesh . 0 0 0 0 0 0 1\n",
    replaced(conf, "bmesh side", "bash side"), replaced(conf, "side.ply", "front.ply"),
    replaced(conf, "side.ply", "broken.ply"), replaced(conf, "side.ply", "../side.ply"),
    replaced(conf, "side.ply", "a/../../side.ply"), replaced(conf, "side.ply", "/dev/zero"),
    replaced(conf, "side.ply", "/etc/passwd"), replaced(conf, "side.ply ", ""),
    replaced(conf, "bmesh side.ply 0.5 -1 2 0 0.6 0 0.8", "bmesh"),
    replaced(conf, "0 0.6 0 0.8", "0 0.6 0"), replaced(conf, "0 0.6 0 0.8", "0 0.6 0 0.8 1"),
    replaced(conf, "0 0.6 0 0.8", "0 0 0 0"), replaced(conf, "0 0.6 0 0.8", "1e-320 0 0 0 0"),
    replaced(conf, "-1 2", "1e308 1e999") };
  for (const char* word :
    { "1.2.3", "--5", "0x1p3", "1e999", "1,5", "one", "", "nan", "inf", "5 5" })
  {
    files.push_back(replaced(conf, "0.5 -1", std::string(word) + " -1"));
  }
  return files;
}
}

#endif

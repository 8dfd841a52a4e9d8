// Make valid and broken plate models for tests.
#ifndef PlateModelSamples_h
#define PlateModelSamples_h

#include "../Bytes/MadeBytes.h"

namespace samples
{
// Return a file with two tables. Each table has a count and numbered rows.
inline const std::string& NumberedPlates()
{
  static const std::string text =
    "       4\n       1   0.00000   0.00000   0.00000\n       2   1.50000   0.00000   0.00000\n"
    "       3   0.00000   1.00000   0.00000\n       4   0.00000   0.00000   0.00100\n"
    "       4\n       1       1       3       2\n       2       1       2       4\n"
    "       3       2       3       4\n       4       3       1       4\n";
  return text;
}

// Return a .ver file with both counts on the first line. The number of corners of each plate is on
// a separate line.
inline const std::string& VerPlates()
{
  static const std::string text = "  4   4\n 0 0 0\n 1.5 0 0\n 0 1 0\n 0 0 1e-3\n"
                                  " 3\n 1 3 2\n 3\n 1 2 4\n 3\n 2 3 4\n 3\n 3 1 4\n";
  return text;
}

// Return a file whose rows have tags.
inline const std::string& TaggedPlates()
{
  static const std::string text = "# a tetrahedron\nv 0 0 0\n v   1.5 0 0\nv 0 1 0\nv 0 0 1e-3\n\n"
                                  "f 1 3 2\nf 1 2 4\r\n# two more\nf 2 3 4\nf 3 1 4\n";
  return text;
}

// Return an implicitly connected quadrilateral model: grids of (q + 1) x (q + 1) vertices on the
// six sides of the cube [-1, 1]^3. Rows and columns of all sides are oriented alike.
inline std::string CubeModel(int q, bool isReversed = false)
{
  std::string text = "  " + std::to_string(q) + "\n";
  for (int face = 0; face < 6; ++face)
  {
    for (int j = 0; j <= q; ++j)
    {
      for (int i = 0; i <= q; ++i)
      {
        const int u = isReversed ? j : i, v = isReversed ? i : j;
        int position[3] = {};
        const int axis = face / 2, sign = face % 2 ? -1 : 1;
        position[axis] = sign * q;
        position[(axis + 1) % 3] = sign * (2 * u - q);
        position[(axis + 2) % 3] = 2 * v - q;
        for (const int coordinate : position)
        {
          text += " " + std::to_string(static_cast<double>(coordinate) / q);
        }
        text += "\n";
      }
    }
  }
  return text;
}

inline std::vector<std::string> PlateModelFiles()
{
  return { NumberedPlates(), VerPlates(), TaggedPlates(), CubeModel(1), CubeModel(2), CubeModel(5),
    "4 4\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n"
    "0 2 1\r\n0 1 3\r\n1 2 3\r\n2 0 3\r\n\r\n",
    "3 1\n\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n", "3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n1\n0 0 1 2\n" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadPlateModelFiles()
{
  const auto& numbered = NumberedPlates();
  const auto& ver = VerPlates();
  const auto& tagged = TaggedPlates();
  const std::string cube = CubeModel(2);
  const std::string four = "       4\n       1  ";
  return { replaced(numbered, "1.50000", "1.2.3"), replaced(numbered, "1.50000", "--5"),
    replaced(numbered, "1.50000", "0x1p3"), replaced(numbered, "1.50000", "1e999"),
    replaced(numbered, "1.50000", "1,5"), replaced(numbered, "1.50000", "nan"),
    replaced(numbered, "1.50000", "inf"), replaced(numbered, "1.50000", ""),
    replaced(numbered, "1.50000", "1.5 7"), replaced(numbered, "       2   1.5", "       3   1.5"),
    replaced(numbered, "       1   0.0", "       2   0.0"),
    replaced(numbered, "       2       1       2       4", "       2       1       2       5"),
    replaced(numbered, "       2       1       2       4", "       2       1       2      -1"),
    replaced(numbered, "       2       1       2       4", "       2       1       2     2.5"),
    replaced(numbered, "       2       1       2       4", "       2       1       2       0"),
    replaced(numbered, "       2       1       2       4", "       3       1       2       4"),
    replaced(numbered, "       2       1       2       4", "       1       2       4"),
    replaced(ver, "  4   4", "  5   4"), replaced(ver, "  4   4", "  3   4"),
    replaced(ver, "  4   4", "  4   5"), replaced(ver, "  4   4", "  4   3"),
    replaced(ver, "  4   4", " -4   4"), replaced(ver, "  4   4", "  4  -4"),
    replaced(ver, "  4   4", "  4 4 4"), replaced(ver, "  4   4", "  4.5 4"),
    replaced(ver, "  4   4", "4000000000 4"), replaced(ver, "  4   4", "4 4000000000"),
    replaced(ver, "  4   4", "99999999999999999999 1"), replaced(ver, " 3\n 1 2 4", " 4\n 1 2 4"),
    replaced(ver, " 3\n 1 2 4", " 3\n 1 2"), replaced(ver, " 3\n 1 2 4", " 3\n 1 2 x"),
    replaced(ver, " 3\n 1 2 4", " 3\n 3 1 2 4"), ver + " 7\n", ver.substr(0, ver.size() - 8),
    replaced(tagged, "1.5", "1.2.3"), replaced(tagged, "1.5", "nan"), replaced(tagged, "1.5", ""),
    replaced(tagged, "1.5", "1.5 2"), replaced(tagged, "f 1 2 4", "f 1 2 5"),
    replaced(tagged, "f 1 2 4", "f 1 2 0"), replaced(tagged, "f 1 2 4", "f 1 2 2.5"),
    replaced(tagged, "f 1 2 4", "f 1 2"), replaced(tagged, "f 1 2 4", "f 1 2 3 4"),
    replaced(tagged, "f 1 2 4", "f 1/1 2/2 4/4"), replaced(tagged, "f 1 2 4", "v 1 2 4"),
    replaced(tagged, "f 1 2 4", "vt 1 2"), replaced(tagged, "v 0 1 0", "1 0 1 0"), cube + "1 2 3\n",
    cube.substr(0, cube.size() - 30), replaced(cube, "  2\n", "  3\n"),
    replaced(cube, "  2\n", "  4000000000\n"), replaced(cube, "1.000000\n", "1.000000 1\n"),
    replaced(cube, "1.000000\n", "inf\n"), replaced(cube, "1.000000\n", "\n") };
}
}

#endif

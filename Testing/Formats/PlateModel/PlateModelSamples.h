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

inline std::vector<std::string> PlateModelFiles()
{
  return { NumberedPlates(), VerPlates(),
    "4 4\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n"
    "0 2 1\r\n0 1 3\r\n1 2 3\r\n2 0 3\r\n\r\n",
    "3 1\n\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n", "3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n1\n0 0 1 2\n" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadPlateModelFiles()
{
  const auto& numbered = NumberedPlates();
  const auto& ver = VerPlates();
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
    replaced(ver, " 3\n 1 2 4", " 3\n 3 1 2 4"), ver + " 7\n", ver.substr(0, ver.size() - 8) };
}
}

#endif

// Make valid and broken OFF files for tests.
#ifndef OFFSamples_h
#define OFFSamples_h

#include "../Bytes/MadeBytes.h"

namespace samples
{
inline const std::string& PlainOFF()
{
  static const std::string text = "OFF\n4 4 6\n0 0 0\n1.5 0 0\n0 1 0\n0 0 1e-3\n"
                                  "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  return text;
}

// Return a text file with all prefixes except 4 and n. The file has comments, and all kinds of
// colors of faces.
inline const std::string& RichOFF()
{
  static const std::string text = "STCNOFF # all of it\n# points\n4 3 # no edges\n\n"
                                  "0 0 0  0 0 1  1 0 0 1  0 0.25\n"
                                  "1 0 0  0 1 0  0 1 0 0.5  0 0.5 # a remark\n"
                                  "0 1 0  1 0 0  0 0 1 1  1 0.75\n"
                                  "0 0 1  0 0 -1  1 1 1 0  1 1\n"
                                  "3 0 2 1 255 128 0\n4 0 1 2 3\n3 0 1 3 7\n";
  return text;
}

inline std::string BinaryOFF()
{
  Bytes file(true, "CNOFF BINARY\n");
  file.add<std::int32_t>(3).add<std::int32_t>(1).add<std::int32_t>(0);
  for (int i = 0; i < 3; ++i)
  {
    file.add(std::vector<float>{ 0.5F * float(i), float(i == 1), 0.1F }); // coordinates
    file.add(std::vector<float>{ 0, 0, 1, 1, 0.5F, 0, 1 });               // normal and color
  }
  file.add(std::vector<std::int32_t>{ 3, 0, 1, 2, 3 }).add(std::vector<float>{ 0, 1, 0 });
  return file.bytes();
}

inline std::vector<std::string> OFFFiles()
{
  return { PlainOFF(), RichOFF(), BinaryOFF(), "COFF 2 0 0\n0 0 0 255 0 0 255\n1 0 0 0 9 0 255\n",
    "4nOFF\n3\n3 1 3\n0 0 0 1\n2 0 0 2\n0 2 0 4\n3 0 1 2 4\n",
    "OFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 9\n3 0 1 2\n" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadOFFFiles()
{
  const auto& plain = PlainOFF();
  const std::string binary = BinaryOFF();
  return { replaced(plain, "OFF", "OFFX"), replaced(plain, "OFF\n", "nOFF 4\n"),
    replaced(plain, "OFF\n", "COFF\n"), replaced(plain, "OFF\n", "STOFF\n"),
    replaced(plain, "OFF\n", "NOFF\n"), replaced(plain, "OFF\n", "OFF BINARY\n"),
    replaced(plain, "4 4 6", "5 4 6"), replaced(plain, "4 4 6", "3 4 6"),
    replaced(plain, "4 4 6", "4 5 6"), replaced(plain, "4 4 6", "4 3 6"),
    replaced(plain, "4 4 6", "-4 4 6"), replaced(plain, "4 4 6", "4 -4 6"),
    replaced(plain, "4 4 6", "4000000000 4 0"), replaced(plain, "4 4 6", "4 4000000000 0"),
    replaced(plain, "4 4 6", "4"), replaced(plain, "4 4 6", "99999999999999999999 1 1"),
    replaced(plain, "1.5", "1.2.3"), replaced(plain, "1.5", "--5"), replaced(plain, "1.5", "0x1p3"),
    replaced(plain, "1.5", "1e999"), replaced(plain, "1.5", "1,5"), replaced(plain, "1.5", "one"),
    replaced(plain, "1.5", "nan"), replaced(plain, "1.5", "-inf"), replaced(plain, "1.5", ""),
    replaced(plain, "1.5 0 0", "1.5 0 0 1"), replaced(plain, "1.5 0 0", "1.5 0 0 1 2 3"),
    replaced(plain, "3 1 2 3", "3 1 2 4"), replaced(plain, "3 1 2 3", "3 1 2 -1"),
    replaced(plain, "3 1 2 3", "-3 1 2 3"), replaced(plain, "3 1 2 3", "3 1 2 3 1 1"),
    replaced(plain, "3 1 2 3", "3 1 2 3 1 1 300"),
    replaced(plain, "3 1 2 3", "3 1 2 3 1 1 1 1 1 1 1"), replaced(plain, "3 1 2 3", "4 1 2"),
    replaced(plain, "3 1 2 3", "3 1 2 x"), replaced(plain, "3 1 2 3", "2000000000 1 2 3"),
    binary.substr(0, binary.size() - 1), plain.substr(0, plain.size() / 2),
    replaced(RichOFF(), "255 128 0", "255 128 nan") };
}
}

#endif

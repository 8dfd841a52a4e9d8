// Make valid and broken text files of points for tests.
#ifndef TextCloudSamples_h
#define TextCloudSamples_h

#include "../Bytes/MadeBytes.h"

namespace samples
{
inline const std::string& PlainCloud()
{
  static const std::string text = "0.5 1.5 2.5\n1234567.123456789 -1e-3 .25\n7 8 9\n";
  return text;
}

// Return a file with named columns in unusual order, as spreadsheets write them.
inline const std::string& NamedCloud()
{
  static const std::string text = "\"label\",\"X\",\"Y\",\"Z\",Red,green,Blue,nx,ny,nz,i\n"
                                  "5,0.5,1,2,1,2,3,0,0,1,-2048\n"
                                  "6, -0.5, 1, 2, 255, 254, 253, 0, 1, 0, 2047\n";
  return text;
}

// Return a laser scan of two blocks of points.
inline const std::string& LaserCloud()
{
  static const std::string text = "3\n0 0 0 -100 1 2 3\n1 0 0 100 4 5 6\n0 1 0 7 7 8 9\n"
                                  "1\n0 0 1 8 250 251 252\n";
  return text;
}

inline std::vector<std::string> TextCloudFiles()
{
  return { PlainCloud(), NamedCloud(), LaserCloud(),
    "//X;Y;Z\n# a remark\n0;0;1\n1;0;1\n\n; another\n0;1;1",
    "0 0 1 0 0 1\n1 0 0 1 0 0\n0 1 0 0 0.6 0.8\n",
    "0\t0\t1\t10\t20\t30\t0\t0\t1\n0\t0\t2\t11\t21\t31\t0\t1\t0\n" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadTextCloudFiles()
{
  const auto& plain = PlainCloud();
  const auto& named = NamedCloud();
  const auto& laser = LaserCloud();
  return { replaced(plain, "1234567.123456789", "1.2.3"),
    replaced(plain, "1234567.123456789", "--5"), replaced(plain, "1234567.123456789", "0x1p3"),
    replaced(plain, "1234567.123456789", "1e999"), replaced(plain, "1234567.123456789", "1,5"),
    replaced(plain, "1234567.123456789", "one"), replaced(plain, "1234567.123456789", "5 5"),
    replaced(plain, "1234567.123456789", ""), replaced(plain, "0.5", "1.2.3"),
    replaced(plain, "0.5", "--5"), replaced(plain, "0.5", "0x1p3"), replaced(plain, "0.5", "1e999"),
    replaced(plain, "0.5", "x 1"), replaced(plain, "7 8 9", "7 8"),
    replaced(plain, "7 8 9", "7 8 9 10"), replaced(plain, "7 8 9", "x y z"),
    replaced(plain, "7 8 9", "7;8;9"), replaced(plain, "7 8 9", "7,8,9"),
    replaced(named, "\"X\"", "\"A\""), replaced(named, "Red,", ""),
    replaced(named, "green,Blue", "Red,Blue"), replaced(named, ",i\n", ",label\n"),
    replaced(named, "255, 254", "255; 254"), replaced(named, "2047", "2047, 1"),
    replaced(named, "0.5,", "0.5."), replaced(named, "5,0.5", "5,\"0.5\""), "5\n" + plain,
    "2\n" + plain, "2000000000\n" + plain, "99999999999999999999\n" + plain, "-3\n" + plain,
    "1 2\n", "x y z\n", "# x y z\n", replaced(laser, "1 2 3", "1 2"), laser + "7 7 7 7 7 7 7\n",
    laser + "5\n", plain + "1 2 3 \x01\n", plain + "1 2 3 4 \n" };
}
}

#endif

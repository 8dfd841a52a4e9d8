// Clouds as text, made in place.
#ifndef TextCloudSamples_h
#define TextCloudSamples_h

#include <string>
#include <vector>

namespace samples
{
inline const std::string& PlainCloud()
{
  static const std::string text = "0.5 1.5 2.5\n1234567.123456789 -1e-3 .25\n7 8 9\n";
  return text;
}

// Columns by names, in an order of their own, as spreadsheets write them.
inline const std::string& NamedCloud()
{
  static const std::string text = "\"label\",\"X\",\"Y\",\"Z\",Red,green,Blue,nx,ny,nz,i\n"
                                  "5,0.5,1,2,1,2,3,0,0,1,-2048\n"
                                  "6, -0.5, 1, 2, 255, 254, 253, 0, 1, 0, 2047\n";
  return text;
}

// Two blocks of a laser scan.
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
}

#endif

// Make valid and broken files of spherical-harmonic coefficients for tests.
#ifndef SPHARMSamples_h
#define SPHARMSamples_h

#include "../Bytes/MadeBytes.h"

namespace samples
{
// Return coefficients up to degree 1, with the number of digits that SPHARM-PDM writes.
inline const std::string& SPHARMCoefficients()
{
  static const std::string text = "{ 4,{0.500000, -1.000000, 2.000000},\n"
                                  "{0.000000, 0.000000, 3.250000},\n"
                                  "{-4.000000, 0.000000, 0.000000},\n"
                                  "{0.000000, -5.125000, 0.100000}}";
  return text;
}

inline std::vector<std::string> SPHARMCoefficientFiles()
{
  std::string large = "{ 49,{1,2,3}";
  for (int i = 1; i < 49; ++i)
  {
    const std::string number = std::to_string(i);
    large += ",{" + number + "e-3, -0." + number + ", 1" + number + "}";
  }
  return { SPHARMCoefficients(), large + "}\n", "{1,{0,0,0}}" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadSPHARMCoefficientFiles()
{
  const std::string& good = SPHARMCoefficients();
  return { replaced(good, "3.25", "1.2.3"), replaced(good, "3.25", "--5"),
    replaced(good, "3.25", "0x1p3"), replaced(good, "3.250000", "1e999"),
    replaced(good, "3.250000", "nan"), replaced(good, "3.250000", "inf"),
    replaced(good, "3.250000", ""), replaced(good, "3.250000", "three"),
    replaced(good, "3.250000}", "3.250000"), replaced(good, "{-4", "-4"),
    replaced(good, "0.000000, 0.000000, 3.25", "0.000000 0.000000, 3.25"),
    replaced(good, "{0.000000, -5.125000, 0.100000}", "{0.000000, -5.125000}"),
    replaced(good, "{0.000000, -5.125000, 0.100000}", "{0, 1, 2, 3}"), replaced(good, "}}", "}"),
    replaced(good, "}}", "},"), good + "}", good + " x", replaced(good, "{ 4", "{ 3"),
    replaced(good, "{ 4", "{ 0"), replaced(good, "{ 4", "{ 9"), replaced(good, "{ 4", "{ 1"),
    replaced(good, "{ 4", "{ -4"), replaced(good, "{ 4", "{ 4.5"),
    replaced(good, "{ 4", "{ 18446744073709551615"),
    replaced(good, "{ 4", "{ 99999999999999999999"), replaced(good, "{ 4,", "{ 4"),
    replaced(good, "{ 4,{", "{ 4,"), replaced(good, "{ 4", "4"), replaced(good, "{ 4", "[ 4") };
}
}

#endif

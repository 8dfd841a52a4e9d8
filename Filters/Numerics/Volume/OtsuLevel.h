/// Choose the level that separates the object of an image from its background, \cite Otsu1979.

#ifndef ConformalOtsuLevel_h
#define ConformalOtsuLevel_h

#include "Base/Run.h"

#include <vector>

namespace conformal
{
/// Return the level k* that maximizes the variance between the values below and above it,
/// \cite Otsu1979 Eqs. 18 and 19. The histogram has 1024 bins between the smallest and the largest
/// value. The result is a border of two bins. If all values are equal, the result is this value.
/// @param[in] values  finite, at least one
/// @throws std::invalid_argument if there are no values
double otsuLevel(const std::vector<float>& values, const Run& run = {});
}

#endif

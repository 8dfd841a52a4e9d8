/// Picture of a page, reduced to the size it needs.

#ifndef ConformalPagePicture_h
#define ConformalPagePicture_h

#include <cstddef>
#include <vector>

namespace conformal
{
struct PagePicture
{
  std::size_t Width = 0;
  std::size_t Height = 0;
  std::vector<unsigned char> Pixels; ///< Height rows of Width by 3: red, green, blue
};

/// A picture shrunk evenly until neither side is larger than asked for; each new pixel is the mean
/// of the area that it covers. What is small enough stays as it is. Opacity is left out.
/// @param[in] pixels       rows of pixels of 3 or 4 bytes
/// @param[in] components   3 or 4
/// @param[in] maximumSize  pixels along the longer side, at least 1
PagePicture shrunkPicture(const unsigned char* pixels, std::size_t width, std::size_t height,
  std::size_t components, std::size_t maximumSize);
}

#endif

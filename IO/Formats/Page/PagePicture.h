/// Reduce a picture to a maximum size, for a web page.

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
  /// Height rows of Width pixels. Each pixel has 3 bytes: red, green, blue.
  std::vector<unsigned char> Pixels;
};

/// Reduce a picture so that neither side has more than `maximumSize` pixels. The ratio of the sides
/// is kept. Each new pixel is the mean of the old pixels in its area. If the picture is small
/// enough, its size is not changed. Opacity is omitted.
/// @param[in] pixels       rows of pixels of 3 or 4 bytes
/// @param[in] components   number of bytes of a pixel, 3 or 4
/// @param[in] maximumSize  maximum number of pixels along a side, at least 1
PagePicture shrunkPicture(const unsigned char* pixels, std::size_t width, std::size_t height,
  std::size_t components, std::size_t maximumSize);
}

#endif

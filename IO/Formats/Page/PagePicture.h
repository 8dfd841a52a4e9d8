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

/// Reduce a picture evenly until neither side exceeds a limit; each new pixel is the mean over its
/// area. A small picture keeps its size. Opacity is omitted.
/// @param[in] pixels      rows of pixels of 3 or 4 bytes
/// @param[in] components  3 or 4
/// @param[in] largest     maximum number of pixels along the longer side, at least 1
PagePicture shrunkPicture(const unsigned char* pixels, std::size_t width, std::size_t height,
  std::size_t components, std::size_t largest);
}

#endif

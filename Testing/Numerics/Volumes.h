/// Make images of three dimensions for tests.
#ifndef ConformalTestVolumes_h
#define ConformalTestVolumes_h

#include "Volume/VolumeImage.h"

#include <functional>

namespace volumes
{
/// Make an image of a function of the position. The middle of the image is at (0, 0, 0).
inline conformal::VolumeImage of(const std::array<conformal::Index, 3>& size,
  const conformal::Vector3& spacing,
  const std::function<double(const conformal::Vector3&)>& function)
{
  conformal::VolumeImage volume;
  volume.Size = size;
  volume.Axes = spacing.asDiagonal();
  for (int a = 0; a < 3; ++a)
  {
    volume.Origin[a] = -0.5 * static_cast<double>(size[a] - 1) * spacing[a];
  }
  volume.Values.resize(volume.size());
  for (conformal::Index k = 0; k < size[2]; ++k)
  {
    for (conformal::Index j = 0; j < size[1]; ++j)
    {
      for (conformal::Index i = 0; i < size[0]; ++i)
      {
        const conformal::Vector3 x =
          volume.Origin + volume.Axes * conformal::Vector3(double(i), double(j), double(k));
        volume.Values[volume.id(i, j, k)] = static_cast<float>(function(x));
      }
    }
  }
  return volume;
}
}

#endif

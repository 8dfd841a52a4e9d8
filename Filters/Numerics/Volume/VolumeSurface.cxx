#include "Volume/VolumeSurface.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Volume/OtsuLevel.h"
#include "Volume/OutsideMask.h"
#include "Volume/VolumeSmoothing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
using Mask = std::vector<std::uint8_t>;

// Crossings of the edges that begin in one slice of voxels, in voxels.
struct Slice
{
  std::vector<Vector3> Positions, Descents;
  Index NumberOfCuts = 0;
};

class Crossings
{
public:
  Crossings(const VolumeImage& volume, const Mask& outside, double level)
    : Volume(volume)
    , Outside(outside)
    , Level(level)
    , Lowest(*std::min_element(volume.Values.begin(), volume.Values.end()))
  {
  }

  // Collect the crossings of the slice k, in [-1, Size[2]). A slice beyond the image is empty.
  Slice of(Index k) const
  {
    Slice slice;
    const auto& size = this->Volume.Size;
    for (Index j = -1; j < size[1]; ++j)
    {
      for (Index i = -1; i < size[0]; ++i)
      {
        const std::array<Index, 3> voxel = { i, j, k };
        for (int axis = 0; axis < 3; ++axis)
        {
          this->cross(voxel, axis, slice);
        }
      }
    }
    return slice;
  }

private:
  bool isInImage(const std::array<Index, 3>& v) const
  {
    bool isIn = true;
    for (int a = 0; a < 3; ++a)
    {
      isIn = isIn && v[a] >= 0 && v[a] < this->Volume.Size[a];
    }
    return isIn;
  }

  double valueAt(const std::array<Index, 3>& v) const
  {
    return this->isInImage(v) ? this->Volume.Values[this->Volume.id(v[0], v[1], v[2])]
                              : this->Lowest;
  }

  bool isOutside(const std::array<Index, 3>& v) const
  {
    return !this->isInImage(v) || this->Outside[this->Volume.id(v[0], v[1], v[2])] != 0;
  }

  // The direction in which values descend at a voxel. Where the image ends, the surrounding is low.
  Vector3 descentAt(const std::array<Index, 3>& v) const
  {
    Vector3 descent;
    for (int a = 0; a < 3; ++a)
    {
      std::array<Index, 3> before = v, after = v;
      --before[a];
      ++after[a];
      descent[a] = 0.5 * (this->valueAt(before) - this->valueAt(after));
    }
    return descent;
  }

  void cross(const std::array<Index, 3>& from, int axis, Slice& slice) const
  {
    std::array<Index, 3> to = from;
    ++to[axis];
    if (this->isOutside(from) == this->isOutside(to))
    {
      return;
    }
    const double a = this->valueAt(from), b = this->valueAt(to);
    if ((a > this->Level) == (b > this->Level))
    {
      return; // a closed opening, or a cavity: no surface of the object
    }
    const double t = std::clamp((this->Level - a) / (b - a), 0.0, 1.0);
    Vector3 position(
      static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2]));
    position[axis] += t;
    Vector3 descent = (1.0 - t) * this->descentAt(from) + t * this->descentAt(to);
    const double side = a > b ? 1.0 : -1.0; // the end of the edge that is outside
    if (!(side * descent[axis] > 0.0))
    {
      descent = side * Vector3::Unit(axis); // another surface is next to the edge
    }
    slice.Positions.push_back(position);
    slice.Descents.push_back(descent);
    slice.NumberOfCuts += !this->isInImage(from) || !this->isInImage(to);
  }

  const VolumeImage& Volume;
  const Mask& Outside;
  double Level, Lowest;
};

VolumeSurface joined(const std::vector<Slice>& slices, const VolumeImage& volume)
{
  // Covariant: gradients change by the inverse transposed matrix.
  const Eigen::Matrix3d toNormal = volume.Axes.inverse().transpose();
  if (!volume.Origin.allFinite() || !volume.Axes.allFinite() || !toNormal.allFinite())
  {
    throw std::invalid_argument("the spacing and the directions of the image must be finite and "
                                "independent, and not extremely large or small");
  }
  Index size = 0;
  for (const Slice& slice : slices)
  {
    size += static_cast<Index>(slice.Positions.size());
  }
  VolumeSurface surface;
  surface.Positions.resize(size, 3);
  surface.Normals.resize(size, 3);
  Index next = 0, cuts = 0;
  for (const Slice& slice : slices)
  {
    for (std::size_t i = 0; i < slice.Positions.size(); ++i, ++next)
    {
      surface.Positions.row(next) = volume.Origin + volume.Axes * slice.Positions[i];
      surface.Normals.row(next) = unitVector(toNormal * unitVector(slice.Descents[i]));
    }
    cuts += slice.NumberOfCuts;
  }
  surface.CutFraction = size > 0 ? static_cast<double>(cuts) / static_cast<double>(size) : 0.0;
  return surface;
}
}

//------------------------------------------------------------------------------
VolumeSurface sampleVolumeSurface(
  VolumeImage volume, const VolumeSurfaceOptions& options, const Run& run)
{
  if (volume.size() == 0)
  {
    throw std::invalid_argument("the image has no voxels");
  }
  if (!std::isfinite(options.Level))
  {
    throw std::invalid_argument("the level must be finite");
  }
  Steps steps(run, { 0.5, 0.1, 0.3, 0.1 }); // smoothing, level, outside, crossings
  smoothVolume(volume, options.Smoothing, steps.next());
  steps.next();
  const double level = options.UseOtsuLevel ? otsuLevel(volume.Values) : options.Level;
  const Mask outside =
    markOutside(volume, { level, options.ClosingRadius, options.LargestObject }, steps.next());
  const Crossings crossings(volume, outside, level);
  std::vector<Slice> slices(volume.Size[2] + 1);
  forBlocksReporting(steps.next(), static_cast<Index>(slices.size()), 1,
    [&](Index begin, Index) { slices[begin] = crossings.of(begin - 1); });
  VolumeSurface surface = joined(slices, volume);
  surface.Level = level;
  return surface;
}
}

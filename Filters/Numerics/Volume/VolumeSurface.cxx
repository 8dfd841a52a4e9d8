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

// Crossings of the edges that begin in a part of a slice of voxels, in voxels.
struct SlicePart
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

  // Collect the crossings of all parts of slices, from the first slice to the last.
  std::vector<SlicePart> collect(const Run& run) const
  {
    const auto& size = this->Volume.Size;
    constexpr Index voxelsOfPart = Index(1) << 14;
    const Index rows = std::max<Index>(voxelsOfPart / (size[0] + 1), 1),
                partsOfSlice = size[1] / rows + 1;
    std::vector<SlicePart> parts((size[2] + 1) * partsOfSlice);
    forBlocksReporting(run, static_cast<Index>(parts.size()), 1,
      [&](Index part, Index)
      {
        const Index first = part % partsOfSlice * rows - 1;
        this->cross(part / partsOfSlice - 1, first, std::min(first + rows, size[1]), parts[part]);
      });
    return parts;
  }

  // Return whether all values exceed the level.
  bool exceedsEverywhere() const { return this->Lowest > this->Level; }

private:
  // Collect the crossings of the rows [begin, end) of the slice k. Rows and slices begin at -1,
  // beyond the image.
  void cross(Index k, Index begin, Index end, SlicePart& part) const
  {
    for (Index j = begin; j < end; ++j)
    {
      for (Index i = -1; i < this->Volume.Size[0]; ++i)
      {
        const std::array<Index, 3> voxel = { i, j, k };
        for (int axis = 0; axis < 3; ++axis)
        {
          this->crossEdge(voxel, axis, part);
        }
      }
    }
  }

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

  void crossEdge(const std::array<Index, 3>& from, int axis, SlicePart& part) const
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
    part.Positions.push_back(position);
    part.Descents.push_back(descent);
    part.NumberOfCuts += !this->isInImage(from) || !this->isInImage(to);
  }

  const VolumeImage& Volume;
  const Mask& Outside;
  double Level, Lowest;
};

VolumeSurface joined(const std::vector<SlicePart>& parts, const VolumeImage& volume)
{
  // Covariant: gradients change by the inverse transposed matrix.
  const Eigen::Matrix3d toNormal = volume.Axes.inverse().transpose();
  if (!volume.Origin.allFinite() || !volume.Axes.allFinite() || !toNormal.allFinite())
  {
    throw std::invalid_argument("the spacing and the directions of the image must be finite and "
                                "independent, and not extremely large or small");
  }
  Index size = 0;
  for (const SlicePart& part : parts)
  {
    size += static_cast<Index>(part.Positions.size());
  }
  VolumeSurface surface;
  surface.Positions.resize(size, 3);
  surface.Normals.resize(size, 3);
  Index next = 0, cuts = 0;
  for (const SlicePart& part : parts)
  {
    for (std::size_t i = 0; i < part.Positions.size(); ++i, ++next)
    {
      surface.Positions.row(next) = volume.Origin + volume.Axes * part.Positions[i];
      surface.Normals.row(next) = unitVector(toNormal * unitVector(part.Descents[i]));
    }
    cuts += part.NumberOfCuts;
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
  const Run otsu = steps.next();
  const double level = options.UseOtsuLevel ? otsuLevel(volume.Values, otsu) : options.Level;
  const Mask outside =
    markOutside(volume, { level, options.ClosingRadius, options.LargestObject }, steps.next());
  const Crossings crossings(volume, outside, level);
  VolumeSurface surface = joined(crossings.collect(steps.next()), volume);
  surface.Level = level;
  surface.ExceedsEverywhere = crossings.exceedsEverywhere();
  return surface;
}
}

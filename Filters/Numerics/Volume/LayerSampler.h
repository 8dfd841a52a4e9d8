/// Sample an image of three dimensions along the normals of a surface, and summarize the samples.
/// Own construction: depths are the same everywhere, so that one layer has one meaning all over the
/// surface. Values are interpolated as in \cite Keys1981.

#ifndef ConformalLayerSampler_h
#define ConformalLayerSampler_h

#include "Volume/VolumeImage.h"

#include <vector>

namespace conformal
{
/// Return equally spaced depths from the first to the last, or their mean if there is one layer.
/// @param[in] count  at least 1
std::vector<double> layerDepths(double first, double last, int count);

/// What the layers of one place have in common.
struct LayerSummary
{
  double Maximum = 0.0;
  double Mean = 0.0;
  /// Depth at which the values are largest. Between layers, the depth is that of the vertex of a
  /// parabola through the largest value and its neighbors.
  double DepthOfMaximum = 0.0;
};

class LayerSampler
{
public:
  /// @param[in] volume  kept by reference; its axes must be independent
  /// @param[in] depths  depths of the layers, ascending; positive outward
  /// @param[in] first, last  range of depths that summarize() considers. Depths that exceed the
  ///   range by up to 1e-9 of the distance between the first and the last layer are in the range.
  /// @throws std::invalid_argument if the volume is empty, its axes are not independent, or no
  ///   depth is in the range
  LayerSampler(const VolumeImage& volume, std::vector<double> depths, double first, double last);

  int numberOfLayers() const { return static_cast<int>(this->Depths.size()); }

  /// Sample all layers. Beyond the limits, the value at the limit is repeated. Farther than half a
  /// voxel from the image, values are 0.
  /// @param[in] normal  unit vector
  /// @param[in] inward, outward  limits of the depth, at least 0
  /// @param[out] values  one value for each layer
  void sample(const Vector3& position, const Vector3& normal, double inward, double outward,
    float* values) const;

  /// Summarize the samples of one place. Layers beyond the limits are left out. If all layers in
  /// the range are beyond a limit, the nearest layer is used.
  LayerSummary summarize(const float* values, double inward, double outward) const;

private:
  bool isInRange(double depth) const { return depth >= this->First && depth <= this->Last; }

  const VolumeImage& Volume;
  std::vector<double> Depths;
  double First = 0.0, Last = 0.0;
  double Lowest = 0.0, Highest = 0.0; ///< range of the values of the image
  Eigen::Matrix3d ToIndex;
};
}

#endif
